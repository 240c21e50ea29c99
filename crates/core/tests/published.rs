//! The published step: its formulas against the equations they come from, and closed forms.

#[path = "published_forms/mod.rs"]
mod published_forms;

use arcless_core::linalg::dense;
use arcless_core::published::{
    Known, Matrix, PublishedStep, acceleration, exchange_row, matrix_a, matrix_b, table_1, velocity,
};

fn matrix(rows: usize, values: &[f64]) -> Matrix {
    Matrix::new("test", rows, values.len() / rows, values.to_vec()).expect("finite entries")
}

/// Numbers in (−1, 1) from a linear congruence (Knuth's MMIX), the same on every machine.
fn numbers(count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    (0..count).map(|_| next()).collect()
}

/// G Gᵀ + shift·1: symmetric, positive definite for a positive shift.
fn gram(n: usize, shift: f64, seed: u64) -> Matrix {
    let g = numbers(n * n, seed);
    let dot = |i: usize, j: usize| (0..n).map(|k| g[i * n + k] * g[j * n + k]).sum::<f64>();
    let entry = |k: usize| dot(k / n, k % n) + if k / n == k % n { shift } else { 0.0 };
    matrix(n, &(0..n * n).map(entry).collect::<Vec<_>>())
}

/// CᵀA⁻¹C by Gauss elimination with row exchanges, which shares nothing with the Jordan exchange.
fn flexibility(a: &Matrix, c: &Matrix) -> Vec<f64> {
    let (n, m) = (c.rows, c.columns);
    let mut h = vec![0.0; m * m];
    for j in 0..m {
        let mut field: Vec<f64> = (0..n).map(|i| c.at(i, j)).collect();
        assert!(dense::solve_in_place(&mut a.values.clone(), &mut field));
        for i in 0..m {
            h[i * m + j] = (0..n).map(|k| c.at(k, i) * field[k]).sum();
        }
    }
    h
}

fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    let size = expected.iter().fold(1e-300, |m: f64, v| m.max(v.abs()));
    for (k, (a, b)) in found.iter().zip(expected).enumerate() {
        assert!((a - b).abs() <= tolerance * size, "entry {k}: {a} and {b}");
    }
    assert_eq!(found.len(), expected.len());
}

/// A single mass m with damper c and spring k.
fn oscillator(m: f64, c: f64, k: f64, tau: f64) -> PublishedStep {
    let one = |v: f64| matrix(1, &[v]);
    PublishedStep::new(one(m), one(c), &one(k), tau).expect("a positive mass")
}

/// Steps 6 and 7: the block exchange is the exchange of all rows of A one after the other.
#[test]
fn block_exchange_is_the_exchange_of_every_row() {
    let (n, m) = (7, 3);
    let a = gram(n, 0.5, 1);
    let c = matrix(n, &numbers(n * m, 2));
    let (p_hat, d0) = (numbers(n, 3), numbers(m, 4));
    let entry = |i: usize, j: usize| match (i < n, j < n) {
        _ if j == n + m => {
            if i < n {
                p_hat[i]
            } else {
                d0[i - n]
            }
        }
        (true, true) => a.at(i, j),
        (true, false) => -c.at(i, j - n),
        (false, true) => c.at(j, i - n),
        (false, false) => 0.0,
    };
    let width = n + m + 1;
    let values: Vec<f64> = (0..(n + m) * width)
        .map(|k| entry(k / width, k % width))
        .collect();
    let mut whole = matrix(n + m, &values);
    let mut inverse = a.clone();
    for k in 0..n {
        exchange_row(&mut whole, k);
        exchange_row(&mut inverse, k);
    }
    let blocks = table_1(&a, &c, p_hat, &d0).exchange(&inverse);
    for (name, block, row, column) in [
        ("A⁻¹", &blocks.upper_left, 0, 0),
        ("A⁻¹C", &blocks.upper_right, 0, n),
        ("CᵀA⁻¹", &blocks.lower_left, n, 0),
        ("H", blocks.h(), n, n),
        ("−A⁻¹p̂", &matrix(n, &blocks.upper_constant), 0, n + m),
        ("w", &matrix(m, blocks.w()), n, n + m),
    ] {
        for i in 0..block.rows {
            for j in 0..block.columns {
                let (found, expected) = (block.at(i, j), whole.at(row + i, column + j));
                // Entries of size 1, condition number about 20.
                assert!(
                    (found - expected).abs() < 1e-13,
                    "{name}: {found} {expected}"
                );
            }
        }
    }
    assert_close(&blocks.h().values, &flexibility(&a, &c), 1e-13);
}

/// An exchange undone is no exchange, and a symmetric matrix has a symmetric inverse to the last bit.
#[test]
fn exchange_is_its_own_inverse() {
    let a = gram(9, 0.5, 5);
    let mut table = a.clone();
    (0..9).for_each(|k| exchange_row(&mut table, k));
    for i in 0..9 {
        (0..i).for_each(|j| assert_eq!(table.at(i, j).to_bits(), table.at(j, i).to_bits()));
    }
    (0..9).for_each(|k| exchange_row(&mut table, k));
    assert_close(&table.values, &a.values, 1e-13);
}

/// Models 1 to 3 hold at the end of every step, while contacts move and the stiffness is re-formed.
#[test]
fn every_step_satisfies_the_model() {
    let (n, m, tau) = (8, 3, 0.01);
    let (mass, damping) = (gram(n, 0.5, 11), gram(n, 0.0, 12));
    let mut p = PublishedStep::new(mass.clone(), damping.clone(), &gram(n, 0.0, 13), tau)
        .expect("a definite system");
    let (mut u_2, mut u_1) = (vec![0.0; n], vec![0.0; n]);
    let mut switches = 0;
    for i in 0..200_u64 {
        let stiffness = gram(n, 0.0, 13 + i / 50);
        if i % 50 == 0 {
            p.reform(&stiffness).expect("a definite system");
        }
        let map = matrix(n, &numbers(n * m, 100 + i / 5));
        let (load, d0) = (numbers(n, 1000 + i), numbers(m, 5000 + i / 5));
        let d0: Vec<f64> = d0.iter().map(|d| 1e-3 * d).collect();
        let known = Known {
            u_1: &u_1,
            u_2: &u_2,
            load: &load,
            contact_map: &map,
            initial_gap: &d0,
        };
        let step = p.step(&known).expect("a solution");

        let (v, a) = (
            velocity(&step.u, &u_1, tau),
            acceleration(&step.u, &u_1, &u_2, tau),
        );
        let (inertia, viscous) = (mass.times(&a), damping.times(&v));
        let (elastic, contact) = (stiffness.times(&step.u), map.times(&step.force));
        let size = inertia
            .iter()
            .chain(&contact)
            .chain(&load)
            .fold(0.0, |m: f64, f| m.max(f.abs()));
        for k in 0..n {
            let r = inertia[k] + viscous[k] + elastic[k] - load[k] - contact[k];
            // Rounding of u is divided by τ² = 10⁻⁴ here.
            assert!(r.abs() < 1e-10 * size, "step {i}, R = {r:e}");
        }
        let reach = step.u.iter().fold(1.0, |m: f64, u| m.max(u.abs()));
        for j in 0..m {
            let d = d0[j] + (0..n).map(|k| map.at(k, j) * step.u[k]).sum::<f64>();
            // A few roundings of the displacements.
            assert!((d - step.gap[j]).abs() < 1e-14 * reach, "{d} {reach}");
            assert!(step.gap[j] >= 0.0 && step.force[j] >= 0.0);
            assert_eq!(step.gap[j] * step.force[j], 0.0);
            switches += usize::from(step.force[j] > 0.0);
        }
        (u_2, u_1) = (u_1, step.u);
    }
    assert!(
        (100..500).contains(&switches),
        "both states occur: {switches} of 600"
    );
}

#[test]
fn matrices_are_those_of_the_formulas() {
    let (m, c, k) = (gram(3, 1.0, 21), gram(3, 1.0, 22), gram(3, 1.0, 23));
    let (a, b) = (matrix_a(&m, &c, &k, 0.5), matrix_b(&m, &c, 0.5));
    assert_eq!(a.at(1, 2), 4.0 * m.at(1, 2) + 2.0 * c.at(1, 2) + k.at(1, 2));
    assert_eq!(b.at(2, 0), 8.0 * m.at(2, 0) + 2.0 * c.at(2, 0));
}

#[test]
fn wrong_systems_are_named() {
    let nan = f64::NAN;
    let good = || matrix(2, &[2.0, 0.5, 0.5, 1.0]);
    let one = |values: [f64; 4]| Matrix {
        rows: 2,
        columns: 2,
        values: values.to_vec(),
    };
    let skew = one([2.0, 0.5, 0.4, 1.0]);
    let small = matrix(1, &[1.0]);
    let wide = Matrix {
        rows: 2,
        columns: 3,
        values: vec![1.0; 6],
    };
    let none = Matrix {
        rows: 0,
        columns: 0,
        values: vec![],
    };
    let cases = [
        (
            good(),
            good(),
            good(),
            0.0,
            "time_step: 0 s is not a positive number",
        ),
        (good(), good(), good(), nan, "time_step: NaN s"),
        (
            none.clone(),
            none.clone(),
            none,
            1.0,
            "mass: no degrees of freedom",
        ),
        (
            wide,
            good(),
            good(),
            1.0,
            "mass: 2 × 3 entries, expected 2 × 2",
        ),
        (
            good(),
            small.clone(),
            good(),
            1.0,
            "damping: 1 × 1 entries, expected 2 × 2",
        ),
        (
            good(),
            good(),
            small,
            1.0,
            "stiffness: 1 × 1 entries, expected 2 × 2",
        ),
        (
            one([nan, 0.0, 0.0, 1.0]),
            good(),
            good(),
            1.0,
            "mass: entry 0 is NaN",
        ),
        (
            skew.clone(),
            good(),
            good(),
            1.0,
            "mass: not symmetric: entry (0, 1) is 0.5",
        ),
        (good(), skew.clone(), good(), 1.0, "damping: not symmetric"),
        (good(), good(), skew, 1.0, "stiffness: not symmetric"),
        (
            good(),
            good(),
            one([-9.0, 0.0, 0.0, 1.0]),
            1.0,
            "A: M/τ² + C_d/τ + K is not positive",
        ),
        (good(), good(), one([0.0, 9.0, 9.0, 0.0]), 1.0, "pivot"),
    ];
    for (mass, damping, stiffness, tau, message) in cases {
        let error = PublishedStep::new(mass, damping, &stiffness, tau).expect_err(message);
        assert!(error.to_string().contains(message), "{error}");
    }
    let error = Matrix::new("load", 2, 2, vec![1.0; 3]).expect_err("three entries");
    assert!(error.to_string().contains("load: 3 entries, expected 4"));
}

#[test]
fn wrong_steps_are_named_and_leave_the_system_usable() {
    let mut p = oscillator(1.0, 0.0, 1.0, 0.1);
    let floor = matrix(1, &[1.0]);
    let good = Known {
        u_1: &[0.0],
        u_2: &[0.0],
        load: &[-1.0],
        contact_map: &floor,
        initial_gap: &[0.0],
    };
    let before = p.step(&good).expect("a solution");
    let two = matrix(2, &[1.0, 1.0]);
    let zero = matrix(1, &[0.0]);
    let cases = [
        (
            Known {
                u_1: &[0.0, 1.0],
                ..good
            },
            "u_1: 2 entries, expected 1",
        ),
        (Known { u_2: &[], ..good }, "u_2: 0 entries, expected 1"),
        (
            Known {
                load: &[f64::INFINITY],
                ..good
            },
            "load: entry 0 is inf",
        ),
        (
            Known {
                contact_map: &two,
                ..good
            },
            "contact_map: 2 entries, expected 1",
        ),
        (
            Known {
                initial_gap: &[],
                ..good
            },
            "initial_gap: 0 entries, expected 1",
        ),
        (
            Known {
                contact_map: &zero,
                ..good
            },
            "contact_map: column 0 is zero",
        ),
    ];
    for (known, message) in cases {
        let error = p.step(&known).expect_err(message);
        assert!(error.to_string().contains(message), "{error}");
    }
    assert!(p.reform(&matrix(1, &[-1e9])).is_err());
    assert_eq!(p.step(&good).expect("a solution"), before);
}

/// Two contacts at one place: H has rank one, and the nearer of the two carries everything.
#[test]
fn twin_contacts_are_solved() {
    let mut p = oscillator(1.0, 0.0, 1e3, 1e-2);
    let twin = Matrix::new("contact_map", 1, 2, vec![1.0, 1.0]).expect("finite");
    let known = Known {
        u_1: &[0.0],
        u_2: &[0.0],
        load: &[-5.0],
        contact_map: &twin,
        initial_gap: &[0.0, 1e-3],
    };
    let step = p.step(&known).expect("the nearer of the two carries");
    assert_eq!(step.force[1], 0.0);
    // Rounding of numbers of order 1.
    assert!((step.force[0] - 5.0).abs() < 1e-12 && (step.gap[1] - 1e-3).abs() < 1e-15);
}
