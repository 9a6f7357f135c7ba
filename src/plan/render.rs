//! The plan as text.

use super::{Decision, Plan};
use std::fmt;

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "scene {}", self.scene)?;
        writeln!(f, "fields")?;
        write_decisions(f, &self.fields)?;
        writeln!(f, "passes")?;
        write_decisions(f, &self.passes)?;
        writeln!(f, "choices")?;
        for choice in &self.choices {
            writeln!(f, "    {:<24}{:<18}{}", choice.key, choice.value, choice.origin)?;
        }
        Ok(())
    }
}

fn write_decisions<T: fmt::Debug>(f: &mut fmt::Formatter<'_>, list: &[Decision<T>]) -> fmt::Result {
    for decision in list {
        let sign = if decision.live { '+' } else { '−' };
        writeln!(f, "  {sign} {:<22}{}", format!("{:?}", decision.what), decision.reason)?;
    }
    Ok(())
}
