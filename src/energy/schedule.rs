//! From a graph to a program: what is run when, and in which registers.
//!
//! Owns dead-code removal, the order of integrals over directions and what precedes them, and
//! register allocation. Knows no value of anything.

use super::graph::{Graph, Node, Operation, Unary};
use super::parity;
use super::program::{Instruction, Integrals, LANES, Program, Register};
use super::sphere::Rule;

/// The program of the outputs of a graph, over `inputs` quantities supplied from outside.
pub(super) fn program(graph: &Graph, outputs: &[Node], inputs: usize) -> Program {
    let order = Order::of(graph, outputs);
    let mut builder = Builder::new(graph, inputs, &order, outputs);
    for stage in &order.stages {
        for &node in &stage.nodes {
            builder.emit(node);
        }
        for group in &stage.groups {
            builder.integrals(group);
        }
    }
    Program {
        inputs,
        constants: builder.constants,
        instructions: builder.instructions,
        integrals: builder.integrals,
        outputs: outputs.iter().map(|&node| builder.place[node as usize]).collect(),
        registers: builder.registers as usize,
    }
}

fn for_children(graph: &Graph, node: Node, mut visit: impl FnMut(Node)) {
    match graph.nodes()[node as usize] {
        Operation::Input(_) | Operation::Constant(_) | Operation::Running(_) => {}
        // only its value is computed: the limits are for its derivatives
        Operation::Unary(_, x) | Operation::Between(x, _) => visit(x),
        Operation::Binary(_, x, y) => {
            visit(x);
            visit(y);
        }
        Operation::Select(_, nodes) => nodes.into_iter().for_each(visit),
        Operation::Directions(rule, body) => {
            visit(body);
            let cone = graph.domains()[rule as usize].cone;
            cone.into_iter().flat_map(|(shape, _)| shape).for_each(visit);
        }
    }
}

/// Integrals over the same directions that can be run together.
struct Group {
    rule: u32,
    /// Their nodes.
    sums: Vec<Node>,
    /// What is run in every direction, children before parents.
    body: Vec<Node>,
}

/// What can be run once the integrals of the stages before are known.
#[derive(Default)]
struct Stage {
    /// Nodes that do not depend on a direction, children before parents.
    nodes: Vec<Node>,
    groups: Vec<Group>,
}

/// The live nodes in the order they are run in.
struct Order {
    stages: Vec<Stage>,
    /// Whether a node depends on the direction an integral runs over.
    is_open: Vec<bool>,
}

impl Order {
    fn of(graph: &Graph, outputs: &[Node]) -> Self {
        let count = graph.nodes().len();
        let mut live = vec![false; count];
        for &output in outputs {
            live[output as usize] = true;
        }
        for node in (0..count).rev() {
            if live[node] {
                for_children(graph, node as Node, |child| live[child as usize] = true);
            }
        }
        let mut is_open = vec![false; count];
        let mut stage = vec![0_usize; count];
        let mut stages = vec![Stage::default()];
        for node in (0..count).filter(|&node| live[node]) {
            let (mut open, mut first) = (false, 0);
            for_children(graph, node as Node, |child| {
                open |= is_open[child as usize];
                first = first.max(stage[child as usize]);
            });
            match graph.nodes()[node] {
                Operation::Running(_) => open = true,
                Operation::Directions(rule, _) => {
                    let groups = &mut stages[first].groups;
                    match groups.iter_mut().find(|group| group.rule == rule) {
                        Some(group) => group.sums.push(node as Node),
                        None => groups.push(Group { rule, sums: vec![node as Node], body: vec![] }),
                    }
                    (open, first) = (false, first + 1);
                }
                _ => {}
            }
            while stages.len() <= first {
                stages.push(Stage::default());
            }
            (is_open[node], stage[node]) = (open, first);
            let is_run = !matches!(
                graph.nodes()[node],
                Operation::Input(_)
                    | Operation::Constant(_)
                    | Operation::Running(_)
                    | Operation::Directions(..)
            );
            if is_run && !open {
                stages[first].nodes.push(node as Node);
            }
        }
        let mut order = Self { stages, is_open };
        for stage in 0..order.stages.len() {
            for group in 0..order.stages[stage].groups.len() {
                let body = order.body(graph, &order.stages[stage].groups[group].sums);
                order.stages[stage].groups[group].body = body;
            }
        }
        order
    }

    /// The nodes some integrals need in every direction.
    fn body(&self, graph: &Graph, sums: &[Node]) -> Vec<Node> {
        let last = sums.iter().copied().max().unwrap_or_default() as usize;
        let mut needed = vec![false; last + 1];
        for &sum in sums {
            if let Operation::Directions(_, body) = graph.nodes()[sum as usize] {
                needed[body as usize] = true;
            }
        }
        for node in (0..=last).rev() {
            needed[node] &= self.is_open[node];
            if needed[node] {
                for_children(graph, node as Node, |child| needed[child as usize] = true);
            }
        }
        let is_run = |node: &Node| !matches!(graph.nodes()[*node as usize], Operation::Running(_));
        (0..=last).filter(|&node| needed[node]).map(|node| node as Node).filter(is_run).collect()
    }
}

struct Builder<'a> {
    graph: &'a Graph,
    is_open: &'a [bool],
    /// Reads still to come.
    left: Vec<u32>,
    /// Register of each node.
    place: Vec<Register>,
    constants: Vec<f64>,
    instructions: Vec<Instruction>,
    integrals: Vec<Integrals>,
    free: Vec<Register>,
    /// First register that may be reused.
    fixed: Register,
    registers: Register,
}

impl<'a> Builder<'a> {
    fn new(graph: &'a Graph, inputs: usize, order: &'a Order, outputs: &[Node]) -> Self {
        let count = graph.nodes().len();
        let mut left = vec![0_u32; count];
        for &output in outputs {
            left[output as usize] += 1;
        }
        for stage in &order.stages {
            for &node in &stage.nodes {
                for_children(graph, node, |child| left[child as usize] += 1);
            }
            for group in &stage.groups {
                for node in group.sums.iter().chain(&group.body) {
                    for_children(graph, *node, |child| left[child as usize] += 1);
                }
            }
        }
        let mut place = vec![Register::MAX; count];
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
        Self {
            graph,
            is_open: &order.is_open,
            left,
            place,
            constants,
            instructions: Vec::new(),
            integrals: Vec::new(),
            free: Vec::new(),
            fixed,
            registers: fixed,
        }
    }

    /// The instruction of a node; what is read for the last time frees its register if `frees` says so.
    fn instruction(&mut self, node: Node, frees: impl Fn(&Self, Node) -> bool) -> Instruction {
        let at = |node: Node| self.place[node as usize];
        let instruction = match self.graph.nodes()[node as usize] {
            Operation::Unary(function, x) => Instruction::Unary(function, 0, at(x)),
            Operation::Binary(function, x, y) => Instruction::Binary(function, 0, at(x), at(y)),
            Operation::Select(comparison, nodes) => Instruction::Select(comparison, 0, nodes.map(at)),
            Operation::Between(value, _) => Instruction::Unary(Unary::Same, 0, at(value)),
            _ => unreachable!("inputs, constants and integrals are not run one by one"),
        };
        let to = self.allocate();
        for_children(self.graph, node, |child| {
            if frees(self, child) {
                self.release(child);
            }
        });
        self.place[node as usize] = to;
        match instruction {
            Instruction::Unary(function, _, x) => Instruction::Unary(function, to, x),
            Instruction::Binary(function, _, x, y) => Instruction::Binary(function, to, x, y),
            Instruction::Select(comparison, _, from) => Instruction::Select(comparison, to, from),
            other => other,
        }
    }

    fn emit(&mut self, node: Node) {
        let instruction = self.instruction(node, |_, _| true);
        self.instructions.push(instruction);
    }

    /// Integrals over one set of directions; what they read from outside stays until they are done.
    fn integrals(&mut self, group: &Group) {
        let graph = self.graph;
        let sums: Vec<(Register, Register)> = group
            .sums
            .iter()
            .map(|_| {
                let first = self.registers;
                self.registers += LANES as Register;
                (self.allocate(), first)
            })
            .collect();
        let running = [(); 3].map(|()| self.allocate());
        let weight = self.allocate();
        for (node, operation) in graph.nodes().iter().enumerate() {
            if let Operation::Running(axis) = *operation {
                self.place[node] = running[usize::from(axis)];
            }
        }
        let domain = graph.domains()[group.rule as usize];
        let above = domain.cone.map(|(_, bits)| f64::from_bits(bits));
        let rule = Rule::new(domain.order, above, parity::is_even(graph, &group.sums, &group.body));
        let shape = domain.cone.map(|(shape, _)| shape.map(|node| self.place[node as usize]));
        let is_open = |builder: &Self, node: Node| {
            builder.is_open[node as usize]
                && !matches!(builder.graph.nodes()[node as usize], Operation::Running(_))
        };
        // the integrals of the group that read a node of the body, itself last computed there
        let mut body = Vec::new();
        let summed = |node: Node| match graph.nodes()[node as usize] {
            Operation::Directions(_, body) => body,
            _ => node,
        };
        let outside = |body: &mut Vec<Instruction>, builder: &mut Self, node: Option<Node>| {
            for (&sum, &(_, to)) in group.sums.iter().zip(&sums) {
                let of = summed(sum);
                let is_here = match node {
                    Some(node) => of == node,
                    None => !is_open(builder, of),
                };
                if is_here {
                    body.push(Instruction::Accumulate(to, builder.place[of as usize], weight));
                    if node.is_some() {
                        builder.release(of);
                    }
                }
            }
        };
        outside(&mut body, self, None);
        for &node in &group.body {
            let instruction = self.instruction(node, is_open);
            body.push(instruction);
            outside(&mut body, self, Some(node));
        }
        self.free.extend(running.into_iter().chain([weight]));
        // what is read from outside
        for &node in group.sums.iter().chain(&group.body) {
            for_children(graph, node, |child| {
                if !is_open(self, child) {
                    self.release(child);
                }
            });
        }
        for (&node, &(sum, _)) in group.sums.iter().zip(&sums) {
            self.place[node as usize] = sum;
        }
        self.instructions.push(Instruction::Integrals(self.integrals.len() as u32));
        self.integrals.push(Integrals { rule, shape, running, weight, body, sums });
    }

    fn release(&mut self, node: Node) {
        if matches!(self.graph.nodes()[node as usize], Operation::Running(_)) {
            return;
        }
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
