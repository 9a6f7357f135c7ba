//! Numbers as colours: dark blue over green to yellow, even in brightness.
//!
//! Owns the map. It is viridis (van der Walt & Smith 2015) by a polynomial of the sixth degree, told
//! apart with any colour vision and when printed in grey.

use super::palette::Colour;

/// Coefficients of red, green, blue, constant first.
const VIRIDIS: [[f64; 7]; 3] = [
    [0.277_727, 0.105_093, -0.330_862, -4.634_230, 6.228_270, 4.776_385, -5.435_456],
    [0.005_407, 1.404_614, 0.214_848, -5.799_101, 14.179_933, -13.745_145, 4.645_853],
    [0.334_100, 1.384_590, 0.095_095, -19.332_441, 56.690_553, -65.353_033, 26.312_435],
];

/// The colour at `fraction` of the scale; beyond its ends that of the end.
pub(super) fn viridis(fraction: f64) -> Colour {
    let t = fraction.clamp(0.0, 1.0);
    let channel = |coefficients: &[f64; 7]| {
        let value = coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c);
        // Within 0 and 255 by the clamp.
        libm::round(255.0 * value.clamp(0.0, 1.0)) as u8
    };
    (channel(&VIRIDIS[0]), channel(&VIRIDIS[1]), channel(&VIRIDIS[2]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_and_the_middle_are_those_of_viridis() {
        // Table of the map's authors at 0, 0.5 and 1; the polynomial errs by up to three steps.
        let near = |(a, b, c): Colour, (d, e, f): Colour| {
            a.abs_diff(d) <= 3 && b.abs_diff(e) <= 3 && c.abs_diff(f) <= 4
        };
        assert!(near(viridis(0.0), (0x44, 0x01, 0x54)), "{:?}", viridis(0.0));
        assert!(near(viridis(0.5), (0x21, 0x91, 0x8c)), "{:?}", viridis(0.5));
        assert!(near(viridis(1.0), (0xfd, 0xe7, 0x25)), "{:?}", viridis(1.0));
        assert!(!near(viridis(0.6), (0x21, 0x91, 0x8c)));
        assert_eq!((viridis(-1.0), viridis(2.0)), (viridis(0.0), viridis(1.0)));
    }

    #[test]
    fn brightness_grows_from_end_to_end() {
        // Relative luminance by ITU-R BT.709 on the encoded values.
        let brightness = |i: u32| {
            let (r, g, b) = viridis(f64::from(i) / 64.0);
            0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
        };
        assert!((0..64).all(|i| brightness(i) < brightness(i + 1)));
    }
}
