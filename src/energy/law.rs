//! A compiled law: stress and density of blocks of particles.
//!
//! Owns the public face of an energy. Knows nothing of which particles they are.

use super::error::EnergyError;
use super::invariant::{Invariant, Leaf};
use super::kinematics::{Block, Conjugate, Reads};
use super::program::{LANES, Program, Row};
use super::raw::Raw;
use super::tangent_block::Tangents;
use super::trace::{Programs, Source};
use super::wide::widest;
use crate::expression::Tape;
use crate::tensor::{Mat3, Vec3};

/// The maps of some particles; those not given follow from `F`.
#[derive(Debug, Clone, Copy)]
pub struct Maps<'a> {
    /// Deformation gradients.
    pub f: &'a [Mat3],
    /// Area maps; `cof F` if none.
    pub h: Option<&'a [Mat3]>,
    /// Volume maps; `det F` if none.
    pub j: Option<&'a [f64]>,
}

/// Unit vectors of the reference configuration a law reads.
#[derive(Debug, Clone, Copy)]
pub enum Directions<'a> {
    /// The same for every particle.
    Uniform(&'a [Vec3]),
    /// Each particle's own: `values[particle * count + index]`.
    PerParticle {
        /// Directions of one particle.
        count: usize,
        /// All directions.
        values: &'a [Vec3],
    },
}

impl Directions<'_> {
    pub(super) fn of(&self, particle: usize, index: usize) -> Vec3 {
        match self {
            Self::Uniform(values) => values[index],
            Self::PerParticle { count, values } => values[particle * count + index],
        }
    }
}

/// Working memory of a law; one for each thread, kept from call to call.
#[derive(Debug, Clone, Default)]
pub struct Scratch {
    pub(super) rows: Vec<Row>,
    pub(super) block: Block,
    pub(super) sigma: Conjugate,
    pub(super) tangents: Tangents,
}

/// Stresses conjugate to the three maps, Pa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConjugateStresses {
    /// `Σ_F = ∂ψ/∂F`
    pub sigma_f: Mat3,
    /// `Σ_H = ∂ψ/∂H`
    pub sigma_h: Mat3,
    /// `Σ_J = ∂ψ/∂J`
    pub sigma_j: f64,
}

/// A strain energy, compiled: programs for its value and its derivatives.
#[derive(Debug, Clone)]
pub struct Law {
    pub(super) live: Vec<Invariant>,
    pub(super) raws: Vec<Raw>,
    pub(super) reads: Reads,
    density: Program,
    gradient: Program,
    /// Second derivatives, brackets at their kink slack and taut.
    pub(super) hessians: [Program; 2],
}

impl Law {
    /// Compiles an energy with its parameters' values, SI.
    ///
    /// # Errors
    /// If the tape is empty, or reads a parameter that is not supplied or a stretch that does not exist.
    pub fn compile(psi: &Tape<Leaf>, parameters: &[f64]) -> Result<Self, EnergyError> {
        if psi.nodes().is_empty() {
            return Err(EnergyError::Empty);
        }
        let mut live = Vec::new();
        for leaf in psi.leaves() {
            match *leaf {
                Leaf::Parameter(index) if index as usize >= parameters.len() => {
                    return Err(EnergyError::MissingParameter { index, supplied: parameters.len() });
                }
                Leaf::Parameter(_) | Leaf::Running(_) => {}
                Leaf::Invariant(Invariant::Stretch(index) | Invariant::StretchBar(index)) if index > 2 => {
                    return Err(EnergyError::NoSuchStretch { index });
                }
                Leaf::Invariant(invariant) => live.push(invariant.canonical()),
            }
        }
        live.sort_unstable();
        live.dedup();
        let mut raws: Vec<Raw> = live.iter().flat_map(|&invariant| Raw::of(invariant)).collect();
        raws.sort_unstable();
        raws.dedup();
        let source = Source { psi, parameters, live: &live, raws: &raws, varied: &[] };
        let Programs { density, gradient, hessians } = source.programs();
        let any = |wanted: fn(&Raw) -> bool| raws.iter().any(wanted);
        let reads = Reads {
            area_map: any(|raw| matches!(raw, Raw::I2)),
            volume_map: any(|raw| matches!(raw, Raw::J)),
            fifth: any(|raw| matches!(raw, Raw::Fifth(_))),
            stretch: any(|raw| matches!(raw, Raw::Stretch(_))),
            directions: raws.iter().map(|raw| raw.directions()).max().unwrap_or(0),
        };
        Ok(Self { live, raws, reads, density, gradient, hessians })
    }

    /// How many directions the law reads: one more than the largest index.
    pub fn directions(&self) -> usize {
        self.reads.directions
    }

    /// The invariants the energy names, in order, each once and under one name.
    pub fn live(&self) -> &[Invariant] {
        &self.live
    }

    /// Operations of the derivative program, for one particle.
    pub fn operations(&self) -> usize {
        self.gradient.operations()
    }

    /// Whether the energy is a function of the area map `H`, so that it pays to evolve it.
    pub fn reads_area_map(&self) -> bool {
        self.reads.area_map
    }

    /// Whether the energy is a function of the volume map `J`.
    pub fn reads_volume_map(&self) -> bool {
        self.reads.volume_map
    }

    /// First Piola–Kirchhoff stress.
    ///
    /// ```text
    /// P = Σ_F + Σ_H ⨯ F + Σ_J H
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `maps` | `F` and, where evolved, `H` and `J` | – |
    /// | `directions` | unit vectors the law reads | – |
    /// | `out` | stresses, one for each `F` | Pa |
    ///
    /// An inadmissible state (`J <= 0`, a number that is none) gives a stress that is not finite
    /// where the law is not defined there; nothing panics. Allocates only on a scratch's first use.
    ///
    /// Exact in floating point: a particle's stress has the same bits wherever it stands in the list.
    ///
    /// # Panics
    /// If the lists differ in length or `directions` holds fewer than the law reads.
    pub fn stress(&self, maps: Maps, directions: Directions, out: &mut [Mat3], scratch: &mut Scratch) {
        self.check(&maps, &directions, out.len());
        self.prepare(&self.gradient, scratch);
        widest!(self.stress_of_blocks(maps, directions, out, scratch));
    }

    #[inline(always)]
    fn stress_of_blocks(&self, maps: Maps, directions: Directions, out: &mut [Mat3], scratch: &mut Scratch) {
        for (start, out) in (0..).step_by(LANES).zip(out.chunks_mut(LANES)) {
            scratch.block.load(&maps, &directions, start, self.reads);
            self.run(&self.gradient, scratch);
            self.conjugate(scratch);
            let Scratch { block, sigma, .. } = scratch;
            block.first_piola(self.reads, sigma);
            for (lane, out) in out.iter_mut().enumerate() {
                for (value, row) in out.as_mut_slice().iter_mut().zip(&sigma.f) {
                    *value = row[lane];
                }
            }
        }
    }

    /// Strain energy `ψ` per reference volume, Pa, one for each `F`.
    ///
    /// # Panics
    /// As [`Law::stress`].
    pub fn density(&self, maps: Maps, directions: Directions, out: &mut [f64], scratch: &mut Scratch) {
        self.check(&maps, &directions, out.len());
        self.prepare(&self.density, scratch);
        widest!(self.density_of_blocks(maps, directions, out, scratch));
    }

    #[inline(always)]
    fn density_of_blocks(&self, maps: Maps, directions: Directions, out: &mut [f64], scratch: &mut Scratch) {
        for (start, out) in (0..).step_by(LANES).zip(out.chunks_mut(LANES)) {
            scratch.block.load(&maps, &directions, start, self.reads);
            self.run(&self.density, scratch);
            let row = &scratch.rows[self.density.outputs()[0] as usize];
            out.copy_from_slice(&row[..out.len()]);
        }
    }

    /// Stresses conjugate to `F`, `H` and `J`, which may be any, not only `cof F` and `det F`.
    ///
    /// # Panics
    /// If `directions` holds fewer than the law reads.
    pub fn conjugate_stresses(&self, f: &Mat3, h: &Mat3, j: f64, directions: &[Vec3]) -> ConjugateStresses {
        let maps = Maps { f: &[*f], h: Some(&[*h]), j: Some(&[j]) };
        let directions = Directions::Uniform(directions);
        self.check(&maps, &directions, 1);
        let mut scratch = Scratch::default();
        self.prepare(&self.gradient, &mut scratch);
        scratch.block.load(&maps, &directions, 0, self.reads);
        self.run(&self.gradient, &mut scratch);
        self.conjugate(&mut scratch);
        let sigma = &scratch.sigma;
        ConjugateStresses {
            sigma_f: Conjugate::tensor(&sigma.f, 0),
            sigma_h: Conjugate::tensor(&sigma.h, 0),
            sigma_j: sigma.j[0],
        }
    }

    pub(super) fn check(&self, maps: &Maps, directions: &Directions, length: usize) {
        assert_eq!(maps.f.len(), length, "one deformation gradient for each result");
        assert!(maps.h.is_none_or(|h| h.len() == length), "one area map for each result");
        assert!(maps.j.is_none_or(|j| j.len() == length), "one volume map for each result");
        let enough = match directions {
            Directions::Uniform(values) => values.len() >= self.reads.directions,
            Directions::PerParticle { count, values } => {
                *count >= self.reads.directions && values.len() >= count * length
            }
        };
        assert!(enough, "the law reads {} directions", self.reads.directions);
    }

    /// Makes room and fills the constants.
    pub(super) fn prepare(&self, program: &Program, scratch: &mut Scratch) {
        if scratch.rows.len() < program.registers() {
            scratch.rows.resize(program.registers(), [0.0; LANES]);
        }
        scratch.block.reserve(self.reads);
        program.prepare(&mut scratch.rows);
    }

    /// Runs a program over the loaded block.
    #[inline(always)]
    pub(super) fn run(&self, program: &Program, scratch: &mut Scratch) {
        let is_alone = scratch.block.is_alone;
        for (&raw, row) in self.raws.iter().zip(&mut scratch.rows) {
            scratch.block.raw(raw, row);
        }
        program.run(&mut scratch.rows, is_alone);
    }

    #[inline(always)]
    fn conjugate(&self, scratch: &mut Scratch) {
        scratch.sigma.clear(self.reads);
        for (&raw, &register) in self.raws.iter().zip(self.gradient.outputs()) {
            scratch.block.add_share(raw, &scratch.rows[register as usize], &mut scratch.sigma);
        }
    }
}
