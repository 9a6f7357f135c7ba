//! Files resolved without mistakes, for tests.

use tissue::expression::Tape;
use tissue::scene::*;
use tissue::syntax::Source;

pub fn resolve_with(name: &str, text: &str, overrides: &[(&str, &str)]) -> (Document, Vec<Mistake>) {
    let overrides: Vec<(String, String)> =
        overrides.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    resolve(&Source { name: name.into(), text: text.into() }, &FileSystem, &overrides)
}

pub fn whole((document, mistakes): (Document, Vec<Mistake>)) -> Document {
    let rendered: String = mistakes.iter().map(Mistake::render).collect();
    assert!(mistakes.is_empty(), "{rendered}");
    document
}

pub fn axial(overrides: &[(&str, &str)]) -> Scene {
    let name = "tests/fixtures/axial.tissue";
    let text = std::fs::read_to_string(name).expect("the spec is in the repository");
    let document = whole(resolve_with(name, &text, overrides));
    document.scenes.into_iter().next().expect("the spec holds a scene")
}

pub fn at(tape: &Tape<Coordinate>, x: [f64; 3], t: f64) -> f64 {
    let leaf = |leaf: &Coordinate| match leaf {
        Coordinate::X(axis) => x[usize::from(*axis)],
        Coordinate::Time => t,
    };
    tape.evaluate(leaf, &mut Vec::new())
}
