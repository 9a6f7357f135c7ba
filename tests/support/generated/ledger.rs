//! What energy a run may have: what it started with and what loads and supports have given it.
//!
//! Owns the work done from outside and the bounds of the integrators. Reads states, knows no text.

use tissue::monitor::totals;
use tissue::plan::damping_rate;
use tissue::scene::{Integrator, Prescribed, Scene, VolumeDissipation};
use tissue::solver::{BodyState, Simulation};
use tissue::tensor::Vec3;

/// Accounts of a run.
pub struct Ledger<'a> {
    scene: &'a Scene,
    /// Whether loads and supports count; a control leaves them out.
    counts_work: bool,
    start: f64,
    /// What round-off of the strain energy at rest can look like, J.
    floor: f64,
    /// Work so far and the most it has been, J.
    work: f64,
    most: f64,
    /// Σ h ‖f‖ of what the loads push, J^½.
    push: f64,
    /// Growth of the energy that theory allows the integrator so far.
    growth: f64,
    before: Snapshot,
    /// Energy before the step entered last, J.
    energy: f64,
    /// Mirror images.
    images: f64,
}

/// The state at the start of a step.
#[derive(Default)]
struct Snapshot {
    velocity: Vec<Vec<Vec3>>,
    acceleration: Vec<Vec<Vec3>>,
    force: Vec<Vec<Vec3>>,
    step: f64,
}

impl Snapshot {
    fn of(simulation: &Simulation, step: f64) -> Self {
        let vectors = |read: fn(&BodyState) -> Vec<Vec3>| simulation.bodies().iter().map(read).collect();
        Self {
            velocity: vectors(|body| body.v.iter().map(|v| v.vector()).collect()),
            acceleration: vectors(|body| body.acceleration.iter().map(|a| a.vector()).collect()),
            force: vectors(|body| match body.external.is_empty() {
                true => vec![Vec3::zeros(); body.len()],
                false => body.external.iter().map(|f| f.vector()).collect(),
            }),
            step,
        }
    }
}

/// Energy against what is allowed, J.
#[derive(Debug, Clone, Copy)]
pub struct Balance {
    /// Kinetic and strain energy.
    pub energy: f64,
    /// The most it may be.
    pub allowed: f64,
}

impl<'a> Ledger<'a> {
    /// Opens the accounts of a simulation that has not stepped yet.
    pub fn new(scene: &'a Scene, simulation: &Simulation, counts_work: bool) -> Self {
        let bodies = simulation.bodies();
        let stiffness = |body: &BodyState| body.density * body.rest.pressure * body.rest.pressure;
        let volume = |body: &BodyState| body.particles.volume.iter().sum::<f64>();
        // some hundred operations on terms of the size of ρ c²
        let floor = bodies.iter().map(|body| 100.0 * f64::EPSILON * stiffness(body) * volume(body)).sum();
        let planes = scene.symmetry.iter().flatten().count();
        let start = energy(scene, simulation);
        Self {
            scene,
            counts_work,
            start,
            energy: start,
            floor,
            work: 0.0,
            most: 0.0,
            push: 0.0,
            growth: 1.0,
            before: Snapshot::of(simulation, 0.0),
            images: f64::from(1_u32 << planes),
        }
    }

    /// Whether the accounts hold: the work of all that acts can be told from outside, which it cannot where a bonded node
    /// may be moved, and no D(J) changes volumes, and with them the strain energy, by itself.
    pub fn is_complete(scene: &Scene) -> bool {
        // a constant displacement other than zero is a jump, which set-up refuses
        let varies =
            |one: &Prescribed| one.displacement.iter().flatten().any(|tape| tape.leaves().next().is_some());
        let moves = scene.prescribed.iter().any(varies);
        let verlet = scene.run.integrator == Integrator::VelocityVerlet;
        let evolves_alone = scene.run.volume_dissipation != VolumeDissipation::Off;
        !evolves_alone && (!moves || (verlet && scene.bonds.is_empty()))
    }

    /// Enters a step and judges the state before it, whose work is known only now.
    ///
    /// Verlet's kick at a state `n` carries the velocities of the middles of two steps, `w₋` to `w₊`; forces do the work
    /// `h f · ½ (w₋ + w₊)`, and a support what is missing of the change of kinetic energy. For a linear body with
    /// stiffness `K` and damping `C` the step then keeps from growing
    ///
    /// ```text
    /// L = ½ w·M w + ½ x_n·K x_{n+1} − ¼ h w·C w = ½ w·(M − ¼ h² K − ½ h C) w + ½ x̄·K x̄ ≥ (1 − q) E(w, x̄)
    /// ```
    ///
    /// but for that work, `x̄ = ½ (x_n + x_{n+1})` and `q ≤ α`, the Courant number: at `α = 1` the bracket is singular.
    /// With `L ≤ (1 + q) E` of the start and `E_n ≤ (1 + q) max E(w, x̄)` of the steps on either side,
    /// `E_n ≤ (1 + q)/(1 − q) ((1 + q) E_0 + max W)`.
    pub fn enter(&mut self, simulation: &Simulation) -> Balance {
        let step = simulation.last_step();
        let run = &self.scene.run;
        if run.integrator == Integrator::VelocityVerlet {
            self.enter_kick(simulation, step);
        } else {
            self.enter_stages(simulation, step);
        }
        self.before = Snapshot::of(simulation, step);
        let energy = std::mem::replace(&mut self.energy, energy(self.scene, simulation));
        let allowed = match run.integrator {
            Integrator::VelocityVerlet => {
                let q = run.cfl.min(0.99);
                (1.0 + q) / (1.0 - q) * ((1.0 + q) * self.start + self.most.max(0.0))
            }
            // norms add: each push is carried on with at most the growth of the start
            _ => self.growth * (self.start.sqrt() + if self.counts_work { self.push } else { 0.0 }).powi(2),
        };
        Balance { energy, allowed: allowed + self.floor }
    }

    fn enter_kick(&mut self, simulation: &Simulation, step: f64) {
        let old = self.before.step;
        let mut whole = 0.0;
        let mut damped = 0.0;
        for (index, body) in simulation.bodies().iter().enumerate() {
            let mut prescribed = vec![[false; 3]; body.len()];
            let mut fastest = 0.0_f64;
            for support in &body.supports {
                for (i, &node) in support.nodes.iter().enumerate() {
                    prescribed[node as usize][support.axis] = true;
                    fastest = fastest.max(support.velocity(i, step).abs());
                }
            }
            for (a, prescribed) in prescribed.iter().enumerate() {
                let volume = body.particles.volume[a];
                let mass = body.density * volume;
                for (axis, prescribed) in prescribed.iter().enumerate() {
                    let v = self.before.velocity[index][a][axis];
                    let acceleration = self.before.acceleration[index][a][axis];
                    let force = volume * self.before.force[index][a][axis];
                    let h = 0.5 * (old + step);
                    whole += match prescribed {
                        false => h * force * (v + 0.25 * acceleration * (step - old)),
                        true => {
                            let (from, to) = (v, body.v[a].0[axis]);
                            0.5 * mass * (to * to - from * from)
                                - h * (mass * acceleration - force) * 0.5 * (from + to)
                        }
                    };
                }
            }
            // (v_affine − v) · v ≤ ¼ |v_affine|², each component at most the sum of three that supports have
            let mass: f64 = body.density * body.particles.volume.iter().sum::<f64>();
            damped += step * damping_rate(self.scene) * mass * 0.25 * 27.0 * fastest * fastest;
        }
        if !self.counts_work {
            return;
        }
        let done = self.images * whole;
        self.most = self.most.max(self.work + 0.5 * done).max(self.work + done);
        self.work += done + self.images * damped;
        self.most = self.most.max(self.work);
    }

    /// Runge–Kutta methods: |R(iz)|² of the fastest undamped mode, and pushes that a stage can amplify by Σ z^k/k!.
    fn enter_stages(&mut self, simulation: &Simulation, step: f64) {
        let z = 2.0 * self.scene.run.cfl;
        let squares = |z: f64| match self.scene.run.integrator {
            Integrator::SspRk3 => (1.0 - z * z / 2.0).powi(2) + (z - z.powi(3) / 6.0).powi(2),
            _ => 1.0 + z.powi(4) / 4.0,
        };
        let worst = (0..=20).map(|i| squares(z * f64::from(i) / 20.0)).fold(1.0, f64::max);
        self.growth *= worst;
        let amplified = 1.0 + z + z * z / 2.0;
        let norm = |forces: &[Vec<Vec3>]| -> f64 {
            let bodies = simulation.bodies().iter().zip(forces);
            let squares = bodies.flat_map(|(body, forces)| {
                forces
                    .iter()
                    .zip(&body.particles.volume)
                    .map(|(f, v)| 0.5 * v * f.norm_squared() / body.density)
            });
            (self.images * squares.sum::<f64>()).sqrt()
        };
        let now = Snapshot::of(simulation, step);
        self.push += amplified * step * norm(&self.before.force).max(norm(&now.force));
    }
}

/// Kinetic and strain energy of all bodies, J.
fn energy(scene: &Scene, simulation: &Simulation) -> f64 {
    let sums = totals(simulation.bodies(), &scene.symmetry);
    sums.kinetic_energy + sums.strain_energy
}
