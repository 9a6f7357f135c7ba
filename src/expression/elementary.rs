//! Elementary functions without a branch: the same bits on every machine, and loops over them
//! become vector instructions.
//!
//! Owns the kernels that pay in blocks; the other functions come from `libm`. No fused
//! multiply-add, so wider instructions cannot change a bit.

/// `2⁵² · 1.5`: adding it rounds a number below `2⁵¹` to an integer in the low bits.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// `ln 2` in two parts, the first with 32 bits so that its multiples are exact.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// Taylor coefficients `1/k!` of `(e^r − 1 − r)/r²`, `k` from 13 down to 2.
const EXP: [f64; 12] = [
    1.0 / 6_227_020_800.0,
    1.0 / 479_001_600.0,
    1.0 / 39_916_800.0,
    1.0 / 3_628_800.0,
    1.0 / 362_880.0,
    1.0 / 40_320.0,
    1.0 / 5_040.0,
    1.0 / 720.0,
    1.0 / 120.0,
    1.0 / 24.0,
    1.0 / 6.0,
    0.5,
];

/// `2^n` for a whole number `n`, given as `n + ROUNDER`, between −1022 and 1023.
#[inline(always)]
fn power_of_two(n_rounded: f64) -> f64 {
    f64::from_bits(n_rounded.to_bits().wrapping_add(1023) << 52)
}

/// `e^x`, to 1 ulp; infinity above 709.78, 0 below −745.13, not a number for what is none.
///
/// `x = k ln 2 + r` with `|r| ≤ ½ ln 2`; the polynomial's first neglected term, `r¹⁴/14!`, is below
/// 5e-18.
#[inline(always)]
pub fn exp(x: f64) -> f64 {
    // beyond these the result is infinity or zero anyway; a NaN passes both comparisons
    let x = if x > 711.0 { 711.0 } else { x };
    let x = if x < -747.0 { -747.0 } else { x };
    let k = (x * std::f64::consts::LOG2_E + ROUNDER) - ROUNDER;
    let r = (x - k * LN_2_HIGH) - k * LN_2_LOW;
    let mut p = EXP[0];
    for c in &EXP[1..] {
        p = p * r + c;
    }
    let series = 1.0 + (r + (r * r) * p);
    // in two factors, so that neither leaves the range of exponents
    let half = (0.5 * k + ROUNDER) - ROUNDER;
    series * power_of_two(half + ROUNDER) * power_of_two((k - half) + ROUNDER)
}

/// Parabola nearest to `m^(-1/3)` over `1 ≤ m < 2`, good to 1.8e-3.
const GUESS: [f64; 3] = [1.388_119_851, -0.483_287_741, 0.093_391_496];

/// `2^(-1/3)` and `2^(1/3)`.
const CBRT_HALF: f64 = 0.793_700_525_984_099_7;
const CBRT_TWO: f64 = 1.259_921_049_894_873_2;

/// `x^(-1/3)`, to 2 ulp, for positive normal `x`; not a number for all others.
///
/// With `x = m 2^e`, `e = 3 q + s`, `s` in −1..1: a parabola in `m`, then two steps of third order
/// `y ← y + y ε (1/3 + 2/9 ε)`, `ε = 1 − m 2^s y³`, and `2^(−q)` at the end.
#[inline(always)]
pub fn reciprocal_cbrt(x: f64) -> f64 {
    let bits = x.to_bits();
    // the exponent as a number: its bits under those of 2⁵²
    let e = f64::from_bits((bits >> 52) | 0x4330_0000_0000_0000) - (4_503_599_627_370_496.0 + 1023.0);
    let q = (e * (1.0 / 3.0) + ROUNDER) - ROUNDER;
    let s = e - 3.0 * q;
    let m = f64::from_bits((bits & 0x000f_ffff_ffff_ffff) | 0x3ff0_0000_0000_0000);
    let scaled = m * if s > 0.5 {
        2.0
    } else if s < -0.5 {
        0.5
    } else {
        1.0
    };
    let root = if s > 0.5 {
        CBRT_HALF
    } else if s < -0.5 {
        CBRT_TWO
    } else {
        1.0
    };
    let mut y = root * (GUESS[0] + m * (GUESS[1] + m * GUESS[2]));
    for _ in 0..2 {
        let error = 1.0 - scaled * (y * y * y);
        y += y * (error * (1.0 / 3.0 + error * (2.0 / 9.0)));
    }
    let result = y * power_of_two(ROUNDER - q);
    if (f64::MIN_POSITIVE..=f64::MAX).contains(&x) { result } else { f64::NAN }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distance of two numbers in units of the last place of the second.
    fn ulps(a: f64, b: f64) -> f64 {
        let unit = f64::from_bits(b.abs().to_bits() + 1) - b.abs();
        ((a - b) / unit).abs()
    }

    fn worst(low: f64, high: f64, count: usize, error: impl Fn(f64) -> f64) -> f64 {
        let at = |i: usize| low + (high - low) * (i as f64 + 0.37) / count as f64;
        (0..count).map(|i| error(at(i))).fold(0.0, |a, b| if b <= a { a } else { b })
    }

    #[test]
    fn exp_is_within_two_ulp_of_libm() {
        for (low, high) in [(-708.0, 709.0), (-1.0, 1.0), (-1e-3, 1e-3), (0.0, 60.0)] {
            let error = worst(low, high, 200_000, |x| ulps(exp(x), libm::exp(x)));
            assert!(error <= 2.0, "{error} ulp in {low}..{high}");
        }
    }

    #[test]
    fn exp_ends_as_it_should() {
        assert_eq!(exp(0.0), 1.0);
        assert_eq!(exp(710.0), f64::INFINITY);
        assert_eq!(exp(f64::INFINITY), f64::INFINITY);
        assert_eq!(exp(f64::NEG_INFINITY), 0.0);
        assert_eq!(exp(-800.0), 0.0);
        assert!(exp(f64::NAN).is_nan());
        assert!(exp(709.78) < f64::INFINITY);
        assert!(exp(-740.0) > 0.0);
    }

    #[test]
    fn the_reciprocal_cube_root_is_within_two_ulp() {
        // against a cube root of 1 ulp and a division
        for (low, high) in [(0.9, 1.1), (0.1, 10.0), (1e-300, 1e-298), (1e298, 1e300), (0.5, 1e6)] {
            let error = worst(low, high, 200_000, |x| ulps(reciprocal_cbrt(x), 1.0 / libm::cbrt(x)));
            assert!(error <= 3.0, "{error} ulp in {low}..{high}");
        }
        assert_eq!(reciprocal_cbrt(1.0), 1.0);
        assert_eq!(reciprocal_cbrt(8.0), 0.5);
    }

    #[test]
    fn the_reciprocal_cube_root_is_none_where_no_isochoric_part_exists() {
        for x in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-310] {
            assert!(reciprocal_cbrt(x).is_nan(), "{x}");
        }
    }
}
