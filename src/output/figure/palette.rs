//! Colours told apart by readers with any colour vision (Okabe & Ito 2008).

/// Red, green, blue.
pub(super) type Colour = (u8, u8, u8);

/// Text, axes and markers without a colour of their own.
pub(super) const INK: Colour = (0x22, 0x22, 0x22);
/// Lines of the grid.
pub(super) const GRID: Colour = (0xdd, 0xdd, 0xdd);
/// The ground.
pub(super) const PAPER: Colour = (0xff, 0xff, 0xff);

/// Blue, vermilion, bluish green, reddish purple, orange, sky blue, black; the yellow of the set is
/// too faint on white.
const SERIES: [Colour; 7] = [
    (0x00, 0x72, 0xb2),
    (0xd5, 0x5e, 0x00),
    (0x00, 0x9e, 0x73),
    (0xcc, 0x79, 0xa7),
    (0xe6, 0x9f, 0x00),
    (0x56, 0xb4, 0xe9),
    (0x00, 0x00, 0x00),
];

/// The colour of series `number`; after seven they start again.
pub(super) fn series(number: usize) -> Colour {
    SERIES[number % SERIES.len()]
}

/// The colour of series `number` mixed with paper, for regions below curves.
pub(super) fn tint(number: usize) -> Colour {
    let (r, g, b) = series(number);
    // a quarter of the colour, three quarters of paper: at most 255
    let mixed = |c: u8, paper: u8| ((u16::from(c) + 3 * u16::from(paper)) / 4) as u8;
    (mixed(r, PAPER.0), mixed(g, PAPER.1), mixed(b, PAPER.2))
}
