//! Choice of the widest vector instructions the machine has.
//!
//! Owns the only dispatch: the same source compiled twice. Rust contracts no multiply and add into
//! one rounding, so both give the same bits; a test holds that.

/// Calls a method, compiled once more for AVX2 where the machine has it.
///
/// The method must be `#[inline(always)]`, and so must all that is to be compiled with it.
macro_rules! widest {
    ($law:ident . $method:ident ( $($argument:expr),* )) => {{
        #[cfg(target_arch = "x86_64")]
        #[target_feature(enable = "avx2")]
        fn wide(call: impl FnOnce()) {
            call();
        }
        #[cfg(target_arch = "x86_64")]
        if $crate::energy::wide::has_avx2() {
            // SAFETY: the machine has the instructions.
            unsafe { wide(#[inline(always)] || $law.$method($($argument),*)) };
            return;
        }
        $law.$method($($argument),*);
    }};
}

pub(super) use widest;

/// Whether to use AVX2; never in the tests that compare both ways.
#[cfg(target_arch = "x86_64")]
pub(super) fn has_avx2() -> bool {
    #[cfg(test)]
    if NARROW.with(std::cell::Cell::get) {
        return false;
    }
    std::arch::is_x86_feature_detected!("avx2")
}

#[cfg(test)]
thread_local! {
    /// Set by a test that wants the baseline.
    pub(super) static NARROW: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
}
