//! A step takes no memory from the system: whatever it needs was taken at set-up.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicU64, Ordering};
use tissue::plan::Plan;
use tissue::scene::{FileSystem, resolve};
use tissue::solver::Simulation;
use tissue::syntax::Source;

/// The system's allocator, counting.
struct Counting;

static TAKEN: AtomicU64 = AtomicU64::new(0);

// SAFETY: every call is handed to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        TAKEN.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller keeps the contract of `alloc`, which is the system's own.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the pointer came from `alloc` above, hence from the system.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Allocations of 100 steps after 20 steps that warm up.
fn allocations(choices: &[(&str, &str)]) -> u64 {
    allocations_of("tests/scenes/strip.tissue", choices)
}

fn allocations_of(name: &str, choices: &[(&str, &str)]) -> u64 {
    let text = if name == "thrown" { Ok(THROWN.to_string()) } else { std::fs::read_to_string(name) };
    let text = text.expect("the scene is there");
    let overrides: Vec<(String, String)> =
        choices.iter().map(|(k, v)| (k.to_string(), v.to_string())).collect();
    let (document, mistakes) = resolve(&Source { name: name.into(), text }, &FileSystem, &overrides);
    let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
    assert!(mistakes.is_empty(), "{told}");
    let scene = &document.scenes[0];
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    pool.install(|| {
        let mut simulation = Simulation::new(scene, &Plan::new(scene)).expect("the scene can be set up");
        let mut steps = |count: u64| {
            let before = TAKEN.load(Ordering::Relaxed);
            for _ in 0..count {
                simulation.step_towards(scene.run.until).expect("the scene runs");
            }
            TAKEN.load(Ordering::Relaxed) - before
        };
        steps(20);
        steps(100)
    })
}

/// A cube that nothing holds, its angular momentum kept, its impulses summed.
const THROWN: &str = "tissue 1
import std.energies { neo_hooke, vol_quadratic }
material gel { energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 10 kPa)  density = 1000 kg/m^3 }
scene thrown {
  body cube { shape = box(1 m, 1 m, 1 m)  spacing = 0.2 m  material = gel }
  start cube { velocity = [1 s^-1 * Y, 0 m/s, 0.5 s^-1 * X] }
  traction cube.zmax { value = [0 Pa, 0 Pa, 1 Pa * sin(3 s^-1 * t)] }
  run { until = 100 s  angular_momentum = projected }
  record impulse { p = impulse(cube).z  every = 1 s }
}
";

// One test, since the counter is the whole process's.
#[test]
fn a_step_allocates_nothing() {
    let before = TAKEN.load(Ordering::Relaxed);
    let kept = std::hint::black_box(vec![0_u8; 64]);
    assert!(TAKEN.load(Ordering::Relaxed) > before, "the counter counts");
    drop(kept);
    assert_eq!(allocations(&[]), 0, "velocity Verlet");
    assert_eq!(allocations(&[("run.integrator", "tvd_rk2"), ("run.cfl", "0.3")]), 0, "Runge-Kutta");
    for integrator in ["tvd_rk2", "ssp_rk3", "velocity_verlet"] {
        let taken = allocations_of("thrown", &[("run.integrator", integrator)]);
        assert_eq!(taken, 0, "{integrator}, projected, impulses summed");
    }
    let restored = [("run.formulation", "pFJ"), ("run.volume_dissipation", "restoring")];
    assert_eq!(allocations(&restored), 0, "D(J) with its restoring term");
    let mixed = [("run.integrator", "tvd_rk2"), ("run.formulation", "pFHJ"), ("run.cfl", "0.3")];
    assert_eq!(allocations(&mixed), 0, "all four fields evolved");
    let slow = [
        ("cube.spacing", "1 m/3"),
        ("run.until", "1 s"),
        ("run.cfl", "0.1"),
        ("motion.boundary", "traction"),
    ];
    assert_eq!(allocations_of("specs/manufactured/goh.tissue", &slow), 0, "an exact motion");
}
