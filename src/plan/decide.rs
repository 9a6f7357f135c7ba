//! The decisions, one function each for fields and passes.

use super::choice::written_at;
use super::reason::{projection, why_dissipated, why_stiffened};
use super::{Decision, Field, Pass, Plan, choices};
use crate::energy::{Invariant, Leaf};
use crate::scene::{
    Coordinate, Formulation, InterfaceStates, Loading, Material, Place, Probe, Scene, VolumeDissipation,
};

/// Decides everything about a scene.
pub(super) fn plan(scene: &Scene) -> Plan {
    let facts = Facts::new(scene);
    Plan {
        scene: scene.name.clone(),
        formulation: facts.formulation,
        fields: fields(scene, &facts),
        passes: passes(scene, &facts),
        choices: choices(scene, facts.formulation),
    }
}

/// What the decisions are made from.
struct Facts<'a> {
    formulation: Formulation,
    why_formulation: String,
    /// A material whose energy reads H, and the invariant.
    reads_area_map: Option<&'a Material>,
    fibrous: Vec<&'a Material>,
    varying: Option<&'a Material>,
}

impl<'a> Facts<'a> {
    fn new(scene: &'a Scene) -> Self {
        let (formulation, why_formulation) = match scene.run.formulation {
            Some(formulation) => {
                let who = if scene.run.written.iter().any(|key| key == "formulation") {
                    written_at(&scene.run, "formulation")
                } else {
                    "chosen by the scheme".into()
                };
                (formulation, who)
            }
            None if scene.run.volume_dissipation != VolumeDissipation::Off => (
                Formulation::Pfj,
                format!("volume dissipation changes J, {}", written_at(&scene.run, "volume_dissipation")),
            ),
            None => (
                Formulation::Pf,
                "without D(J) the evolved maps equal cof F and det F to second order in the time step".into(),
            ),
        };
        Self {
            formulation,
            why_formulation,
            reads_area_map: scene
                .materials
                .iter()
                .find(|material| invariants(material).any(|i| matches!(i, Invariant::I2 | Invariant::I2Bar))),
            fibrous: scene
                .materials
                .iter()
                .filter(|material| !used_directions(material).is_empty())
                .collect(),
            varying: scene
                .materials
                .iter()
                .find(|material| used_directions(material).iter().any(|&k| varies(material, k))),
        }
    }
}

fn invariants(material: &Material) -> impl Iterator<Item = Invariant> {
    material.energy.leaves().filter_map(|leaf| match leaf {
        Leaf::Invariant(invariant) => Some(*invariant),
        Leaf::Parameter(_) | Leaf::Running(_) => None,
    })
}

/// Indices of the directions an energy reads, ascending.
fn used_directions(material: &Material) -> Vec<usize> {
    let mut used: Vec<usize> = invariants(material)
        .flat_map(|invariant| match invariant {
            Invariant::I4(a) | Invariant::I5(a) | Invariant::I4Bar(a) | Invariant::I5Bar(a) => {
                vec![a as usize]
            }
            Invariant::Component(a, _) => vec![a as usize],
            Invariant::I8(a, b) | Invariant::Green(a, b) => vec![a as usize, b as usize],
            _ => Vec::new(),
        })
        .collect();
    used.sort_unstable();
    used.dedup();
    used
}

fn varies(material: &Material, direction: usize) -> bool {
    material.directions.get(direction).is_some_and(|direction| {
        direction.components.iter().any(|tape| tape.leaves().any(|leaf| matches!(leaf, Coordinate::X(_))))
    })
}

/// `line 12`, the way a reason points at the scene.
pub(super) fn line(place: &Place) -> String {
    format!("line {}", place.line)
}

fn names<'a>(items: impl Iterator<Item = &'a str>) -> String {
    let quoted: Vec<String> = items.map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

fn fields(scene: &Scene, facts: &Facts) -> Vec<Decision<Field>> {
    let mut list = Vec::new();
    let mut add = |what, live, reason: String| list.push(Decision { what, live, reason });
    add(Field::Position, true, "supports, probes and pair directions read x".into());
    add(Field::Momentum, true, "conserved in every scene".into());
    add(Field::DeformationGradient, true, "every energy reads F".into());
    let evolves_h = facts.formulation == Formulation::Pfhj;
    add(
        Field::AreaMap,
        evolves_h,
        if evolves_h {
            format!("formulation pFHJ evolves H, {}", facts.why_formulation)
        } else if let Some(material) = facts.reads_area_map {
            format!("`{}`, {}, reads H; it is derived as cof F", material.name, line(&material.place))
        } else {
            "no energy in the scene names I2; H = cof F is derived where P needs it".into()
        },
    );
    let evolves_j = facts.formulation != Formulation::Pf;
    add(
        Field::VolumeMap,
        evolves_j,
        if evolves_j {
            format!("J is evolved: {}", facts.why_formulation)
        } else {
            format!("J = det F is derived: {}", facts.why_formulation)
        },
    );
    let isotropic: Vec<&Material> =
        scene.materials.iter().filter(|m| !facts.fibrous.iter().any(|f| f.name == m.name)).collect();
    let fibre_reason = match (facts.fibrous.first(), isotropic.first()) {
        (Some(material), _) => {
            let count = used_directions(material).len();
            let plural = if count == 1 { "" } else { "s" };
            format!("material `{}` reads {count} direction{plural}, {}", material.name, line(&material.place))
        }
        (None, Some(material)) => {
            format!("material `{}` reads no direction, {}", material.name, line(&material.place))
        }
        (None, None) => "the scene has no material".into(),
    };
    add(Field::FibreDirection, !facts.fibrous.is_empty(), fibre_reason);
    add(
        Field::FibreDirectionField,
        facts.varying.is_some(),
        match facts.varying {
            Some(material) => {
                format!("a direction of `{}` depends on the place, {}", material.name, line(&material.place))
            }
            None => "no direction depends on the place".into(),
        },
    );
    add(Field::ExternalForce, is_loaded(scene), loads_reason(scene));
    list
}

/// Whether anything but stresses acts on a particle.
fn is_loaded(scene: &Scene) -> bool {
    let exact = scene.motion.as_ref().is_some_and(|motion| motion.body_force || !motion.loaded.is_empty());
    exact || !scene.loads.is_empty()
}

fn loads_reason(scene: &Scene) -> String {
    use crate::scene::Load;
    if let Some(motion) = scene.motion.as_ref().filter(|_| is_loaded(scene)) {
        let more = scene.loads.len();
        let own = format!("the exact motion, {}", line(&motion.place));
        return if more == 0 { own } else { format!("{own}, and {more} more") };
    }
    match scene.loads.first() {
        None => "no body force and no traction in the scene".into(),
        Some(
            Load::Traction { place, .. }
            | Load::Pressure { place, .. }
            | Load::BodyForce { place, .. }
            | Load::Gravity { place, .. },
        ) => {
            let more = scene.loads.len() - 1;
            if more == 0 { line(place) } else { format!("{} and {more} more", line(place)) }
        }
    }
}

fn passes(scene: &Scene, facts: &Facts) -> Vec<Decision<Pass>> {
    let run = &scene.run;
    let mut list = Vec::new();
    let mut add = |what, live, reason: String| list.push(Decision { what, live, reason });
    let symmetric = scene.symmetry.iter().flatten().count();
    let held = scene.prescribed.len();
    add(
        Pass::PrescribedMotion,
        symmetric + held > 0,
        match (held, symmetric) {
            (0, 0) => "no support and no plane of symmetry in the scene".into(),
            (0, 1) => "a plane of symmetry".into(),
            (0, planes) => format!("{planes} planes of symmetry"),
            (_, 0) => format!("`{}`, {}", scene.prescribed[0].word, line(&scene.prescribed[0].place)),
            (_, planes) => format!(
                "`{}`, {}, and {planes} planes of symmetry",
                scene.prescribed[0].word,
                line(&scene.prescribed[0].place)
            ),
        },
    );
    add(Pass::VelocityGradient, true, "the rate of F (28)".into());
    let pruned_map = "H is derived, not evolved";
    add(
        Pass::AreaMapRate,
        facts.formulation == Formulation::Pfhj,
        if facts.formulation == Formulation::Pfhj { "the rate of H (29)".into() } else { pruned_map.into() },
    );
    add(
        Pass::VolumeMapRate,
        facts.formulation != Formulation::Pf,
        if facts.formulation == Formulation::Pf {
            "J is derived, not evolved".into()
        } else {
            "the rate of J (30)".into()
        },
    );
    add(
        Pass::Stress,
        true,
        format!("energy of {}", names(scene.materials.iter().map(|material| material.name.as_str()))),
    );
    add(Pass::InternalForce, true, "momentum balance (32)".into());
    add(Pass::MomentumDissipation, run.momentum_dissipation != InterfaceStates::Off, why_dissipated(run));
    add(
        Pass::VolumeDissipation,
        run.volume_dissipation != VolumeDissipation::Off,
        match run.volume_dissipation {
            VolumeDissipation::Off => "off: D(J) has no restoring force and lets J drift from det F",
            VolumeDissipation::On => "D(J) smooths the pressure (34)",
            VolumeDissipation::Restoring { .. } => "D(J) smooths the pressure (34); J relaxes to det F",
        }
        .into(),
    );
    add(Pass::Hourglass, run.hourglass_stiffness > 0.0, why_stiffened(run).into());
    add(Pass::ExternalForce, is_loaded(scene), loads_reason(scene));
    add(
        Pass::AffineDamping,
        matches!(run.loading, Loading::QuasiStatic { .. }),
        match run.loading {
            Loading::QuasiStatic { .. } => {
                format!("loading is quasi-static, {}", written_at(run, "loading"))
            }
            Loading::Dynamic => "loading is dynamic: inertia is part of the answer".into(),
        },
    );
    if scene.bodies.len() > 1 {
        add(
            Pass::Bond,
            !scene.bonds.is_empty(),
            match scene.bonds.as_slice() {
                [] => "the bodies are not bonded: each moves for itself".into(),
                [bond] => format!("`bond`, {}", line(&bond.place)),
                [bond, more @ ..] => format!("`bond`, {} and {} more", line(&bond.place), more.len()),
            },
        );
    }
    let (projected, why_projected) = projection(scene);
    add(Pass::TorqueProjection, projected, why_projected);
    let impulse = scene.records.iter().find(|record| {
        let mut leaves = record.columns.iter().flat_map(|column| column.value.leaves());
        leaves.any(|probe| matches!(probe, Probe::Impulse { .. }))
    });
    add(
        Pass::Impulse,
        impulse.is_some(),
        impulse.map_or("no record asks for an impulse".into(), |r| {
            format!("record `{}`, {}", r.name, line(&r.place))
        }),
    );
    add(
        Pass::WaveSpeed,
        run.wave_speed_every > 0,
        if run.wave_speed_every > 0 {
            format!("the material stiffens; every {} steps (42)", run.wave_speed_every)
        } else {
            "speed at rest is kept, as the paper has it (42)".into()
        },
    );
    list
}
