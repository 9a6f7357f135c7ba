//! Two layers of gel, one stiffer than the other, for tests of scenes of several bodies.

use tissue::scene::{Memory, Scene, resolve};
use tissue::syntax::Source;

/// A scene `layers` with the materials `stiff` and `soft` of the given densities, kg/m³.
pub fn layers([stiff, soft]: [u32; 2], members: &str) -> Scene {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material stiff {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 100 kPa)  density = {stiff} kg/m^3 }}
material soft {{ energy = neo_hooke(mu = 5 kPa) + vol_quadratic(K = 30 kPa)  density = {soft} kg/m^3 }}
scene layers {{
{members}
}}
"
    );
    let (document, mistakes) = resolve(&Source { name: "layers".into(), text }, &Memory::default(), &[]);
    let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
    assert!(mistakes.is_empty(), "{told}");
    document.scenes.into_iter().next().expect("the text has a scene")
}
