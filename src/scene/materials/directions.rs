//! Directions of a material: its frame, then its fibres.

use super::*;

/// Directions by name.
pub(super) struct Directions {
    named: BTreeMap<String, Direction>,
}

impl Directions {
    /// The directions of these names, in this order.
    pub(super) fn named<'a>(&self, names: impl Iterator<Item = &'a String>) -> Vec<Direction> {
        names.filter_map(|name| self.named.get(name).cloned()).collect()
    }
}

/// Evaluates frame and fibres; each may use those before it.
pub(super) fn read(
    mistakes: &mut Mistakes,
    file: &Rc<File>,
    members: &Members,
    lets: &Lets,
    own: &[Own],
    frame: &[(Name, crate::syntax::ExprId)],
) -> Result<Directions, Reported> {
    let known = RefCell::default();
    let mut evaluator = Evaluator::<Coordinate>::new(mistakes);
    let scope = MaterialScope {
        file: Rc::clone(file),
        own,
        lets: lets.fresh(),
        directions: Named::Components(&known),
    };
    let mut named = BTreeMap::new();
    let mut sound = true;
    for (name, id) in frame.iter().chain(&members.fibre) {
        let first = frame.iter().chain(&members.fibre).find(|(other, _)| other.text == name.text);
        if let Some((first, _)) = first.filter(|(first, _)| first.span != name.span) {
            super::super::members::duplicate(evaluator.mistakes, file, name, first);
            sound = false;
            continue;
        }
        let direction = direction(&mut evaluator, &scope, name, *id);
        let value = direction.map(|components| Value::List(components.map(Value::Scalar).into()));
        if let Ok(components) = direction {
            let components = components.map(|component| evaluator.tape(component));
            let place = file.place(&name.span);
            named.insert(name.text.clone(), Direction { name: name.text.clone(), place, components });
        }
        sound &= direction.is_ok();
        known.borrow_mut().insert(name.text.clone(), value);
    }
    if members.fibre.len() + frame.len() > usize::from(u8::MAX) {
        let (name, _) = &members.fibre.iter().chain(frame).next_back().ok_or(Reported)?;
        let message = "a material has at most 255 directions";
        evaluator.mistakes.report(file, Code::WrongForm, name.span.clone(), message, "", None);
        sound = false;
    }
    if sound { Ok(Directions { named }) } else { Err(Reported) }
}

/// Three numbers of length 1; where they depend on place only their dimension is known here.
fn direction(
    evaluator: &mut Evaluator<Coordinate>,
    scope: &MaterialScope,
    name: &Name,
    id: crate::syntax::ExprId,
) -> Result<[Scalar; 3], Reported> {
    let required = Required { name: &name.text, dimension: Dimension::NUMBER };
    let components = evaluator.vector_quantity(scope, id, required)?;
    let values = components.map(|component| evaluator.graph.number(component.node));
    if let [Some(x), Some(y), Some(z)] = values {
        let length = (x * x + y * y + z * z).sqrt();
        // Six digits, as a direction is typically written.
        if !length.is_finite() || (length - 1.0).abs() > 1e-6 {
            let file = &scope.file;
            let span: Span = file.span(id);
            let message =
                format!("the direction `{}` must be of length 1, but its length is {length:.4}", name.text);
            let written = file.expression(id);
            let diagnostic =
                Diagnostic::new(Code::NotUnitLength, message, span, format!("length {length:.4}"));
            let diagnostic = match length > 0.0 {
                true => diagnostic.with_help(format!("write `unit({written})` if the direction is meant")),
                false => diagnostic,
            };
            return Err(evaluator.mistakes.push(file, diagnostic));
        }
    }
    Ok(components)
}
