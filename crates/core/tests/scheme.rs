//! Time-stepping schemes on one oscillator: exact steps, order, damping, stability.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::pantograph::excitation::Excitation;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::state::PantographState;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::{AlphaScheme, Scheme};
use std::f64::consts::TAU;

/// Oscillator of one hertz with ratio of damping ζ: a pantograph that touches nothing.
fn oscillator(zeta: f64) -> Pantograph {
    let omega = TAU;
    Pantograph {
        mass: vec![1.0],
        damping: vec![2.0 * zeta * omega],
        stiffness: vec![omega * omega],
        strips: vec![Strip::plain(vec![1.0])],
        preload: vec![1.0],
        lift: vec![0.0],
        start_force: 0.0,
        excitation: Excitation::default(),
        stops: Vec::new(),
        piecewise_forces: Vec::new(),
        actuator: None,
        is_external: false,
    }
}

/// Oscillator released at 1 from rest, with the acceleration that balances it.
fn released(pantograph: Pantograph, scheme: Scheme, h: f64) -> PantographState {
    let c = scheme.coefficients(h);
    let mut state = PantographState::new(pantograph, &c, 0.0, 0.0).expect("an equilibrium");
    state.u[0] = 1.0;
    state.a[0] = -state.model.stiffness[0] / state.model.mass[0];
    state
}

fn advance(state: &mut PantographState, scheme: Scheme, h: f64, steps: usize) {
    let c = scheme.coefficients(h);
    for _ in 0..steps {
        state.predict(&c, 0.0);
        state.commit(&c);
    }
}

/// Displacement after one second.
fn after_a_second(scheme: Scheme, zeta: f64, steps: usize) -> f64 {
    let h = 1.0 / steps as f64;
    let mut state = released(oscillator(zeta), scheme, h);
    advance(&mut state, scheme, h, steps);
    state.u[0]
}

/// u(t) = e^(−ζωt) (cos ω't + ζω/ω' sin ω't).
fn exact(zeta: f64) -> f64 {
    let root = (1.0 - zeta * zeta).sqrt();
    (-zeta * TAU).exp() * ((TAU * root).cos() + zeta / root * (TAU * root).sin())
}

fn second_order() -> Vec<Scheme> {
    let mut members: Vec<Scheme> = [1.0, 0.9, 0.5, 0.0].map(Scheme::generalised_alpha).to_vec();
    members.extend([0.05, 0.3].map(Scheme::hht));
    members.push(Scheme::newmark(0.25, 0.5));
    members
}

/// Two steps of the trapezoidal rule from u = 1 at rest: with q = (ωh/2)², u₁ = (1−q)/(1+q) and
/// u₂ = 2 u₁² − 1 (a rotation by twice the angle).
#[test]
fn two_steps_of_the_trapezoidal_rule() {
    let h = 0.05;
    let q = (0.5 * TAU * h).powi(2);
    let first = (1.0 - q) / (1.0 + q);
    for scheme in [Scheme::generalised_alpha(1.0), Scheme::newmark(0.25, 0.5)] {
        let mut state = released(oscillator(0.0), scheme, h);
        advance(&mut state, scheme, h, 1);
        assert!((state.u[0] - first).abs() < 1e-15, "rounding of one step");
        advance(&mut state, scheme, h, 1);
        assert!((state.u[0] - (2.0 * first * first - 1.0)).abs() < 1e-14);
        // Partner: stiffness one per cent off.
        let mut fault = oscillator(0.0);
        fault.stiffness[0] *= 1.01;
        let mut state = released(fault, scheme, h);
        advance(&mut state, scheme, h, 1);
        assert!((state.u[0] - first).abs() > 1e-4);
    }
}

/// One step with the recursion written out by hand for the general member (Chung & Hulbert 1993,
/// equations 12 to 15), solved for the acceleration instead of the increment.
#[test]
fn two_steps_of_every_member() {
    let (h, zeta) = (0.05, 0.1);
    let (k, d) = (TAU * TAU, 2.0 * zeta * TAU);
    let mut members = second_order();
    members.push(Scheme::newmark(0.4, 0.7));
    for scheme in members {
        let Scheme::Alpha(s) = scheme else {
            unreachable!("members of the family only");
        };
        let (mut u, mut v, mut a) = (1.0, 0.0, -k);
        let mut state = released(oscillator(zeta), scheme, h);
        for _ in 0..2 {
            let (um, vm) = (
                u + h * v + h * h * (0.5 - s.beta) * a,
                v + h * (1.0 - s.gamma) * a,
            );
            let keep = 1.0 - s.alpha_f;
            let known =
                s.alpha_m * a + d * (keep * vm + s.alpha_f * v) + k * (keep * um + s.alpha_f * u);
            let factor = 1.0 - s.alpha_m + keep * (d * h * s.gamma + k * h * h * s.beta);
            let new = -known / factor;
            (u, v, a) = (um + h * h * s.beta * new, vm + h * s.gamma * new, new);
        }
        advance(&mut state, scheme, h, 2);
        // 1/(β h²) amplifies rounding of displacements in the acceleration.
        assert!((state.u[0] - u).abs() < 1e-13, "{s:?}");
        assert!((state.v[0] - v).abs() < 1e-11, "{s:?}");
        assert!((state.a[0] - a).abs() < 1e-9, "{s:?}");
    }
}

#[test]
fn order_in_time() {
    let errors =
        |s: Scheme| [400, 800, 1600].map(|n| (after_a_second(s, 0.1, n) - exact(0.1)).abs());
    for s in second_order() {
        let orders = common::orders(&errors(s));
        // Theory says 2; one tenth for the terms of higher order.
        assert!(orders.iter().all(|&p| p > 1.9), "{s:?}: {orders:?}");
    }
    // Partner: γ > ½ without α's is of first order only.
    let orders = common::orders(&errors(Scheme::newmark(0.3025, 0.6)));
    assert!(
        orders.iter().all(|&p| (0.9..1.1).contains(&p)),
        "{orders:?}"
    );
}

#[test]
fn trapezoidal_rule_conserves_energy() {
    let (s, h) = (Scheme::generalised_alpha(1.0), 0.01);
    let mut state = released(oscillator(0.0), s, h);
    let start = state.energy();
    advance(&mut state, s, h, 100_000);
    // A thousand periods; every step adds rounding ε, which walks at random.
    assert!((state.energy() / start - 1.0).abs() < 1e-11);
    let damped = Scheme::generalised_alpha(0.9);
    let mut state = released(oscillator(0.0), damped, h);
    advance(&mut state, damped, h, 100_000);
    assert!(state.energy() / start < 1.0 - 1e-4, "the partner");
}

type Matrix = [[f64; 3]; 3];

/// Amplification matrix of (u, v/ω, a/ω²) for an oscillator with ωh given.
fn amplification(scheme: Scheme, omega_h: f64) -> Matrix {
    let h = omega_h / TAU;
    let mut matrix = [[0.0; 3]; 3];
    for column in 0..3 {
        let mut state = released(oscillator(0.0), scheme, h);
        let unit = |k: usize| f64::from(u8::from(k == column));
        (state.u[0], state.v[0], state.a[0]) = (unit(0), unit(1) * TAU, unit(2) * TAU * TAU);
        advance(&mut state, scheme, h, 1);
        let new = [state.u[0], state.v[0] / TAU, state.a[0] / TAU / TAU];
        (0..3).for_each(|row| matrix[row][column] = new[row]);
    }
    matrix
}

/// Spectral radius ‖Aᴺ‖^(1/N) with N = 2²⁰ by squaring: a double root adds less than 2e-5.
fn radius(scheme: Scheme, omega_h: f64) -> f64 {
    let mut a = amplification(scheme, omega_h);
    let (mut log, mut power) = (0.0, 1.0);
    for _ in 0..20 {
        let size = a.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
        if size == 0.0 {
            return 0.0;
        }
        log += size.ln() / power;
        a.iter_mut().flatten().for_each(|v| *v /= size);
        let old = a;
        for (i, row) in a.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                *value = (0..3).map(|k| old[i][k] * old[k][j]).sum();
            }
        }
        power *= 2.0;
    }
    log.exp()
}

/// Chung & Hulbert (1993), equations 17, 20 and 25, and the HHT member, worked out by hand:
/// β, γ, α_m, α_f.
#[test]
fn members_have_the_parameters_of_their_papers() {
    let third = 1.0 / 3.0;
    let expected = [
        (Scheme::generalised_alpha(0.0), [1.0, 1.5, -1.0, 0.0]),
        (
            Scheme::generalised_alpha(0.5),
            [4.0 / 9.0, 5.0 / 6.0, 0.0, third],
        ),
        (Scheme::generalised_alpha(1.0), [0.25, 0.5, 0.5, 0.5]),
        (Scheme::hht(0.3), [0.4225, 0.8, 0.0, 0.3]),
        (Scheme::newmark(0.3, 0.55), [0.3, 0.55, 0.0, 0.0]),
    ];
    for (scheme, numbers) in expected {
        let Scheme::Alpha(s) = scheme else {
            unreachable!("members of the family only");
        };
        // The last bit of numbers of order 1.
        for (found, number) in [s.beta, s.gamma, s.alpha_m, s.alpha_f].iter().zip(numbers) {
            assert!((found - number).abs() < 1e-15, "{scheme:?}");
        }
    }
}

/// At infinite frequency the amplitude shrinks by ρ in every step (Chung & Hulbert 1993).
#[test]
fn spectral_radius_at_infinite_frequency() {
    for rho in [1.0, 0.95, 0.9, 0.7] {
        let found = radius(Scheme::generalised_alpha(rho), 1e5);
        // The double root ρ splits by √(1/(ωh)²); one per cent of ρ is the partner.
        assert!((found / rho - 1.0).abs() < 1e-3, "{rho}: {found}");
        assert!((found / (1.01 * rho) - 1.0).abs() > 5e-3);
    }
}

/// Numerical damping of small ωh. For γ = ½ members it is of third order; Newmark with γ > ½ has
/// ζ = (γ − ½) ωh / 2 (Hughes, The Finite Element Method, section 9.3).
#[test]
fn numerical_damping_of_newmark() {
    let (gamma, omega_h) = (0.6_f64, 0.05);
    let s = Scheme::newmark(0.25 * (gamma + 0.5).powi(2), gamma);
    let zeta = -radius(s, omega_h).ln() / omega_h;
    let expected = 0.5 * (gamma - 0.5) * omega_h;
    // The next term is of relative size (ωh)².
    assert!((zeta / expected - 1.0).abs() < 0.005, "{zeta} {expected}");
    assert!(-radius(Scheme::generalised_alpha(0.9), omega_h).ln() / omega_h < 1e-3 * expected);
}

/// Backward differences: z = 1/(1 ± iωh), so the amplitude shrinks by 1/√(1 + ω²h²) in every step,
/// and the displacement after n steps from rest (u₀ = u₋₁) follows the recursion written out.
#[test]
fn backward_differences_shrink_as_their_roots_say() {
    let scheme = Scheme::BackwardDifference;
    for omega_h in [0.01_f64, 0.125_66, 1.0, 10.0] {
        let expected = 1.0 / (1.0 + omega_h * omega_h).sqrt();
        let found = radius(scheme, omega_h);
        // A double root would add 2e-5; these are simple.
        assert!((found / expected - 1.0).abs() < 1e-5, "{omega_h}: {found}");
    }
    let (h, zeta) = (0.05, 0.1);
    let (k, d) = (TAU * TAU, 2.0 * zeta * TAU);
    let mut state = released(oscillator(zeta), scheme, h);
    let (mut old, mut now) = (1.0, 1.0);
    for _ in 0..20 {
        let new = ((2.0 * now - old) / (h * h) + d * now / h) / (1.0 / (h * h) + d / h + k);
        (old, now) = (now, new);
    }
    advance(&mut state, scheme, h, 20);
    assert!((state.u[0] - now).abs() < 1e-13, "rounding of 20 steps");
    let errors = [400, 800, 1600].map(|n| (after_a_second(scheme, 0.1, n) - exact(0.1)).abs());
    let orders = common::orders(&errors);
    // First order; the quadratic term is a few per cent of the linear one at these steps.
    assert!(
        orders.iter().all(|&p| (0.9..1.1).contains(&p)),
        "{orders:?}"
    );
}

#[test]
fn members_that_pass_the_check_are_stable_at_any_step() {
    let mut members = second_order();
    members.extend([Scheme::newmark(0.3025, 0.6), Scheme::newmark(0.5, 1.0)]);
    for s in members {
        s.check().expect("a member of the family");
        for omega_h in [0.1, 1.0, 3.0, 10.0, 100.0] {
            let found = radius(s, omega_h);
            // Squaring leaves twenty roundings and the double root.
            assert!(found < 1.0 + 1e-4, "{s:?} grows by {found} at {omega_h}");
        }
    }
}

#[test]
fn unstable_parameters_are_refused() {
    let explicit = Scheme::newmark(0.0, 0.5);
    let linear = Scheme::newmark(1.0 / 6.0, 0.5);
    let growing = Scheme::newmark(0.25, 0.4);
    let with = |change: fn(&mut AlphaScheme)| {
        let mut s = AlphaScheme {
            beta: 0.25,
            gamma: 0.5,
            alpha_m: 0.5,
            alpha_f: 0.5,
        };
        assert!(Scheme::Alpha(s).check().is_ok(), "trapezoidal");
        change(&mut s);
        Scheme::Alpha(s)
    };
    let (old, nan) = (with(|s| s.alpha_f = 0.6), with(|s| s.beta = f64::NAN));
    for s in [explicit, linear, growing, old, nan] {
        assert!(
            matches!(
                s.check(),
                Err(CoreError::Input {
                    array: "scheme",
                    ..
                })
            ),
            "{s:?}"
        );
    }
    assert!(radius(linear, 4.0) > 1.1, "the partner: it does grow");
}

/// 2β ≥ γ is what unconditional stability needs when γ > ½ (Hughes, section 9.1).
#[test]
fn newmark_with_too_small_beta_is_refused() {
    let s = Scheme::newmark(0.25, 0.6);
    assert!(radius(s, 10.0) > 1.1, "it grows at ωh = 10");
    assert!(s.check().is_err());
}

/// Angle by which one step turns an undamped oscillator with ωh = `q`: that of the pair of complex
/// eigenvalues of the step, from the motion of the free oscillator over many steps.
fn turned(scheme: Scheme, q: f64) -> f64 {
    let h = q / TAU;
    let mut state = released(oscillator(0.0), scheme, h);
    // The third eigenvalue is far smaller than one and forgotten after some steps.
    advance(&mut state, scheme, h, 200);
    let mut u = [0.0; 3];
    for value in &mut u {
        *value = state.u[0];
        advance(&mut state, scheme, h, 1);
    }
    let next = state.u[0];
    // u₂ = 2 ρ cos Ω u₁ − ρ² u₀ and the same one step on, for ρ and Ω.
    let determinant = u[1] * u[1] - u[0] * u[2];
    let sum = (u[2] * u[1] - u[0] * next) / determinant;
    let product = (u[2] * u[2] - u[1] * next) / determinant;
    (0.5 * sum / product.sqrt()).acos()
}

/// Ω = q (1 − c q²) + O(q⁵): at q = 0.1 the next term is about q² of the error.
#[test]
fn the_period_error_is_what_the_coefficient_says() {
    for scheme in second_order() {
        let c = scheme.period_error().expect("of second order");
        for q in [0.1, 0.05] {
            let found = (1.0 - turned(scheme, q) / q) / (q * q);
            // The next term of the expansion: its coefficient is of the size of c, or one.
            assert!((found - c).abs() < 2.0 * q * q, "{scheme:?}: {found} {c}");
        }
    }
    let trapezoidal = Scheme::generalised_alpha(1.0).period_error();
    // Ω = 2 arctan(q/2) = q (1 − q²/12 + …); rounding of a few terms.
    assert!((trapezoidal.expect("second order") - 1.0 / 12.0).abs() < 1e-15);
    assert_eq!(Scheme::newmark(1.0, 1.0).period_error(), None);
    assert_eq!(Scheme::BackwardDifference.period_error(), None);
}
