//! `trade`: a sweep with two columns, error and cost.

use super::super::blocks::unknown_block;
use super::super::file::{File, Reported};
use super::super::members::{Members, Site};
use super::super::model::{Column, Reduced, Sweep, SweepRecord, Swept, Trade};
use super::super::scenes::Stage;
use super::super::session::{Module, Session};
use super::super::words::TRADE;
use super::{Setting, claim, points, record, target, vary};
use crate::expression::{Function, Node, Tape};
use crate::syntax::{Block, Code, Name};
use std::rc::Rc;

/// Name of the table of a trade.
const TABLE: &str = "trade";

/// Reads a trade.
pub(super) fn read(
    session: &mut Session,
    file: &Rc<File>,
    block: &Block,
    name: &Name,
    module: &Module,
    setting: &Setting<'_>,
) -> Result<Sweep, Reported> {
    let before = session.mistakes.len();
    let members = Members::read(&mut session.mistakes, file, &TRADE, block);
    let given = |key| session.overrides.find(&[&name.text], key).or_else(|| members.written(key).cloned());
    let (cost, tolerance) = (given("cost"), given("tolerance"));
    let of = members
        .required(&mut session.mistakes, file, &TRADE, block, "of")
        .and_then(|site| target(session, file, site.id, setting));
    let error = members.required(&mut session.mistakes, file, &TRADE, block, "error");
    let varied = vary::read(session, file, block, name, &members);
    let (of, error, varied) = (of?, error?, varied?);
    if let Some(drive) = setting.document.drives.iter().find(|drive| drive.name == of) {
        let message = format!("a trade is of a scene, but `{}` is a drive, which costs nothing", drive.name);
        let span = name.span.clone();
        return Err(session.mistakes.report(file, Code::WrongForm, span, message, "", None));
    }
    let points = points::describe(session, file, &of, &varied, setting)?;
    let varied: Vec<_> = varied.into_iter().map(|entry| entry.varied).collect();
    let mut stage = Stage::new(session, file, name, module, &members);
    let cost = match &cost {
        Some(site) => stage.choice(site, &TRADE, "cost"),
        None => Ok("particle_updates"),
    };
    let error = columns(&mut stage, &error, &varied, &points[0].swept);
    let cost = cost?;
    let (mut error, dimension) = error?;
    // An error is a magnitude.
    let last = error.value.nodes().len() as u32 - 1;
    error.value.push(Node::Call(Function::Abs, last));
    let tolerance = match &tolerance {
        Some(site) => Some(stage.positive(site, "tolerance", dimension)?),
        None => None,
    };
    let unit = error.unit.clone();
    let leaf = match cost {
        "steps" => Reduced::Steps,
        "particles" => Reduced::Particles,
        _ => Reduced::ParticleUpdates,
    };
    let mut tape = Tape::new();
    tape.push(Node::Leaf(leaf));
    let spent = Column {
        name: "cost".into(),
        place: file.place(&name.span),
        value: tape,
        unit: String::new(),
        text: cost.into(),
    };
    let own = [("error", Some(dimension)), ("cost", Some(crate::unit::Dimension::NUMBER))];
    let varying = varied.iter().map(|varied| (varied.column.clone(), record::dimension(&varied.unit)));
    let known = own.into_iter().map(|(name, dimension)| (name.to_string(), dimension)).chain(varying);
    stage.columns.insert(TABLE.into(), known.collect());
    stage.varied = varied.iter().map(|varied| varied.column.clone()).collect();
    stage.abscissa.clone_from(&varied[0].column);
    for entry in &members.expects {
        let _ = claim(&mut stage, file, entry, &varied);
    }
    for inner in &members.blocks {
        unknown_block(stage.mistakes, file, inner, Some(TRADE.word));
    }
    let expectations = std::mem::take(&mut stage.scene.expectations);
    if session.mistakes.len() > before {
        return Err(Reported);
    }
    let place = file.place(&name.span);
    let table = SweepRecord { name: TABLE.into(), place: place.clone(), columns: vec![error, spent] };
    Ok(Sweep {
        name: name.text.clone(),
        place,
        of,
        varied,
        points,
        records: vec![table],
        plots: Vec::new(),
        expectations,
        trade: Some(Trade { tolerance, unit, cost: cost.into() }),
    })
}

/// The column of the error.
fn columns(
    stage: &mut Stage,
    error: &Site,
    varied: &[super::super::model::Varied],
    swept: &Swept,
) -> Result<(Column<Reduced>, crate::unit::Dimension), Reported> {
    let known = record::columns(swept);
    let name = Name { text: "error".into(), span: stage.file.span(error.id) };
    record::value(stage, &name, error.id, varied, &known, swept)
}
