//! `panel`: a field on the deformed bodies.

use super::super::super::file::Reported;
use super::super::super::members::{Members, Site};
use super::super::super::model::{Field, FieldPanel, FieldPicture, Moment, Viewpoint};
use super::super::super::words::{PANEL, PLOT};
use super::super::fields::written_field;
use super::super::stage::Stage;
use super::{column_dimension, column_name, dotted};
use crate::schema::nearest;
use crate::syntax::{BinaryOperator, Block, Code, ExprKind};
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

impl Stage<'_> {
    pub(super) fn fields_of(
        &mut self,
        block: &Block,
        members: &Members,
    ) -> Result<Option<FieldPicture>, Reported> {
        let file = Rc::clone(&self.file);
        let panels: Vec<&Block> =
            members.blocks.iter().copied().filter(|inner| inner.kind.text == "panel").collect();
        if panels.is_empty() {
            return match members.written("field") {
                None => Ok(None),
                Some(_) => {
                    let message = "a `field` is shown in panels, but the plot has none";
                    let help = Some("write `panel name { frames = fields }`".into());
                    let span = block.kind.span.clone();
                    Err(self.mistakes.report(&file, Code::MissingKey, span, message, "", help))
                }
            };
        }
        let Some(site) = members.written("field") else {
            let message = "the plot has panels, but no `field` that colours them";
            let help = Some("write `field = pressure`".into());
            let span = block.kind.span.clone();
            return Err(self.mistakes.report(&file, Code::MissingKey, span, message, "", help));
        };
        let (field, dimension) = written_field(self.mistakes, &site.file, site.id)?;
        let written = site.file.expression(site.id).to_string();
        let view = match members.written("view") {
            Some(site) => viewpoint(self.choice(site, &PLOT, "view")?),
            None => Viewpoint::Plane(0, 1),
        };
        let mirror = match members.written("mirror") {
            Some(site) => Some(self.chosen_list(site, &PLOT, "mirror")?),
            None => None,
        };
        let columns = match members.written("columns") {
            Some(site) => self.count(site, "columns")?,
            None => 1,
        };
        let range = self.range(members, "range", dimension)?;
        let label = self.text(members, "label")?.unwrap_or_else(|| written.clone());
        let mut read = Vec::new();
        for panel in panels {
            read.push(self.panel(panel, field, mirror.as_deref())?);
        }
        Ok(Some(FieldPicture {
            field,
            label,
            unit: dimension.si_symbol(),
            range,
            view,
            columns: columns as usize,
            panels: read,
        }))
    }

    fn panel(
        &mut self,
        block: &Block,
        field: Field,
        mirror: Option<&[&'static str]>,
    ) -> Result<FieldPanel, Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &PANEL, block);
        let site = members.required(self.mistakes, &file, &PANEL, block, "frames")?;
        let Some(name) = dotted(&site.file, site.id) else {
            let message = "the name of frames is required";
            let span = site.file.span(site.id);
            return Err(self.mistakes.report(&site.file, Code::WrongForm, span, message, "", None));
        };
        let known = self.known_frames();
        let Some((_, values, symmetry)) = known.iter().find(|(known, ..)| *known == name.text) else {
            let names = || known.iter().map(|(name, ..)| name.as_str());
            let help = match nearest(&name.text, names()) {
                Some(meant) => Some(format!("write `{meant}`")),
                None if known.is_empty() => Some("write `frames name { … }` in the scene".into()),
                None => Some(format!("the frames are {}", names().collect::<Vec<_>>().join(", "))),
            };
            let message = format!("there are no frames `{}`", name.text);
            return Err(self.mistakes.report(&site.file, Code::UnknownName, name.span, message, "", help));
        };
        let (kept, _) = field.stored();
        if kept != "displacement" && !values.iter().any(|value| value == kept) {
            let message = format!("the frames `{}` do not hold `{kept}`", name.text);
            let help = Some(format!("they hold {}; add `{kept}` to their `values`", values.join(", ")));
            return Err(self.mistakes.report(&site.file, Code::UnknownName, name.span, message, "", help));
        }
        let wanted = |axis: usize| mirror.is_none_or(|axes| axes.contains(&["x", "y", "z"][axis]));
        let mirrors = (0..3_u8)
            .filter(|&axis| wanted(usize::from(axis)))
            .filter_map(|axis| symmetry[usize::from(axis)].map(|at| (axis, at)))
            .collect();
        let moment = self.moment(&members)?;
        let caption = self.text(&members, "caption")?.unwrap_or_default();
        Ok(FieldPanel { frames: name.text, moment, caption, mirrors })
    }

    /// `time = 0.1 s`, `when = record.column == value`, or the last frame.
    fn moment(&mut self, members: &Members) -> Result<Moment, Reported> {
        match (members.written("time"), members.written("when")) {
            (None, None) => Ok(Moment::Last),
            (Some(site), None) => {
                let time = self.constant(site, "time", Dimension::TIME)?;
                let until = self.run.as_ref().map_or(f64::INFINITY, |run| run.until);
                if time > until * (1.0 + 1e-12) {
                    let said = |value| Quantity::new(value, Dimension::TIME);
                    let message = format!("the run ends at {}, before {}", said(until), said(time));
                    let span = site.file.span(site.id);
                    let (code, label) = (Code::AfterEnd, "too late");
                    return Err(self.mistakes.report(&site.file, code, span, message, label, None));
                }
                Ok(Moment::Time(time))
            }
            (None, Some(site)) => self.when(site),
            (Some(_), Some(site)) => {
                let message = "a panel has either `time` or `when`";
                let span = site.file.span(site.id);
                Err(self.mistakes.report(&site.file, Code::WrongForm, span, message, "", None))
            }
        }
    }

    fn when(&mut self, site: &Site) -> Result<Moment, Reported> {
        let ExprKind::Binary { operator: BinaryOperator::Equal, left, right, .. } =
            &site.file.tree.expr(site.id).kind
        else {
            let message = "`when` is a column and the value it takes";
            let help = Some("write `when = record.column == value`".into());
            let span = site.file.span(site.id);
            return Err(self.mistakes.report(&site.file, Code::WrongForm, span, message, "", help));
        };
        let name = column_name(self.mistakes, &site.file, *left)?;
        let dimension = column_dimension(self.mistakes, &self.columns, &site.file, &name)?;
        let value = self.constant(&Site { file: Rc::clone(&site.file), id: *right }, "when", dimension)?;
        Ok(Moment::When { record: name.table.text, column: name.column.text, value })
    }

    /// Frames by name, with the fields they hold and the planes of symmetry of their scene.
    fn known_frames(&self) -> Vec<(String, Vec<String>, [Option<f64>; 3])> {
        let of = |prefix: &str, scene: &crate::scene::Scene| {
            let planes = scene.symmetry.each_ref().map(|plane| plane.as_ref().map(|plane| plane.at));
            let named = |name: &str| match prefix {
                "" => name.to_string(),
                prefix => format!("{prefix}.{name}"),
            };
            let frames = scene.frames.iter();
            frames.map(move |frames| (named(&frames.name), frames.values.clone(), planes)).collect::<Vec<_>>()
        };
        let own = of("", &self.scene);
        own.into_iter().chain(self.sources.iter().flat_map(|(name, scene)| of(name, scene))).collect()
    }
}

fn viewpoint(word: &str) -> Viewpoint {
    match word {
        "xz" => Viewpoint::Plane(0, 2),
        "yz" => Viewpoint::Plane(1, 2),
        "oblique" => Viewpoint::Oblique,
        "corner" => Viewpoint::Corner,
        _ => Viewpoint::Plane(0, 1),
    }
}
