//! The specs of this repository resolve to the scenes they describe.

use tissue::scene::*;
use tissue::syntax::Source;

fn resolve_text(name: &str, text: &str, overrides: &[(&str, &str)]) -> (Document, Vec<Mistake>) {
    let overrides: Vec<(String, String)> =
        overrides.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    resolve(&Source { name: name.into(), text: text.into() }, &FileSystem, &overrides)
}

fn axial(overrides: &[(&str, &str)]) -> Scene {
    let name = "specs/artery/axial.tissue";
    let text = std::fs::read_to_string(name).expect("the spec is in the repository");
    let (document, mistakes) = resolve_text(name, &text, overrides);
    let rendered: String = mistakes.iter().map(Mistake::render).collect();
    assert!(mistakes.is_empty(), "{rendered}");
    assert_eq!(document.materials.len(), 1);
    document.scenes.into_iter().next().expect("the spec holds a scene")
}

#[test]
fn the_axial_strip_resolves() {
    let scene = axial(&[]);
    assert_eq!(scene.bodies.len(), 1);
}
