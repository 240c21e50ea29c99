//! Closed forms of the backward differences and of what falls, rubs and comes to rest.

use super::{assert_close, flexibility, matrix, oscillator};
use arcless_core::lcp::LcpSolver;
use arcless_core::linalg::dense;
use arcless_core::published::{Known, Matrix, PublishedStep, Step, friction, velocity};

const GRAVITY: f64 = 9.81;

/// Displacements of a system of one degree of freedom, from u₋₁ and u₀, with forces and gaps.
fn march(
    p: &mut PublishedStep,
    start: [f64; 2],
    load: f64,
    map: &Matrix,
    steps: usize,
) -> Vec<Step> {
    let mut u = start;
    let mut taken = Vec::new();
    for _ in 0..steps {
        let known = Known {
            u_1: &[u[1]],
            u_2: &[u[0]],
            load: &[load],
            contact_map: map,
            initial_gap: &vec![0.0; map.columns],
        };
        let step = p.step(&known).expect("a solution");
        u = [u[1], step.u[0]];
        taken.push(step);
    }
    taken
}

fn free() -> Matrix {
    Matrix::new("contact_map", 1, 0, vec![]).expect("no contact")
}

/// z = 1/(1 − λτ), λ = −ζω + iω√(1−ζ²): the roots of (1+2ζΩ+Ω²) z² − (2+2ζΩ) z + 1 = 0, Ω = ωτ.
/// From u₀ = 1 and u₋₁ = Re z⁻¹ = 1 + ζΩ the scheme gives u_i = Re zⁱ.
#[test]
fn oscillator_follows_its_closed_form() {
    let (mass, tau) = (2.5, 1e-3);
    for frequency in [0.5, 20.0, 300.0] {
        for zeta in [0.0, 0.05, 0.9] {
            let omega = std::f64::consts::TAU * frequency;
            let mut p = oscillator(mass, 2.0 * zeta * omega * mass, omega * omega * mass, tau);
            let steps = march(&mut p, [1.0 + zeta * omega * tau, 1.0], 0.0, &free(), 400);
            let inverse: [f64; 2] = [
                1.0 + zeta * omega * tau,
                omega * tau * (1.0 - zeta * zeta).sqrt(),
            ];
            let (radius, angle) = (inverse[0].hypot(inverse[1]), inverse[1].atan2(inverse[0]));
            for (i, step) in steps.iter().enumerate() {
                let i = (i + 1) as f64;
                let expected = radius.powf(-i) * (i * angle).cos();
                // 400 steps, each with roundings of the size of u, growing with 1/Ω below 1 Hz.
                assert!(
                    (step.u[0] - expected).abs() < 1e-10,
                    "{frequency} Hz, ζ {zeta}, step {i}"
                );
            }
        }
    }
}

/// Undamped: |z| = 1/√(1+Ω²), angle arctan Ω. Measured on the stepped oscillator by two successive
/// triples of displacements: u_{i+1} + |z|² u_{i−1} = 2 Re z u_i.
#[test]
fn numerical_damping_at_20_hz_and_1_ms_is_six_per_cent() {
    let (omega, tau) = (std::f64::consts::TAU * 20.0, 1e-3);
    let mut p = oscillator(1.0, 0.0, omega * omega, tau);
    let u: Vec<f64> = march(&mut p, [1.0, 1.0], 0.0, &free(), 5)
        .iter()
        .map(|s| s.u[0])
        .collect();
    let mut rows = vec![2.0 * u[1], -u[0], 2.0 * u[2], -u[1]];
    let mut roots = vec![u[2], u[3]];
    assert!(dense::solve_in_place(&mut rows, &mut roots));
    let (real, square) = (roots[0], roots[1]);
    let (decay, angle) = (-0.5 * square.ln(), (real / square.sqrt()).acos());
    let measured = decay / decay.hypot(angle);
    let capital = omega * tau;
    let exact = {
        let (decay, angle) = (0.5 * (capital * capital).ln_1p(), capital.atan());
        decay / decay.hypot(angle)
    };
    // The triples span a hundredth of the amplitude: fourteen digits become about ten.
    assert!((measured - exact).abs() < 1e-9, "{measured} {exact}");
    assert!((exact - 0.062_54).abs() < 5e-6);
    assert!(
        (exact / (0.5 * capital) - 1.0).abs() < 0.01,
        "half of Ω to first order"
    );
    // The period grows by Ω/arctan Ω − 1 = Ω²/3: half a per cent.
    assert!((capital / angle - 1.0 - capital * capital / 3.0).abs() < 2e-4);
}

/// First order: halving the step halves the error at a fixed time, here to 3 % of the ratio.
#[test]
fn order_of_convergence_is_one() {
    let omega = 7.0;
    let error = |tau: f64| {
        let mut p = oscillator(1.0, 0.0, omega * omega, tau);
        let steps = (1.0 / tau).round() as usize;
        // At rest at time zero: u₋₁ = u₀ up to τ², which is beyond the first order.
        let end = march(&mut p, [1.0, 1.0], 0.0, &free(), steps)[steps - 1].u[0];
        (end - omega.cos()).abs()
    };
    let errors = [4e-4, 2e-4, 1e-4].map(error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 1.0).abs() < 0.03, "{order} of {errors:?}");
    }
}

/// A mass falls on a rigid floor. The momentum that the floor takes is that of the fall, no energy
/// appears, and nothing rebounds: the velocity after the impact is zero.
#[test]
fn mass_on_a_rigid_floor_stays_there() {
    let (mass, height, tau) = (16.0, 0.2, 1e-3);
    let mut p = oscillator(mass, 0.0, 0.0, tau);
    let floor = matrix(1, &[1.0]);
    let steps = march(&mut p, [height, height], -mass * GRAVITY, &floor, 400);

    // Velocity after i steps of free fall: −g i τ; height: h − g τ² i(i+1)/2.
    let fall = |i: f64| height - 0.5 * GRAVITY * tau * tau * i * (i + 1.0);
    let hit = steps
        .iter()
        .position(|s| s.force[0] > 0.0)
        .expect("it reaches the floor");
    for (i, step) in steps[..hit].iter().enumerate() {
        // Rounding of up to 1e3 steps.
        assert!((step.u[0] - fall((i + 1) as f64)).abs() < 1e-12);
    }
    assert!(
        fall((hit + 1) as f64) < 0.0,
        "no step earlier than the floor is reached"
    );

    assert!(
        steps[hit..]
            .iter()
            .all(|s| s.gap[0] == 0.0 && s.u[0].abs() < 1e-15)
    );
    for step in &steps[hit + 2..] {
        // Rounding of 1 over τ².
        assert!(
            (step.force[0] - mass * GRAVITY).abs() < 1e-9,
            "the weight remains"
        );
    }
    // Two steps take the momentum of the fall: to the floor, then to rest.
    let momentum = mass * GRAVITY * hit as f64 * tau;
    let impulse: f64 = steps.iter().map(|s| (s.force[0]) * tau).sum();
    let weight_since = mass * GRAVITY * (steps.len() - hit) as f64 * tau;
    assert!((impulse - weight_since - momentum).abs() < 1e-9 * momentum);
    assert!(steps[hit].force[0] > 0.0 && steps[hit + 1].force[0] > 0.0);

    let energies = (1..steps.len()).map(|i| {
        let v = (steps[i].u[0] - steps[i - 1].u[0]) / tau;
        0.5 * mass * v * v + mass * GRAVITY * steps[i].u[0]
    });
    let mut last = mass * GRAVITY * height;
    for energy in energies {
        assert!(
            energy <= last + 1e-12 * mass * GRAVITY * height,
            "{energy} after {last}"
        );
        last = energy;
    }
}

/// Algorithm 4: a block on a floor is pulled along by f times the weight, one step late.
#[test]
fn friction_is_that_of_the_force_before() {
    let (mass, f, tau) = (3.0, 0.3, 1e-3);
    let m = matrix(2, &[mass, 0.0, 0.0, mass]);
    let zero = matrix(2, &[0.0; 4]);
    let mut p = PublishedStep::new(m, zero.clone(), &zero, tau).expect("two masses");
    let floor = matrix(2, &[0.0, 1.0]);
    let (mut u_2, mut u_1, mut force) = (vec![0.0; 2], vec![0.0; 2], vec![0.0]);
    for i in 0..50 {
        let t = friction(f, &force);
        let load = [t[0], -mass * GRAVITY];
        let known = Known {
            u_1: &u_1,
            u_2: &u_2,
            load: &load,
            contact_map: &floor,
            initial_gap: &[0.0],
        };
        let step = p.step(&known).expect("a solution");
        let v = velocity(&step.u, &u_1, tau);
        // Rounding of u over τ.
        assert!((v[0] - f * GRAVITY * f64::from(i) * tau).abs() < 1e-12);
        (u_2, u_1, force) = (u_1, step.u, step.force);
    }
}

/// When everything has come to rest, forces and gaps are those of the static problem
/// y = (CᵀK⁻¹C) x + d0 + CᵀK⁻¹p.
#[test]
fn rest_is_the_static_solution() {
    let n = 6;
    // A chain of springs between two walls over three stops, pressed down.
    let spring = |k: usize| match (k / n).abs_diff(k % n) {
        0 => 2e4,
        1 => -1e4,
        _ => 0.0,
    };
    let stiffness = matrix(n, &(0..n * n).map(spring).collect::<Vec<_>>());
    let diagonal = |v: f64| {
        (0..n * n)
            .map(|k| if k / n == k % n { v } else { 0.0 })
            .collect::<Vec<_>>()
    };
    let (mass, damping) = (matrix(n, &diagonal(2.0)), matrix(n, &diagonal(50.0)));
    let mut map = vec![0.0; n * 3];
    (map[0], map[2 * 3 + 1], map[5 * 3 + 2]) = (1.0, 1.0, 1.0);
    let map = matrix(n, &map);
    let (d0, load) = ([1e-3, 4e-3, 10e-3], [-20.0; 6]);

    let mut p = PublishedStep::new(mass, damping, &stiffness, 1e-3).expect("a definite system");
    let (mut u_2, mut u_1) = (vec![0.0; n], vec![0.0; n]);
    let mut last = None;
    for _ in 0..4000 {
        let known = Known {
            u_1: &u_1,
            u_2: &u_2,
            load: &load,
            contact_map: &map,
            initial_gap: &d0,
        };
        let step = p.step(&known).expect("a solution");
        (u_2, u_1) = (u_1, step.u.clone());
        last = Some(step);
    }
    let last = last.expect("steps");

    let mut still = load.to_vec();
    assert!(dense::solve_in_place(
        &mut stiffness.values.clone(),
        &mut still
    ));
    let w: Vec<f64> = (0..3)
        .map(|j| d0[j] + (0..n).map(|k| map.at(k, j) * still[k]).sum::<f64>())
        .collect();
    let (mut x, mut y) = (vec![0.0; 3], vec![0.0; 3]);
    LcpSolver::new()
        .solve(&flexibility(&stiffness, &map), &w, &mut x, &mut y, &[])
        .expect("a solution");
    assert!(
        x.iter().any(|v| *v > 0.0) && y.iter().any(|v| *v > 0.0),
        "both kinds"
    );
    // Damped with some 20 1/s for 4 s: e⁻⁸⁰ of the start remains, so this is rounding over τ².
    assert_close(&last.force, &x, 1e-8);
    assert_close(&last.gap, &y, 1e-8);
}
