//! How stress and energy answer to a law's parameters.
//!
//! Owns the derivatives of a law by its parameters at a fixed deformation, traced and written by
//! num-dual like those by its invariants. Knows nothing of data.

use super::error::EnergyError;
use super::invariant::Leaf;
use super::law::{Directions, Law, Maps, Scratch};
use super::program::{LANES, Program};
use super::trace::Source;
use crate::expression::Tape;
use crate::tensor::{Mat3, Vec3};

/// Derivatives by one parameter `θ` at a fixed deformation, in Pa over the unit of `θ`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParameterSlope {
    /// `∂P/∂θ`
    pub first_piola: Mat3,
    /// `∂ψ/∂θ`
    pub psi: f64,
}

/// The compiled derivatives of a law by some of its parameters.
#[derive(Debug, Clone)]
pub struct ParameterSlopes {
    law: Law,
    program: Program,
    values: Vec<f64>,
}

impl ParameterSlopes {
    /// Compiles the derivatives by `varied`, indices into `parameters`, at the values of `parameters`, SI.
    ///
    /// # Errors
    /// As [`Law::compile`], and where a varied parameter does not exist.
    pub fn compile(psi: &Tape<Leaf>, parameters: &[f64], varied: &[u32]) -> Result<Self, EnergyError> {
        let law = Law::compile(psi, parameters)?;
        let mut values = Vec::with_capacity(varied.len());
        for &index in varied {
            let missing = EnergyError::MissingParameter { index, supplied: parameters.len() };
            values.push(*parameters.get(index as usize).ok_or(missing)?);
        }
        let source = Source { psi, parameters, live: &law.live, raws: &law.raws, varied };
        let program = source.parameter_slopes();
        Ok(Self { law, program, values })
    }

    /// The law at these parameters.
    pub fn law(&self) -> &Law {
        &self.law
    }

    /// Derivatives by each varied parameter at a state, `H = cof F`, `J = det F`.
    ///
    /// ```text
    /// ∂P/∂θ = Σ_k ∂²ψ/∂I_k∂θ ∂I_k/∂F
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `f` | deformation gradient | – |
    /// | `directions` | unit vectors the law reads | – |
    ///
    /// Not finite where the law is not defined.
    ///
    /// # Panics
    /// If `directions` holds fewer than the law reads.
    pub fn at(&self, f: &Mat3, directions: &[Vec3], scratch: &mut Scratch) -> Vec<ParameterSlope> {
        let (law, reads) = (&self.law, self.law.reads);
        let (maps, directions) = (Maps { f: &[*f], h: None, j: None }, Directions::Uniform(directions));
        law.check(&maps, &directions, 1);
        law.prepare(&self.program, scratch);
        scratch.block.load(&maps, &directions, 0, reads);
        for (row, &value) in scratch.rows[law.raws.len()..].iter_mut().zip(&self.values) {
            *row = [value; LANES];
        }
        law.run(&self.program, scratch);
        let one = 1 + law.raws.len();
        let outputs = self.program.outputs().chunks_exact(one);
        outputs
            .map(|registers| {
                let Scratch { block, sigma, rows, .. } = &mut *scratch;
                sigma.clear(reads);
                for (&raw, &register) in law.raws.iter().zip(&registers[1..]) {
                    block.add_share(raw, &rows[register as usize], sigma);
                }
                block.first_piola(reads, sigma);
                let first_piola = Mat3::from_fn(|i, j| sigma.f[i + 3 * j][0]);
                ParameterSlope { first_piola, psi: rows[registers[0] as usize][0] }
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::Invariant;
    use crate::expression::Node;

    /// `c/2 (I1bar − 3) + k/2 (J − 1)²`
    fn neo_hooke() -> Tape<Leaf> {
        let mut tape = Tape::new();
        let half = tape.push(Node::Constant(0.5));
        let c = tape.push(Node::Leaf(Leaf::Parameter(0)));
        let i1_bar = tape.push(Node::Leaf(Leaf::Invariant(Invariant::I1Bar)));
        let three = tape.push(Node::Constant(3.0));
        let excess = tape.push(Node::Subtract(i1_bar, three));
        let matrix = tape.push(Node::Multiply(c, excess));
        let k = tape.push(Node::Leaf(Leaf::Parameter(1)));
        let j = tape.push(Node::Leaf(Leaf::Invariant(Invariant::J)));
        let one = tape.push(Node::Constant(1.0));
        let dilation = tape.push(Node::Subtract(j, one));
        let square = tape.push(Node::Multiply(dilation, dilation));
        let volume = tape.push(Node::Multiply(k, square));
        let sum = tape.push(Node::Add(matrix, volume));
        tape.push(Node::Multiply(half, sum));
        tape
    }

    // The stress is linear in both parameters, so its slope is the stress of the law with that one alone.
    #[test]
    fn the_slope_of_a_linear_parameter_is_the_stress_of_its_term() {
        let psi = neo_hooke();
        let f = Mat3::new(1.2, 0.3, 0.0, -0.1, 0.9, 0.2, 0.1, 0.0, 1.1);
        let slopes = ParameterSlopes::compile(&psi, &[3e3, 1e5], &[1, 0]).expect("a law");
        let found = slopes.at(&f, &[], &mut Scratch::default());
        for (slope, unit) in found.iter().zip([[0.0, 1.0], [1.0, 0.0]]) {
            let law = Law::compile(&psi, &unit).expect("a law");
            let (mut p, mut w) = ([Mat3::zeros()], [0.0]);
            let maps = Maps { f: &[f], h: None, j: None };
            law.stress(maps, Directions::Uniform(&[]), &mut p, &mut Scratch::default());
            law.density(maps, Directions::Uniform(&[]), &mut w, &mut Scratch::default());
            assert!((slope.first_piola - p[0]).norm() < 1e-14 * p[0].norm());
            assert!((slope.psi - w[0]).abs() < 1e-14 * w[0].abs());
            assert!((slope.first_piola - 1.001 * p[0]).norm() > 1e-4 * p[0].norm(), "a control");
        }
    }

    #[test]
    fn a_parameter_that_does_not_exist_is_refused() {
        let found = ParameterSlopes::compile(&neo_hooke(), &[1.0, 1.0], &[2]);
        assert!(matches!(found, Err(EnergyError::MissingParameter { index: 2, supplied: 2 })));
    }
}
