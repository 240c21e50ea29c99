//! Natural frequencies of wires against closed forms.

use crate::tests::common;

use arcless_core::linalg::dense::tridiagonal_eigenvalues;
use arcless_core::linear::model::LinearModel;
use arcless_core::slideline::Slideline;
use arcless_core::statics::Geometry;
use common::Single;
use common::space::in_space;
use std::f64::consts::PI;

/// Contact wire of the 55 m line (reference-data.md, section 6).
const WIRE: Single = Single {
    length: 55.0,
    elements: 20,
    mass: 1.35,
    axial: 15e6,
    bending: 195.0,
    tension: 22e3,
    gravity: 0.0,
};

fn frequencies(s: &Single, count: usize) -> Vec<f64> {
    let mut g = Geometry::<2, 4>::new(s.structure(2).0).expect("a valid structure");
    let shape = g.design().expect("the design converges");
    let line = LinearModel::new(&g, shape);
    line.frequencies(count).expect("regular")
}

/// f = (n/2L) √(T/m) √(1 + (nπ/L)² EI/T), ends hinged; m and EI per stretched metre.
/// Source: reference-data.md, section 6.
fn exact(s: &Single, n: usize) -> f64 {
    let stretched = 1.0 + s.stretch();
    let (mass, bending) = (s.mass / stretched, s.bending / stretched);
    let k = n as f64 * PI / s.length;
    0.5 * n as f64 / s.length * (s.tension / mass * (1.0 + k * k * bending / s.tension)).sqrt()
}

#[test]
fn frequencies_of_a_beam_under_tension() {
    let s = Single {
        elements: 38,
        ..WIRE
    };
    let found = frequencies(&s, 20);
    // Published with four digits for the unstretched wire; its stretch of 0.15 % changes
    // frequencies by half of that.
    for (n, published) in [
        (1, 1.161),
        (2, 2.321),
        (3, 3.482),
        (5, 5.805),
        (10, 11.62),
        (20, 23.34),
    ] {
        assert!((found[n - 1] / published - 1.0).abs() < 1.2e-3);
    }
    for n in 1..=20 {
        let relative = found[n - 1] / exact(&s, n) - 1.0;
        // Rayleigh quotients are upper bounds; order h⁴ of the bending part, 2e-4 at a half wave of
        // 1.9 elements.
        let size = 2.5e-4 * (n as f64 / 20.0).powi(4) + 1e-9;
        assert!((-1e-11..size).contains(&relative), "{n}: {relative:e}");
        let fault = Single {
            tension: 1.01 * s.tension,
            ..s
        };
        // The partner: 1 % of tension is 0.5 % of a frequency.
        assert!((found[n - 1] / exact(&fault, n) - 1.0).abs() > 4e-3);
    }
}

/// Twice the order of the shape functions in the norm of the energy: 6 for the string (first
/// derivatives), 4 for the beam (second). Source: Strang & Fix, section 6.3.
#[test]
fn order_of_the_frequencies() {
    for (bending, theory) in [(0.0, 6.0), (2e6, 4.0)] {
        let errors = [10, 20, 40].map(|elements| {
            let s = Single {
                elements,
                bending,
                ..WIRE
            };
            frequencies(&s, 6)[5] / exact(&s, 6) - 1.0
        });
        let last = common::orders(&errors)[1];
        assert!(last > theory - 0.4, "{errors:?}: {last}");
    }
}

/// A straight wire in space swings alike to the side and up: every frequency comes twice, also when
/// few are asked for. The second mode grows out of rounding only.
#[test]
fn equal_frequencies_are_all_found() {
    let s = Single {
        elements: 12,
        ..WIRE
    };
    for count in [1, 2, 3, 8] {
        let mut g = Geometry::<3, 6>::new(in_space(&s.structure(2).0)).expect("a valid structure");
        let shape = g.design().expect("the design converges");
        let found = LinearModel::new(&g, shape)
            .frequencies(count)
            .expect("regular");
        let plane = frequencies(&s, 4);
        assert_eq!(found.len(), count);
        for (k, f) in found.iter().enumerate() {
            // Remaining change of the values in the last iterations, and rounding of EA/T.
            assert!((f / plane[k / 2] - 1.0).abs() < 1e-9, "{count}: {found:?}");
        }
    }
}

/// A structure has no more frequencies than modes: an invariant space ends the iteration.
#[test]
fn a_structure_of_few_modes_has_few_frequencies() {
    let s = Single {
        elements: 1,
        bending: 0.0,
        ..WIRE
    };
    // Two free slopes of two components.
    assert_eq!(frequencies(&s, 20).len(), 4);
}

/// Eigenvalues θ of a tridiagonal matrix, and squares of the first components of its eigenvectors:
/// Π (θ − μ)/Π (θ − θ′) over the eigenvalues μ of the matrix without its first row and column.
fn gauss_rule(diagonal: &[f64], off: &[f64]) -> Vec<(f64, f64)> {
    let all = tridiagonal_eigenvalues(diagonal, off);
    let rest = tridiagonal_eigenvalues(&diagonal[1..], &off[1..]);
    let weight = |j: usize| -> f64 {
        let others = all.iter().enumerate().filter(|&(k, _)| k != j);
        let pairs = others.zip(&rest);
        pairs
            .map(|((_, other), mu)| (all[j] - mu) / (all[j] - other))
            .product()
    };
    (0..all.len()).map(|j| (all[j], weight(j))).collect()
}

/// A force in the middle of a string of lift e = L/4T there moves its odd modes only, mode n by
/// 8/π²n² of e.
#[test]
fn modes_that_a_force_moves() {
    let s = Single {
        elements: 40,
        bending: 0.0,
        ..WIRE
    };
    let (structure, path) = s.structure(2);
    let mut g = Geometry::<2, 4>::new(structure).expect("a valid structure");
    let shape = g.design().expect("the design converges");
    let lanes = Slideline::from_elements(&g, &shape, &[path]).expect("a path");
    let line = LinearModel::new(&g, shape);
    let middle = lanes[0].locate(0.5 * s.length, 0).expect("on the wire");
    let found = line.modes_moved(&[middle], 20).expect("regular");
    let mut rule = gauss_rule(&found.diagonal, &found.off);
    // Even modes have nothing but rounding; mode 5 has (1/5)⁴ of what mode 1 has.
    rule.retain(|&(_, weight)| weight > 1e-4);
    rule.reverse();
    let lift = 0.25 * s.length / s.tension;
    for (k, (square, weight)) in rule.into_iter().take(3).enumerate() {
        let n = 2 * k + 1;
        let f = 1.0 / (square.sqrt() * 2.0 * PI);
        // Cubic elements of an eighth of the shortest half wave.
        assert!((f / exact(&s, n) - 1.0).abs() < 1e-5, "{n}: {f} Hz");
        let share = found.squared_length * weight / square / lift;
        // Half the wire's stretch of 0.15 %.
        assert!(
            (share * (PI * n as f64).powi(2) / 8.0 - 1.0).abs() < 2e-3,
            "{n}: {share}"
        );
    }
}

#[test]
fn a_force_on_a_fixed_node_moves_no_mode() {
    let (structure, path) = WIRE.structure(2);
    let mut g = Geometry::<2, 4>::new(structure).expect("a valid structure");
    let shape = g.design().expect("the design converges");
    let lanes = Slideline::from_elements(&g, &shape, &[path]).expect("a path");
    let end = lanes[0].locate(0.0, 0).expect("on the wire");
    let line = LinearModel::new(&g, shape);
    let found = line.modes_moved(&[end], 30).expect("regular");
    assert!(found.squared_length.abs() < f64::MIN_POSITIVE);
    assert!(found.diagonal.is_empty() && found.off.is_empty());
}
