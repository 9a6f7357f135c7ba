//! A flat program of real operations, run over a block of particles at a time.
//!
//! Owns dead-code removal, register allocation and the loop over operations. Each operation is
//! applied lane by lane, so a particle's result does not depend on its neighbours in the block.

use super::graph::{Binary, Graph, Node, Operation, Unary};
use crate::expression::{Comparison, elementary};

/// Particles worked on together.
pub(super) const LANES: usize = 16;

/// One quantity of the particles of a block.
pub(super) type Row = [f64; LANES];

type Register = u32;

#[derive(Debug, Clone, Copy)]
enum Instruction {
    Unary(Unary, Register, Register),
    Binary(Binary, Register, Register, Register),
    Select(Comparison, Register, [Register; 4]),
}

/// Registers: first the inputs, then the constants, then what is computed.
#[derive(Debug, Clone)]
pub(super) struct Program {
    inputs: usize,
    constants: Vec<f64>,
    instructions: Vec<Instruction>,
    outputs: Vec<Register>,
    registers: usize,
}

impl Program {
    /// The program of the outputs, over `inputs` quantities supplied from outside.
    pub(super) fn new(graph: &Graph, outputs: &[Node], inputs: usize) -> Self {
        let uses = count_uses(graph, outputs);
        let mut builder = Builder::new(graph, inputs, uses);
        let instructions = builder.instructions(graph);
        Self {
            inputs,
            constants: builder.constants,
            instructions,
            outputs: outputs.iter().map(|&node| builder.place[node as usize]).collect(),
            registers: builder.registers as usize,
        }
    }

    /// Operations a particle costs.
    pub(super) fn operations(&self) -> usize {
        self.instructions.len()
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
    #[inline(always)]
    pub(super) fn run(&self, rows: &mut [Row]) {
        for instruction in &self.instructions {
            match *instruction {
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
            }
        }
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

/// How often each node is read, outputs included; 0 is dead code.
fn count_uses(graph: &Graph, outputs: &[Node]) -> Vec<u32> {
    let mut uses = vec![0_u32; graph.nodes().len()];
    for &output in outputs {
        uses[output as usize] += 1;
    }
    for (node, operation) in graph.nodes().iter().enumerate().rev() {
        if uses[node] > 0 {
            for_children(operation, |child| uses[child as usize] += 1);
        }
    }
    uses
}

fn for_children(operation: &Operation, mut visit: impl FnMut(Node)) {
    match *operation {
        Operation::Input(_) | Operation::Constant(_) => {}
        Operation::Unary(_, x) => visit(x),
        Operation::Binary(_, x, y) => {
            visit(x);
            visit(y);
        }
        Operation::Select(_, nodes) => nodes.into_iter().for_each(visit),
    }
}

struct Builder {
    /// Reads still to come.
    left: Vec<u32>,
    /// Register of each node.
    place: Vec<Register>,
    constants: Vec<f64>,
    free: Vec<Register>,
    /// First register that may be reused.
    fixed: Register,
    registers: Register,
}

impl Builder {
    fn new(graph: &Graph, inputs: usize, left: Vec<u32>) -> Self {
        let mut place = vec![Register::MAX; graph.nodes().len()];
        let mut constants = Vec::new();
        for (node, operation) in graph.nodes().iter().enumerate() {
            match *operation {
                Operation::Input(input) => place[node] = input,
                Operation::Constant(bits) if left[node] > 0 => {
                    place[node] = (inputs + constants.len()) as Register;
                    constants.push(f64::from_bits(bits));
                }
                _ => {}
            }
        }
        let fixed = (inputs + constants.len()) as Register;
        Self { left, place, constants, free: Vec::new(), fixed, registers: fixed }
    }

    fn instructions(&mut self, graph: &Graph) -> Vec<Instruction> {
        let mut instructions = Vec::new();
        for (node, operation) in graph.nodes().iter().enumerate() {
            if self.left[node] == 0 || matches!(operation, Operation::Input(_) | Operation::Constant(_)) {
                continue;
            }
            let at = |node: Node| self.place[node as usize];
            let instruction = match *operation {
                Operation::Input(_) | Operation::Constant(_) => continue,
                Operation::Unary(function, x) => Instruction::Unary(function, 0, at(x)),
                Operation::Binary(function, x, y) => Instruction::Binary(function, 0, at(x), at(y)),
                Operation::Select(comparison, nodes) => Instruction::Select(comparison, 0, nodes.map(at)),
            };
            let to = self.allocate();
            for_children(operation, |child| self.release(child));
            self.place[node] = to;
            instructions.push(match instruction {
                Instruction::Unary(function, _, x) => Instruction::Unary(function, to, x),
                Instruction::Binary(function, _, x, y) => Instruction::Binary(function, to, x, y),
                Instruction::Select(comparison, _, from) => Instruction::Select(comparison, to, from),
            });
        }
        instructions
    }

    fn release(&mut self, node: Node) {
        self.left[node as usize] -= 1;
        let register = self.place[node as usize];
        if self.left[node as usize] == 0 && register >= self.fixed {
            self.free.push(register);
        }
    }

    fn allocate(&mut self) -> Register {
        self.free.pop().unwrap_or_else(|| {
            self.registers += 1;
            self.registers - 1
        })
    }
}
