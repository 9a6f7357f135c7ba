//! A scene under construction.

use super::super::evaluate::{Elsewhere, Evaluator, Lets, Required, Scope};
use super::super::file::{File, Mistakes, Reported};
use super::super::loader::Loader;
use super::super::materials::Materials;
use super::super::members::{Members, Overrides, Site, duplicate};
use super::super::model::*;
use super::super::session::{Module, Session};
use super::records::TIME;
use super::scope::SceneScope;
use super::tables::Tables;
use crate::expression::{Node, Tape};
use crate::schema::{Choice, Declaration, Kind, nearest};
use crate::syntax::{Block, Code, ExprId, ExprKind, Name, Span};
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The dimensions of the columns of each record, by name; `None` where a column is wrong.
pub(in crate::scene) type Records = BTreeMap<String, BTreeMap<String, Option<Dimension>>>;

/// A scene under construction.
pub(in crate::scene) struct Stage<'a> {
    pub(in crate::scene) mistakes: &'a mut Mistakes,
    pub(in crate::scene) overrides: &'a Overrides,
    pub(super) loader: &'a dyn Loader,
    pub(in crate::scene) file: Rc<File>,
    pub(in crate::scene) name: Name,
    pub(in crate::scene) lets: Lets,
    pub(in crate::scene) materials: &'a Materials,
    /// Tables read by `let name = csv(…)`; `None` where one could not be read.
    pub(in crate::scene) tables: Tables,
    /// Names of bodies, of those that are wrong as well.
    pub(super) body_names: Vec<Name>,
    /// Dimensions of the columns of each record; `None` where a column is wrong.
    pub(in crate::scene) columns: Records,
    /// The column every table begins with: `t`, or the parameter of a drive.
    pub(in crate::scene) abscissa: String,
    /// Columns of the varied values of a sweep, the first the one an order runs over.
    pub(in crate::scene) varied: Vec<String>,
    /// What a fit finds, by name: dimensions of parameters and of numbers of its own.
    pub(in crate::scene) fitted: BTreeMap<String, Dimension>,
    /// Names of records, frames and plots.
    pub(super) outputs: BTreeMap<String, Name>,
    /// Where each prescribed motion is written, in the order of the scene's.
    pub(super) sites: Vec<Span>,
    /// Where each load is written, in the order of the scene's.
    pub(super) load_sites: Vec<Span>,
    /// Where ramps stand and when they end, s.
    pub(super) ramps: Vec<(Rc<File>, Span, f64)>,
    /// Where `until` is written.
    pub(super) until: Option<(Rc<File>, Span)>,
    pub(super) run: Option<Run>,
    pub(super) run_seen: Option<Name>,
    pub(super) single: BTreeMap<String, Name>,
    /// Scenes of the sources of a figure.
    pub(in crate::scene) sources: BTreeMap<String, Scene>,
    /// Names of the sources of a figure.
    pub(in crate::scene) source_names: BTreeMap<String, Name>,
    pub(in crate::scene) scene: Scene,
}

impl<'a> Stage<'a> {
    pub(in crate::scene) fn new(
        session: &'a mut Session,
        file: &Rc<File>,
        name: &Name,
        module: &'a Module,
        members: &Members,
    ) -> Self {
        let mut stage = Self {
            mistakes: &mut session.mistakes,
            overrides: &session.overrides,
            loader: session.loader,
            file: Rc::clone(file),
            name: name.clone(),
            lets: Lets::default(),
            materials: &module.materials,
            tables: BTreeMap::new(),
            body_names: Vec::new(),
            columns: BTreeMap::new(),
            abscissa: TIME.into(),
            varied: Vec::new(),
            fitted: BTreeMap::new(),
            outputs: BTreeMap::new(),
            sites: Vec::new(),
            load_sites: Vec::new(),
            ramps: Vec::new(),
            until: None,
            run: None,
            run_seen: None,
            single: BTreeMap::new(),
            sources: BTreeMap::new(),
            source_names: BTreeMap::new(),
            scene: Scene {
                name: name.text.clone(),
                place: file.place(&name.span),
                materials: Vec::new(),
                bodies: Vec::new(),
                symmetry: [None, None, None],
                bonds: Vec::new(),
                prescribed: Vec::new(),
                loads: Vec::new(),
                starts: Vec::new(),
                motion: None,
                run: Run::placeholder(),
                records: Vec::new(),
                frames: Vec::new(),
                plots: Vec::new(),
                expectations: Vec::new(),
            },
        };
        let mut lets = members.lets.clone();
        lets.retain(|name, definition| {
            let is_table = matches!(&file.tree.expr(definition.value).kind,
                ExprKind::Call { function, .. } if function.text == "csv");
            if is_table {
                let table = stage.table(definition.value).ok().map(Rc::new);
                stage.tables.insert(name.clone(), table);
            }
            !is_table
        });
        stage.lets = Lets::new(lets);
        stage
    }

    /// The scene, if it has what every scene needs.
    pub(super) fn finish(mut self, block: &Block) -> Result<Scene, Reported> {
        let span = block.kind.span.start..self.name.span.end;
        let title = format!("`scene {}`", self.name.text);
        if self.body_names.is_empty() {
            let help = "write `body name { shape = …  spacing = …  material = … }`";
            self.mistakes.report(
                &self.file,
                Code::MissingKey,
                span.clone(),
                format!("{title} needs a body"),
                "",
                Some(help.into()),
            );
        }
        if self.run_seen.is_none() {
            let help = "write `run { until = 1 s }` with the end time that is meant";
            self.mistakes.report(
                &self.file,
                Code::MissingKey,
                span,
                format!("{title} needs `run`"),
                "no end time",
                Some(help.into()),
            );
        }
        self.refuse_conflicts();
        self.refuse_idle_tractions();
        self.refuse_late_ramps();
        self.scene.run = self.run.ok_or(Reported)?;
        Ok(self.scene)
    }

    /// Evaluates something that needs an evaluator over coordinates.
    pub(super) fn evaluate<T>(
        &mut self,
        site: &Site,
        (place, time): (bool, bool),
        run: impl FnOnce(&mut Evaluator<Coordinate>, &dyn Scope<Coordinate>, ExprId) -> Result<T, Reported>,
    ) -> Result<T, Reported> {
        let home =
            SceneScope { file: &self.file, lets: self.lets.fresh(), tables: &self.tables, place, time };
        let scope = Elsewhere { outer: &home, file: Rc::clone(&site.file) };
        let mut evaluator = Evaluator::new(self.mistakes);
        let result = run(&mut evaluator, &scope, site.id);
        self.ramps.append(&mut evaluator.ramps);
        result
    }

    /// One fixed value.
    pub(in crate::scene) fn constant(
        &mut self,
        site: &Site,
        name: &str,
        dimension: Dimension,
    ) -> Result<f64, Reported> {
        self.evaluate(site, (false, false), |e, scope, id| {
            e.constant(scope, id, Required { name, dimension })
        })
    }

    /// Three fixed values.
    pub(super) fn constants(
        &mut self,
        site: &Site,
        name: &str,
        dimension: Dimension,
    ) -> Result<[f64; 3], Reported> {
        self.evaluate(site, (false, false), |e, scope, id| {
            e.constant_vector(scope, id, Required { name, dimension })
        })
    }

    /// One formula over place and time.
    pub(super) fn field(
        &mut self,
        site: &Site,
        name: &str,
        dimension: Dimension,
        depends: (bool, bool),
    ) -> Result<Tape<Coordinate>, Reported> {
        let field = self.evaluate(site, depends, |e, scope, id| {
            let scalar = e.quantity(scope, id, Required { name, dimension })?;
            Ok(e.tape(scalar))
        })?;
        self.refuse_infinite(site, name, std::slice::from_ref(&field))?;
        Ok(field)
    }

    /// Refuses formulas with a number that is none, such as `1/0`.
    fn refuse_infinite(
        &mut self,
        site: &Site,
        name: &str,
        formulas: &[Tape<Coordinate>],
    ) -> Result<(), Reported> {
        let mut nodes = formulas.iter().flat_map(Tape::nodes);
        let broken = nodes.find_map(|node| match node {
            Node::Constant(value) if !value.is_finite() => Some(*value),
            _ => None,
        });
        let Some(value) = broken else { return Ok(()) };
        let message = format!("`{name}` holds a part whose value is {value}");
        let help = Some("write no division by 0, and roots and logarithms of positive numbers only".into());
        let span = site.file.span(site.id);
        Err(self.mistakes.report(&site.file, Code::ParameterOutOfRange, span, message, "not finite", help))
    }

    /// Three formulas over place and time.
    pub(super) fn fields(
        &mut self,
        site: &Site,
        name: &str,
        dimension: Dimension,
        depends: (bool, bool),
    ) -> Result<[Tape<Coordinate>; 3], Reported> {
        let fields = self.evaluate(site, depends, |e, scope, id| {
            let vector = e.vector_quantity(scope, id, Required { name, dimension })?;
            Ok(vector.map(|component| e.tape(component)))
        })?;
        self.refuse_infinite(site, name, &fields)?;
        Ok(fields)
    }

    /// One of the words a key allows.
    pub(in crate::scene) fn choice(
        &mut self,
        site: &Site,
        declaration: &Declaration,
        key: &str,
    ) -> Result<&'static str, Reported> {
        let choices = choices(declaration, key);
        self.chosen(&site.file, site.id, key, choices)
    }

    /// Several of the words a key allows.
    pub(in crate::scene) fn chosen_list(
        &mut self,
        site: &Site,
        declaration: &Declaration,
        key: &str,
    ) -> Result<Vec<&'static str>, Reported> {
        let choices = choices(declaration, key);
        let ids = match &site.file.tree.expr(site.id).kind {
            ExprKind::List(ids) => ids.clone(),
            _ => vec![site.id],
        };
        let mut words = Vec::new();
        for id in ids {
            let word = self.chosen(&site.file, id, key, choices)?;
            if words.contains(&word) {
                let message = format!("`{word}` stands twice in `{key}`");
                return Err(self.mistakes.report(
                    &site.file,
                    Code::DuplicateName,
                    site.file.span(id),
                    message,
                    "",
                    None,
                ));
            }
            words.push(word);
        }
        Ok(words)
    }

    fn chosen(
        &mut self,
        file: &File,
        id: ExprId,
        key: &str,
        choices: &'static [Choice],
    ) -> Result<&'static str, Reported> {
        let written = match &file.tree.expr(id).kind {
            ExprKind::Name(word) => word.as_str(),
            _ => file.expression(id),
        };
        if let Some(choice) = choices.iter().find(|choice| choice.word == written) {
            return Ok(choice.word);
        }
        let words: Vec<&str> = choices.iter().map(|choice| choice.word).collect();
        let message = format!("`{key}` cannot be `{written}`");
        let help = match nearest(written, words.iter().copied()) {
            Some(meant) => format!("write `{meant}`"),
            None => format!("write one of {}", words.join(", ")),
        };
        Err(self.mistakes.report(file, Code::UnknownName, file.span(id), message, "", Some(help)))
    }

    /// Refuses a second block of a kind there can be one of.
    pub(super) fn only_one(&mut self, block: &Block) -> Result<(), Reported> {
        super::super::blocks::refuse_target(self.mistakes, &self.file, block, crate::schema::Target::Absent);
        match self.single.get(&block.kind.text) {
            Some(first) => {
                duplicate(self.mistakes, &self.file, &block.kind, first);
                Err(Reported)
            }
            None => {
                self.single.insert(block.kind.text.clone(), block.kind.clone());
                Ok(())
            }
        }
    }
}

fn choices(declaration: &Declaration, key: &str) -> &'static [Choice] {
    match declaration.key(key).map(|parameter| parameter.kind) {
        Some(Kind::Choice(choices) | Kind::Choices(choices)) => choices,
        _ => &[],
    }
}

/// Where the kind and the target of a block stand.
pub(super) fn heading(block: &Block) -> Span {
    let last = block.target.as_ref().and_then(|path| path.parts.last());
    block.kind.span.start..last.map_or(block.kind.span.end, |part| part.span.end)
}

/// A constant as a formula.
pub(super) fn zero() -> Tape<Coordinate> {
    Tape::constant(0.0)
}

impl Run {
    /// Stands in the scene until its `run` block is read.
    fn placeholder() -> Self {
        super::run::defaults(Scheme::Improved, Place::default(), 0.0)
    }
}
