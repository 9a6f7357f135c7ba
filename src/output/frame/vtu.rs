//! A frame as a VTU file (VTK's XML unstructured grid).
//!
//! Owns the format: version 1.0, little endian, base64 inside the element, 64-bit sizes and floats,
//! no compression, so that the same frame gives the same bytes everywhere.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::model::{Frame, FrameError, FrameField};

/// VTK's number for a cell that is a point.
const VERTEX: u8 = 1;
/// VTK's number for a cell of eight corners.
const HEXAHEDRON: u8 = 12;

impl Frame {
    /// The frame as VTU, points at their current positions.
    ///
    /// # Errors
    /// As [`Frame::check`].
    pub fn to_vtu(&self) -> Result<String, FrameError> {
        self.check()?;
        let (connectivity, offsets, types) = self.cells();
        let fields = self.all_fields();
        let positions = FrameField::vector("position", "m", &self.positions());
        let mut text = String::from("<?xml version=\"1.0\"?>\n");
        text.push_str(&comment(&self.provenance));
        text.push_str(
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">\n<UnstructuredGrid>\n",
        );
        text.push_str(&format!(
            "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
            self.reference.len(),
            types.len()
        ));
        text.push_str("<PointData>\n");
        for field in &fields {
            text.push_str(&field_array(field));
        }
        text.push_str("</PointData>\n<Points>\n");
        text.push_str(&field_array(&positions));
        text.push_str("</Points>\n<Cells>\n");
        let bytes: Vec<u8> = connectivity.iter().flat_map(|i| i.to_le_bytes()).collect();
        text.push_str(&array("type=\"Int64\" Name=\"connectivity\"", &bytes));
        let bytes: Vec<u8> = offsets.iter().flat_map(|i| i.to_le_bytes()).collect();
        text.push_str(&array("type=\"Int64\" Name=\"offsets\"", &bytes));
        text.push_str(&array("type=\"UInt8\" Name=\"types\"", &types));
        text.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
        Ok(text)
    }

    /// Corners of all cells, the end of each cell in that list, and the kind of each.
    fn cells(&self) -> (Vec<i64>, Vec<i64>, Vec<u8>) {
        // An index is below the number of particles, far below 2^63.
        let index = |i: usize| i as i64;
        if self.hexahedra.is_empty() {
            let n = self.reference.len();
            return ((0..n).map(index).collect(), (1..=n).map(index).collect(), vec![VERTEX; n]);
        }
        let n = self.hexahedra.len();
        let connectivity = self.hexahedra.iter().flatten().copied().map(index).collect();
        (connectivity, (1..=n).map(|i| index(8 * i)).collect(), vec![HEXAHEDRON; n])
    }
}

/// A `DataArray` of 64-bit floats; the unit is an attribute of our own, which readers skip.
fn field_array(field: &FrameField) -> String {
    let mut attributes = format!(
        "type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\"",
        escaped(&field.name),
        field.components
    );
    for (i, name) in field.component_names().iter().enumerate() {
        attributes.push_str(&format!(" ComponentName{i}=\"{name}\""));
    }
    if !field.unit.is_empty() {
        attributes.push_str(&format!(" unit=\"{}\"", escaped(&field.unit)));
    }
    let bytes: Vec<u8> = field.values.iter().flat_map(|value| value.to_le_bytes()).collect();
    array(&attributes, &bytes)
}

/// A `DataArray` with its size in bytes and its bytes in one base64 text.
fn array(attributes: &str, bytes: &[u8]) -> String {
    let mut block = Vec::with_capacity(8 + bytes.len());
    block.extend_from_slice(&(bytes.len() as u64).to_le_bytes());
    block.extend_from_slice(bytes);
    format!("<DataArray {attributes} format=\"binary\">{}</DataArray>\n", STANDARD.encode(block))
}

/// Provenance as an XML comment, in which two hyphens may not stand together.
pub(super) fn comment(lines: &[String]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    let mut text = lines.join("\n");
    while text.contains("--") {
        text = text.replace("--", "- -");
    }
    format!("<!--\n{text}\n-->\n")
}

/// Text as an XML attribute value.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tensor::{Mat3, Vec3};
    use vtkio::model::{Attribute, CellType, DataSet, IOBuffer, Piece, UnstructuredGridPiece};

    fn cube() -> Frame {
        let corner = |i: usize| {
            let bit = |k: usize| ((i >> k) & 1) as f64;
            Vec3::new(bit(0), bit(1), bit(2))
        };
        let reference: Vec<Vec3> = (0..8).map(corner).collect();
        let displacement: Vec<Vec3> =
            reference.iter().map(|x| Vec3::new(0.1 * x.y, 0.0, -1.0 / 3.0)).collect();
        let stress: Vec<Mat3> =
            (0..8).map(|i| Mat3::from_fn(|r, c| (r + c) as f64 + i as f64 / 7.0)).collect();
        Frame {
            time: 1e-3,
            reference,
            displacement,
            hexahedra: vec![],
            fields: vec![
                FrameField::symmetric("sigma", "Pa", &stress),
                FrameField::tensor("F", "", &stress),
                FrameField::scalar("pressure", "Pa", &[0.0, 1e-300, -1e5, 3.0, 4.0, 5.0, 6.0, 7.0]),
            ],
            provenance: vec!["tissue 0.1.0".into(), "input a--b.tissue".into()],
        }
    }

    /// The piece as another implementation reads it.
    fn read_back(text: &str) -> UnstructuredGridPiece {
        let vtk = vtkio::Vtk::parse_xml(text.as_bytes()).expect("vtkio reads it");
        let DataSet::UnstructuredGrid { mut pieces, .. } = vtk.data else { panic!("another kind of data") };
        let Some(Piece::Inline(piece)) = pieces.pop() else { panic!("no piece inside the file") };
        *piece
    }

    fn values(piece: &UnstructuredGridPiece, name: &str) -> Vec<f64> {
        let array = piece.data.point.iter().find_map(|attribute| match attribute {
            Attribute::DataArray(array) if array.name == name => Some(array),
            _ => None,
        });
        floats(&array.expect("the field is there").data)
    }

    fn floats(buffer: &IOBuffer) -> Vec<f64> {
        let IOBuffer::F64(values) = buffer else { panic!("not 64-bit floats") };
        values.clone()
    }

    #[test]
    fn another_implementation_reads_back_points_fields_and_vertices_bit_by_bit() {
        let frame = cube();
        let piece = read_back(&frame.to_vtu().expect("consistent"));
        let positions: Vec<f64> = frame.positions().iter().flat_map(|x| [x.x, x.y, x.z]).collect();
        assert_eq!(floats(&piece.points), positions);
        for field in frame.all_fields() {
            assert_eq!(values(&piece, &field.name), field.values, "{}", field.name);
        }
        assert_eq!(piece.cells.types, vec![CellType::Vertex; 8]);
        let mut other = frame;
        other.fields[0].values[5] += 1e-15;
        assert_ne!(values(&piece, "sigma"), other.fields[0].values);
    }

    #[test]
    fn another_implementation_reads_back_hexahedra() {
        let corners = [0, 1, 3, 2, 4, 5, 7, 6];
        let frame = Frame { hexahedra: vec![corners, corners], ..cube() };
        let piece = read_back(&frame.to_vtu().expect("consistent"));
        assert_eq!(piece.cells.types, vec![CellType::Hexahedron; 2]);
        let (connectivity, offsets) = piece.cells.cell_verts.into_xml();
        assert_eq!(connectivity, [corners, corners].concat().iter().map(|&i| i as u64).collect::<Vec<_>>());
        assert_eq!(offsets, [8, 16]);
    }

    #[test]
    fn a_symmetric_tensor_has_the_component_order_of_vtk() {
        let m = Mat3::new(1.0, 4.0, 6.0, 4.0, 2.0, 5.0, 6.0, 5.0, 3.0);
        let field = FrameField::symmetric("sigma", "Pa", &[m]);
        assert_eq!(field.values, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        let text = field_array(&field);
        assert!(
            text.contains("ComponentName3=\"xy\" ComponentName4=\"yz\" ComponentName5=\"xz\" unit=\"Pa\"")
        );
        let field = FrameField::tensor("F", "", &[Mat3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)]);
        assert_eq!(field.values, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
    }

    #[test]
    fn a_frame_that_does_not_fit_is_refused_with_what_and_where() {
        let fault = |change: fn(&mut Frame)| {
            let mut frame = cube();
            change(&mut frame);
            frame.to_vtu().expect_err("unfit").to_string()
        };
        assert_eq!(
            fault(|f| f.fields[0].values[13] = f64::NAN),
            "field `sigma` is not finite at particle 2, X = (0.0000e0, 1.0000e0, 0.0000e0) m, t = 1.0000e-3 s"
        );
        assert_eq!(
            fault(|f| f.fields[2].components = 3),
            "field `pressure` has 8 values, but 24 are required"
        );
        assert_eq!(
            fault(|f| f.fields[2].components = 2),
            "field `pressure` has 2 components, but 1, 3, 6 or 9 are required"
        );
        assert_eq!(
            fault(|f| f.fields[1].name = "displacement".into()),
            "two fields of a frame are named `displacement`"
        );
        assert_eq!(fault(|f| f.hexahedra.push([8; 8])), "cell 0 names corner 8, but there are 8 particles");
        assert_eq!(
            fault(|f| f.displacement.truncate(7)),
            "field `displacement` has 21 values, but 24 are required"
        );
    }

    #[test]
    fn the_file_says_where_it_comes_from() {
        let text = cube().to_vtu().expect("consistent");
        assert!(text.contains("<!--\ntissue 0.1.0\ninput a- -b.tissue\n-->"));
    }
}
