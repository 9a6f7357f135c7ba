//! An energy's tape, run once over handles, and its derivatives: all as programs.

use super::differentiate::{Leaves, slopes};
use super::handle::{Handle, Trace};
use super::invariant::{Invariant, Leaf};
use super::program::Program;
use super::raw::{self, Raw};
use crate::expression::{Scalar, Tape};
use num_dual::Dual;

/// A law to be traced: its tape, its parameters, the invariants it names and the raw ones.
pub(super) struct Source<'a> {
    pub(super) psi: &'a Tape<Leaf>,
    pub(super) parameters: &'a [f64],
    pub(super) live: &'a [Invariant],
    /// In order, each once.
    pub(super) raws: &'a [Raw],
}

/// Position of the second derivative by raw invariants `k <= l` in the list of them.
pub(super) fn pair(k: usize, l: usize) -> usize {
    debug_assert!(k <= l, "the upper triangle is stored");
    l * (l + 1) / 2 + k
}

impl Source<'_> {
    /// `ψ`
    pub(super) fn density(&self) -> Program {
        let trace = Trace::new(false);
        let psi = self.evaluate(&self.inputs(&trace));
        self.finish(trace, vec![psi])
    }

    /// `∂ψ/∂I_k` in the order of the raw invariants.
    pub(super) fn gradient(&self) -> Program {
        let trace = Trace::new(false);
        let outputs = self.traced_gradient(&trace);
        self.finish(trace, outputs)
    }

    /// `∂ψ/∂I_k`, then `∂²ψ/∂I_k ∂I_l` at [`pair`]; brackets at their kink loaded if `taut`.
    pub(super) fn hessian(&self, taut: bool) -> Program {
        let trace = Trace::new(taut);
        let mut outputs = self.traced_gradient(&trace);
        let gradient = outputs.clone();
        let operations = trace.operations();
        let nodes: Vec<_> = self.inputs(&trace).iter().filter_map(Handle::node).collect();
        let leaves = Leaves::new(nodes.iter().copied(), operations.len());
        for (l, &node) in nodes.iter().enumerate() {
            outputs.extend(slopes(&trace, &operations, &gradient[..=l], &leaves, node));
        }
        self.finish(trace, outputs)
    }

    /// ψ is differentiated by the invariants it names; the rest is the chain rule, with all isochoric
    /// ones of a power `r^p`, `r = J^(-1/3)`, gathered before their slope `−p/3 r^(p+3)` by `J`.
    fn traced_gradient(&self, trace: &Trace) -> Vec<Handle> {
        let inputs = self.inputs(trace);
        let by_named = self.slopes_by_named(trace, &inputs);
        let mut outputs = vec![Handle::constant(0.0); inputs.len()];
        let mut gathered = [(); 5].map(|()| Handle::constant(0.0));
        let raw = |wanted: Raw| inputs[self.place(wanted)].clone();
        let mut add = |raw: Raw, share: Handle| {
            let output = &mut outputs[self.place(raw)];
            *output = output.clone() + share;
        };
        for (&named, d) in self.live.iter().zip(by_named) {
            if let Some((part, power)) = raw::isochoric(named) {
                let r = raw(Raw::J).reciprocal_cbrt();
                gathered[power as usize] = gathered[power as usize].clone() + d.clone() * raw(part);
                add(part, d * r.fixed_power(f64::from(power)));
            } else {
                for part in Raw::of(named).into_iter().filter(|part| !matches!(part, Raw::Dot(..))) {
                    let seeded = |wanted: Raw| {
                        Dual::new(raw(wanted), Handle::constant(if wanted == part { 1.0 } else { 0.0 }))
                    };
                    add(part, d.clone() * raw::invariant(named, &seeded).eps);
                }
            }
        }
        for (power, sum) in gathered.into_iter().enumerate() {
            if sum.fixed() != Some(0.0) {
                let r = raw(Raw::J).reciprocal_cbrt();
                let slope = r.fixed_power(power as f64) * (r.fixed_power(2.0) * r);
                add(Raw::J, sum * (slope * Handle::constant(power as f64 / -3.0)));
            }
        }
        outputs
    }

    /// `∂ψ/∂I` by each invariant the tape names, the others held.
    fn slopes_by_named(&self, trace: &Trace, inputs: &[Handle]) -> Vec<Handle> {
        let lookup = |wanted: Raw| inputs[self.place(wanted)].clone();
        let named = self.live.iter().map(|&named| raw::invariant(named, &lookup));
        let nodes: Vec<_> = named.filter_map(|handle| handle.node()).collect();
        let psi = self.evaluate(inputs);
        let operations = trace.operations();
        let leaves = Leaves::new(nodes.iter().copied(), operations.len());
        let slope = |&node| slopes(trace, &operations, std::slice::from_ref(&psi), &leaves, node);
        nodes.iter().flat_map(slope).collect()
    }

    fn evaluate(&self, inputs: &[Handle]) -> Handle {
        let lookup = |wanted: Raw| inputs[self.place(wanted)].clone();
        let leaf = |leaf: &Leaf| match *leaf {
            Leaf::Invariant(named) => raw::invariant(named, &lookup),
            Leaf::Parameter(index) => Handle::constant(self.parameters[index as usize]),
        };
        self.psi.evaluate(leaf, &mut Vec::new())
    }

    fn inputs(&self, trace: &Trace) -> Vec<Handle> {
        (0..self.raws.len()).map(|place| trace.input(place)).collect()
    }

    fn place(&self, wanted: Raw) -> usize {
        self.raws.binary_search(&wanted).expect("every raw invariant of the tape is listed")
    }

    fn finish(&self, trace: Trace, outputs: Vec<Handle>) -> Program {
        let (graph, nodes) = trace.finish(outputs);
        Program::new(&graph, &nodes, self.raws.len())
    }
}
