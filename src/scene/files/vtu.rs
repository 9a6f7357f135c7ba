//! VTU, VTK's unstructured grid as XML: points, hexahedra, point data.

use super::FileError;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// VTK's number for a cell that is a point, and for one of eight corners.
const VERTEX: f64 = 1.0;
const HEXAHEDRON: f64 = 12.0;

/// What a file says of its points.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::scene) struct Points {
    /// Positions in the file's unit.
    pub(in crate::scene) position: Vec<[f64; 3]>,
    /// Corners of hexahedra; none where the points stand alone.
    pub(in crate::scene) cell: Vec<[u32; 8]>,
    /// The point data asked for.
    pub(in crate::scene) data: Option<Vec<f64>>,
}

/// Points, hexahedra and the point data `wanted`.
pub(in crate::scene) fn points(text: &str, wanted: Option<&str>) -> Result<Points, FileError> {
    if text.contains("compressor=") {
        return Err(FileError::Unsupported { what: "compressed data".into() });
    }
    if text.contains("byte_order=\"BigEndian\"") {
        return Err(FileError::Unsupported { what: "big-endian data".into() });
    }
    let wide = text.contains("header_type=\"UInt64\"");
    let coordinates = array(section(text, "Points")?, None, wide)?;
    let (position, rest) = coordinates.as_chunks::<3>();
    if !rest.is_empty() || position.is_empty() {
        return Err(FileError::Short { what: "points" });
    }
    let data = match wanted {
        None => None,
        Some(name) => Some(array(section(text, "PointData")?, Some(name), wide)?),
    };
    if data.as_ref().is_some_and(|data| data.len() != position.len()) {
        return Err(FileError::Short { what: "point data" });
    }
    Ok(Points { position: position.to_vec(), cell: hexahedra(text, wide)?, data })
}

/// The hexahedra of a file, none if all its cells are points.
fn hexahedra(text: &str, wide: bool) -> Result<Vec<[u32; 8]>, FileError> {
    let Ok(cells) = section(text, "Cells") else { return Ok(Vec::new()) };
    let types = array(cells, Some("types"), wide)?;
    if types.iter().all(|kind| *kind == VERTEX) {
        return Ok(Vec::new());
    }
    if let Some(other) = types.iter().find(|kind| **kind != HEXAHEDRON) {
        let what =
            format!("a cell of VTK's type {other} beside or in place of hexahedra, type {HEXAHEDRON},");
        return Err(FileError::Unsupported { what });
    }
    let connectivity = array(cells, Some("connectivity"), wide)?;
    let (corners, rest) = connectivity.as_chunks::<8>();
    if !rest.is_empty() || corners.len() != types.len() {
        return Err(FileError::Short { what: "cells" });
    }
    // a corner that is no index becomes one no file has points for
    let index = |x: f64| if (0.0..4e9).contains(&x) { x as u32 } else { u32::MAX };
    Ok(corners.iter().map(|cell| cell.map(index)).collect())
}

/// What stands between `<Name …>` and `</Name>`.
fn section<'a>(text: &'a str, name: &str) -> Result<&'a str, FileError> {
    let missing = || FileError::Missing { word: format!("<{name}>") };
    let start =
        text.find(&format!("<{name}>")).or_else(|| text.find(&format!("<{name} "))).ok_or_else(missing)?;
    let rest = &text[start..];
    let end = rest.find(&format!("</{name}>")).ok_or_else(missing)?;
    Ok(&rest[..end])
}

/// The numbers of the first `DataArray` of a section, or of the one of a name.
fn array(section: &str, name: Option<&str>, wide: bool) -> Result<Vec<f64>, FileError> {
    let word = || name.map_or("<DataArray>".to_string(), |name| format!("DataArray Name=\"{name}\""));
    let wanted = |element: &&str| name.is_none_or(|name| attribute(element, "Name") == Some(name));
    let element = section
        .split("<DataArray")
        .skip(1)
        .find(wanted)
        .ok_or_else(|| FileError::Missing { word: word() })?;
    let (head, body) = element.split_once('>').ok_or(FileError::Short { what: "DataArray" })?;
    let body = body.split("</DataArray>").next().unwrap_or("");
    match attribute(head, "format").unwrap_or("ascii") {
        "ascii" => body
            .split_ascii_whitespace()
            .map(|word| {
                let line =
                    1 + section[..word.as_ptr() as usize - section.as_ptr() as usize].matches('\n').count();
                word.parse().map_err(|_| FileError::NotANumber { found: word.to_string(), line })
            })
            .collect(),
        "binary" => decoded(body.trim(), attribute(head, "type").unwrap_or(""), wide),
        other => Err(FileError::Unsupported { what: format!("the format `{other}`") }),
    }
}

/// The value of an attribute in the head of an element.
fn attribute<'a>(element: &'a str, name: &str) -> Option<&'a str> {
    let head = element.split('>').next()?;
    let (_, rest) = head.split_once(&format!(" {name}=\""))?;
    rest.split('"').next()
}

/// Numbers in base64 after their count of bytes.
fn decoded(text: &str, kind: &str, wide: bool) -> Result<Vec<f64>, FileError> {
    let bytes = STANDARD
        .decode(text)
        .map_err(|_| FileError::Unsupported { what: "text that is no base64".into() })?;
    let head = if wide { 8 } else { 4 };
    let body = bytes.get(head..).ok_or(FileError::Short { what: "data" })?;
    let announced = bytes[..head].iter().rev().fold(0_u64, |sum, byte| sum << 8 | u64::from(*byte));
    if announced != body.len() as u64 {
        return Err(FileError::Short { what: "data" });
    }
    fn each<const N: usize>(bytes: &[u8], number: fn([u8; N]) -> f64) -> Vec<f64> {
        bytes.as_chunks::<N>().0.iter().map(|bytes| number(*bytes)).collect()
    }
    Ok(match kind {
        "Float64" => each(body, f64::from_le_bytes),
        "Float32" => each(body, |bytes| f64::from(f32::from_le_bytes(bytes))),
        "Int64" => each(body, |bytes| i64::from_le_bytes(bytes) as f64),
        "UInt64" => each(body, |bytes| u64::from_le_bytes(bytes) as f64),
        "Int32" => each(body, |bytes| f64::from(i32::from_le_bytes(bytes))),
        "UInt32" => each(body, |bytes| f64::from(u32::from_le_bytes(bytes))),
        "UInt8" => each(body, |[byte]: [u8; 1]| f64::from(byte)),
        other => return Err(FileError::Unsupported { what: format!("the type `{other}`") }),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_as_text_are_read_and_words_refused() {
        let text = "<VTKFile><Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0 1 2e0 3\n\
                    </DataArray></Points></VTKFile>";
        let read = points(text, None).expect("the file is whole");
        assert_eq!((read.position, read.cell.len()), (vec![[0.0; 3], [1.0, 2.0, 3.0]], 0));
        let told = FileError::NotANumber { found: "two".into(), line: 3 };
        assert_eq!(points(&text.replace("2e0", "two"), None), Err(told));
        assert_eq!(points(text, Some("W")), Err(FileError::Missing { word: "<PointData>".into() }));
        assert!(points(&text[..text.len() / 2], None).is_err());
    }
}
