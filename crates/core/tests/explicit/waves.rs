//! Standing waves against the closed forms of the chain and of the wire.
//!
//! String: with q = 4 sin² (κ/2), κ = kℓ and C = c h/ℓ, steps of central differences keep its wave
//! speed when they turn q into 4 sin² (Cκ/2). Gauss's cos 2Cz = F(C, −C; ½; sin² z) with z = κ/2
//! gives
//!
//!   4 sin² (Cκ/2) = C² q (1 + (1 − C²)/12 q (1 + (4 − C²)/30 q (1 + (9 − C²)/56 q (1 + …))))
//!
//! with term n equal to (n² − C²)/((2n + 1)(2n + 2)) q times the one before. The filter has the
//! first two; the third is left.
//!
//! Stiff wire: with ε = EI/(Tℓ²) its Ω = (ωh)² is C² (κ² + ε κ⁴), and steps need 4 sin² (√Ω/2)
//! = Ω − Ω²/12 + Ω³/360 − Ω⁴/20160 + …, with κ² = q + q²/12 + q³/90 + q⁴/560 + …; divided by C²
//! that is Σ cₙ qⁿ,
//!
//!   c₁ = 1,   c₂ = (1 − C²)/12 + ε,   c₃ = 1/90 + ε/6 − (C²/12)(1/6 + 2ε) + C⁴/360
//!   c₄ = 1/560 + 7ε/240 − (C²/12)(7/240 + ε/2 + ε²) + (C⁴/360)(1/4 + 3ε) − C⁶/20160
//!
//! The chain with bends of ε* has (q + ε* q²)(1 + a q + b q²): a = c₂ − ε*, b = c₃ − a ε* within 0
//! and 1/30. The terms left are c₄ − b ε*, and c₃ − a ε* − b where b is limited.

use super::{explicit, seen_wire, stiffer};
use crate::tests::common::{Single, orders};
use arcless_core::slideline::point::Nodal;
use std::f64::consts::PI;

const WIRE: Single = Single {
    length: 55.0,
    elements: 110,
    mass: 1.35,
    axial: 15e6,
    bending: 0.0,
    tension: 22e3,
    gravity: 0.0,
};

/// 1 + T/EA
fn stretch(s: &Single) -> f64 {
    1.0 + s.tension / s.axial
}

/// c = √(T/m), m of the stretched wire.
fn speed(s: &Single) -> f64 {
    (s.tension * stretch(s) / s.mass).sqrt()
}

/// Step in which a wave goes a share of an element.
fn step(s: &Single, share: f64) -> f64 {
    share * s.length / s.elements as f64 / speed(s)
}

/// Angle per step of a standing wave of n halves, released at rest; read over strides of steps.
fn angle(s: &Single, n: usize, h: f64, stride: usize) -> f64 {
    let p = explicit::<2, 2>(&seen_wire(s, 2), h);
    let turn = |i: usize| (n as f64 * PI * i as f64 / s.elements as f64).sin();
    let start = (0..=s.elements).map(|i| [0.0, 1e-3 * turn(i)]).collect();
    let mut state = p.at_rest(start);
    let mut seen = Vec::new();
    for _ in 0..6 * stride + 40 {
        p.predict(&mut state, |_| false);
        p.commit(&mut state);
        seen.push(state.displacement().at(s.elements / 2)[1]);
    }
    // u(t + s) + u(t − s) = 2 cos(s θ) u(t), by least squares.
    let (mut product, mut square) = (0.0, 0.0);
    for window in seen.windows(2 * stride + 1) {
        let [a, b, c] = [0, stride, 2 * stride].map(|k| window[k]);
        product += (a + c) * b;
        square += 2.0 * b * b;
    }
    (product / square).acos() / stride as f64
}

/// EI x coth x, which stands for EI, and what that has more than EI over T L².
fn fitted(s: &Single, rest: f64) -> (f64, f64) {
    if s.bending == 0.0 {
        return (0.0, 0.0);
    }
    let fitted = stiffer(s.bending, s.tension, rest);
    (fitted, (fitted - s.bending) / (s.tension * rest * rest))
}

/// c₂, c₃ and c₄ for C² and ε.
fn series(courant: f64, wire: f64) -> [f64; 3] {
    let by_step = [1.0 / 12.0, 1.0 / 360.0, 1.0 / 20_160.0];
    let [once, twice, thrice] = [1, 2, 3].map(|n| courant.powi(n) * by_step[n as usize - 1]);
    let third = 1.0 / 90.0 + wire / 6.0 - once * (1.0 / 6.0 + 2.0 * wire) + twice;
    let fourth = 1.0 / 560.0 + 7.0 / 240.0 * wire - once * (7.0 / 240.0 + wire / 2.0 + wire * wire)
        + twice * (0.25 + 3.0 * wire)
        - thrice;
    [1.0 / 12.0 + wire - once, third, fourth]
}

/// Coefficients a and b of the filter, and the terms that it leaves.
struct Filter {
    a: f64,
    b: f64,
    /// Coefficients of q³ and q⁴ that are left.
    left: [f64; 2],
}

fn filter(courant: f64, wire: f64, chain: f64) -> Filter {
    let [second, third, fourth] = series(courant, wire);
    let a = second - chain;
    let whole = third - a * chain;
    let b = whole.clamp(0.0, 1.0 / 30.0);
    Filter {
        a,
        b,
        left: [whole - b, fourth - b * chain],
    }
}

/// C², ε and ε*.
fn shares(s: &Single, h: f64) -> [f64; 3] {
    let l = s.length / s.elements as f64;
    let (bending, more) = fitted(s, l / stretch(s));
    let unit = s.tension * (l / stretch(s)).powi(2);
    let wire = bending / unit - more;
    [(speed(s) * h / l).powi(2), wire, wire + more]
}

/// Angle θ per step in closed form. The force is (T/ℓ) q + (EI*/L³) q² per displacement, the filter
/// multiplies it by 1 + a q + b q², and 4 sin² (θ/2) = ω² h².
fn of_the_steps(s: &Single, n: usize, h: f64) -> f64 {
    let l = s.length / s.elements as f64;
    let rest = l / stretch(s);
    let q = 4.0 * (0.5 * n as f64 * PI / s.elements as f64).sin().powi(2);
    let (bending, _) = fitted(s, rest);
    let stiffness = s.tension / l * q + bending / rest.powi(3) * q * q;
    let [courant, wire, chain] = shares(s, h);
    let Filter { a, b, .. } = filter(courant, wire, chain);
    let squared = stiffness / (s.mass * rest) * (1.0 + a * q + b * q * q);
    2.0 * (0.5 * h * squared.sqrt()).asin()
}

/// ω h of the wire, ω² = (T k² + EI k⁴)/m; EI counts per unstretched length.
fn of_the_wire(s: &Single, n: usize, h: f64) -> f64 {
    let k = n as f64 * PI / s.length;
    let bending = s.bending * stretch(s).powi(3);
    let mass = s.mass / stretch(s);
    h * ((s.tension * k * k + bending * k.powi(4)) / mass).sqrt()
}

/// Central differences of lumped masses.
fn uncorrected(s: &Single, n: usize, h: f64) -> f64 {
    let half = 0.5 * n as f64 * PI / s.elements as f64;
    2.0 * (h * speed(s) * s.elements as f64 / s.length * half.sin()).asin()
}

#[test]
fn each_wave_turns_by_the_angle_of_the_closed_form() {
    // Bending stiffness, N m²: none; of a wire; with a tenth of the force of the shortest waves;
    // with the largest b.
    for (bending, most) in [(0.0, 0.85), (195.0, 0.75), (550.0, 0.65), (2e3, 0.3)] {
        let s = Single { bending, ..WIRE };
        for share in [0.3, most] {
            let h = step(&s, share);
            for n in [1, 7, 51, 109] {
                let (found, exact) = (angle(&s, n, h, 1), of_the_steps(&s, n, h));
                // Rounding 1e-16 of an amplitude is seen in a cosine, and 1 − θ²/2 of small angles.
                let rounding = 1e-11 / exact;
                assert!((found - exact).abs() < rounding, "{n} {found} {exact}");
                // The partner: without the filter.
                let lumped = uncorrected(&s, n, h);
                assert!((found - lumped).abs() > rounding, "{n}: a filter");
            }
        }
    }
}

/// Points lie in strands side by side; short wires fill some of them only, or give one point to
/// each. An error at an end reaches the middle within a few steps; λ/ℓ is 0.1 for the longest
/// segments and 1.3 for the shortest.
#[test]
fn so_it_does_with_any_number_of_points() {
    for bending in [0.0, 2e5] {
        for elements in 2..24 {
            let s = Single {
                elements,
                bending,
                ..WIRE
            };
            let h = step(&s, 0.2);
            let (found, exact) = (angle(&s, 1, h, 1), of_the_steps(&s, 1, h));
            let rounding = 1e-11 / exact;
            assert!(
                (found - exact).abs() < rounding,
                "{bending} {elements}: {found} {exact}"
            );
        }
    }
}

/// The remaining error of a wave is of sixth order in element and step together:
/// (1 − C²)(4 − C²)(9 − C²) κ⁶/20160 of ω², half of that of ω.
#[test]
fn waves_of_tension_keep_their_speed_to_sixth_order() {
    for share in [0.3, 0.8] {
        let errors = [22, 44, 88].map(|elements| {
            let (s, n) = (Single { elements, ..WIRE }, 5);
            let (h, turn) = (step(&s, share), n as f64 * PI / elements as f64);
            let exact = of_the_wire(&s, n, h);
            let stride = (0.5 * PI / exact).round() as usize;
            let error = 1.0 - angle(&s, n, h, stride) / exact;
            let product: f64 = [1.0, 4.0, 9.0].map(|n| n - share * share).iter().product();
            let slower = 0.5 * product / 20_160.0 * turn.powi(6);
            // Terms of the next order: q⁴ is κ²/3 less than κ⁸, the next term adds (16 − C²)/90 q,
            // and θ² has C²κ²/6 more of the error than 4 sin² (θ/2).
            let next = 7.0 / 45.0 * (1.0 - share * share) * turn * turn;
            assert!(
                (error / slower - 1.0 + next).abs() < 0.1 * next,
                "{error:e} {slower:e}"
            );
            let lumped = (uncorrected(&s, n, h) / exact - 1.0).abs();
            assert!(error < 0.02 * lumped, "the partner: without the filter");
            error
        });
        // Order 6 except for that next term, 0.08 on the coarsest mesh and a quarter of it on the
        // next.
        let found = orders(&errors);
        assert!(
            found.iter().all(|p| (p - 6.0).abs() < 0.1),
            "{found:?} {errors:?}"
        );
    }
}

/// 1 − θ/ωh of waves of ever more elements, and κ, for ε and C.
fn delays(wire: f64, share: f64) -> [[f64; 3]; 2] {
    let like = Single {
        // Elements are stretched by T/EA, of which ε takes no note.
        axial: 15e10,
        ..WIRE
    };
    let s = Single {
        bending: wire * like.tension * (like.length / like.elements as f64).powi(2),
        ..like
    };
    let h = step(&s, share);
    // Odd ones: the point in the middle is seen.
    let waves = [43, 21, 11].map(|n| {
        let exact = of_the_wire(&s, n, h);
        let stride = (0.5 * PI / exact).round().max(1.0) as usize;
        let turn = n as f64 * PI / s.elements as f64;
        [turn, 1.0 - angle(&s, n, h, stride) / exact]
    });
    [0, 1].map(|k| waves.map(|wave| wave[k]))
}

/// Slower by half of what the filter leaves of ω², for its 1 + ε κ².
fn slower(turn: f64, wire: f64, share: f64) -> f64 {
    let x = 0.5 / wire.sqrt();
    let Filter { left, .. } = filter(share * share, wire, wire * x / x.tanh());
    let left = left[0] * turn.powi(4) + left[1] * turn.powi(6);
    0.5 * left / (1.0 + wire * turn * turn)
}

/// Contact wire in elements of 0.5 m; of 0.3 m, in long steps; and of 0.16 m, where b is bounded.
#[test]
fn a_stiff_wire_obeys_its_dispersion_relation() {
    for (wire, share, order) in [(0.0354, 0.3, 6.0), (0.1, 0.65, 6.0), (0.364, 0.3, 4.0)] {
        let [turns, errors] = delays(wire, share);
        for (turn, error) in turns.iter().zip(errors).skip(1) {
            let expected = slower(*turn, wire, share);
            // Next terms: q⁴ falls short of κ⁸ by κ²/3, and more q of like size.
            assert!(
                (error / expected - 1.0).abs() < 0.5 * turn * turn,
                "{wire} {turn}: {error:e} {expected:e}"
            );
            let bends = (1.0 + wire * turn * turn).sqrt() - 1.0;
            assert!(bends > 20.0 * error.abs(), "the partner: without bending");
        }
        let left = |k: usize| errors[k] * (1.0 + wire * turns[k].powi(2));
        let found = (left(1) / left(2)).ln() / (turns[1] / turns[2]).ln();
        // κ = 0.60 and 0.31: where the next terms are κ²/2, ln (0.82/0.95)/ln 1.9 of the order.
        assert!((found - order).abs() < 0.23, "{found} {errors:?}");
    }
}
