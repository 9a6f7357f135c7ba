//! Tests of nodal integrals on blocks and a curved body.

use super::*;
use crate::discretisation::Shape;

fn block(jitter: f64) -> Particles {
    let shape = Shape::Box { min: Vec3::zeros(), max: Vec3::new(0.9, 0.6, 0.5) };
    Particles::lattice(&shape, 0.1, [None, Some(0.2), None], jitter).unwrap()
}

const HIGH: Vec3 = Vec3::new(0.9, 0.6, 0.5);
const LOW: Vec3 = Vec3::new(0.0, 0.2, 0.0);

/// `∫ x^i y^j z^k dV` over the block.
fn exact(power: [i32; 3]) -> f64 {
    (0..3)
        .map(|i| (HIGH[i].powi(power[i] + 1) - LOW[i].powi(power[i] + 1)) / f64::from(power[i] + 1))
        .product()
}

fn monomial(x: &Vec3, power: [i32; 3]) -> f64 {
    (0..3).map(|i| x[i].powi(power[i])).product()
}

const QUADRATICS: [[i32; 3]; 6] = [[2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 1, 0], [0, 1, 1], [1, 0, 1]];

/// Worst error of volumes, and of areas by the divergence theorem along x.
fn errors(particles: &Particles) -> (f64, f64) {
    let area = particles.boundary_area();
    QUADRATICS.iter().fold((0.0, 0.0), |(volume, face): (f64, f64), &power| {
        let sum = |weight: &dyn Fn(usize) -> f64| -> f64 {
            (0..particles.len()).map(|a| weight(a) * monomial(&particles.position[a], power)).sum()
        };
        let slope = [power[0] - 1, power[1], power[2]];
        let along_x = if power[0] == 0 { 0.0 } else { f64::from(power[0]) * exact(slope) };
        (
            volume.max((sum(&|a| particles.volume[a]) - exact(power)).abs()),
            face.max((sum(&|a| area[a].x) - along_x).abs()),
        )
    })
}

#[test]
fn volumes_and_areas_integrate_quadratic_fields() {
    for jitter in [0.0, 0.3] {
        let hats = block(jitter);
        let mut particles = hats.clone();
        particles.integrate_quadratics().unwrap();
        // 300 terms below 0.01, moment matrices of condition 1e4
        let (volume, area) = errors(&particles);
        assert!(volume < 1e-13 && area < 1e-13, "{volume:e} {area:e}");
        assert!(errors(&hats).0 > 1e-4);
        assert!(particles.volume.iter().all(|&v| v > 0.0));
    }
}

/// An L, 0.9 × 0.6 × 0.5 without its upper right quarter: its inner face has two planes.
#[test]
fn a_face_of_two_planes_is_integrated_plane_by_plane() {
    let whole = Shape::Box { min: Vec3::zeros(), max: Vec3::new(0.9, 0.6, 0.5) };
    let corner = Shape::Box { min: Vec3::new(0.4, 0.3, 0.0), max: Vec3::new(0.9, 0.6, 0.5) };
    let shape = Shape::Difference(Box::new(whole), vec![corner]);
    let integral = |power: [i32; 3]| {
        let part = |low: [f64; 3], high: [f64; 3]| -> f64 {
            let one =
                |i: usize| (high[i].powi(power[i] + 1) - low[i].powi(power[i] + 1)) / f64::from(power[i] + 1);
            one(0) * one(1) * one(2)
        };
        part([0.0; 3], [0.9, 0.6, 0.5]) - part([0.4, 0.3, 0.0], [0.9, 0.6, 0.5])
    };
    for jitter in [0.0, 0.2] {
        let hats = Particles::lattice(&shape, 0.1, [None; 3], jitter).unwrap();
        let mut particles = hats.clone();
        particles.integrate_quadratics().unwrap();
        assert_eq!(particles.first_moment.len(), particles.len());
        assert!(particles.volume.iter().all(|&v| v > 0.0));
        let worst = |particles: &Particles| {
            let area = particles.boundary_area();
            let mut worst = 0.0_f64;
            for power in QUADRATICS {
                let value = |a: usize| monomial(&particles.position[a], power);
                let nodes = 0..particles.len();
                let volume: f64 = nodes.clone().map(|a| particles.volume[a] * value(a)).sum();
                worst = worst.max((volume - integral(power)).abs());
                for axis in 0..3 {
                    let mut slope = power;
                    slope[axis] -= 1;
                    let along = match power[axis] {
                        0 => 0.0,
                        n => f64::from(n) * integral(slope),
                    };
                    let sum: f64 = nodes.clone().map(|a| area[a][axis] * value(a)).sum();
                    worst = worst.max((sum - along).abs());
                }
            }
            worst
        };
        // as on the block
        assert!(worst(&particles) < 1e-13, "{:e}", worst(&particles));
        assert!(worst(&hats) > 1e-4);
    }
}

#[test]
fn first_moments_and_areas_are_what_the_boundary_integrates() {
    let mut particles = block(0.3);
    particles.integrate_quadratics().unwrap();
    let area = particles.boundary_area();
    for power in QUADRATICS {
        for axis in 0..3 {
            // ∮ x_axis q N_x dS, of degree 3
            let mut raised = power;
            raised[axis] += 1;
            let slope = [raised[0] - 1, raised[1], raised[2]];
            let whole = if raised[0] == 0 { 0.0 } else { f64::from(raised[0]) * exact(slope) };
            let sum = |term: &dyn Fn(usize) -> f64| -> f64 {
                (0..particles.len()).map(|a| term(a) * monomial(&particles.position[a], power)).sum()
            };
            let areas = sum(&|a| particles.position[a][axis] * area[a].x);
            let moments = sum(&|a| particles.first_moment[a][(axis, 0)]);
            assert!(
                (areas + moments - whole).abs() < 1e-13,
                "{power:?} {axis}: {:e}",
                areas + moments - whole
            );
        }
    }
    // without them the areas alone miss by a share of the spacing's square
    assert!(particles.first_moment.iter().any(|moment| moment.amax() > 1e-6));
}

#[test]
fn a_lattice_has_the_weights_of_gregory_plane_by_plane() {
    let mut particles = block(0.0);
    particles.integrate_quadratics().unwrap();
    let plane = |i: usize| {
        let at = 0.1 * i as f64;
        let inside = (0..particles.len()).filter(|&a| (particles.position[a].x - at).abs() < 0.01);
        inside.map(|a| particles.volume[a]).sum::<f64>() / (0.4 * 0.5 * 0.1)
    };
    for (i, exact) in [3.0 / 8.0, 7.0 / 6.0, 23.0 / 24.0, 1.0, 1.0].into_iter().enumerate() {
        assert!((plane(i) - exact).abs() < 1e-12, "{i}: {}", plane(i));
    }
}

#[test]
fn a_curved_body_keeps_its_volumes() {
    let shape = Shape::Cylinder { axis: 2, centre: Vec3::zeros(), radius: 0.5, height: 0.6 };
    let before = Particles::lattice(&shape, 0.1, [None; 3], 0.0).unwrap();
    let mut after = before.clone();
    after.integrate_quadratics().unwrap();
    assert_eq!(before.volume, after.volume);
    assert!(after.first_moment.is_empty());
}

#[test]
fn the_sizes_of_a_face_of_two_planes_add_to_its_area() {
    let whole = Shape::Box { min: Vec3::zeros(), max: Vec3::new(0.9, 0.6, 0.5) };
    let corner = Shape::Box { min: Vec3::new(0.4, 0.3, 0.0), max: Vec3::new(0.9, 0.6, 0.5) };
    let mut particles =
        Particles::lattice(&Shape::Difference(Box::new(whole), vec![corner]), 0.1, [None; 3], 0.0).unwrap();
    // of the two planes where the corner was cut off and of one plane, m²
    for (name, exact) in [("hole", 0.5 * (0.5 + 0.3)), ("xmin", 0.6 * 0.5)] {
        for quadratic in [false, true] {
            if quadratic {
                particles.integrate_quadratics().unwrap();
            }
            let face = particles.face(name).unwrap();
            let sum: f64 = particles.sizes(face).iter().sum();
            // some hundred areas of 0.01 m², corrected by moments of condition 1e4; as vectors those of the edge of `hole` lack 0.015 m²
            assert!((sum - exact).abs() < 1e-12, "{name}: {sum}");
            let vectors: f64 = face.area.iter().map(|area| area.norm()).sum();
            assert_eq!((vectors - exact).abs() < 1e-12, name == "xmin", "{vectors}");
        }
    }
}
