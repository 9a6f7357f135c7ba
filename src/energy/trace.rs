//! An energy's tape, run once over handles and their duals: its derivatives as programs.

use super::handle::{Handle, Trace};
use super::invariant::{Invariant, Leaf};
use super::program::Program;
use super::raw::{self, Raw};
use crate::expression::{Part, Scalar, Tape};
use num_dual::Dual;

/// A law to be traced: its tape, its parameters, the invariants it names and the raw ones.
pub(super) struct Source<'a> {
    pub(super) psi: &'a Tape<Leaf>,
    pub(super) parameters: &'a [f64],
    pub(super) live: &'a [Invariant],
    pub(super) raws: &'a [Raw],
}

/// Position of the second derivative by raw invariants `k <= l` in the list of them.
pub(super) fn pair(k: usize, l: usize) -> usize {
    debug_assert!(k <= l, "the upper triangle is stored");
    l * (l + 1) / 2 + k
}

impl Source<'_> {
    fn evaluate<T: Scalar>(&self, raws: &[T], scratch: &mut Vec<T>) -> T {
        let lookup = |wanted: Raw| raws[self.place(wanted)].clone();
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
    ///
    /// ψ is differentiated by the invariants it names; the rest is the chain rule, with all isochoric
    /// ones of a power `r^p`, `r = J^(-1/3)`, gathered before their slope `−p/3 r^(p+3)` by `J`.
    pub(super) fn gradient(&self) -> Program {
        let trace = Trace::new(false);
        let inputs = self.inputs(&trace);
        let mut outputs = vec![Handle::Constant(0.0); inputs.len()];
        let raw = |wanted: Raw| inputs[self.place(wanted)].clone();
        let mut gathered = [(); 5].map(|()| Handle::Constant(0.0));
        let mut add = |raw: Raw, share: Handle| {
            let output = &mut outputs[self.place(raw)];
            *output = output.clone() + share;
        };
        for &named in self.live {
            let d = self.slope_by(named, &inputs);
            if let Some((part, power)) = raw::isochoric(named) {
                let r = raw(Raw::J).reciprocal_cbrt();
                gathered[power as usize] = gathered[power as usize].clone() + d.clone() * raw(part);
                add(part, d * r.fixed_power(f64::from(power)));
            } else {
                for part in Raw::of(named).into_iter().filter(|part| !matches!(part, Raw::Dot(..))) {
                    let duals = seeded(&inputs, self.place(part));
                    let slope = raw::invariant(named, &|wanted| duals[self.place(wanted)].clone()).eps;
                    add(part, d.clone() * slope);
                }
            }
        }
        for (power, sum) in gathered.into_iter().enumerate() {
            if sum.fixed() != Some(0.0) {
                let r = raw(Raw::J).reciprocal_cbrt();
                let slope = r.fixed_power(power as f64) * (r.fixed_power(2.0) * r);
                add(Raw::J, sum * (slope * Handle::Constant(power as f64 / -3.0)));
            }
        }
        self.finish(trace, outputs)
    }

    /// `∂ψ/∂I` by one of the invariants the tape names.
    fn slope_by(&self, seed: Invariant, inputs: &[Handle]) -> Handle {
        let lookup = |wanted: Raw| inputs[self.place(wanted)].clone();
        let leaf = |leaf: &Leaf| match *leaf {
            Leaf::Invariant(named) => {
                let slope = if named == seed { 1.0 } else { 0.0 };
                Dual::new(raw::invariant(named, &lookup), Handle::Constant(slope))
            }
            Leaf::Parameter(index) => <Dual<Handle> as Scalar>::constant(self.parameters[index as usize]),
        };
        self.psi.evaluate(leaf, &mut Vec::new()).eps
    }

    fn place(&self, wanted: Raw) -> usize {
        let place = self.raws.iter().position(|&raw| raw == wanted);
        place.expect("every raw invariant of the tape is listed")
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
