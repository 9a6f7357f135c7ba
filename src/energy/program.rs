//! A flat program of real operations, run over a block of particles at a time.
//!
//! Owns the loop over operations and, inside it, those over directions. Each operation is
//! applied lane by lane, so a particle's result does not depend on its neighbours in the block.

use super::graph::{Binary, Graph, Node, TAUT_FROM, Unary};
use super::lanes::Vector;
use super::schedule;
use super::sphere::Rule;
use crate::expression::{Comparison, elementary};

/// Particles worked on together.
pub(super) const LANES: usize = 16;

/// One quantity of the particles of a block.
pub(super) type Row = [f64; LANES];

pub(super) type Register = u32;

/// One operation; the register written stands first.
#[derive(Debug, Clone, Copy)]
pub(super) enum Instruction {
    Unary(Unary, Register, Register),
    Binary(Binary, Register, Register, Register),
    Select(Comparison, Register, [Register; 4]),
    /// Adds a value times the weight of the direction at hand, the last register, to one of the partial sums
    /// that start at the first.
    Accumulate(Register, Register, Register),
    /// All of an integral over directions, by its place in the list of them.
    Integrals(u32),
}

/// Integrals over the same directions: one body, run once for each of them.
#[derive(Debug, Clone)]
pub(super) struct Integrals {
    pub(super) rule: Rule,
    /// `S` of the cone, where there is one.
    pub(super) shape: Option<[Register; 6]>,
    /// Where the components of the direction go.
    pub(super) running: [Register; 3],
    /// Where its weight goes.
    pub(super) weight: Register,
    pub(super) body: Vec<Instruction>,
    /// Where the sums go, and the first of as many partial sums as there are lanes.
    pub(super) sums: Vec<(Register, Register)>,
}

/// Registers: first the inputs, then the constants, then what is computed.
#[derive(Debug, Clone)]
pub(super) struct Program {
    pub(super) inputs: usize,
    pub(super) constants: Vec<f64>,
    pub(super) instructions: Vec<Instruction>,
    pub(super) integrals: Vec<Integrals>,
    pub(super) outputs: Vec<Register>,
    pub(super) registers: usize,
}

impl Program {
    /// The program of the outputs, over `inputs` quantities supplied from outside.
    pub(super) fn new(graph: &Graph, outputs: &[Node], inputs: usize) -> Self {
        schedule::program(graph, outputs, inputs)
    }

    /// The same program with brackets at their kink taken as loaded.
    pub(super) fn taut(&self) -> Self {
        let loaded = |instruction: &mut Instruction| {
            if let Instruction::Unary(function @ Unary::Step, ..) = instruction {
                *function = Unary::StepTaut;
            }
        };
        let mut taut = self.clone();
        taut.instructions.iter_mut().for_each(loaded);
        for integrals in &mut taut.integrals {
            integrals.body.iter_mut().for_each(loaded);
            integrals.rule = integrals.rule.lowered(TAUT_FROM);
        }
        taut
    }

    /// Operations a particle costs.
    pub(super) fn operations(&self) -> usize {
        let integrals = self.integrals.iter().map(|integrals| integrals.body.len() * integrals.rule.count());
        self.instructions.len() + integrals.sum::<usize>()
    }

    /// Rows the program needs.
    pub(super) fn registers(&self) -> usize {
        self.registers
    }

    /// Register of each output.
    pub(super) fn outputs(&self) -> &[Register] {
        &self.outputs
    }

    /// Whether an output is zero whatever the inputs.
    pub(super) fn is_zero(&self, output: usize) -> bool {
        let place = (self.outputs[output] as usize).checked_sub(self.inputs);
        place.and_then(|place| self.constants.get(place)) == Some(&0.0)
    }

    /// Fills the constants' rows; they stay through any number of runs.
    pub(super) fn prepare(&self, rows: &mut [Row]) {
        for (row, &constant) in rows[self.inputs..].iter_mut().zip(&self.constants) {
            *row = [constant; LANES];
        }
    }

    /// Runs the program over the block whose inputs are in the first rows.
    ///
    /// `is_alone` says that all lanes hold the same particle; the result is the same, sooner.
    #[inline(always)]
    pub(super) fn run(&self, rows: &mut [Row], is_alone: bool) {
        for instruction in &self.instructions {
            match *instruction {
                Instruction::Integrals(place) => self.integrals[place as usize].run(rows, is_alone),
                other => execute(other, rows, 0),
            }
        }
    }
}

impl Integrals {
    /// Sums the body over the directions of the rule.
    ///
    /// Direction `q` goes to partial sum `q mod 16` and these are added in order, so that one particle can
    /// be given sixteen directions at once, one a lane, with the same bits.
    #[inline(always)]
    fn run(&self, rows: &mut [Row], is_alone: bool) {
        let partial = if is_alone { 1 } else { LANES };
        for &(_, first) in &self.sums {
            rows[first as usize..][..partial].fill([0.0; LANES]);
        }
        let shape = self.shape.unwrap_or_default();
        let cones = self.rule.cones(shape.map(|register| &rows[register as usize]), is_alone);
        let mut turn = 0;
        let visit = |n: &Vector, weight: &Row| {
            for (&register, component) in self.running.iter().zip(n) {
                rows[register as usize] = *component;
            }
            rows[self.weight as usize] = *weight;
            for instruction in &self.body {
                execute(*instruction, rows, turn);
            }
            turn = (turn + 1) % partial;
        };
        if is_alone {
            self.rule.each_of_one(&cones, visit);
        } else {
            self.rule.each(&cones, visit);
        }
        for &(sum, first) in &self.sums {
            let mut total = [0.0; LANES];
            for part in 0..LANES {
                for lane in 0..LANES {
                    total[lane] += match is_alone {
                        true => rows[first as usize][part],
                        false => rows[first as usize + part][lane],
                    };
                }
            }
            rows[sum as usize] = total;
        }
    }
}

#[inline(always)]
fn execute(instruction: Instruction, rows: &mut [Row], turn: usize) {
    match instruction {
        Instruction::Unary(function, to, x) => {
            let [to, x] = disjoint(rows, [to, x]);
            unary(function, x, to);
        }
        Instruction::Binary(function, to, x, y) if x == y => {
            let [to, x] = disjoint(rows, [to, x]);
            binary(function, x, x, to);
        }
        Instruction::Binary(function, to, x, y) => {
            let [to, x, y] = disjoint(rows, [to, x, y]);
            binary(function, x, y, to);
        }
        Instruction::Select(comparison, to, from) => {
            let [left, right, then, otherwise] = from.map(|register| rows[register as usize]);
            let row = &mut rows[to as usize];
            for lane in 0..LANES {
                let holds = comparison.holds(left[lane], right[lane]);
                row[lane] = if holds { then[lane] } else { otherwise[lane] };
            }
        }
        Instruction::Accumulate(to, x, weight) => {
            let [to, x, weight] = disjoint(rows, [to + turn as Register, x, weight]);
            for lane in 0..LANES {
                // what has no weight counts nothing, even where it is no number
                let share = weight[lane] * x[lane];
                to[lane] += if weight[lane] == 0.0 { 0.0 } else { share };
            }
        }
        Instruction::Integrals(_) => {}
    }
}

#[inline(always)]
fn disjoint<const N: usize>(rows: &mut [Row], registers: [Register; N]) -> [&mut Row; N] {
    let places = registers.map(|register| register as usize);
    rows.get_disjoint_mut(places).expect("a result's register is none of its operands'")
}

#[inline(always)]
fn each(x: &Row, to: &mut Row, of: impl Fn(f64) -> f64) {
    for lane in 0..LANES {
        to[lane] = of(x[lane]);
    }
}

#[inline(always)]
fn unary(function: Unary, x: &Row, to: &mut Row) {
    match function {
        Unary::Negate => each(x, to, |x| -x),
        Unary::Reciprocal => each(x, to, |x| 1.0 / x),
        Unary::Sqrt => each(x, to, f64::sqrt),
        Unary::Pos => each(x, to, |x| Unary::Pos.of(x)),
        Unary::Step => each(x, to, |x| Unary::Step.of(x)),
        Unary::Exp => each(x, to, elementary::exp),
        Unary::ReciprocalCbrt => each(x, to, elementary::reciprocal_cbrt),
        other => each(x, to, |x| other.of(x)),
    }
}

#[inline(always)]
fn binary(function: Binary, x: &Row, y: &Row, to: &mut Row) {
    match function {
        Binary::Add => both(x, y, to, |x, y| x + y),
        Binary::Subtract => both(x, y, to, |x, y| x - y),
        Binary::Multiply => both(x, y, to, |x, y| x * y),
        Binary::Divide => both(x, y, to, |x, y| x / y),
        Binary::Power => both(x, y, to, |x, y| Binary::Power.of(x, y)),
    }
}

#[inline(always)]
fn both(x: &Row, y: &Row, to: &mut Row, of: impl Fn(f64, f64) -> f64) {
    for lane in 0..LANES {
        to[lane] = of(x[lane], y[lane]);
    }
}
