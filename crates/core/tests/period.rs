//! Correction of the period error: waves on a string, and a mass that stays positive.

use crate::tests::common::Single;
use crate::tests::common::chain::settled;
use crate::tests::common::lanes::STRING;
use arcless_core::integrator::state::WireState;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::scheme::Scheme;
use arcless_core::slideline::Slideline;
use arcless_core::slideline::point::Nodal;
use std::f64::consts::PI;

const H: f64 = 1e-3;

fn corrected(string: &Single, scheme: Scheme, h: f64) -> (LinearModel<2, 4>, Vec<Slideline<2>>) {
    let (structure, path) = string.structure(2);
    let (geometry, shape) = settled::<2, 4>(structure);
    let lanes = Slideline::from_elements(&geometry, &shape, &[path]).expect("a path");
    let line = LinearModel::new(&geometry, shape);
    (line.with_correct_period(&geometry, &scheme, h), lanes)
}

/// Angle by which the shape sin(nπx/L), slopes included, turns in a step, over ωh of the string.
fn turned(line: LinearModel<2, 4>, lanes: Vec<Slideline<2>>, scheme: Scheme, waves: f64) -> f64 {
    let length = STRING.length;
    let shape: Vec<[f64; 4]> = line
        .shape
        .iter()
        .map(|node| {
            let (k, x) = (waves * PI / length, node[0]);
            // Slopes are derivatives along the unstretched string.
            [0.0, (k * x).sin(), 0.0, k * node[2] * (k * x).cos()]
        })
        .collect();
    let p = WireModel::new(line, lanes, scheme, H, 5e4).expect("regular");
    let at = |state: &WireState<4>| {
        let u = state.displacement();
        let nodes = shape.iter().enumerate();
        nodes.map(|(i, s)| u.at(i)[1] * s[1]).sum::<f64>()
    };
    let mut state = p.at_rest(shape.clone());
    // Mass per metre of the stretched wire: that of its unstretched length, m/(1 + ε).
    let speed = (STRING.tension * (1.0 + STRING.stretch()) / STRING.mass).sqrt();
    let exact = waves * PI / length * speed * H;
    // About a radian, so that faint waves from node to node do not count.
    let stride = (1.0 / exact).round() as usize;
    let mut values = Vec::new();
    for _ in 0..200 + 3 * stride + 2 {
        p.predict(&mut state, |_| false);
        p.commit(&mut state);
        values.push(at(&state));
    }
    // Mean without the root −1 of the trapezoidal rule, which the start without acceleration
    // excites.
    let smooth = |n: usize| 0.25 * (values[n - 1] + 2.0 * values[n] + values[n + 1]);
    // u₂ = 2 ρ cos Ω u₁ − ρ² u₀ and the same one step on, for ρ and Ω.
    let u = [0, 1, 2, 3].map(|k| smooth(200 + k * stride));
    let determinant = u[1] * u[1] - u[0] * u[2];
    let sum = (u[2] * u[1] - u[0] * u[3]) / determinant;
    let product = (u[2] * u[2] - u[1] * u[3]) / determinant;
    (0.5 * sum / product.sqrt()).acos() / (stride as f64 * exact) - 1.0
}

#[test]
fn waves_on_a_string_keep_their_period() {
    for radius in [1.0, 0.9, 0.5] {
        let scheme = Scheme::generalised_alpha(radius);
        let c = scheme.period_error().expect("of second order");
        // 5.3, 10.6 and 21.3 Hz: wavelengths of 24, 12 and 6 m.
        for waves in [5.0, 10.0, 20.0] {
            let (line, lanes) = corrected(&STRING, scheme, H);
            let found = turned(line, lanes, scheme, waves);
            let q2 = (waves * PI / STRING.length * 127.7 * H).powi(2);
            // Next term of the expansion: (ωh)⁴ with a factor below one; elements of a metre add
            // less than 1e-6.
            assert!(found.abs() < q2 * q2 + 1e-6, "{radius} {waves}: {found:e}");
            let (line, lanes) = corrected(&STRING, Scheme::BackwardDifference, H);
            let plain = turned(line, lanes, scheme, waves);
            assert!((plain + c * q2).abs() < q2 * q2 + 1e-6, "{plain:e}");
        }
    }
}

/// The odd motion of an element that tension resists most, e = x − b x³ about its middle, keeps a
/// quarter of its mass where the correction is cut, and more in longer elements.
#[test]
fn a_quarter_of_the_mass_is_left_in_the_worst_motion() {
    let scheme = Scheme::generalised_alpha(0.9);
    for (length, left) in [(0.1, 0.25), (0.5, 0.25), (0.75, 0.25), (1.4, 0.76)] {
        let string = Single {
            length,
            elements: 1,
            ..STRING
        };
        let (structure, path) = string.structure(2);
        let (geometry, shape) = settled::<2, 4>(structure);
        let l = geometry.structure.wires[path[0]].section.rest_length;
        // Ends at ±½ of the element; 90 + √6420 belongs to ∂E/∂b = 0, which gives b.
        let kappa = 90.0 + 6420.0_f64.sqrt();
        let b = (kappa / 12.0 - 1.0) / (kappa / 80.0 - 0.25);
        let (end, slope) = (0.5 - b / 8.0, (1.0 - 0.75 * b) / l);
        let motion = [[0.0, -end, 0.0, slope], [0.0, end, 0.0, slope]];
        let plain = LinearModel::new(&geometry, shape.clone());
        let whole = plain.mass.quadratic(&motion);
        let corrected = plain.with_correct_period(&geometry, &scheme, H);
        let share = corrected.mass.quadratic(&motion) / whole;
        // Exact to rounding where the correction is cut; 2 c h² κ T/(m ℓ²) to two digits elsewhere.
        assert!(
            (share - left).abs() < if left == 0.25 { 1e-12 } else { 0.01 },
            "{share}"
        );
    }
}

/// Where an element is so short that its correction is cut, nothing jumps: neither in h nor in ℓ.
#[test]
fn the_correction_is_continuous() {
    let scheme = Scheme::generalised_alpha(0.9);
    let kinetic = |h: f64, length: f64| {
        let string = Single { length, ..STRING };
        let (line, _) = corrected(&string, scheme, h);
        let mut v = vec![[0.0; 4]; line.nodes()];
        v[30][3] = 1.0;
        line.mass.quadratic(&v) / length.powi(3)
    };
    // Elements of 0.79 m at 1 ms are the shortest with the whole correction.
    let mut last = kinetic(1e-3, 40.0);
    for n in 1..=200 {
        let next = kinetic(1e-3, 40.0 + 0.1 * f64::from(n));
        // A step of a quarter of a percent in ℓ moves 2 (ℓ₀/ℓ)² of the share by as much.
        assert!(
            (next / last - 1.0).abs() < 0.01,
            "ℓ {n}: {next} after {last}"
        );
        last = next;
    }
    let mut last = kinetic(0.5e-3, 48.0);
    for n in 1..=200 {
        let next = kinetic(0.5e-3 + 5e-6 * f64::from(n), 48.0);
        // A step of one percent in h, likewise.
        assert!(
            (next / last - 1.0).abs() < 0.03,
            "h {n}: {next} after {last}"
        );
        last = next;
    }
}
