//! Faces of two bodies that touch without sharing nodes.
//!
//! Owns how the nodes of the finer face hang on the coarser, and how forces go back. Knows no material.

use super::body::BodyState;
use super::error::SolveError;
use super::quad::Quad;
use crate::discretisation::Particles;
use crate::scene::Region;
use crate::tensor::{Mat3, Vec3};

/// Share of the spacing within which a node lies on a quadrilateral, and of their size within which two faces are one.
const ON: f64 = 1e-6;
const SAME: f64 = 1e-9;

/// What is left of the forces on the common nodes, relative and squared, when the masses are solved for.
const LEFT: f64 = 1e-30;
const ITERATIONS: usize = 200;

/// A node of the finer face and the four of the coarser it hangs on.
#[derive(Debug, Clone, PartialEq)]
struct Row {
    slave: u32,
    /// Index among the nodes of the coarser face, and bilinear weight.
    part: [(u32, f64); 4],
    mass: f64,
    /// Components a support of its own prescribes.
    led: [bool; 3],
}

/// The finer of two faces hung on the coarser.
///
/// ```text
/// x_s = Σ_m w_sm x_m,    (M_m + Wᵀ M_s W) a_m = f_m + Wᵀ f_s,    a_s = W a_m
/// A_m = −Σ_s w_sm A_s
/// ```
///
/// The constraint does no work and holds for every rigid motion, so linear and angular momentum are conserved as within a
/// body, and it raises no frequency. The weights are bilinear in the reference, so affine maps meet it; with the
/// coarser face's areas taken from the finer's, which have the same sum and first moments, a uniform stress is in
/// equilibrium on every node, whatever the spacings.
#[derive(Debug, Clone, PartialEq)]
pub struct Tie {
    master: usize,
    slave: usize,
    /// Nodes of the coarser face.
    node: Vec<u32>,
    row: Vec<Row>,
    mass: Vec<f64>,
    /// Components of the coarser nodes that supports prescribe.
    held: Vec<[bool; 3]>,
    /// Inverse diagonal of the common mass, and room to solve with it.
    inverse: Vec<f64>,
    room: [Vec<Quad>; 4],
}

impl Tie {
    /// Hangs the finer of two faces on the coarser and gives that the finer's areas; `None` if they are not one region.
    pub fn between(particles: &mut [Particles], first: &Region, second: &Region) -> Option<Self> {
        let count = |region: &Region| particles[region.body].face(&region.face).map(|face| face.nodes.len());
        let (coarse, fine) = if count(first)? <= count(second)? { (first, second) } else { (second, first) };
        let (master, slave) = (&particles[coarse.body], &particles[fine.body]);
        let (base, over) = (master.face(&coarse.face)?, slave.face(&fine.face)?);
        let corners: Vec<[Vec3; 4]> =
            base.quads.iter().map(|quad| quad.map(|a| master.position[a as usize])).collect();
        let tolerance = ON * master.least_spacing.min(slave.least_spacing);
        let mut row = Vec::with_capacity(over.nodes.len());
        let mut area = vec![Vec3::zeros(); base.nodes.len()];
        for (&node, normal) in over.nodes.iter().zip(&over.area) {
            let x = slave.position[node as usize];
            let found = corners.iter().zip(&base.quads).find_map(|(corner, quad)| {
                let weight = weights(corner, &x, tolerance)?;
                let index = quad.map(|a| base.nodes.binary_search(&a).ok());
                let at = |k: usize| index[k].map(|index| (index as u32, weight[k]));
                Some([at(0)?, at(1)?, at(2)?, at(3)?])
            })?;
            found.iter().for_each(|&(index, weight)| area[index as usize] -= weight * normal);
            row.push(Row { slave: node, part: found, mass: 0.0, led: [false; 3] });
        }
        let moments = |area: &[Vec3]| -> (Vec3, Mat3) {
            let pairs = || base.nodes.iter().zip(area).map(|(&a, n)| (master.position[a as usize], n));
            (pairs().map(|(_, n)| n).sum(), pairs().map(|(x, n)| x * n.transpose()).sum())
        };
        let ((sum, first), (own, own_first)) = (moments(&area), moments(&base.area));
        let size = own.norm();
        if (sum - own).norm() > SAME * size || (first - own_first).norm() > SAME * size * libm::sqrt(size) {
            return None;
        }
        let node = base.nodes.clone();
        let (master, slave) = (coarse.body, fine.body);
        let face = particles[master].faces.iter_mut().find(|face| face.name == coarse.face)?;
        face.area = area;
        let held = vec![[false; 3]; node.len()];
        let room = std::array::from_fn(|_| vec![Quad::ZERO; node.len()]);
        Some(Self { master, slave, mass: vec![0.0; node.len()], inverse: vec![], node, row, held, room })
    }

    /// Bodies and nodes of both faces.
    pub fn nodes(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let master = self.node.iter().map(|&a| (self.master, a as usize));
        master.chain(self.row.iter().map(|row| (self.slave, row.slave as usize)))
    }

    /// Reads masses and supports, and makes positions and velocities meet the tie without a change of momentum.
    ///
    /// # Errors
    /// [`SolveError::BondedApart`] if a hanging node is told to move otherwise than those it hangs on.
    pub fn meet(&mut self, bodies: &mut [BodyState]) -> Result<(), SolveError> {
        let mass = |body: &BodyState, a: u32| body.density * body.particles.volume[a as usize];
        let (master, slave) = (&bodies[self.master], &bodies[self.slave]);
        let told = |body: &BodyState, axis: usize, a: u32| {
            let mut own =
                body.supports.iter().filter(|s| s.axis == axis && s.nodes.binary_search(&a).is_ok());
            own.next().map(|support| support.displacement.clone())
        };
        for (i, &a) in self.node.iter().enumerate() {
            self.mass[i] = mass(master, a);
            self.held[i] = [0, 1, 2].map(|axis| told(master, axis, a).is_some());
        }
        for row in &mut self.row {
            row.mass = mass(slave, row.slave);
            for axis in 0..3 {
                let Some(own) = told(slave, axis, row.slave) else { continue };
                row.led[axis] = true;
                let carried = row.part.iter().filter(|(_, weight)| *weight > SAME);
                if carried
                    .clone()
                    .any(|&(i, _)| told(master, axis, self.node[i as usize]) != Some(own.clone()))
                {
                    return Err(SolveError::BondedApart {
                        first: slave.name.clone(),
                        second: master.name.clone(),
                        axis: ['x', 'y', 'z'][axis],
                        position: slave.particles.position[row.slave as usize],
                    });
                }
            }
        }
        self.inverse = self.mass.clone();
        for Row { part, mass, .. } in &self.row {
            part.iter().for_each(|&(i, weight)| self.inverse[i as usize] += weight * weight * mass);
        }
        self.inverse.iter_mut().for_each(|diagonal| *diagonal = 1.0 / *diagonal);
        for row in &self.row {
            let place = self.hanging(row, &bodies[self.master].x);
            bodies[self.slave].x[row.slave as usize] = place;
        }
        self.share(bodies, |body| &mut body.v);
        Ok(())
    }

    /// Gives both faces the acceleration of their common masses; a force on a component that is held stays with its
    /// support.
    pub fn share_forces(&mut self, bodies: &mut [BodyState]) {
        self.share(bodies, |body| &mut body.acceleration);
    }

    /// Gives hanging nodes the velocity of those they hang on.
    ///
    /// What this changes of their momentum comes through the supports of those, by their weights; `carried` as in
    /// `Bonds::follow`.
    pub fn follow(&self, bodies: &mut [BodyState], carried: &mut impl FnMut(usize, usize, f64)) {
        for row in &self.row {
            let velocity = self.hanging(row, &bodies[self.master].v);
            for axis in (0..3).filter(|&axis| !row.led[axis]) {
                let master = &bodies[self.master];
                let held = |(i, weight): &(u32, f64)| {
                    (*weight > 0.0).then_some(())?;
                    Some((master.support_of(self.node[*i as usize] as usize, axis)?, *weight))
                };
                let own = bodies[self.slave].v[row.slave as usize].0[axis];
                let change = row.mass * (velocity.0[axis] - own);
                let all: f64 = row.part.iter().filter_map(held).map(|(_, weight)| weight).sum();
                for (support, weight) in row.part.iter().filter_map(held) {
                    carried(self.master, support, change * (weight / all));
                }
                bodies[self.slave].v[row.slave as usize].0[axis] = velocity.0[axis];
            }
        }
    }

    /// What a quantity of the coarser body is at a hanging node.
    fn hanging(&self, row: &Row, of: &[Quad]) -> Quad {
        let at = |&(i, weight): &(u32, f64)| of[self.node[i as usize] as usize] * weight;
        row.part.iter().map(at).fold(Quad::ZERO, |sum, part| sum + part)
    }

    /// Replaces a quantity by what conserves its sum weighted by mass and meets the tie: preconditioned conjugate
    /// gradients, which masses no worse than those of neighbours let end in some twenty rounds.
    fn share(&mut self, bodies: &mut [BodyState], of: impl Fn(&mut BodyState) -> &mut Vec<Quad>) {
        let Self { master, slave, node, row, mass, held, inverse, room } = self;
        let [solution, left, along, image] = room;
        let free = |held: &[bool; 3], of: Quad| {
            let mut of = of;
            (0..3).filter(|&axis| held[axis]).for_each(|axis| of.0[axis] = 0.0);
            of
        };
        for ((left, &a), mass) in left.iter_mut().zip(&*node).zip(&*mass) {
            *left = of(&mut bodies[*master])[a as usize] * *mass;
        }
        for Row { slave: a, part, mass, led } in &*row {
            let force = free(led, of(&mut bodies[*slave])[*a as usize] * *mass);
            part.iter().for_each(|&(i, weight)| left[i as usize] += force * weight);
        }
        // held components keep all that came to them, for the reaction
        for (i, &a) in node.iter().enumerate() {
            of(&mut bodies[*master])[a as usize] = left[i] * (1.0 / mass[i]);
            left[i] = free(&held[i], left[i]);
            (solution[i], along[i]) = (Quad::ZERO, left[i] * inverse[i]);
        }
        let mut square: f64 = left.iter().zip(&*along).map(|(r, z)| r.dot(*z)).sum();
        let enough = LEFT * square;
        for _ in 0..ITERATIONS {
            if square <= enough {
                break;
            }
            for ((image, along), mass) in image.iter_mut().zip(&*along).zip(&*mass) {
                *image = *along * *mass;
            }
            for Row { part, mass, led, .. } in &*row {
                let hung = part.iter().fold(Quad::ZERO, |sum, &(i, weight)| sum + along[i as usize] * weight);
                let force = free(led, hung * *mass);
                part.iter().for_each(|&(i, weight)| image[i as usize] += force * weight);
            }
            image.iter_mut().zip(&*held).for_each(|(image, held)| *image = free(held, *image));
            let step = square / along.iter().zip(&*image).map(|(p, q)| p.dot(*q)).sum::<f64>();
            for i in 0..node.len() {
                solution[i] += along[i] * step;
                left[i] = left[i] - image[i] * step;
            }
            let next: f64 = left.iter().zip(&*inverse).map(|(r, inverse)| r.dot(*r) * inverse).sum();
            for i in 0..node.len() {
                along[i] = left[i] * inverse[i] + along[i] * (next / square);
            }
            square = next;
        }
        for (i, &a) in node.iter().enumerate() {
            let own = &mut of(&mut bodies[*master])[a as usize];
            (0..3).filter(|&axis| !held[i][axis]).for_each(|axis| own.0[axis] = solution[i].0[axis]);
        }
        for Row { slave: a, part, mass: hanging, led } in &*row {
            let hung = part.iter().fold(Quad::ZERO, |sum, &(i, weight)| sum + solution[i as usize] * weight);
            let own = &mut of(&mut bodies[*slave])[*a as usize];
            (0..3).filter(|&axis| !led[axis]).for_each(|axis| own.0[axis] = hung.0[axis]);
            // a hanging node takes its own inertia out of what comes to those it hangs on, the held ones too
            for &(i, weight) in part {
                let (i, kept) = (i as usize, hung * (weight * *hanging / mass[i as usize]));
                let carrier = &mut of(&mut bodies[*master])[node[i] as usize];
                let of_support = |axis: &usize| held[i][*axis] && !led[*axis];
                (0..3).filter(of_support).for_each(|axis| carrier.0[axis] -= kept.0[axis]);
            }
        }
    }
}

/// Bilinear weights of the corners of a quadrilateral at a point on it, by Newton's iteration.
fn weights(corner: &[Vec3; 4], x: &Vec3, tolerance: f64) -> Option<[f64; 4]> {
    const PLACE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let low = corner.iter().skip(1).fold(corner[0], |low, x| low.inf(x)) - Vec3::repeat(tolerance);
    let high = corner.iter().skip(1).fold(corner[0], |high, x| high.sup(x)) + Vec3::repeat(tolerance);
    if (0..3).any(|i| x[i] < low[i] || x[i] > high[i]) {
        return None;
    }
    let (mut s, mut t) = (0.0, 0.0);
    for _ in 0..20 {
        let weight = PLACE.map(|[p, q]| 0.25 * (1.0 + p * s) * (1.0 + q * t));
        let at: Vec3 = corner.iter().zip(weight).map(|(x, w)| x * w).sum();
        let left = x - at;
        let along_s: Vec3 = corner.iter().zip(PLACE).map(|(x, [p, q])| x * (0.25 * p * (1.0 + q * t))).sum();
        let along_t: Vec3 = corner.iter().zip(PLACE).map(|(x, [p, q])| x * (0.25 * q * (1.0 + p * s))).sum();
        let (a, b, c) = (along_s.dot(&along_s), along_s.dot(&along_t), along_t.dot(&along_t));
        let (f, g) = (along_s.dot(&left), along_t.dot(&left));
        let determinant = a * c - b * b;
        let (ds, dt) = ((c * f - b * g) / determinant, (a * g - b * f) / determinant);
        (s, t) = (s + ds, t + dt);
        if ds.abs() + dt.abs() < 1e-15 {
            break;
        }
    }
    let inside = s.abs() <= 1.0 + ON && t.abs() <= 1.0 + ON;
    let weight = PLACE.map(|[p, q]| 0.25 * (1.0 + p * s) * (1.0 + q * t));
    let at: Vec3 = corner.iter().zip(weight).map(|(x, w)| x * w).sum();
    (inside && (at - x).norm() <= tolerance).then_some(weight)
}
