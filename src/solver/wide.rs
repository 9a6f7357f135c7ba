//! Loops compiled once more for the vector instructions the machine has.
//!
//! Owns the dispatch of the solver's passes. It stands at the level of a chunk of particles, so its cost is
//! spread over some hundred pairs. Knows nothing of what the loops compute.

/// Calls an expression compiled for AVX2 and fused multiply-add where the machine has both, as it is elsewhere.
///
/// What is to be compiled wide must be `#[inline(always)]` down to the last kernel. The bits are the same either
/// way: Rust contracts nothing by itself, and `f64::mul_add` rounds once on every machine.
macro_rules! wide {
    ($call:expr) => {{
        #[cfg(target_arch = "x86_64")]
        #[target_feature(enable = "avx2,fma")]
        fn compiled_wide<R>(call: impl FnOnce() -> R) -> R {
            call()
        }
        #[cfg(target_arch = "x86_64")]
        if $crate::solver::wide::has_avx2_and_fma() {
            // SAFETY: the machine has the instructions.
            unsafe {
                compiled_wide(
                    #[inline(always)]
                    || $call,
                )
            }
        } else {
            $call
        }
        #[cfg(not(target_arch = "x86_64"))]
        $call
    }};
}

pub(super) use wide;

/// Whether to use AVX2 and FMA; never in the tests that compare both ways.
#[cfg(target_arch = "x86_64")]
pub(super) fn has_avx2_and_fma() -> bool {
    #[cfg(test)]
    if NARROW.with(std::cell::Cell::get) {
        return false;
    }
    std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
}

#[cfg(test)]
thread_local! {
    /// Set by a test that wants the portable loops.
    pub(super) static NARROW: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
}
