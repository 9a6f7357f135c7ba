//! A frame back from a VTU file, and the list of frames from a PVD file, as this program writes them.
//!
//! Owns reading only. Files of other programs need not be readable: binary arrays inside their elements,
//! 64-bit numbers, little endian, no compression.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::collection::Collection;
use super::model::{Frame, FrameError, FrameField};
use crate::tensor::Vec3;

impl Frame {
    /// Reads a frame from the text of a VTU file; its time stands in the collection, not in it.
    ///
    /// # Errors
    /// [`FrameError::Unreadable`] says which part is missing or broken.
    pub fn from_vtu(text: &str) -> Result<Self, FrameError> {
        let displacement = vectors(&floats(text, "displacement")?.values);
        let position = vectors(&floats(text, "position")?.values);
        if displacement.len() != position.len() {
            return Err(unreadable("position"));
        }
        let reference = position.iter().zip(&displacement).map(|(x, u)| x - u).collect();
        let (start, end) = section(text, "<PointData>", "</PointData>")?;
        let mut fields = Vec::new();
        for element in text[start..end].split("<DataArray ").skip(1) {
            let name = attribute(element, "Name").ok_or_else(|| unreadable("Name"))?;
            if name != "displacement" {
                fields.push(floats(text, name)?);
            }
        }
        Ok(Self {
            time: 0.0,
            reference,
            displacement,
            hexahedra: hexahedra(text)?,
            fields,
            provenance: vec![],
        })
    }
}

impl Collection {
    /// Reads times and file names from the text of a PVD file.
    ///
    /// # Errors
    /// [`FrameError::Unreadable`] where a time is no number.
    pub fn from_pvd(text: &str) -> Result<Self, FrameError> {
        let mut frames = Vec::new();
        for element in text.split("<DataSet ").skip(1) {
            let time = attribute(element, "timestep").and_then(|time| time.parse::<f64>().ok());
            let file = attribute(element, "file");
            let (Some(time), Some(file)) = (time, file) else { return Err(unreadable("DataSet")) };
            frames.push((time, file.to_owned()));
        }
        Ok(Self { frames, provenance: Vec::new() })
    }
}

fn unreadable(part: &str) -> FrameError {
    FrameError::Unreadable { part: part.to_owned() }
}

fn section(text: &str, from: &str, to: &str) -> Result<(usize, usize), FrameError> {
    let start = text.find(from).ok_or_else(|| unreadable(from))? + from.len();
    let length = text[start..].find(to).ok_or_else(|| unreadable(to))?;
    Ok((start, start + length))
}

/// The value of `name="value"`.
fn attribute<'a>(element: &'a str, name: &str) -> Option<&'a str> {
    let (head, _) = element.split_once('>')?;
    let (_, rest) = head.split_once(&format!("{name}=\""))?;
    rest.split_once('"').map(|(value, _)| value)
}

/// Attributes and bytes of the array of a name.
fn array<'a>(text: &'a str, name: &str) -> Result<(&'a str, Vec<u8>), FrameError> {
    let fault = || unreadable(name);
    let element = text
        .split("<DataArray ")
        .skip(1)
        .find(|element| attribute(element, "Name") == Some(name))
        .ok_or_else(fault)?;
    let (_, body) = element.split_once('>').ok_or_else(fault)?;
    let (body, _) = body.split_once('<').ok_or_else(fault)?;
    let block = STANDARD.decode(body.trim()).map_err(|_| fault())?;
    let (size, bytes) = block.split_first_chunk::<8>().ok_or_else(fault)?;
    if u64::from_le_bytes(*size) != bytes.len() as u64 {
        return Err(fault());
    }
    Ok((element, bytes.to_vec()))
}

fn words(bytes: &[u8]) -> impl Iterator<Item = [u8; 8]> {
    bytes.chunks_exact(8).map(|word| std::array::from_fn(|i| word[i]))
}

fn floats(text: &str, name: &str) -> Result<FrameField, FrameError> {
    let (element, bytes) = array(text, name)?;
    let components = attribute(element, "NumberOfComponents").and_then(|n| n.parse().ok());
    Ok(FrameField {
        name: name.to_owned(),
        unit: attribute(element, "unit").unwrap_or("").to_owned(),
        components: components.ok_or_else(|| unreadable(name))?,
        values: words(&bytes).map(f64::from_le_bytes).collect(),
    })
}

fn vectors(values: &[f64]) -> Vec<Vec3> {
    values.chunks_exact(3).map(|x| Vec3::new(x[0], x[1], x[2])).collect()
}

/// Corners of the cells; none where every particle is a cell of its own.
fn hexahedra(text: &str) -> Result<Vec<[usize; 8]>, FrameError> {
    let (_, types) = array(text, "types")?;
    let (_, connectivity) = array(text, "connectivity")?;
    // An index is written from a `usize`.
    let corners: Vec<usize> = words(&connectivity).map(|word| i64::from_le_bytes(word) as usize).collect();
    if types.len() == corners.len() {
        return Ok(Vec::new());
    }
    Ok(corners.chunks_exact(8).map(|cell| std::array::from_fn(|i| cell[i])).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wedge() -> Frame {
        let reference: Vec<Vec3> = (0..8).map(|i| Vec3::new(f64::from(i), 0.5, -1.0)).collect();
        Frame {
            displacement: reference.iter().map(|x| 0.25 * x).collect(),
            hexahedra: vec![[0, 1, 2, 3, 4, 5, 6, 7]],
            fields: vec![
                FrameField::scalar("pressure", "Pa", &[1.0, -2.0, 3.0, 4.0, 5.0, 1e-300, 7.0, 8.0]),
                FrameField::vector("velocity", "m/s", &reference),
            ],
            reference,
            ..Frame::default()
        }
    }

    #[test]
    fn a_written_frame_reads_back_equal_with_cells_and_without() {
        let mut frame = wedge();
        for _ in 0..2 {
            let read = Frame::from_vtu(&frame.to_vtu().expect("sound")).expect("our own");
            assert_eq!(read, frame);
            frame.hexahedra.clear();
        }
    }

    #[test]
    fn a_collection_reads_back_equal() {
        let frames = vec![(0.0, "fields_0000.vtu".to_owned()), (6e-4, "fields_0001.vtu".to_owned())];
        let collection = Collection { frames, provenance: vec![] };
        assert_eq!(Collection::from_pvd(&collection.to_pvd()), Ok(collection));
    }

    #[test]
    fn a_damaged_frame_is_refused_with_the_part_that_is_damaged() {
        let text = wedge().to_vtu().expect("sound");
        let fault = |text: &str| Frame::from_vtu(text).expect_err("damaged").to_string();
        assert_eq!(fault("nothing"), "the frame cannot be read: `displacement` is missing or damaged");
        let cut = text.replace("Name=\"pressure\" NumberOfComponents=\"1\"", "Name=\"pressure\"");
        assert_eq!(fault(&cut), "the frame cannot be read: `pressure` is missing or damaged");
    }
}
