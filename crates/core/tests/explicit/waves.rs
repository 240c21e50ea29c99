//! Standing waves against the closed forms of the chain and of the wire.

use super::{explicit, seen_wire, stiffer};
use crate::common::{Single, orders};
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
        p.free_increment(&mut state, |_| false);
        p.advance(&mut state);
        seen.push(state.u[s.elements / 2][1]);
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

/// The same in closed form. With q = 4 sin²(nπ/2N) and C = c h/ℓ the force is (T/ℓ) q + (EI*/L³) q² per
/// displacement, the filter multiplies it by 1 + (1 − C²) q/12 − (EI* − EI)/TL² q, and 4 sin²(θ/2) = ω² h².
fn of_the_steps(s: &Single, n: usize, h: f64) -> f64 {
    let l = s.length / s.elements as f64;
    let (rest, courant) = (l / stretch(s), (speed(s) * h / l).powi(2));
    let q = 4.0 * (0.5 * n as f64 * PI / s.elements as f64).sin().powi(2);
    let (bending, more) = fitted(s, rest);
    let stiffness = s.tension / l * q + bending / rest.powi(3) * q * q;
    let filter = 1.0 + (1.0 - courant) * q / 12.0 - more * q;
    let squared = stiffness / (s.mass * rest) * filter;
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
    // The bending stiffness of a wire, and one that is a tenth of the force of the shortest waves.
    for (bending, most) in [(0.0, 0.85), (195.0, 0.75), (550.0, 0.7)] {
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

/// Points lie in strands side by side, of which short wires fill some only, or with a point each.
#[test]
fn so_it_does_with_any_number_of_points() {
    for elements in 2..24 {
        let s = Single { elements, ..WIRE };
        let h = step(&s, 0.6);
        let (found, exact) = (angle(&s, 1, h, 1), of_the_steps(&s, 1, h));
        let rounding = 1e-11 / exact;
        assert!(
            (found - exact).abs() < rounding,
            "{elements}: {found} {exact}"
        );
    }
}

/// Both leading errors go: what is left of a wave is of fourth order in element and step together.
#[test]
fn waves_of_tension_keep_their_speed_to_fourth_order() {
    for share in [0.3, 0.8] {
        let errors = [22, 44, 88].map(|elements| {
            let (s, n) = (Single { elements, ..WIRE }, 5);
            let h = step(&s, share);
            let exact = of_the_wire(&s, n, h);
            let stride = (0.5 * PI / exact).round() as usize;
            let error = (angle(&s, n, h, stride) / exact - 1.0).abs();
            let lumped = (uncorrected(&s, n, h) / exact - 1.0).abs();
            // (kℓ)²/24 (1 − C²) becomes a share of (kℓ)⁴: 0.51 rad a node at the coarsest, squared 0.26.
            assert!(error < 0.26 * lumped, "{error:e} {lumped:e}");
            error
        });
        // 4 but for the next order, which is (kℓ)² of it.
        let found = orders(&errors);
        assert!(
            found.iter().all(|p| (p - 4.0).abs() < 0.26),
            "{found:?} {errors:?}"
        );
    }
}

/// With a = EI/Tℓ², EI* = e T ℓ² and f = 1/12 + a − e, force and filter are
///
///   T k² (1 + a (kℓ)² − ((1/12 + a)/6 − e f − 1/360) (kℓ)⁴ + …)
///
/// in short steps: T k² + EI k⁴ of the wire, and a wave is slower by half of what comes after it.
#[test]
fn a_stiff_wire_obeys_its_dispersion_relation() {
    let wire = Single {
        bending: 2e3,
        ..WIRE
    };
    let n = 11;
    let k = n as f64 * PI / wire.length;
    for elements in [110, 220, 440] {
        let s = Single { elements, ..wire };
        // Steps of ℓ²: bending moves the shortest waves.
        let h = step(&s, 0.2 * 55.0 / elements as f64);
        let exact = of_the_wire(&s, n, h);
        let stride = (0.5 * PI / exact).round() as usize;
        let error = 1.0 - angle(&s, n, h, stride) / exact;
        let length = s.length / elements as f64;
        let (turn, unit) = ((k * length).powi(2), s.tension * length * length);
        let (a, e) = (s.bending / unit, fitted(&s, length).0 / unit);
        let left = (1.0 / 12.0 + a) / 6.0 - e * (1.0 / 12.0 + a - e) - 1.0 / 360.0;
        let slower = 0.5 * left * turn * turn / (1.0 + a * turn);
        // What comes next is a share (kℓ)² of it, 0.1 at most; what steps of 0.1 ℓ/c hasten, as much.
        assert!((error / slower - 1.0).abs() < 0.2, "{error:e} {slower:e}");
        let string = Single { bending: 0.0, ..s };
        let apart = of_the_wire(&s, n, h) / of_the_wire(&string, n, h) - 1.0;
        assert!(apart > 50.0 * error, "the partner: without bending");
    }
}
