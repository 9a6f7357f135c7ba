//! Measurements that cannot be taken.
//!
//! Owns the way from a panic in a claim's set-up to its cause as text. Knows no claim.

use std::ops::Deref;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::OnceLock;

/// What a measurement gives, or in one line why it could not be taken.
///
/// A claim is code about code: where what it sets up is refused, it panics with the refusal, and that is
/// a fault of this claim alone.
///
/// # Errors
/// The message of the panic.
pub(crate) fn caught<T>(measure: impl FnOnce() -> T) -> Result<T, String> {
    // what `measure` wrote to is not read again after a panic
    catch_unwind(AssertUnwindSafe(measure)).map_err(|payload| {
        let text = payload.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| payload.downcast_ref::<&str>().copied());
        let lines = text.unwrap_or("it panicked without a message").split_whitespace();
        lines.collect::<Vec<_>>().join(" ")
    })
}

/// Runs what catches its panics itself, without telling them on the terminal as well.
pub(crate) fn silently<T>(run: impl FnOnce() -> T) -> T {
    let told = take_hook();
    set_hook(Box::new(|_| ()));
    let result = catch_unwind(AssertUnwindSafe(run));
    set_hook(told);
    result.unwrap_or_else(|payload| std::panic::resume_unwind(payload))
}

/// A measurement several claims read, taken once.
///
/// Unlike a `LazyLock` that is poisoned, it tells each of them why it could not be taken.
pub(crate) struct Shared<T> {
    measure: fn() -> T,
    taken: OnceLock<Result<T, String>>,
}

impl<T> Shared<T> {
    /// What `measure` will give when it is first read.
    pub(crate) const fn new(measure: fn() -> T) -> Self {
        Self { measure, taken: OnceLock::new() }
    }
}

impl<T> Deref for Shared<T> {
    type Target = T;

    fn deref(&self) -> &T {
        self.taken.get_or_init(|| caught(self.measure)).as_ref().unwrap_or_else(|cause| panic!("{cause}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused() -> f64 {
        let number: Result<f64, _> = "no number".parse();
        number.expect("the scene can be set up")
    }

    #[test]
    fn a_panic_becomes_its_message_in_one_line() {
        assert_eq!(caught(|| 2.0), Ok(2.0));
        assert_eq!(caught(refused), Err("the scene can be set up: ParseFloatError { kind: Invalid }".into()));
        assert_eq!(caught(|| panic!("two\n  lines")), Err::<(), _>("two lines".into()));
        let wordless = || std::panic::resume_unwind(Box::new(1));
        assert_eq!(caught(wordless), Err::<(), _>("it panicked without a message".into()));
    }

    #[test]
    fn every_reader_of_a_shared_measurement_learns_why_it_was_not_taken() {
        static SHARED: Shared<f64> = Shared::new(refused);
        static TAKEN: Shared<f64> = Shared::new(|| 3.0);
        let first = caught(|| *SHARED);
        assert!(first.is_err() && first == caught(|| *SHARED), "{first:?}");
        assert_eq!(*TAKEN, 3.0);
    }
}
