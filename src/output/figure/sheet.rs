//! Several pictures on one page.
//!
//! Owns their places; what they show is theirs.

use super::model::FigureError;

/// Distance between pictures, units of the page.
const GAP: f64 = 12.0;
/// Font size of the letters that name the pictures, units.
const LETTER: f64 = 20.0;

/// Pictures side by side, `columns` in a row, named (a), (b), … if there are several, as one SVG.
///
/// | argument | meaning |
/// |---|---|
/// | `title` | title of the file |
/// | `provenance` | lines kept in the file |
/// | `pictures` | SVG texts of this module's |
/// | `columns` | pictures in a row, at least 1 |
///
/// A single picture is the page itself.
///
/// # Errors
/// [`FigureError::Empty`] without pictures, [`FigureError::Drawing`] where one has no size.
pub fn sheet(
    title: &str,
    provenance: &[String],
    pictures: &[String],
    columns: usize,
) -> Result<String, FigureError> {
    let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    match pictures {
        [] => return Err(FigureError::Empty),
        // drawn without a title above it, but not without a name
        [one] => {
            return Ok(one.replacen("<title></title>", &format!("<title>{}</title>", escaped(title)), 1));
        }
        _ => {}
    }
    let sizes = pictures.iter().map(|picture| size(picture)).collect::<Result<Vec<_>, _>>()?;
    let columns = columns.clamp(1, pictures.len());
    let mut body = String::new();
    let (mut width, mut top) = (0.0_f64, 0.0);
    for (row, pair) in pictures.chunks(columns).zip(sizes.chunks(columns)).enumerate() {
        let mut left = 0.0;
        let mut tallest = 0.0_f64;
        for (i, (picture, (wide, tall))) in row_of(pair.0, pair.1).enumerate() {
            let letter = char::from(b'a' + ((row * columns + i) % 26) as u8);
            let y = top + LETTER + 8.0;
            // the picture's own opening tag, with its place
            let placed = picture.replacen("<svg ", &format!("<svg x=\"{left}\" y=\"{y}\" "), 1);
            body.push_str(&placed);
            body.push_str(&format!(
                "\n<text x=\"{}\" y=\"{}\" dy=\"0.5ex\" font-family=\"sans-serif\" font-size=\"{LETTER}\" \
                 fill=\"#222222\">({letter})</text>\n",
                left + 8.0,
                top + 0.5 * LETTER + 6.0
            ));
            left += wide + GAP;
            tallest = tallest.max(*tall);
        }
        width = width.max(left - GAP);
        top += tallest + LETTER + 8.0 + GAP;
    }
    let height = top - GAP;
    Ok(format!(
        "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         xmlns=\"http://www.w3.org/2000/svg\">\n<title>{}</title>\n<desc>{}</desc>\n\
         <rect x=\"0\" y=\"0\" width=\"{width}\" height=\"{height}\" fill=\"#FFFFFF\" stroke=\"none\"/>\n{body}</svg>\n",
        escaped(title),
        escaped(&provenance.join("\n"))
    ))
}

fn row_of<'a>(
    pictures: &'a [String],
    sizes: &'a [(f64, f64)],
) -> impl Iterator<Item = (&'a String, &'a (f64, f64))> {
    pictures.iter().zip(sizes)
}

/// Width and height of a picture.
fn size(picture: &str) -> Result<(f64, f64), FigureError> {
    let value = |name: &str| -> Option<f64> {
        let (_, rest) = picture.split_once(&format!(" {name}=\""))?;
        rest.split_once('"')?.0.parse().ok()
    };
    value("width")
        .zip(value("height"))
        .ok_or_else(|| FigureError::Drawing { cause: "a picture without a size".into() })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(width: u32, height: u32) -> String {
        format!("<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 1 1\"></svg>")
    }

    #[test]
    fn pictures_stand_in_rows_and_none_reaches_into_another() {
        let pictures = [picture(100, 50), picture(80, 70), picture(60, 10)];
        let svg = sheet("a < b", &["tissue".into()], &pictures, 2).expect("drawn");
        assert!(svg.starts_with("<svg width=\"192\" height=\"148\""), "{svg}");
        assert!(svg.contains("<svg x=\"112\" y=\"28\" width=\"80\""), "{svg}");
        assert!(svg.contains("<svg x=\"0\" y=\"138\" width=\"60\""), "{svg}");
        assert!(svg.contains("(c)") && svg.contains("a &lt; b"));
    }

    #[test]
    fn one_picture_is_the_page_and_none_is_no_figure() {
        assert_eq!(sheet("", &[], &[picture(1, 2)], 3), Ok(picture(1, 2)));
        assert_eq!(sheet("", &[], &[], 1), Err(FigureError::Empty));
        assert!(sheet("", &[], &["<svg>".into(), picture(1, 1)], 1).is_err());
    }
}
