//! Bodies that share the nodes of an interface.
//!
//! Owns which nodes are one, and how the forces of the bodies meet on them; faces without common nodes are tied. Knows no
//! material.

use super::body::BodyState;
use super::error::SolveError;
use super::quad::Quad;
use super::tie::Tie;
use crate::discretisation::{Consistency, Particles};
use crate::expression::Tape;
use crate::scene::{Bond, Region, Scene};
use crate::tensor::Vec3;
use std::collections::{BTreeMap, BTreeSet};

/// Share of the spacing within which two nodes are one.
const ONE: f64 = 1e-6;

/// Nodes of several bodies at one place, moving as one.
///
/// ```text
/// (Σ_i m_i) dv/dt = Σ_i f_i,    m_i = ρ_i V_i,   f_i the force on the node in its own body
/// ```
///
/// Every body keeps its own gradient, so F may jump across the interface while x and v are the same
/// to the last bit; what one body exerts on the other is equal and opposite at one point, so linear
/// and angular momentum are conserved as within a body. The highest frequency of the bonded bodies is
/// at most that of the stiffest of them alone (a constraint never raises the largest Rayleigh
/// quotient), so the stable step is theirs.
#[derive(Debug, Clone, PartialEq)]
struct Cluster {
    /// Body and node of each member.
    member: Vec<(usize, usize)>,
    /// Mass of each member over the mass of all.
    share: Vec<f64>,
    /// For each component the members whose motion is prescribed; the first leads the others.
    led: [Vec<usize>; 3],
}

/// All bonds of a simulation.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Bonds {
    clusters: Vec<Cluster>,
    ties: Vec<Tie>,
}

impl Bonds {
    /// For each bond of a scene the tie of its faces where their nodes do not meet but they are one region.
    ///
    /// Gradients exact for quadratic fields need areas balanced to second degree, which those of a tie are not.
    pub fn ties(scene: &Scene, particles: &mut [Particles]) -> Vec<Option<Tie>> {
        let tie = |Bond { first, second, .. }: &Bond| {
            let apart = matched(&particles.iter().collect::<Vec<_>>(), first, second).is_err();
            let fits = scene.run.consistency != Consistency::Quadratic;
            if apart && fits { Tie::between(particles, first, second) } else { None }
        };
        scene.bonds.iter().map(tie).collect()
    }

    /// Finds the shared nodes of a scene's bonds and makes their positions and velocities one.
    ///
    /// # Errors
    /// [`SolveError::NotBonded`] if the nodes of neither face lie on those of the other,
    /// [`SolveError::BondedApart`] if a shared node is told to move in two ways.
    pub fn new(scene: &Scene, bodies: &mut [BodyState], ties: Vec<Option<Tie>>) -> Result<Self, SolveError> {
        let mut joined = Joined::default();
        let (mut hung, mut met) = (BTreeSet::new(), BTreeSet::new());
        for (Bond { first, second, .. }, tie) in scene.bonds.iter().zip(&ties) {
            let name = |region: &Region| format!("{}.{}", bodies[region.body].name, region.face);
            // a node hangs on one face alone, and nothing else is joined to it
            let twice = tie
                .iter()
                .flat_map(Tie::nodes)
                .filter(|at| !hung.insert(*at) || met.contains(at))
                .collect::<Vec<_>>();
            if let Some(&(body, a)) = twice.first() {
                let position = bodies[body].particles.position[a];
                let (first, second) = (name(first), name(second));
                return Err(SolveError::NotBonded { first, second, unmatched: twice.len(), position });
            }
            if tie.is_some() {
                continue;
            }
            let particles: Vec<&Particles> = bodies.iter().map(|body| &body.particles).collect();
            let pairs = matched(&particles, first, second).map_err(|(unmatched, position)| {
                SolveError::NotBonded { first: name(first), second: name(second), unmatched, position }
            })?;
            let shared = pairs
                .iter()
                .find(|(a, b)| hung.contains(&(first.body, *a)) || hung.contains(&(second.body, *b)));
            if let Some((a, _)) = shared {
                let position = bodies[first.body].particles.position[*a];
                let (first, second) = (name(first), name(second));
                return Err(SolveError::NotBonded { first, second, unmatched: 1, position });
            }
            met.extend(pairs.iter().flat_map(|(a, b)| [(first.body, *a), (second.body, *b)]));
            pairs.into_iter().for_each(|(a, b)| joined.join((first.body, a), (second.body, b)));
        }
        let clusters =
            joined.groups().map(|member| cluster(bodies, member)).collect::<Result<Vec<_>, SolveError>>()?;
        for Cluster { member, share, .. } in &clusters {
            let x = bodies[member[0].0].x[member[0].1];
            let v = member.iter().zip(share).map(|(&(body, a), &share)| bodies[body].v[a] * share);
            let v = v.fold(Quad::ZERO, |sum, v| sum + v);
            for &(body, a) in member {
                (bodies[body].x[a], bodies[body].v[a]) = (x, v);
            }
        }
        let mut ties: Vec<Tie> = ties.into_iter().flatten().collect();
        ties.iter_mut().try_for_each(|tie| tie.meet(bodies))?;
        Ok(Self { clusters, ties })
    }

    /// Gives all members of a cluster the acceleration of their common mass; a force on a member that
    /// is led goes to the one that leads it, whose support carries it.
    pub fn share_forces(&mut self, bodies: &mut [BodyState]) {
        self.ties.iter_mut().for_each(|tie| tie.share_forces(bodies));
        for Cluster { member, share, led } in &self.clusters {
            for (axis, led) in led.iter().enumerate() {
                let of = |bodies: &[BodyState], i: usize| -> f64 {
                    let (body, a) = member[i];
                    bodies[body].acceleration[a].0[axis]
                };
                match led.first() {
                    None => {
                        let mean: f64 = (0..member.len()).map(|i| share[i] * of(bodies, i)).sum();
                        for &(body, a) in member {
                            bodies[body].acceleration[a].0[axis] = mean;
                        }
                    }
                    Some(&leader) => {
                        for i in (0..member.len()).filter(|i| !led.contains(i)) {
                            let carried = of(bodies, i) * share[i] / share[leader];
                            let ((body, a), (own, b)) = (member[leader], member[i]);
                            bodies[body].acceleration[a].0[axis] += carried;
                            bodies[own].acceleration[b].0[axis] = 0.0;
                        }
                    }
                }
            }
        }
    }

    /// Gives members the prescribed velocity of the one that leads them.
    ///
    /// What this changes of a member's momentum comes through the support that leads: `carried` is told the body and the
    /// number of that support, and the change, kg m/s.
    pub fn follow(&self, bodies: &mut [BodyState], carried: &mut impl FnMut(usize, usize, f64)) {
        self.ties.iter().for_each(|tie| tie.follow(bodies, carried));
        for Cluster { member, led, .. } in &self.clusters {
            for (axis, led) in led.iter().enumerate() {
                let Some(&leader) = led.first() else { continue };
                let (body, a) = member[leader];
                let velocity = bodies[body].v[a].0[axis];
                let support = bodies[body].support_of(a, axis);
                for (i, &(own, b)) in member.iter().enumerate() {
                    let BodyState { density, particles, v, .. } = &mut bodies[own];
                    if let (Some(support), false) = (support, led.contains(&i)) {
                        let change = velocity - v[b].0[axis];
                        carried(body, support, *density * particles.volume[b] * change);
                    }
                    v[b].0[axis] = velocity;
                }
            }
        }
    }

    /// For each body the number of the bonded group it belongs to.
    pub fn groups(scene: &Scene) -> Vec<usize> {
        let mut group: Vec<usize> = (0..scene.bodies.len()).collect();
        for Bond { first, second, .. } in &scene.bonds {
            let (a, b) = (group[first.body], group[second.body]);
            group.iter_mut().filter(|group| **group == b).for_each(|group| *group = a);
        }
        group
    }
}

/// Nodes of two faces at the same places, as pairs: all nodes of the face that has fewer, and all of the
/// other within the bounds of that one.
///
/// Otherwise the number of nodes left over, and the place of the first.
fn matched(
    particles: &[&Particles],
    first: &Region,
    second: &Region,
) -> Result<Vec<(usize, usize)>, (usize, Vec3)> {
    let nodes = |region: &Region| particles[region.body].face(&region.face).map(|face| &face.nodes);
    let (Some(a), Some(b)) = (nodes(first), nodes(second)) else { return Ok(Vec::new()) };
    let (few, many) = if a.len() <= b.len() { ((first, a), (second, b)) } else { ((second, b), (first, a)) };
    let position = |region: &Region, node: u32| particles[region.body].position[node as usize];
    let spacing = [first, second].map(|region| particles[region.body].least_spacing);
    let tolerance = ONE * spacing[0].min(spacing[1]);
    // by the coordinate that differs most, so that a search looks at few
    let extent = |axis: usize| {
        let at = many.1.iter().map(|&node| position(many.0, node)[axis]);
        at.clone().fold(f64::NEG_INFINITY, f64::max) - at.fold(f64::INFINITY, f64::min)
    };
    let axis = (0..3).max_by(|&i, &j| extent(i).total_cmp(&extent(j))).unwrap_or(0);
    let mut sorted: Vec<(f64, u32)> =
        many.1.iter().map(|&node| (position(many.0, node)[axis], node)).collect();
    sorted.sort_by(|s, t| s.0.total_cmp(&t.0));
    let mut pairs = Vec::with_capacity(few.1.len());
    let mut left = Vec::new();
    for &node in few.1 {
        let at = position(few.0, node);
        let start = sorted.partition_point(|(x, _)| *x < at[axis] - tolerance);
        let near = sorted[start..].iter().take_while(|(x, _)| *x <= at[axis] + tolerance);
        let found = near.map(|(_, other)| *other).find(|&o| (position(many.0, o) - at).norm() <= tolerance);
        match found {
            Some(other) if few.0 == first => pairs.push((node as usize, other as usize)),
            Some(other) => pairs.push((other as usize, node as usize)),
            None => left.push(at),
        }
    }
    // nodes of the other face between those of this one would be left hanging
    let start = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
    let places = few.1.iter().map(|&node| position(few.0, node));
    let (low, high) = places.fold(start, |(low, high), x| (low.inf(&x), high.sup(&x)));
    let taken: BTreeSet<usize> = pairs.iter().map(|&(a, b)| if many.0 == first { a } else { b }).collect();
    for &node in many.1 {
        let at = position(many.0, node);
        let within = (0..3).all(|i| at[i] >= low[i] - tolerance && at[i] <= high[i] + tolerance);
        if within && !taken.contains(&(node as usize)) {
            left.push(at);
        }
    }
    left.first().map_or(Ok(pairs), |at| Err((left.len(), *at)))
}

fn cluster(bodies: &[BodyState], member: Vec<(usize, usize)>) -> Result<Cluster, SolveError> {
    let mass = |&(body, a): &(usize, usize)| bodies[body].density * bodies[body].particles.volume[a];
    let total: f64 = member.iter().map(mass).sum();
    let share = member.iter().map(|at| mass(at) / total).collect();
    let mut led: [Vec<usize>; 3] = Default::default();
    for (axis, led) in led.iter_mut().enumerate() {
        let mut told: Option<(&str, Tape<_>)> = None;
        for (i, &(body, a)) in member.iter().enumerate() {
            let supports = bodies[body].supports.iter();
            let mut own =
                supports.filter(|s| s.axis == axis && s.nodes.binary_search(&(a as u32)).is_ok()).peekable();
            if own.peek().is_some() {
                led.push(i);
            }
            for support in own {
                let tape = support.displacement.clone().unwrap_or_else(|| Tape::constant(0.0));
                match &told {
                    Some((other, known)) if *known != tape => {
                        return Err(SolveError::BondedApart {
                            first: (*other).to_string(),
                            second: bodies[body].name.clone(),
                            axis: ['x', 'y', 'z'][axis],
                            position: bodies[body].particles.position[a],
                        });
                    }
                    Some(_) => {}
                    None => told = Some((&bodies[body].name, tape)),
                }
            }
        }
    }
    Ok(Cluster { member, share, led })
}

/// Nodes joined to clusters.
#[derive(Debug, Default)]
struct Joined {
    cluster: BTreeMap<(usize, usize), usize>,
    members: Vec<Vec<(usize, usize)>>,
}

impl Joined {
    fn join(&mut self, first: (usize, usize), second: (usize, usize)) {
        match (self.cluster.get(&first).copied(), self.cluster.get(&second).copied()) {
            (None, None) => {
                let index = self.members.len();
                self.members.push(vec![first, second]);
                self.cluster.extend([(first, index), (second, index)]);
            }
            (Some(index), None) => self.add(index, second),
            (None, Some(index)) => self.add(index, first),
            (Some(a), Some(b)) if a != b => {
                for member in std::mem::take(&mut self.members[b]) {
                    self.add(a, member);
                }
            }
            _ => {}
        }
    }

    fn add(&mut self, index: usize, member: (usize, usize)) {
        self.members[index].push(member);
        self.cluster.insert(member, index);
    }

    /// The clusters, members ascending, in the order of their first.
    fn groups(self) -> impl Iterator<Item = Vec<(usize, usize)>> {
        let mut groups: Vec<_> = self.members.into_iter().filter(|group| !group.is_empty()).collect();
        groups.iter_mut().for_each(|group| group.sort_unstable());
        groups.sort_unstable();
        groups.into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_joined_in_any_order_form_one_cluster() {
        let mut joined = Joined::default();
        joined.join((0, 1), (1, 7));
        joined.join((2, 3), (3, 4));
        joined.join((1, 7), (2, 3));
        joined.join((5, 0), (6, 0));
        let groups: Vec<_> = joined.groups().collect();
        assert_eq!(groups, [vec![(0, 1), (1, 7), (2, 3), (3, 4)], vec![(5, 0), (6, 0)]]);
    }
}
