//! `path = uniaxial(e1, stretch = 1 .. 1.5, steps = 100)` and its kin.

use super::super::evaluate::{Elsewhere, Evaluator, Required};
use super::super::file::Reported;
use super::super::members::Site;
use super::super::model::{Material, Path, PathParameter};
use super::super::scenes::Stage;
use super::super::words::PATHS;
use super::scope::PathScope;
use super::{frame, target};
use crate::schema::nearest;
use crate::syntax::{Argument, BinaryOperator, Code, ExprId, ExprKind, Name, Span};
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

/// A path that has been read.
pub(super) struct Way {
    pub(super) path: Path,
    pub(super) axes: [[f64; 3]; 2],
    pub(super) parameter: String,
    pub(super) dimension: Dimension,
    pub(super) range: (f64, f64),
    pub(super) steps: u32,
    /// The path as written, on one line.
    pub(super) written: String,
    pub(super) site: Site,
    pub(super) span: Span,
}

/// Most points of a path.
const MOST_STEPS: f64 = 1e6;

/// How a path is written.
struct Form {
    /// Least and greatest number of directions.
    directions: (usize, usize),
    /// Name of the parameter; `None` if the file chooses it.
    parameter: Option<&'static str>,
    /// Further arguments it must have.
    keys: &'static [&'static str],
}

fn form(word: &str) -> Option<Form> {
    let form = |directions, parameter, keys| Some(Form { directions, parameter, keys });
    match word {
        "uniaxial" => form((1, 2), Some("stretch"), &[]),
        "biaxial" => form((2, 2), Some("stretch"), &["ratio"]),
        "equibiaxial" | "planar" => form((2, 2), Some("stretch"), &[]),
        "simple_shear" => form((2, 2), Some("amount"), &[]),
        "deformation" => form((0, 2), None, &["F"]),
        _ => None,
    }
}

/// Reads a path.
pub(super) fn read(stage: &mut Stage, site: &Site, material: Option<&Material>) -> Result<Way, Reported> {
    let file = Rc::clone(&site.file);
    let ExprKind::Call { function, arguments } = &file.tree.expr(site.id).kind else {
        let words: Vec<&str> = PATHS.iter().map(|path| path.word).collect();
        let help = Some(format!("write one of {} with its arguments", words.join(", ")));
        let message = "`path` says where the point is led";
        return Err(stage.mistakes.report(&file, Code::WrongForm, file.span(site.id), message, "", help));
    };
    let Some(form) = form(&function.text) else {
        let words: Vec<&str> = PATHS.iter().map(|path| path.word).collect();
        let help = match nearest(&function.text, words.iter().copied()) {
            Some(meant) => format!("write `{meant}(…)`"),
            None => format!("the paths are {}", words.join(", ")),
        };
        let message = format!("there is no path `{}`", function.text);
        let span = function.span.clone();
        return Err(stage.mistakes.report(&file, Code::UnknownFunction, span, message, "", Some(help)));
    };
    let named = frame::named(material);
    let mut reader = Reader { stage, site, function, form, named };
    let sorted = reader.sort(arguments)?;
    // Without its material the names of directions mean nothing.
    let axes = match material {
        Some(_) => frame::axes(reader.stage, site, &reader.named, &sorted.directions),
        None => Err(Reported),
    };
    let range = reader.range(&sorted);
    let steps = reader.steps(sorted.keys.get("steps").copied());
    let (parameter, dimension, range) = range?;
    let path = reader.path(&sorted, (&parameter, dimension, range));
    let written = file.expression(site.id).split_whitespace().collect::<Vec<_>>().join(" ");
    Ok(Way {
        path: path?,
        axes: axes?,
        parameter,
        dimension,
        range,
        steps: steps?,
        written,
        site: site.clone(),
        span: file.span(site.id),
    })
}

/// The arguments of a path by what they are.
struct Sorted {
    directions: Vec<ExprId>,
    keys: BTreeMap<String, ExprId>,
    /// The parameter: its name and its range.
    parameter: Option<(Name, ExprId)>,
}

struct Reader<'s, 'a, 'r> {
    stage: &'s mut Stage<'a>,
    site: &'r Site,
    function: &'r Name,
    form: Form,
    named: BTreeMap<String, [f64; 3]>,
}

impl Reader<'_, '_, '_> {
    fn report(&mut self, code: Code, span: Span, message: String, help: Option<String>) -> Reported {
        self.stage.mistakes.report(&self.site.file, code, span, message, "", help)
    }

    fn sort(&mut self, arguments: &[Argument]) -> Result<Sorted, Reported> {
        let mut sorted = Sorted { directions: Vec::new(), keys: BTreeMap::new(), parameter: None };
        let mut sound = true;
        for argument in arguments {
            let Some(name) = argument.name.as_ref().and_then(|path| path.parts.first()) else {
                sorted.directions.push(argument.value);
                continue;
            };
            let key = name.text.as_str();
            let known = key == "steps" || self.form.keys.contains(&key);
            let parameter = self.form.parameter.is_none_or(|parameter| parameter == key);
            let twice = sorted.keys.contains_key(key) || (parameter && !known && sorted.parameter.is_some());
            if twice {
                let message = if sorted.keys.contains_key(key) || self.form.parameter.is_some() {
                    format!("`{key}` is given twice")
                } else {
                    let first = sorted.parameter.as_ref().map_or("", |(name, _)| name.text.as_str());
                    format!("a path has one parameter: `{first}` or `{key}`")
                };
                self.report(Code::DuplicateName, name.span.clone(), message, None);
                sound = false;
            } else if known {
                sorted.keys.insert(key.into(), argument.value);
            } else if parameter {
                sorted.parameter = Some((name.clone(), argument.value));
            } else {
                let keys =
                    self.form.parameter.into_iter().chain(self.form.keys.iter().copied()).chain(["steps"]);
                let meant = nearest(key, keys).map(|meant| format!("write `{meant}`"));
                let help = meant
                    .or_else(|| Some(format!("`{}` is written `{}`", self.function.text, self.written())));
                let message = format!("`{}` has no argument `{key}`", self.function.text);
                self.report(Code::UnknownArgument, name.span.clone(), message, help);
                sound = false;
            }
        }
        let (least, most) = self.form.directions;
        let found = sorted.directions.len();
        if found < least || found > most || (least == 0 && found == 1) {
            let required = match (least, most) {
                (0, _) => "no direction or two".to_string(),
                (1, _) => "one direction or two".to_string(),
                _ => "two directions".to_string(),
            };
            let message = format!("`{}` takes {required}, but {found} are given", self.function.text);
            let help = Some(format!("it is written `{}`", self.written()));
            self.report(Code::WrongForm, self.function.span.clone(), message, help);
            sound = false;
        }
        for key in ["steps"].iter().chain(self.form.keys) {
            if !sorted.keys.contains_key(*key) {
                // What is misspelt is there, and has been reported.
                sound &= !sound || self.missing(key).is_ok();
            }
        }
        if sorted.parameter.is_none() && sound {
            let parameter = self.form.parameter.unwrap_or("a parameter");
            sound &= self.missing(parameter).is_ok();
        }
        if sound { Ok(sorted) } else { Err(Reported) }
    }

    fn missing(&mut self, key: &str) -> Result<(), Reported> {
        let message = if key.contains(' ') {
            format!("`{}` needs {key}", self.function.text)
        } else {
            format!("`{}` needs `{key}`", self.function.text)
        };
        let help = Some(format!("it is written `{}`", self.written()));
        Err(self.report(Code::MissingArgument, self.function.span.clone(), message, help))
    }

    /// How the path is written, from the vocabulary.
    fn written(&self) -> &'static str {
        PATHS.iter().find(|path| path.word == self.function.text).map_or("", |path| path.form)
    }

    /// `1 .. 1.5`: two different values of one dimension.
    fn range(&mut self, sorted: &Sorted) -> Result<(String, Dimension, (f64, f64)), Reported> {
        let (name, id) = sorted.parameter.as_ref().ok_or(Reported)?;
        let file = Rc::clone(&self.site.file);
        let ExprKind::Binary { operator: BinaryOperator::Range, left, right, .. } = &file.tree.expr(*id).kind
        else {
            let message = format!("`{}` runs from one value to another", name.text);
            let help = Some(format!(
                "write `{} = 1 .. {}` with the ends that are meant",
                name.text,
                file.expression(*id)
            ));
            return Err(self.report(Code::WrongForm, file.span(*id), message, help));
        };
        let dimension = match self.form.parameter {
            Some(_) => Dimension::NUMBER,
            None => self.dimension(*left)?,
        };
        let (from, to) =
            (self.constant(*left, &name.text, dimension), self.constant(*right, &name.text, dimension));
        let (from, to) = (from?, to?);
        if from == to {
            let message = format!("`{}` must run between two different values", name.text);
            return Err(self.report(Code::WrongForm, file.span(*id), message, None));
        }
        if name.text == "stretch" && self.form.parameter.is_some() {
            for (value, id) in [(from, *left), (to, *right)] {
                self.positive("a stretch", value, id)?;
            }
        }
        Ok((name.text.clone(), dimension, (from, to)))
    }

    fn positive(&mut self, what: &str, value: f64, id: ExprId) -> Result<(), Reported> {
        if value > 0.0 {
            return Ok(());
        }
        let message = format!("{what} must be > 0, but the value is {value}");
        let span = self.site.file.span(id);
        Err(self.report(Code::ParameterOutOfRange, span, message, None))
    }

    fn dimension(&mut self, id: ExprId) -> Result<Dimension, Reported> {
        self.evaluate(|evaluator, scope| Ok(evaluator.scalar(scope, id)?.dimension))
    }

    fn constant(&mut self, id: ExprId, name: &str, dimension: Dimension) -> Result<f64, Reported> {
        self.evaluate(|evaluator, scope| evaluator.constant(scope, id, Required { name, dimension }))
    }

    fn evaluate<T>(
        &mut self,
        run: impl FnOnce(&mut Evaluator<PathParameter>, &Elsewhere<PathParameter>) -> Result<T, Reported>,
    ) -> Result<T, Reported> {
        let (file, lets) = (&self.stage.file, self.stage.lets.fresh());
        let home = PathScope { file, lets, directions: &self.named, parameter: None };
        let scope = Elsewhere { outer: &home, file: Rc::clone(&self.site.file) };
        run(&mut Evaluator::new(self.stage.mistakes), &scope)
    }

    fn steps(&mut self, id: Option<ExprId>) -> Result<u32, Reported> {
        let id = id.ok_or(Reported)?;
        let value = self.constant(id, "steps", Dimension::NUMBER)?;
        if value >= 1.0 && value.fract() == 0.0 && value <= MOST_STEPS {
            return Ok(value as u32);
        }
        let message = format!("`steps` must be a whole number from 1 to 1000000, but the value is {value}");
        Err(self.report(Code::ParameterOutOfRange, self.site.file.span(id), message, None))
    }

    fn path(
        &mut self,
        sorted: &Sorted,
        (parameter, dimension, range): (&str, Dimension, (f64, f64)),
    ) -> Result<Path, Reported> {
        match self.function.text.as_str() {
            "uniaxial" => Ok(Path::Uniaxial),
            "equibiaxial" => Ok(Path::Equibiaxial),
            "planar" => Ok(Path::Planar),
            "simple_shear" => Ok(Path::SimpleShear),
            "biaxial" => {
                let id = *sorted.keys.get("ratio").ok_or(Reported)?;
                let ratio = self.constant(id, "ratio", Dimension::NUMBER)?;
                for stretch in [range.0, range.1] {
                    self.positive(
                        "the stretch along the second direction",
                        1.0 + ratio * (stretch - 1.0),
                        id,
                    )?;
                }
                Ok(Path::Biaxial { ratio })
            }
            _ => {
                let id = *sorted.keys.get("F").ok_or(Reported)?;
                if self.named.contains_key(parameter) {
                    let message = format!("`{parameter}` is a direction already");
                    let span = sorted
                        .parameter
                        .as_ref()
                        .map_or(self.function.span.clone(), |(name, _)| name.span.clone());
                    return Err(self.report(
                        Code::DuplicateName,
                        span,
                        message,
                        Some("choose another name".into()),
                    ));
                }
                let home = PathScope {
                    file: &self.stage.file,
                    lets: self.stage.lets.fresh(),
                    directions: &self.named,
                    parameter: Some((parameter, dimension)),
                };
                let scope = Elsewhere { outer: &home, file: Rc::clone(&self.site.file) };
                target::deformation(self.stage.mistakes, &scope, id).map(Path::Deformation)
            }
        }
    }
}
