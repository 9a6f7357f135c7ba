//! The audit as text for the terminal.

use super::judge::Standing;
use super::{Along, MaterialAudit, Side};
use std::fmt;

/// Width of the labels.
const LABEL: usize = 34;

/// Prefixes by powers of a thousand.
const PREFIXES: [(f64, &str); 5] = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m")];

/// A value with four digits and the prefix that leaves one to three before the point.
pub(crate) fn quantity(value: f64, unit: &str) -> String {
    if !value.is_finite() {
        return "not finite".into();
    }
    let size = value.abs();
    let fitting = PREFIXES.iter().find(|(factor, _)| size >= 0.99995 * factor);
    match fitting {
        Some((factor, prefix)) if size < 999.95 * PREFIXES[0].0 => {
            format!("{} {prefix}{unit}", four_digits(value / factor))
        }
        _ if size == 0.0 => format!("0 {unit}"),
        _ => format!("{value:.3e} {unit}"),
    }
}

/// `15.28`, `149.2`, `1.189`.
fn four_digits(value: f64) -> String {
    let decimals = match value.abs() {
        size if size < 9.9995 => 3,
        size if size < 99.995 => 2,
        _ => 1,
    };
    format!("{value:.decimals$}")
}

impl fmt::Display for MaterialAudit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "material {}: density {} kg/m^3", self.material, self.density)?;
        match self.directions.is_empty() {
            true => writeln!(f, ", no directions")?,
            false => writeln!(f, ", directions {}", self.directions.join(", "))?,
        }
        if !self.varying.is_empty() {
            line(f, "taken at X = [1, 2, 3] mm", &self.varying.join(", "))?;
        }
        line(f, "shear modulus at rest", &quantity(self.shear_modulus, "Pa"))?;
        line(f, "bulk modulus at rest", &quantity(self.bulk_modulus, "Pa"))?;
        let waves = match (self.pressure_wave_speed, self.shear_wave_speed) {
            (Some(pressure), Some(shear)) => waves(pressure, shear),
            _ => "none travels".into(),
        };
        line(f, "waves at rest", &waves)?;
        for along in &self.along {
            write_along(f, along)?;
        }
        for property in &self.properties {
            let mark = match property.standing {
                Standing::Holds => "holds",
                Standing::Broken => "FAILS",
                Standing::Warns => "warns",
                Standing::NotAsked => "-    ",
            };
            writeln!(f, "  {mark}  {:<26} {}", property.property.replace('_', " "), property.found)?;
        }
        if let Some(first) = self.requirements.first() {
            let [low, high] = self.stretches;
            writeln!(f, "  required at {} over stretches {low} to {high}", first.place)?;
        }
        for requirement in &self.requirements {
            let mark = if requirement.is_met { "met  " } else { "UNMET" };
            writeln!(f, "  {mark}  {}", requirement.property.replace('_', " "))?;
        }
        Ok(())
    }
}

fn line(f: &mut fmt::Formatter<'_>, label: &str, value: &str) -> fmt::Result {
    writeln!(f, "  {label:<LABEL$}{value}")
}

fn waves(pressure: f64, shear: f64) -> String {
    format!("pressure {}, shear {}", quantity(pressure, "m/s"), quantity(shear, "m/s"))
}

fn write_along(f: &mut fmt::Formatter<'_>, along: &Along) -> fmt::Result {
    let name = &along.name;
    let sides = |value: fn(&Side) -> Option<String>| {
        let text = |side: &Option<Side>| side.as_ref().and_then(value).unwrap_or("no equilibrium".into());
        format!("{:<16} pulled, {:<16} pushed", text(&along.tension), text(&along.compression))
    };
    line(
        f,
        &format!("Young's modulus along {name}"),
        &sides(|side| Some(quantity(side.young_modulus, "Pa"))),
    )?;
    line(f, "  slope at 1 % strain", &sides(|side| side.slope_at_one_percent.map(|e| quantity(e, "Pa"))))?;
    line(f, "  Poisson's ratios", &sides(|side| Some(ratios(side.poisson_ratios))))?;
    let pulled = along.pulled.map_or("no equilibrium".into(), |pulled| {
        let waves = waves(pulled.pressure_wave_speed, pulled.shear_wave_speed);
        format!("P = {}, J = {:.4}, {waves}", quantity(pulled.stress, "Pa"), pulled.volume)
    });
    let stretch = along.pulled.map_or(1.1, |pulled| pulled.stretch);
    line(f, &format!("  at stretch {stretch:.3}"), &pulled)?;
    let overflow = match along.overflow_stretch {
        Some(stretch) => format!("at isochoric stretch {stretch:.4}"),
        None => "none up to stretch 1000".into(),
    };
    line(f, "  overflow", &overflow)
}

/// Two ratios, or one if they agree to the digits shown.
fn ratios([small, large]: [f64; 2]) -> String {
    let (small, large) = (format!("{small:.4}"), format!("{large:.4}"));
    if small == large { small } else { format!("{small}, {large}") }
}
