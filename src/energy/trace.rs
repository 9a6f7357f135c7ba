//! An energy's tape, run once over handles, and its derivatives: all as programs.

use super::differentiate::{Leaves, slopes};
use super::graph::Node;
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
    /// Parameters that stay inputs of the programs, after the raw invariants; the others are constants.
    pub(super) varied: &'a [u32],
}

/// The programs of a law.
pub(super) struct Programs {
    /// `ψ`
    pub(super) density: Program,
    /// `∂ψ/∂I_k` in the order of the raw invariants.
    pub(super) gradient: Program,
    /// `∂ψ/∂I_k`, then `∂²ψ/∂I_k ∂I_l` at [`pair`]; brackets at their kink slack, and loaded.
    pub(super) hessians: [Program; 2],
}

/// Position of the second derivative by raw invariants `k <= l` in the list of them.
pub(super) fn pair(k: usize, l: usize) -> usize {
    debug_assert!(k <= l, "the upper triangle is stored");
    l * (l + 1) / 2 + k
}

impl Source<'_> {
    /// All programs of the law, from one graph.
    pub(super) fn programs(&self) -> Programs {
        let trace = Trace::default();
        let inputs = self.inputs(&trace);
        let psi = self.evaluate(&trace, &inputs);
        let gradient = self.traced_gradient(&trace, &inputs, &psi);
        let curvatures = self.traced_hessian(&trace, &inputs, &gradient);
        let density = trace.nodes(&[psi]);
        let mut second = trace.nodes(&gradient);
        let first = second.clone();
        second.extend(trace.nodes(&curvatures));
        let graph = trace.graph();
        let program = |outputs: &[Node]| Program::new(&graph, outputs, inputs.len());
        let slack = program(&second);
        let hessians = [slack.clone(), slack.taut()];
        Programs { density: program(&density), gradient: program(&first), hessians }
    }

    /// `∂²ψ/∂I_k ∂I_l` at [`pair`].
    fn traced_hessian(&self, trace: &Trace, inputs: &[Handle], gradient: &[Handle]) -> Vec<Handle> {
        let operations = trace.operations();
        let nodes: Vec<_> = inputs[..self.raws.len()].iter().filter_map(Handle::node).collect();
        let leaves = Leaves::new(nodes.iter().copied(), operations.len());
        let by = |(l, &node): (usize, &Node)| slopes(trace, &operations, &gradient[..=l], &leaves, node);
        nodes.iter().enumerate().flat_map(by).collect()
    }

    /// For each varied parameter θ in turn `∂ψ/∂θ`, then `∂²ψ/∂I_k∂θ` in the order of the raw invariants.
    pub(super) fn parameter_slopes(&self) -> Program {
        let trace = Trace::default();
        let inputs = self.inputs(&trace);
        let psi = self.evaluate(&trace, &inputs);
        let mut differentiated = vec![psi.clone()];
        differentiated.extend(self.traced_gradient(&trace, &inputs, &psi));
        let operations = trace.operations();
        let nodes: Vec<_> = inputs[self.raws.len()..].iter().filter_map(Handle::node).collect();
        let leaves = Leaves::new(nodes.iter().copied(), operations.len());
        let slope = |&node| slopes(&trace, &operations, &differentiated, &leaves, node);
        let outputs: Vec<Handle> = nodes.iter().flat_map(slope).collect();
        let outputs = trace.nodes(&outputs);
        let graph = trace.graph();
        Program::new(&graph, &outputs, inputs.len())
    }

    /// ψ is differentiated by the invariants it names; the rest is the chain rule, with all isochoric
    /// ones of a power `r^p`, `r = J^(-1/3)`, gathered before their slope `−p/3 r^(p+3)` by `J`.
    fn traced_gradient(&self, trace: &Trace, inputs: &[Handle], psi: &Handle) -> Vec<Handle> {
        let by_named = self.slopes_by_named(trace, inputs, psi);
        let mut outputs = vec![Handle::constant(0.0); self.raws.len()];
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
                for part in Raw::of(named).into_iter().filter(|part| !part.is_fixed()) {
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
    fn slopes_by_named(&self, trace: &Trace, inputs: &[Handle], psi: &Handle) -> Vec<Handle> {
        let lookup = |wanted: Raw| inputs[self.place(wanted)].clone();
        let named = self.live.iter().map(|&named| raw::invariant(named, &lookup));
        let nodes: Vec<_> = named.filter_map(|handle| handle.node()).collect();
        let operations = trace.operations();
        let leaves = Leaves::new(nodes.iter().copied(), operations.len());
        let slope = |&node| slopes(trace, &operations, std::slice::from_ref(psi), &leaves, node);
        nodes.iter().flat_map(slope).collect()
    }

    fn evaluate(&self, trace: &Trace, inputs: &[Handle]) -> Handle {
        let lookup = |wanted: Raw| inputs[self.place(wanted)].clone();
        let leaf = |leaf: &Leaf| match *leaf {
            Leaf::Invariant(named) => raw::invariant(named, &lookup),
            Leaf::Parameter(index) => match self.varied.iter().position(|&varied| varied == index) {
                Some(place) => inputs[self.raws.len() + place].clone(),
                None => Handle::constant(self.parameters[index as usize]),
            },
            Leaf::Running(axis) => trace.running(axis),
        };
        self.psi.evaluate(leaf, &mut Vec::new())
    }

    fn inputs(&self, trace: &Trace) -> Vec<Handle> {
        (0..self.raws.len() + self.varied.len()).map(|place| trace.input(place)).collect()
    }

    fn place(&self, wanted: Raw) -> usize {
        self.raws.binary_search(&wanted).expect("every raw invariant of the tape is listed")
    }
}
