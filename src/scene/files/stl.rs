//! STL, as text and as bytes.

use super::FileError;

/// Bytes of a binary file before its triangles, and of each triangle.
const HEADER: usize = 84;
const TRIANGLE: usize = 50;

/// The corners of all triangles in the file's unit; its normals are not read.
///
/// A file is binary if it is as long as its count of triangles says, whatever it begins with: some programs begin
/// those with `solid`, the first word of a text, as well.
pub(in crate::scene) fn triangles(bytes: &[u8]) -> Result<Vec<[[f64; 3]; 3]>, FileError> {
    let count = bytes.get(80..HEADER).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    let length = count.and_then(|count| (count as usize).checked_mul(TRIANGLE)?.checked_add(HEADER));
    if length == Some(bytes.len()) {
        return Ok(bytes[HEADER..].chunks_exact(TRIANGLE).map(triangle).collect());
    }
    match std::str::from_utf8(bytes) {
        // a text holds no zero byte; a binary file that breaks off may be one otherwise
        Ok(text) if text.trim_start().starts_with("solid") && !bytes.contains(&0) => of_text(text),
        _ if count.is_some() => Err(FileError::Short { what: "triangles" }),
        _ => Err(FileError::Missing { word: "solid".into() }),
    }
}

/// Three corners after the normal, each of three 32-bit floats.
fn triangle(bytes: &[u8]) -> [[f64; 3]; 3] {
    let float = |at: usize| {
        let bytes = [bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]];
        f64::from(f32::from_le_bytes(bytes))
    };
    std::array::from_fn(|corner| std::array::from_fn(|axis| float(12 + 12 * corner + 4 * axis)))
}

fn of_text(text: &str) -> Result<Vec<[[f64; 3]; 3]>, FileError> {
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let mut words = line.split_ascii_whitespace();
        if words.next() != Some("vertex") {
            continue;
        }
        let mut corner = [0.0; 3];
        for value in &mut corner {
            let word = words.next().ok_or(FileError::Short { what: "coordinates" })?;
            *value = word
                .parse()
                .map_err(|_| FileError::NotANumber { found: word.to_string(), line: index + 1 })?;
        }
        corners.push(corner);
    }
    if corners.is_empty() {
        return Err(FileError::Missing { word: "vertex".into() });
    }
    let (triangles, rest) = corners.as_chunks::<3>();
    if rest.is_empty() { Ok(triangles.to_vec()) } else { Err(FileError::Short { what: "last triangle" }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "solid one\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1.5 0 0\n  vertex 0 2e0 0\n\
                        endloop\nendfacet\nendsolid one\n";

    fn binary(count: u32, triangles: &[[f32; 9]]) -> Vec<u8> {
        let mut bytes = b"solid though it is binary".to_vec();
        bytes.resize(80, b' ');
        bytes.extend(count.to_le_bytes());
        for corners in triangles {
            bytes.extend([0u8; 12]);
            bytes.extend(corners.iter().flat_map(|x| x.to_le_bytes()));
            bytes.extend([0u8; 2]);
        }
        bytes
    }

    #[test]
    fn text_and_bytes_say_the_same() {
        let expected = vec![[[0.0, 0.0, 0.0], [1.5, 0.0, 0.0], [0.0, 2.0, 0.0]]];
        assert_eq!(triangles(TEXT.as_bytes()), Ok(expected.clone()));
        let bytes = binary(1, &[[0.0, 0.0, 0.0, 1.5, 0.0, 0.0, 0.0, 2.0, 0.0]]);
        assert_eq!(triangles(&bytes), Ok(expected));
    }

    #[test]
    fn a_file_that_breaks_off_is_refused() {
        let short = binary(2, &[[0.0; 9]]);
        assert_eq!(triangles(&short), Err(FileError::Short { what: "triangles" }));
        let cut = TEXT.replace("  vertex 0 2e0 0\n", "");
        assert_eq!(triangles(cut.as_bytes()), Err(FileError::Short { what: "last triangle" }));
        let word = TEXT.replace("2e0", "two");
        let told = FileError::NotANumber { found: "two".into(), line: 6 };
        assert_eq!(triangles(word.as_bytes()), Err(told));
        assert_eq!(triangles(b"nothing"), Err(FileError::Missing { word: "solid".into() }));
    }
}
