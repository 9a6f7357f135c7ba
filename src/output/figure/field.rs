//! What a figure of particle fields shows: deformed bodies coloured by a scalar.
//!
//! Owns the data and how it is taken from frames; drawing is in the neighbouring files.

use super::model::FigureError;
use super::surface::outer_faces;
use crate::output::frame::Frame;
use crate::tensor::Vec3;

/// Deformed bodies side by side, coloured by one field on one scale.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FieldFigure {
    /// Line above the panels; may be empty.
    pub title: String,
    /// What the colours mean.
    pub label: String,
    /// SI unit of the values; drawn with a prefix where it takes one.
    pub unit: String,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
    /// Panels in a row; at least 1.
    pub columns: usize,
    /// Where the eye is.
    pub view: View,
    /// Values at the ends of the colour bar; the least and largest value where absent. Values beyond
    /// take the colour of the end.
    pub range: Option<(f64, f64)>,
    /// Lines kept in the file: program, input, hash, scene.
    pub provenance: Vec<String>,
}

/// One deformed body.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Panel {
    /// Line below the body; may be empty.
    pub caption: String,
    /// Current positions, m.
    pub positions: Vec<Vec3>,
    /// One value a position, SI.
    pub values: Vec<f64>,
    /// Faces of the surface by their corners, anticlockwise from outside; a disc a position where there
    /// are none.
    pub faces: Vec<Vec<usize>>,
    /// Diameter of a disc, m.
    pub spacing: f64,
}

/// An orthographic view: unit vectors to the right and upwards on the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// To the right.
    pub right: Vec3,
    /// Upwards.
    pub up: Vec3,
}

impl Default for View {
    /// Along −z: x to the right, y upwards.
    fn default() -> Self {
        Self { right: Vec3::x(), up: Vec3::y() }
    }
}

impl View {
    /// From above one side: x mostly to the right, z upwards, y into the page.
    pub fn oblique() -> Self {
        let eye = Vec3::new(-0.45, -1.0, 0.55).normalize();
        let right = Vec3::z().cross(&eye).normalize();
        Self { right, up: eye.cross(&right) }
    }

    /// From the origin of a quarter model, above: its planes of symmetry x = 0 and y = 0 and its top.
    pub fn corner() -> Self {
        let eye = Vec3::new(-1.0, -0.75, 0.7).normalize();
        let right = Vec3::z().cross(&eye).normalize();
        Self { right, up: eye.cross(&right) }
    }

    /// Towards the eye.
    pub(super) fn towards(&self) -> Vec3 {
        self.right.cross(&self.up)
    }
}

impl Panel {
    /// The bodies of `frame` coloured by one component of a field, discs of diameter `spacing`.
    ///
    /// # Errors
    /// [`FigureError::NoField`] where the frame has no such field or component.
    pub fn new(
        caption: &str,
        frame: &Frame,
        field: &str,
        component: usize,
        spacing: f64,
    ) -> Result<Self, FigureError> {
        let found = frame.field(field).filter(|field| component < field.components);
        let Some(found) = found else {
            return Err(FigureError::NoField { field: field.to_owned(), component });
        };
        Ok(Self {
            caption: caption.to_owned(),
            positions: frame.positions(),
            values: found.values.iter().skip(component).step_by(found.components).copied().collect(),
            faces: outer_faces(&frame.hexahedra),
            spacing,
        })
    }

    /// The panel with its mirror image at the plane where coordinate `axis` is `at`, as a plane of
    /// symmetry shows the whole body; `is_odd` where the mirror turns the sign of the values.
    ///
    /// Positions on the plane belong to both sides, so that no seam is seen.
    #[must_use]
    pub fn mirrored(mut self, axis: usize, at: f64, is_odd: bool) -> Self {
        let extent = self.positions.iter().map(|x| (x[axis] - at).abs()).fold(0.0, f64::max);
        let on_plane: Vec<bool> =
            self.positions.iter().map(|x| (x[axis] - at).abs() <= ON_PLANE * extent).collect();
        let mut image_of = Vec::with_capacity(on_plane.len());
        for (i, &is_on_plane) in on_plane.iter().enumerate() {
            if is_on_plane && !self.faces.is_empty() {
                image_of.push(i);
                continue;
            }
            let mut image = self.positions[i];
            image[axis] = 2.0 * at - image[axis];
            image_of.push(self.positions.len());
            self.positions.push(image);
            self.values.push(if is_odd { -self.values[i] } else { self.values[i] });
        }
        self.faces.retain(|face| !face.iter().all(|&corner| on_plane[corner]));
        // a mirror image is seen the other way round
        let turned: Vec<Vec<usize>> = self
            .faces
            .iter()
            .map(|face| face.iter().rev().map(|&corner| image_of[corner]).collect())
            .collect();
        self.faces.extend(turned);
        self
    }
}

/// Share of the extent below which a position lies on a plane of symmetry.
const ON_PLANE: f64 = 1e-6;

impl FieldFigure {
    /// Whether the figure can be drawn.
    ///
    /// # Errors
    /// [`FigureError::Empty`], [`FigureError::NotFinite`], [`FigureError::Panel`].
    pub fn check(&self) -> Result<(), FigureError> {
        if self.panels.iter().all(|panel| panel.positions.is_empty()) {
            return Err(FigureError::Empty);
        }
        for panel in &self.panels {
            let points = panel.positions.len();
            let corners_exist =
                panel.faces.iter().all(|face| face.len() > 2 && face.iter().all(|&corner| corner < points));
            let needs_size = panel.faces.is_empty();
            let has_size = panel.spacing.is_finite() && panel.spacing > 0.0;
            if panel.values.len() != points || !corners_exist || (needs_size && !has_size) {
                return Err(FigureError::Panel { caption: panel.caption.clone() });
            }
            let is_finite =
                |i: &usize| panel.values[*i].is_finite() && panel.positions[*i].iter().all(|x| x.is_finite());
            if let Some(point) = (0..points).find(|i| !is_finite(i)) {
                return Err(FigureError::NotFinite { series: panel.caption.clone(), point });
            }
        }
        let is_range =
            self.range.is_none_or(|(low, high)| low.is_finite() && high.is_finite() && low <= high);
        if is_range { Ok(()) } else { Err(FigureError::Panel { caption: self.title.clone() }) }
    }

    /// Values at the ends of the colour bar.
    pub(super) fn values_range(&self) -> (f64, f64) {
        self.range.unwrap_or_else(|| {
            let all = || self.panels.iter().flat_map(|panel| &panel.values).copied();
            (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max))
        })
    }
}
