//! An energy's tape, run once over handles and their duals: its derivatives as programs.

use super::handle::{Handle, Trace};
use super::invariant::Leaf;
use super::program::Program;
use super::raw::{self, Raw};
use crate::expression::{Part, Scalar, Tape};
use num_dual::Dual;

/// A law to be traced: its tape, its parameters and the raw invariants it reads.
pub(super) struct Source<'a> {
    pub(super) psi: &'a Tape<Leaf>,
    pub(super) parameters: &'a [f64],
    pub(super) raws: &'a [Raw],
}

/// Position of the second derivative by raw invariants `k <= l` in the list of them.
pub(super) fn pair(k: usize, l: usize) -> usize {
    debug_assert!(k <= l, "the upper triangle is stored");
    l * (l + 1) / 2 + k
}

impl Source<'_> {
    fn evaluate<T: Scalar>(&self, raws: &[T], scratch: &mut Vec<T>) -> T {
        let lookup = |wanted: Raw| {
            let place = self.raws.iter().position(|&raw| raw == wanted);
            raws[place.expect("every raw invariant of the tape is listed")].clone()
        };
        let leaf = |leaf: &Leaf| match *leaf {
            Leaf::Invariant(invariant) => raw::invariant(invariant, &lookup),
            Leaf::Parameter(index) => T::constant(self.parameters[index as usize]),
        };
        self.psi.evaluate(leaf, scratch)
    }

    fn inputs(&self, trace: &Trace) -> Vec<Handle> {
        (0..self.raws.len()).map(|place| trace.input(place)).collect()
    }

    /// `ψ`
    pub(super) fn density(&self) -> Program {
        let trace = Trace::new(false);
        let psi = self.evaluate(&self.inputs(&trace), &mut Vec::new());
        self.finish(trace, vec![psi])
    }

    /// `∂ψ/∂I_k` in the order of the raw invariants.
    pub(super) fn gradient(&self) -> Program {
        let trace = Trace::new(false);
        let inputs = self.inputs(&trace);
        let outputs = (0..inputs.len()).map(|k| self.evaluate(&seeded(&inputs, k), &mut Vec::new()).eps);
        let outputs = outputs.collect();
        self.finish(trace, outputs)
    }

    /// `∂ψ/∂I_k`, then `∂²ψ/∂I_k ∂I_l` at [`pair`]; brackets at their kink loaded if `taut`.
    pub(super) fn hessian(&self, taut: bool) -> Program {
        let trace = Trace::new(taut);
        let inputs = self.inputs(&trace);
        let (mut first, mut second) = (Vec::new(), Vec::new());
        for l in 0..inputs.len() {
            for k in 0..=l {
                let psi = self.evaluate(&seeded(&seeded(&inputs, k), l), &mut Vec::new());
                if k == l {
                    first.push(psi.re.eps);
                }
                second.push(psi.eps.eps);
            }
        }
        first.append(&mut second);
        self.finish(trace, first)
    }

    fn finish(&self, trace: Trace, outputs: Vec<Handle>) -> Program {
        let (graph, nodes) = trace.finish(outputs);
        Program::new(&graph, &nodes, self.raws.len())
    }
}

/// The duals of the parts, the `k`-th of slope 1.
fn seeded<T: Part>(parts: &[T], k: usize) -> Vec<Dual<T>> {
    let slope = |place| <T as Scalar>::constant(if place == k { 1.0 } else { 0.0 });
    parts.iter().enumerate().map(|(place, part)| Dual::new(part.clone(), slope(place))).collect()
}
