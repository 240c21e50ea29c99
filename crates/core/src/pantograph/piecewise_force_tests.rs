//! Laws of random riders against an enumeration of all their pieces.

use crate::error::CoreError;
use crate::lcp::LcpSolver;
use crate::linalg::dense;
use crate::pantograph::breakpoint::{ForceKind, RelativeCoordinate};
use crate::pantograph::excitation::{BaseMotion, Excitation, ExcitationNow, ForceHistory};
use crate::pantograph::piecewise_force::{Branch, PiecewiseForce};
use crate::pantograph::strip::Strip;
use crate::pantograph::system::{Pantograph, PantographState, inner};
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
            crate::pantograph::piecewise_force::add_outer(size, &x, &mut matrix);
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

fn random_rider(random: &mut Random) -> Pantograph {
    let n = 1 + random.below(4);
    let mut mass = random.matrix(n, n, 4.0);
    (0..n).for_each(|i| mass[i * n + i] += 1.0);
    let mut stiffness = random.matrix(n, 1, 3e3);
    (0..n).for_each(|i| stiffness[i * n + i] += 500.0);
    let laws = (0..1 + random.below(4)).map(|_| {
        let motion = [ForceKind::Spring, ForceKind::Damper][random.below(2)];
        let steep = 10_f64.powi(2 + random.below(4) as i32);
        PiecewiseForce {
            direction: random.vector(n),
            motion,
            // Dampers steep enough to outweigh the inertia: 2/h · 10⁵ against 4/h² · some kg.
            points: match motion {
                ForceKind::Spring => table(random, 2e4, 1e-3),
                ForceKind::Damper => table(random, steep, 0.1),
            },
        }
    });
    Pantograph {
        laws: laws.collect(),
        mass,
        damping: random.matrix(n, 1, 50.0),
        stiffness,
        strips: vec![Strip::plain(random.vector(n))],
        preload: random.vector(n),
        lift: vec![0.0; n],
        start_force: 0.0,
        given: Excitation {
            forces: vec![ForceHistory {
                direction: random.vector(n),
                values: (0..60).map(|_| 500.0 * random.next()).collect(),
            }],
            ground: Some(BaseMotion {
                carried: vec![1.0; n],
                displacement: (0..60).map(|_| 1e-3 * random.next()).collect(),
                rate: random.vector(60),
            }),
        },
        stops: Vec::new(),
        actuator: None,
    }
}

/// Solve the complementarity problem of a rider on its own, as a step does; returns the turns taken.
fn close(state: &mut PantographState, c: &Coefficients, solver: &mut LcpSolver) -> usize {
    for turns in 0.. {
        let entered: Vec<_> = state.entered().cloned().collect();
        let n = entered.len();
        let (mut h, mut w) = (vec![0.0; n * n], vec![0.0; n]);
        for (k, kink) in entered.iter().enumerate() {
            for (l, other) in entered.iter().enumerate() {
                h[k * n + l] = kink.response(other, k == l);
            }
            w[k] = kink.free / kink.factor;
        }
        let both: Vec<f64> = (0..n * n).map(|i| h[i] + h[i % n * n + i / n]).collect();
        assert!(dense::is_positive(&both, n), "the symmetric part of {h:?}");
        let (mut x, mut y) = (vec![0.0; n], vec![0.0; n]);
        solver
            .solve(&h, &w, &mut x, &mut y, &[])
            .expect("a P-matrix");
        for (kink, force) in state.entered_mut().zip(x) {
            kink.force = force;
        }
        state.add_kinks();
        if !state.turn(c) {
            return turns;
        }
        assert!(turns < 1 << state.laws.len(), "the sides settle");
        state.take_back();
    }
    unreachable!()
}

/// Motion of a law at the time of balance, linear in the increment: [value without, factors].
fn motion(
    state: &PantographState,
    gauge: &RelativeCoordinate,
    c: &Coefficients,
) -> (f64, Vec<f64>) {
    let drive = &state.drive;
    let d = &gauge.direction;
    let (old, ground) = match gauge.motion {
        ForceKind::Spring => (inner(d, &state.u), drive.balance[0]),
        ForceKind::Damper => {
            let by_v = c.velocity_from_v * inner(d, &state.v);
            (
                by_v + c.velocity_from_a * inner(d, &state.a),
                drive.balance[1],
            )
        }
    };
    let factors = d.iter().map(|d| d * gauge.motion.factor(c)).collect();
    (old - inner(d, &drive.carried) * ground, factors)
}

/// Increments of all arrangements of pieces in which every law is on its piece.
fn enumerate(rider: &Pantograph, state: &PantographState, c: &Coefficients) -> Vec<Vec<f64>> {
    let n = rider.size();
    let counts: Vec<usize> = rider.laws.iter().map(PiecewiseForce::pieces).collect();
    let mut found: Vec<Vec<f64>> = Vec::new();
    for number in 0..counts.iter().product::<usize>() {
        let mut rest = number;
        let pieces = counts.iter().map(|count| {
            let piece = rest % count;
            rest /= count;
            piece
        });
        let pieces: Vec<usize> = pieces.collect();
        // A Δu = rhs of the rider without laws, less g f on the pieces chosen.
        let mut a: Vec<f64> = (0..n * n)
            .map(|i| {
                c.mass * rider.mass[i]
                    + c.damping * rider.damping[i]
                    + c.stiffness * rider.stiffness[i]
            })
            .collect();
        let mut rhs = bare_rhs(rider, state, c);
        for ((law, own), &piece) in rider.laws.iter().zip(&state.laws).zip(&pieces) {
            let (old, _) = motion(state, &own.gauge, c);
            let slope = law.slope(piece);
            crate::pantograph::piecewise_force::add_outer(
                slope * law.motion.factor(c),
                &law.direction,
                &mut a,
            );
            let force = law.intercept(piece) + slope * old;
            (0..n).for_each(|i| rhs[i] -= law.direction[i] * force);
        }
        assert!(dense::solve_in_place(&mut a, &mut rhs));
        let fits = rider
            .laws
            .iter()
            .zip(&state.laws)
            .zip(&pieces)
            .all(|((law, own), &piece)| {
                let (old, factors) = motion(state, &own.gauge, c);
                let q = old + inner(&factors, &rhs);
                let ends = [law.points[piece][0], law.points[piece + 1][0]];
                let slack = 1e-12 * (ends[0].abs() + ends[1].abs() + old.abs());
                (piece == 0 || q >= ends[0] - slack)
                    && (piece + 1 == law.pieces() || q <= ends[1] + slack)
            });
        if fits {
            found.push(rhs);
        }
    }
    found
}

/// Right-hand side without any law: forces less inertia, dampers and springs of the old state.
fn bare_rhs(rider: &Pantograph, state: &PantographState, c: &Coefficients) -> Vec<f64> {
    let n = rider.size();
    let drive = &state.drive;
    let row = |matrix: &[f64], i: usize, x: &[f64]| inner(&matrix[i * n..(i + 1) * n], x);
    let combine =
        |v: f64, a: f64| -> Vec<f64> { (0..n).map(|k| v * state.v[k] + a * state.a[k]).collect() };
    let inertia = combine(c.acceleration_from_v, c.acceleration_from_a);
    let rate: Vec<f64> = combine(c.velocity_from_v, c.velocity_from_a)
        .iter()
        .zip(&drive.carried)
        .map(|(v, r)| v - r * drive.balance[1])
        .collect();
    let place: Vec<f64> = (0..n)
        .map(|k| state.u[k] - drive.carried[k] * drive.balance[0])
        .collect();
    (0..n)
        .map(|i| {
            rider.preload[i] * state.preload + drive.force[i]
                - row(&rider.mass, i, &inertia)
                - row(&rider.damping, i, &rate)
                - row(&rider.stiffness, i, &place)
        })
        .collect()
}

#[test]
fn a_step_finds_the_one_arrangement_of_pieces_that_fits() {
    let mut random = Random(7);
    let mut solver = LcpSolver::new();
    let (mut turns, mut refused, mut steps) = (0, 0, 0);
    for number in 0..400 {
        let scheme = [
            Scheme::generalised_alpha(1.0),
            Scheme::generalised_alpha(0.8),
        ];
        let c = [scheme[number % 2], Scheme::BackwardDifference][number % 5 / 4].coefficients(1e-3);
        let rider = random_rider(&mut random);
        let mut state = match PantographState::new(rider.clone(), &c, 0.0, 0.0) {
            Ok(state) => state,
            // Beyond a table at the start, or a table that needs a shorter step.
            Err(CoreError::BeyondTable { .. } | CoreError::Input { .. }) => {
                refused += 1;
                continue;
            }
            Err(error) => panic!("{error}"),
        };
        let mut now = ExcitationNow::zero(rider.size());
        for step in 0..40 {
            rider.given.read(step, c.old, &mut now);
            state.begin(&now);
            state.free_increment(&c, 0.0);
            turns += close(&mut state, &c, &mut solver);
            let all = enumerate(&rider, &state, &c);
            assert!(!all.is_empty(), "one fits");
            let size = state.delta.iter().fold(0.0_f64, |m, d| m.max(d.abs()));
            for other in &all {
                for (d, known) in state.delta.iter().zip(other) {
                    // Rounding, times the spread of stiffness: 2/h · 10⁵ and 4/h² beside 10³ N/m.
                    assert!((d - known).abs() < 1e-8 * size + 1e-14, "{d} {known}");
                }
            }
            steps += 1;
            state.advance(&c);
        }
    }
    // Enough of everything for the test to say something.
    assert!(
        steps > 6000 && turns > 500 && refused > 10,
        "{steps} {turns} {refused}"
    );
}

/// Why only one side stands in the problem at a time.
#[test]
fn both_sides_of_a_steep_friction_together_are_no_p_matrix() {
    let c = Scheme::generalised_alpha(1.0).coefficients(1e-3);
    let mut rider = random_rider(&mut Random(3));
    rider.mass = vec![5.0];
    (rider.damping, rider.stiffness) = (vec![0.0], vec![0.0]);
    rider.strips = vec![Strip::plain(vec![1.0])];
    (rider.preload, rider.lift) = (vec![1.0], vec![0.0]);
    rider.given = Excitation::default();
    let points = vec![[-2.0, -20.0], [-1e-3, -20.0], [1e-3, 20.0], [2.0, 20.0]];
    rider.laws = vec![PiecewiseForce {
        direction: vec![1.0],
        motion: ForceKind::Damper,
        points,
    }];
    let state = PantographState::new(rider, &c, 0.0, 0.0).expect("one side is carried");
    let [a, b] = [&state.kinks[0], &state.kinks[1]];
    assert_eq!(
        [a.law, b.law],
        [Some((0, Branch::Left)), Some((0, Branch::Right))]
    );
    let minor =
        a.response(a, true) * b.response(b, true) - a.response(b, false) * b.response(a, false);
    assert!(a.response(a, true) > 0.0 && minor < 0.0, "{minor}");
}

/// Softening that adds up to more than the steepest slope, twice over the inertia of a long step.
#[test]
fn a_table_that_softens_twice_needs_short_steps() {
    let mut rider = random_rider(&mut Random(3));
    rider.mass = vec![1.0];
    (rider.damping, rider.stiffness) = (vec![0.0], vec![10.0]);
    rider.strips = vec![Strip::plain(vec![1.0])];
    (rider.preload, rider.lift) = (vec![1.0], vec![0.0]);
    rider.given = Excitation::default();
    let points = [
        [-1.0, -1e4],
        [0.1, 1e3],
        [0.2, 1e3],
        [0.3, 1.9e3],
        [0.4, 1.9e3],
        [0.5, 2.8e3],
        [0.6, 2.8e3],
    ];
    rider.laws = vec![PiecewiseForce {
        direction: vec![1.0],
        motion: ForceKind::Spring,
        points: points.to_vec(),
    }];
    // Softening 10⁴ + 9·10³ + 9·10³, the steepest 10⁴: 18 kN/m too much; 4 kg/h² = 16 kN/m at 16 ms.
    let refused = |h: f64| {
        let c = Scheme::generalised_alpha(1.0).coefficients(h);
        PantographState::new(rider.clone(), &c, 0.0, 0.0).is_err()
    };
    assert!(refused(0.016) && !refused(0.014));
}
