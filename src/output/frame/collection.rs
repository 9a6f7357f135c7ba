//! The frames of a run over time, as a PVD file that names them.
//!
//! Owns the list only; it reads none of the files it names.

use super::vtu::{comment, escaped};
use crate::output::table::number;

/// File names of frames with their times.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Collection {
    /// Time in s and file name relative to the collection, in order of time.
    pub frames: Vec<(f64, String)>,
    /// Lines at the head of the file: program, input, hash, scene.
    pub provenance: Vec<String>,
}

impl Collection {
    /// The name of the frame that would be added next: `fields_0003.vtu`.
    pub fn next_name(&self, stem: &str) -> String {
        format!("{stem}_{:04}.vtu", self.frames.len())
    }

    /// The collection as PVD.
    pub fn to_pvd(&self) -> String {
        let mut text = String::from("<?xml version=\"1.0\"?>\n");
        text.push_str(&comment(&self.provenance));
        text.push_str(
            "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n",
        );
        for (time, file) in &self.frames {
            let (time, file) = (number(*time), escaped(file));
            text.push_str(&format!("<DataSet timestep=\"{time}\" part=\"0\" file=\"{file}\"/>\n"));
        }
        text.push_str("</Collection>\n</VTKFile>\n");
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_collection_lists_its_frames_with_their_times() {
        let mut collection = Collection { provenance: vec!["tissue 0.1.0".into()], ..Collection::default() };
        for time in [0.0, 6e-4] {
            let name = collection.next_name("fields");
            collection.frames.push((time, name));
        }
        insta::assert_snapshot!(collection.to_pvd());
    }
}
