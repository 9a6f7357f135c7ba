//! The body force that makes a motion written as text an exact solution.
//!
//! Owns the nesting of duals: gradient of the energy over Jacobian of the motion over derivatives in
//! place and time, traced once into programs that run over blocks of particles. Knows neither
//! particles nor what the leaves of the motion are called.

use super::error::EnergyError;
use super::handle::{Handle, Trace};
use super::invariant::{Invariant, Leaf};
use super::law::Scratch;
use super::program::{LANES, Program};
use super::raw::{self, Raw};
use super::wide::widest;
use crate::expression::{Part, Scalar, Tape};
use crate::tensor::{Mat3, Vec3};
use num_dual::Dual;

/// A number with a derivative in place or time, and one more.
type Nested<T> = Dual<Dual<T>>;

/// What a motion is written in: reference coordinate 0 to 2, or time, which is 3.
type Input = usize;

/// Place of time among the inputs.
const TIME: Input = 3;

/// A motion, and the material that is to move so.
#[derive(Debug)]
pub struct MotionSource<'a, L> {
    /// Components of `x(X, t)`, m.
    pub position: &'a [Tape<L>; 3],
    /// Strain energy per reference volume, Pa.
    pub energy: &'a Tape<Leaf>,
    /// Values of the energy's parameters, SI.
    pub parameters: &'a [f64],
    /// Unit vectors the energy reads, functions of place.
    pub directions: &'a [[Tape<L>; 3]],
    /// `ρR`, kg/m³.
    pub density: f64,
    /// Coordinate 0 to 2 of a leaf, or 3 for time.
    pub input: fn(&L) -> usize,
}

impl<L> MotionSource<'_, L> {
    /// Components of a vector written as tapes.
    fn vector<T: Scalar>(&self, tapes: &[Tape<L>; 3], at: &[T; 4]) -> [T; 3] {
        let component =
            |tape: &Tape<L>| tape.evaluate(|leaf| at[(self.input)(leaf)].clone(), &mut Vec::new());
        [component(&tapes[0]), component(&tapes[1]), component(&tapes[2])]
    }

    /// Slope of the position by one input.
    fn slope<T: Part>(&self, at: &[T; 4], by: Input) -> [T; 3] {
        self.vector(self.position, &seeded(at, by)).map(|component| component.eps)
    }

    /// Second slope of a vector, by two inputs, with its value and first slopes.
    fn second<T: Part>(&self, tapes: &[Tape<L>; 3], at: &[T; 4], by: (Input, Input)) -> [Nested<T>; 3] {
        self.vector(tapes, &seeded(&seeded(at, by.0), by.1))
    }

    /// `f0 = ρR ∂²x/∂t² − DIV P`, the derivatives by nested duals in any scalar.
    ///
    /// ```text
    /// (DIV P)_i = Σ_J ∂/∂X_J ∂ψ/∂F_iJ,   F_jK = ∂x_j/∂X_K
    /// ```
    fn body_force<T: Part>(&self, at: &[T; 4]) -> [T; 3] {
        let inertia = self.second(self.position, at, (TIME, TIME)).map(|x| x.eps.eps);
        let mut force = inertia.map(|a| a * T::constant(self.density));
        for by in 0..3 {
            // F and the directions with their slopes by X_J
            let columns = [0, 1, 2].map(|k| self.second(self.position, at, (by, k)));
            let f = |j: usize, k: usize| columns[k][j].eps.clone();
            let along = seeded(at, by);
            let directions: Vec<[Dual<T>; 3]> =
                self.directions.iter().map(|direction| self.vector(direction, &along)).collect();
            for (i, force) in force.iter_mut().enumerate() {
                let seed = |j, k| if (j, k) == (i, by) { 1.0 } else { 0.0 };
                let f = [0, 1, 2].map(|j| {
                    [0, 1, 2].map(|k| Dual::new(f(j, k), <Dual<T> as Scalar>::constant(seed(j, k))))
                });
                let fixed =
                    |component: &Dual<T>| Dual::new(component.clone(), <Dual<T> as Scalar>::constant(0.0));
                let directions: Vec<[Nested<T>; 3]> =
                    directions.iter().map(|direction| direction.each_ref().map(fixed)).collect();
                let psi = density(self.energy, self.parameters, &f, &directions);
                *force = force.clone() - psi.eps.eps;
            }
        }
        force
    }
}

/// The inputs as duals, seeded by one of them.
fn seeded<T: Part>(at: &[T; 4], by: Input) -> [Dual<T>; 4] {
    [0, 1, 2, TIME].map(|k| Dual::new(at[k].clone(), T::constant(if k == by { 1.0 } else { 0.0 })))
}

/// `ψ` as a function of `F` and the directions.
fn density<T: Scalar>(psi: &Tape<Leaf>, parameters: &[f64], f: &[[T; 3]; 3], directions: &[[T; 3]]) -> T {
    let dot = |a: &[T; 3], b: &[T; 3]| {
        a[0].clone() * b[0].clone() + a[1].clone() * b[1].clone() + a[2].clone() * b[2].clone()
    };
    let minor = |i: usize, k: usize| {
        let (i1, i2, k1, k2) = ((i + 1) % 3, (i + 2) % 3, (k + 1) % 3, (k + 2) % 3);
        f[i1][k1].clone() * f[i2][k2].clone() - f[i1][k2].clone() * f[i2][k1].clone()
    };
    let image = |a: u8| [0, 1, 2].map(|i| dot(&f[i], &directions[usize::from(a)]));
    let value = |raw: Raw| match raw {
        Raw::I1 => dot(&f[0], &f[0]) + dot(&f[1], &f[1]) + dot(&f[2], &f[2]),
        Raw::I2 => {
            let h = [0, 1, 2].map(|i| [0, 1, 2].map(|k| minor(i, k)));
            dot(&h[0], &h[0]) + dot(&h[1], &h[1]) + dot(&h[2], &h[2])
        }
        Raw::J => dot(&f[0], &[minor(0, 0), minor(0, 1), minor(0, 2)]),
        Raw::Fourth(a) => dot(&image(a), &image(a)),
        Raw::Fifth(a) => {
            let m = image(a);
            let pulled = [0, 1, 2].map(|k| dot(&[f[0][k].clone(), f[1][k].clone(), f[2][k].clone()], &m));
            dot(&pulled, &pulled)
        }
        Raw::Eighth(a, b) => dot(&image(a), &image(b)),
        Raw::Dot(a, b) => dot(&directions[usize::from(a)], &directions[usize::from(b)]),
        Raw::Metric(i, k) => {
            let column = |k: u8| [0, 1, 2].map(|i: usize| f[i][usize::from(k)].clone());
            dot(&column(i), &column(k))
        }
        Raw::Component(a, i) => directions[usize::from(a)][usize::from(i)].clone(),
        // refused by `ExactMotion::compile`
        Raw::Stretch(_) => T::constant(f64::NAN),
    };
    let leaf = |leaf: &Leaf| match *leaf {
        Leaf::Invariant(named) => raw::invariant(named, &value),
        Leaf::Parameter(index) => T::constant(parameters[index as usize]),
        // refused by `ExactMotion::compile`
        Leaf::Running(_) => T::constant(f64::NAN),
    };
    psi.evaluate(leaf, &mut Vec::new())
}

/// What a motion is at a particle and a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionState {
    /// `x`, m.
    pub position: Vec3,
    /// `∂x/∂t`, m/s.
    pub velocity: Vec3,
    /// `F = ∂x/∂X`.
    pub gradient: Mat3,
}

impl Default for MotionState {
    fn default() -> Self {
        Self { position: Vec3::zeros(), velocity: Vec3::zeros(), gradient: Mat3::identity() }
    }
}

/// A motion compiled: programs for what it is and for the force it needs.
#[derive(Debug, Clone)]
pub struct ExactMotion {
    position: Program,
    state: Program,
    force: Program,
}

impl ExactMotion {
    /// Traces a motion of a material.
    ///
    /// # Errors
    /// If the energy is empty, reads what is not supplied, or reads principal stretches, which are no
    /// formulas of `F` a dual could go through.
    pub fn compile<L>(source: &MotionSource<'_, L>) -> Result<Self, EnergyError> {
        if source.energy.nodes().is_empty() {
            return Err(EnergyError::Empty);
        }
        for leaf in source.energy.leaves() {
            match *leaf {
                Leaf::Parameter(index) if index as usize >= source.parameters.len() => {
                    let supplied = source.parameters.len();
                    return Err(EnergyError::MissingParameter { index, supplied });
                }
                Leaf::Invariant(Invariant::Stretch(_) | Invariant::StretchBar(_)) => {
                    return Err(EnergyError::StretchOfMotion);
                }
                Leaf::Running(_) => return Err(EnergyError::IntegralOfMotion),
                _ => {}
            }
        }
        let traced = |outputs: &dyn Fn(&[Handle; 4]) -> Vec<Handle>| {
            let trace = Trace::default();
            let at = [0, 1, 2, TIME].map(|place| trace.input(place));
            let outputs = outputs(&at);
            let nodes = trace.nodes(&outputs);
            Program::new(&trace.graph(), &nodes, at.len())
        };
        Ok(Self {
            position: traced(&|at| source.vector(source.position, at).to_vec()),
            state: traced(&|at| {
                let [x, v] = [source.vector(source.position, at), source.slope(at, TIME)];
                let columns = [0, 1, 2].map(|k| source.slope(at, k));
                [x, v].into_iter().chain(columns).flatten().collect()
            }),
            force: traced(&|at| source.body_force(at).to_vec()),
        })
    }

    /// Operations of the force program, for one particle.
    pub fn operations(&self) -> usize {
        self.force.operations()
    }

    /// `x(X, t)` of some reference positions, m.
    ///
    /// # Panics
    /// If the lists differ in length.
    pub fn positions(&self, reference: &[Vec3], time: f64, out: &mut [Vec3], scratch: &mut Scratch) {
        assert_eq!(reference.len(), out.len(), "one position for each particle");
        prepare(&self.position, scratch);
        widest!(self.vectors(&self.position, reference, time, out, scratch));
    }

    /// `f0 = ρR ∂²x/∂t² − DIV P` at some reference positions, N/m³.
    ///
    /// Allocates only on a scratch's first use; a particle's force has the same bits wherever it stands.
    ///
    /// # Panics
    /// If the lists differ in length.
    pub fn body_forces(&self, reference: &[Vec3], time: f64, out: &mut [Vec3], scratch: &mut Scratch) {
        assert_eq!(reference.len(), out.len(), "one force for each particle");
        prepare(&self.force, scratch);
        widest!(self.vectors(&self.force, reference, time, out, scratch));
    }

    /// Position, velocity and deformation gradient at some reference positions.
    ///
    /// # Panics
    /// If the lists differ in length.
    pub fn states(&self, reference: &[Vec3], time: f64, out: &mut [MotionState], scratch: &mut Scratch) {
        assert_eq!(reference.len(), out.len(), "one state for each particle");
        prepare(&self.state, scratch);
        for (reference, out) in reference.chunks(LANES).zip(out.chunks_mut(LANES)) {
            run(&self.state, reference, time, scratch);
            let at = |place: usize, lane: usize| scratch.rows[self.state.outputs()[place] as usize][lane];
            for (lane, out) in out.iter_mut().enumerate() {
                out.position = Vec3::from_fn(|i, _| at(i, lane));
                out.velocity = Vec3::from_fn(|i, _| at(3 + i, lane));
                out.gradient = Mat3::from_fn(|i, k| at(6 + 3 * k + i, lane));
            }
        }
    }

    #[inline(always)]
    fn vectors(
        &self,
        program: &Program,
        reference: &[Vec3],
        time: f64,
        out: &mut [Vec3],
        scratch: &mut Scratch,
    ) {
        for (reference, out) in reference.chunks(LANES).zip(out.chunks_mut(LANES)) {
            run(program, reference, time, scratch);
            for (axis, &register) in program.outputs().iter().enumerate() {
                let row = &scratch.rows[register as usize];
                for (out, &value) in out.iter_mut().zip(row) {
                    out[axis] = value;
                }
            }
        }
    }
}

fn prepare(program: &Program, scratch: &mut Scratch) {
    if scratch.rows.len() < program.registers() {
        scratch.rows.resize(program.registers(), [0.0; LANES]);
    }
    program.prepare(&mut scratch.rows);
}

/// Runs a program over a block; lanes beyond the end repeat its last particle.
#[inline(always)]
fn run(program: &Program, reference: &[Vec3], time: f64, scratch: &mut Scratch) {
    let last = reference.len() - 1;
    for lane in 0..LANES {
        let at = &reference[lane.min(last)];
        for axis in 0..3 {
            scratch.rows[axis][lane] = at[axis];
        }
        scratch.rows[TIME][lane] = time;
    }
    program.run(&mut scratch.rows, false);
}

#[cfg(test)]
mod tests;
