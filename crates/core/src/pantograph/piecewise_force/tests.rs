//! Piecewise linear forces of random pantographs against an enumeration of all their pieces.

use crate::error::CoreError;
use crate::lcp::LcpSolver;
use crate::linalg::dense;
use crate::linalg::small::{add_outer, inner};
use crate::pantograph::breakpoint::{Branch, ForceKind, RelativeCoordinate};
use crate::pantograph::excitation::{BaseMotion, Excitation, ExcitationNow, ForceHistory};
use crate::pantograph::model::Pantograph;
use crate::pantograph::piecewise_force::PiecewiseForce;
use crate::pantograph::state::PantographState;
use crate::pantograph::strip::Strip;
use crate::scheme::{Coefficients, Scheme};

/// Numbers between −1 and 1 from a linear congruential generator (Knuth's MMIX constants).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        let [factor, offset] = [6_364_136_223_846_793_005, 1_442_695_040_888_963_407];
        self.0 = self.0.wrapping_mul(factor).wrapping_add(offset);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.next()).collect()
    }

    /// Σ size · x xᵀ of some random vectors: symmetric, positive (semi-)definite.
    fn matrix(&mut self, n: usize, rank: usize, size: f64) -> Vec<f64> {
        let mut matrix = vec![0.0; n * n];
        for _ in 0..rank {
            let x = self.vector(n);
            add_outer(size, &x, &mut matrix);
        }
        matrix
    }

    fn below(&mut self, bound: usize) -> usize {
        ((self.next() * 0.5 + 0.5) * bound as f64) as usize % bound
    }
}

/// A table whose slopes fall to both sides of the steepest piece, or (every fourth) any slopes.
fn table(random: &mut Random, steep: f64, width: f64) -> Vec<[f64; 2]> {
    let pieces = 1 + random.below(5);
    let mut slopes: Vec<f64> = (0..pieces).map(|_| random.next().abs() * steep).collect();
    if random.below(4) > 0 {
        let top = random.below(pieces);
        slopes[..top].sort_by(f64::total_cmp);
        slopes[top..].sort_by(|a, b| b.total_cmp(a));
        slopes[top] = steep;
    }
    if random.below(3) == 0 {
        slopes[pieces - 1] = 0.0;
    }
    let mut points = vec![[
        -width * random.next().abs() * pieces as f64 * 0.5,
        random.next(),
    ]];
    for slope in slopes {
        let [x, f] = points[points.len() - 1];
        let wide = width * (0.05 + random.next().abs());
        points.push([x + wide, f + slope * wide]);
    }
    points
}

fn random_pantograph(random: &mut Random) -> Pantograph {
    let n = 1 + random.below(4);
    let mut mass = random.matrix(n, n, 4.0);
    (0..n).for_each(|i| mass[i * n + i] += 1.0);
    let mut stiffness = random.matrix(n, 1, 3e3);
    (0..n).for_each(|i| stiffness[i * n + i] += 500.0);
    let forces = (0..1 + random.below(4)).map(|_| {
        let kind = [ForceKind::Spring, ForceKind::Damper][random.below(2)];
        let steep = 10_f64.powi(2 + random.below(4) as i32);
        PiecewiseForce {
            direction: random.vector(n),
            kind,
            // Dampers steep enough to outweigh the inertia: 2/h · 10⁵ against 4/h² · some kg.
            points: match kind {
                ForceKind::Spring => table(random, 2e4, 1e-3),
                ForceKind::Damper => table(random, steep, 0.1),
            },
        }
    });
    Pantograph {
        piecewise_forces: forces.collect(),
        mass,
        damping: random.matrix(n, 1, 50.0),
        stiffness,
        strips: vec![Strip::plain(random.vector(n))],
        preload: random.vector(n),
        lift: vec![0.0; n],
        start_force: 0.0,
        excitation: Excitation {
            forces: vec![ForceHistory {
                direction: random.vector(n),
                values: (0..60).map(|_| 500.0 * random.next()).collect(),
            }],
            base: Some(BaseMotion {
                influence: vec![1.0; n],
                displacement: (0..60).map(|_| 1e-3 * random.next()).collect(),
                rate: random.vector(60),
            }),
        },
        stops: Vec::new(),
        actuator: None,
        is_external: false,
    }
}

/// Solves the complementarity problem of a pantograph alone, as a step does; returns the number of
/// switches.
fn solve_constraints(
    state: &mut PantographState,
    c: &Coefficients,
    solver: &mut LcpSolver,
) -> usize {
    for switches in 0.. {
        let active: Vec<_> = state.active_breakpoints().cloned().collect();
        let n = active.len();
        let (mut h, mut w) = (vec![0.0; n * n], vec![0.0; n]);
        for (k, breakpoint) in active.iter().enumerate() {
            for (l, other) in active.iter().enumerate() {
                h[k * n + l] = breakpoint.response(other, k == l);
            }
            w[k] = breakpoint.predicted_opening / breakpoint.factor;
        }
        let both: Vec<f64> = (0..n * n).map(|i| h[i] + h[i % n * n + i / n]).collect();
        assert!(dense::is_positive(&both, n), "the symmetric part of {h:?}");
        let (mut x, mut y) = (vec![0.0; n], vec![0.0; n]);
        solver
            .solve(&h, &w, &mut x, &mut y, &[])
            .expect("a P-matrix");
        for (breakpoint, force) in state.breakpoints.iter_mut().filter(|b| b.active).zip(x) {
            breakpoint.force = force;
        }
        state.apply_breakpoint_forces();
        if !state.switch_branch(c) {
            return switches;
        }
        assert!(
            switches < 1 << state.piecewise_forces.len(),
            "the branches settle"
        );
        state.reset_to_prediction();
    }
    unreachable!()
}

/// Coordinate of a force at the time of balance, linear in the increment: [value without, factors].
fn coordinate_of(
    state: &PantographState,
    coordinate: &RelativeCoordinate,
    c: &Coefficients,
) -> (f64, Vec<f64>) {
    let excitation = &state.excitation;
    let d = &coordinate.direction;
    let (old, base) = match coordinate.kind {
        ForceKind::Spring => (inner(d, &state.u), excitation.balance[0]),
        ForceKind::Damper => {
            let by_v = c.velocity_from_v * inner(d, &state.v);
            (
                by_v + c.velocity_from_a * inner(d, &state.a),
                excitation.balance[1],
            )
        }
    };
    let factors = d.iter().map(|d| d * coordinate.kind.factor(c)).collect();
    (old - inner(d, &excitation.influence) * base, factors)
}

/// Increments of all arrangements of pieces in which every force is on its piece.
fn enumerate(pantograph: &Pantograph, state: &PantographState, c: &Coefficients) -> Vec<Vec<f64>> {
    let n = pantograph.size();
    let counts: Vec<usize> = pantograph
        .piecewise_forces
        .iter()
        .map(PiecewiseForce::pieces)
        .collect();
    let mut increments: Vec<Vec<f64>> = Vec::new();
    for number in 0..counts.iter().product::<usize>() {
        let mut remaining = number;
        let pieces = counts.iter().map(|count| {
            let piece = remaining % count;
            remaining /= count;
            piece
        });
        let pieces: Vec<usize> = pieces.collect();
        // A Δu = rhs of the pantograph without piecewise forces, less g f on the pieces chosen.
        let mut a: Vec<f64> = (0..n * n)
            .map(|i| {
                c.mass * pantograph.mass[i]
                    + c.damping * pantograph.damping[i]
                    + c.stiffness * pantograph.stiffness[i]
            })
            .collect();
        let mut rhs = bare_rhs(pantograph, state, c);
        for ((force, force_state), &piece) in pantograph
            .piecewise_forces
            .iter()
            .zip(&state.piecewise_forces)
            .zip(&pieces)
        {
            let (old, _) = coordinate_of(state, &force_state.coordinate, c);
            let slope = force.slope(piece);
            add_outer(slope * force.kind.factor(c), &force.direction, &mut a);
            let given = force.intercept(piece) + slope * old;
            (0..n).for_each(|i| rhs[i] -= force.direction[i] * given);
        }
        assert!(dense::solve_in_place(&mut a, &mut rhs));
        let fits = pantograph
            .piecewise_forces
            .iter()
            .zip(&state.piecewise_forces)
            .zip(&pieces)
            .all(|((force, force_state), &piece)| {
                let (old, factors) = coordinate_of(state, &force_state.coordinate, c);
                let q = old + inner(&factors, &rhs);
                let ends = [force.points[piece][0], force.points[piece + 1][0]];
                let slack = 1e-12 * (ends[0].abs() + ends[1].abs() + old.abs());
                (piece == 0 || q >= ends[0] - slack)
                    && (piece + 1 == force.pieces() || q <= ends[1] + slack)
            });
        if fits {
            increments.push(rhs);
        }
    }
    increments
}

/// Right-hand side without piecewise forces: forces less inertia, dampers and springs of the old
/// state.
fn bare_rhs(pantograph: &Pantograph, state: &PantographState, c: &Coefficients) -> Vec<f64> {
    let n = pantograph.size();
    let excitation = &state.excitation;
    let row = |matrix: &[f64], i: usize, x: &[f64]| inner(&matrix[i * n..(i + 1) * n], x);
    let combine =
        |v: f64, a: f64| -> Vec<f64> { (0..n).map(|k| v * state.v[k] + a * state.a[k]).collect() };
    let inertia = combine(c.acceleration_from_v, c.acceleration_from_a);
    let rate: Vec<f64> = combine(c.velocity_from_v, c.velocity_from_a)
        .iter()
        .zip(&excitation.influence)
        .map(|(v, r)| v - r * excitation.balance[1])
        .collect();
    let displacement: Vec<f64> = (0..n)
        .map(|k| state.u[k] - excitation.influence[k] * excitation.balance[0])
        .collect();
    (0..n)
        .map(|i| {
            pantograph.preload[i] * state.preload + excitation.force[i]
                - row(&pantograph.mass, i, &inertia)
                - row(&pantograph.damping, i, &rate)
                - row(&pantograph.stiffness, i, &displacement)
        })
        .collect()
}

#[test]
fn a_step_finds_the_one_arrangement_of_pieces_that_fits() {
    let mut random = Random(7);
    let mut solver = LcpSolver::new();
    let (mut switches, mut refused, mut steps) = (0, 0, 0);
    for number in 0..400 {
        let scheme = [
            Scheme::generalised_alpha(1.0),
            Scheme::generalised_alpha(0.8),
        ];
        let c = [scheme[number % 2], Scheme::BackwardDifference][number % 5 / 4].coefficients(1e-3);
        let pantograph = random_pantograph(&mut random);
        let mut state = match PantographState::new(pantograph.clone(), &c, 0.0, 0.0) {
            Ok(state) => state,
            // Beyond a table at the start, or a table that needs a shorter step.
            Err(CoreError::BeyondTable { .. } | CoreError::Input { .. }) => {
                refused += 1;
                continue;
            }
            Err(error) => panic!("{error}"),
        };
        let mut now = ExcitationNow::zero(pantograph.size());
        for step in 0..40 {
            pantograph.excitation.read(step, c.old, &mut now);
            state.set_excitation(&now);
            state.predict(&c, 0.0);
            switches += solve_constraints(&mut state, &c, &mut solver);
            let all = enumerate(&pantograph, &state, &c);
            assert!(!all.is_empty(), "one fits");
            let size = state.delta.iter().fold(0.0_f64, |m, d| m.max(d.abs()));
            for other in &all {
                for (d, known) in state.delta.iter().zip(other) {
                    // Rounding, times the spread of stiffness: 2/h · 10⁵ and 4/h² against 10³ N/m.
                    assert!((d - known).abs() < 1e-8 * size + 1e-14, "{d} {known}");
                }
            }
            steps += 1;
            state.commit(&c);
        }
    }
    // Enough of everything for the test to say something.
    assert!(
        steps > 6000 && switches > 500 && refused > 10,
        "{steps} {switches} {refused}"
    );
}

/// Only one branch is in the problem at a time, for this reason.
#[test]
fn both_branches_of_a_steep_friction_together_are_no_p_matrix() {
    let c = Scheme::generalised_alpha(1.0).coefficients(1e-3);
    let mut pantograph = random_pantograph(&mut Random(3));
    pantograph.mass = vec![5.0];
    (pantograph.damping, pantograph.stiffness) = (vec![0.0], vec![0.0]);
    pantograph.strips = vec![Strip::plain(vec![1.0])];
    (pantograph.preload, pantograph.lift) = (vec![1.0], vec![0.0]);
    pantograph.excitation = Excitation::default();
    let points = vec![[-2.0, -20.0], [-1e-3, -20.0], [1e-3, 20.0], [2.0, 20.0]];
    pantograph.piecewise_forces = vec![PiecewiseForce {
        direction: vec![1.0],
        kind: ForceKind::Damper,
        points,
    }];
    let state = PantographState::new(pantograph, &c, 0.0, 0.0).expect("one side is carried");
    let [a, b] = [&state.breakpoints[0], &state.breakpoints[1]];
    assert_eq!(
        [a.branch_of, b.branch_of],
        [Some((0, Branch::Left)), Some((0, Branch::Right))]
    );
    let minor =
        a.response(a, true) * b.response(b, true) - a.response(b, false) * b.response(a, false);
    assert!(a.response(a, true) > 0.0 && minor < 0.0, "{minor}");
}

/// Softening that adds up to more than the steepest slope, twice over the inertia of a long step.
#[test]
fn a_table_that_softens_twice_needs_short_steps() {
    let mut pantograph = random_pantograph(&mut Random(3));
    pantograph.mass = vec![1.0];
    (pantograph.damping, pantograph.stiffness) = (vec![0.0], vec![10.0]);
    pantograph.strips = vec![Strip::plain(vec![1.0])];
    (pantograph.preload, pantograph.lift) = (vec![1.0], vec![0.0]);
    pantograph.excitation = Excitation::default();
    let points = [
        [-1.0, -1e4],
        [0.1, 1e3],
        [0.2, 1e3],
        [0.3, 1.9e3],
        [0.4, 1.9e3],
        [0.5, 2.8e3],
        [0.6, 2.8e3],
    ];
    pantograph.piecewise_forces = vec![PiecewiseForce {
        direction: vec![1.0],
        kind: ForceKind::Spring,
        points: points.to_vec(),
    }];
    // Softening 10⁴ + 9·10³ + 9·10³, the steepest 10⁴: 18 kN/m too much; 4 kg/h² = 16 kN/m at 16
    // ms.
    let refused = |h: f64| {
        let c = Scheme::generalised_alpha(1.0).coefficients(h);
        PantographState::new(pantograph.clone(), &c, 0.0, 0.0).is_err()
    };
    assert!(refused(0.016) && !refused(0.014));
}
