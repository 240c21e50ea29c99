//! Updated kinematics against the published step written out densely, against linearised kinematics
//! for small motion, and at rest.

use crate::common;

use arcless_core::CoreError;
use arcless_core::dynamics::given::Given;
use arcless_core::dynamics::line::Line;
use arcless_core::dynamics::path::Path;
use arcless_core::dynamics::place::Place;
use arcless_core::dynamics::record::{Record, RecordPlan};
use arcless_core::dynamics::rider::Rider;
use arcless_core::dynamics::run::Travel;
use arcless_core::dynamics::stepper::Prepared;
use arcless_core::dynamics::strip::Strip;
use arcless_core::linalg::SymmetricBlocks;
use arcless_core::published::{Known, Matrix, PublishedStep, friction};
use arcless_core::scheme::Scheme;
use arcless_core::statics::assembly::LinkLaw;
use arcless_core::statics::{Geometry, Shape};
use arcless_core::structure::Structure;
use common::chain::{lumped, settled};
use common::{Single, orders, simple_line_of, three_masses};

const CONTACT: f64 = 50e3;

fn plan(points: Vec<f64>) -> RecordPlan {
    RecordPlan {
        contact_every: 1,
        line_every: 1,
        links: true,
        nodes: Vec::new(),
        points,
        ledger: false,
        ledger_every: 1,
        near: None,
    }
}

fn travel(start: f64, speed: f64, h: f64, steps: usize, friction: f64) -> Travel {
    Travel {
        positions: (0..=steps).map(|i| start + speed * h * i as f64).collect(),
        speeds: vec![speed; steps + 1],
        distances: vec![0.0],
        friction,
        loads: Vec::new(),
    }
}

fn updated<const DIM: usize, const D: usize>(
    (structure, path): &(Structure, Vec<usize>),
    scheme: Scheme,
    h: f64,
    contact: f64,
) -> Prepared<DIM, D> {
    let (geometry, shape) = settled::<DIM, D>(structure.clone());
    let lanes =
        Path::lanes(&geometry, &shape, std::slice::from_ref(path)).expect("the wire is a path");
    Prepared::updated(
        &geometry,
        Line::new(&geometry, shape.clone()),
        lanes,
        scheme,
        h,
        contact,
    )
    .expect("regular")
}

fn linearised<const DIM: usize, const D: usize>(
    line: &(Structure, Vec<usize>),
    scheme: Scheme,
    h: f64,
    contact: f64,
) -> Prepared<DIM, D> {
    common::prepare_any(line.clone(), |_| (), scheme, h, contact)
}

fn run<const DIM: usize, const D: usize>(
    p: &Prepared<DIM, D>,
    rider: &Rider,
    travel: &Travel,
    points: Vec<f64>,
) -> Record {
    p.run(
        std::slice::from_ref(rider),
        travel,
        &plan(points),
        &mut |_| true,
    )
    .expect("the run goes through")
}

/// The two masses of the paper's example, without damping.
fn two_masses(force: f64) -> Rider {
    Rider {
        mass: vec![45.0, 0.0, 0.0, 16.0],
        damping: vec![0.0; 4],
        stiffness: vec![7e3, -6e3, -6e3, 6e3],
        strips: vec![Strip::plain(vec![0.0, 1.0])],
        preload: vec![1.0, 0.0],
        lift: vec![0.0; 2],
        start_force: force,
        given: Given::default(),
        stops: Vec::new(),
        laws: Vec::new(),
        actuator: None,
    }
}

/// A slack-free single wire of point masses that sags by some centimetres.
fn wire() -> (Structure, Vec<usize>) {
    let single = Single {
        length: 24.0,
        elements: 48,
        mass: 1.07,
        axial: 12e6,
        bending: 145.0,
        tension: 12e3,
        gravity: 9.81,
    };
    let (structure, path) = single.structure(2);
    (lumped(&structure), path)
}

/// The literal step of `published`, dense, for line and rider together.
struct Literal {
    geometry: Geometry<2, 2>,
    rest: Shape<2>,
    free: Vec<(usize, usize)>,
    path: Path<2>,
    rider: Rider,
    preload: f64,
    datum: f64,
    step: PublishedStep,
    u_1: Vec<f64>,
    u_2: Vec<f64>,
}

impl Literal {
    fn size(&self) -> usize {
        self.free.len() + self.rider.size()
    }

    /// Block matrix over the free degrees of freedom, and the rider's matrix below it.
    fn dense(free: &[(usize, usize)], a: &SymmetricBlocks<2>, rider: &[f64]) -> Matrix {
        let (n, m) = (free.len(), rider.len().isqrt());
        let mut full = vec![vec![0.0; n + m]; n + m];
        let number = |node, c| free.iter().position(|&f| f == (node, c));
        for i in 0..a.rows() {
            for k in a.row_start[i]..a.row_start[i + 1] {
                for (p, q) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    if let (Some(r), Some(s)) = (number(i, p), number(a.columns[k], q)) {
                        full[r][s] = a.blocks[k][p][q];
                        full[s][r] = a.blocks[k][p][q];
                    }
                }
            }
        }
        for (k, value) in rider.iter().enumerate() {
            full[n + k / m][n + k % m] = *value;
        }
        let rows: Vec<f64> = full.concat();
        Matrix::new("dense", n + m, n + m, rows).expect("finite")
    }

    fn new(line: &(Structure, Vec<usize>), rider: Rider, start: f64, speed: f64, h: f64) -> Self {
        let (geometry, rest) = settled::<2, 2>(line.0.clone());
        let mut path = Path::new(&geometry, &rest, &line.1).expect("a path");
        let lin = Line::new(&geometry, rest.clone());
        let all = lin.free.iter().enumerate();
        let free: Vec<(usize, usize)> = all
            .flat_map(|(node, f)| (0..2).filter(|&c| f[c]).map(move |c| (node, c)))
            .collect();
        let force = rider.start_force;
        // The first equilibrium: ten times as many approximations as it needs.
        let (mut shape, mut loaded) = (rest.clone(), geometry.clone());
        for _ in 0..30 {
            let place = path.locate(start, 0).expect("on the wire");
            let shares = place.shares::<2>(1);
            loaded.structure.loads = shares.map(|(n, c, s)| (n, c, s * force)).collect();
            shape = loaded.settle(&shape).expect("an equilibrium");
            path.follow(&difference(&shape, &rest));
        }
        let place = path.locate(start, 0).expect("on the wire");
        let u = difference(&shape, &rest);
        let z = place.displacement(&u, 1);
        let (own, preload) = rider.equilibrium(force, z, speed).expect("a balance");
        let mut u_1: Vec<f64> = free.iter().map(|&(n, c)| u[n][c]).collect();
        u_1.extend(own);
        let mass = Self::dense(&free, &lin.inertia(1.0, 0.0), &rider.mass);
        let size = mass.rows;
        let damping = Matrix::new("damping", size, size, vec![0.0; size * size]).expect("zeros");
        let k = Self::dense(&free, &lin.stiffness, &rider.stiffness);
        Self {
            step: PublishedStep::new(mass, damping, &k, h).expect("positive definite"),
            datum: place.height,
            geometry,
            rest,
            free,
            path,
            rider,
            preload,
            u_2: u_1.clone(),
            u_1,
        }
    }

    /// p_i such that K u_i − p_i is the force at the new position, to first order: p = K u − g(r).
    fn load(&self, k: &Matrix, shape: &Shape<2>) -> Vec<f64> {
        let mut g = vec![[0.0; 2]; shape.len()];
        let law = LinkLaw::Linear;
        self.geometry.service_residual(shape, law, &mut g);
        let mut load = k.times(&self.u_1);
        for (p, &(node, c)) in load.iter_mut().zip(&self.free) {
            *p -= g[node][c];
        }
        let n = self.free.len();
        for (i, b) in self.rider.preload.iter().enumerate() {
            load[n + i] = b * self.preload;
        }
        load
    }

    /// One step with the collector at `x`; `force_1` is the contact force of the step before.
    fn advance(&mut self, x: f64, coefficient: f64, force_1: f64) -> f64 {
        let n = self.free.len();
        let mut u = vec![[0.0; 2]; self.rest.len()];
        for (&(node, c), value) in self.free.iter().zip(&self.u_1) {
            u[node][c] = *value;
        }
        let mut shape = self.rest.clone();
        for (r, u) in shape.iter_mut().zip(&u) {
            (0..2).for_each(|c| r[c] += u[c]);
        }
        let mut tangent = self.geometry.empty_matrix();
        self.geometry.tangent(&shape, LinkLaw::Linear, &mut tangent);
        let k = Self::dense(&self.free, &tangent, &self.rider.stiffness);
        self.step.reform(&k).expect("positive definite");
        self.path.follow(&u);
        let place: Place<2> = self.path.locate(x, 0).expect("on the wire");
        let mut map = vec![0.0; self.size()];
        let mut load = self.load(&k, &shape);
        let drag = friction(coefficient, &[force_1])[0];
        for (i, dof) in self.free.iter().enumerate() {
            for (node, c, share) in place.shares::<2>(1) {
                if *dof == (node, c) {
                    map[i] += share;
                }
            }
            for (node, c, share) in place.shares::<2>(0) {
                if *dof == (node, c) {
                    load[i] += share * drag;
                }
            }
        }
        for (i, e) in self.rider.strips[0].vectors[0].iter().enumerate() {
            map[n + i] = -e;
        }
        let map = Matrix::new("map", self.size(), 1, map).expect("finite");
        let known = Known {
            u_1: &self.u_1,
            u_2: &self.u_2,
            load: &load,
            contact_map: &map,
            initial_gap: &[place.height - self.datum],
        };
        let step = self.step.step(&known).expect("solved");
        self.u_2 = std::mem::replace(&mut self.u_1, step.u);
        step.force[0]
    }
}

fn difference(shape: &Shape<2>, rest: &Shape<2>) -> Vec<[f64; 2]> {
    let rows = shape.iter().zip(rest);
    rows.map(|(a, b)| [a[0] - b[0], a[1] - b[1]]).collect()
}

/// The run of the fast path is the published method: same force, step by step, with gaps, friction and
/// re-formed stiffness.
#[test]
fn the_fast_path_is_the_published_step() {
    let line = wire();
    let (start, speed, coefficient) = (6.0, 60.0, 0.2);
    let h = 0.5 / speed;
    let p = updated::<2, 2>(&line, Scheme::BackwardDifference, h, f64::INFINITY);
    let steps = 24;
    let rider = two_masses(150.0);
    let way = travel(start, speed, h, steps, coefficient);
    let record = run(&p, &rider, &way, Vec::new());
    let mut literal = Literal::new(&line, rider, start, speed, h);
    let mut force = 150.0;
    let scale = record.force.iter().fold(0.0_f64, |m, f| m.max(*f));
    for (x, found) in way.positions[1..].iter().zip(&record.force) {
        force = literal.advance(*x, coefficient, force);
        // A⁻¹ of 96 unknowns with entries from 1 kN/m to 24 MN/m loses six digits of sixteen at most.
        assert!((force - found).abs() < 1e-7 * scale, "{x}: {force} {found}");
    }
    let (low, high) =
        (record.force.iter()).fold((f64::MAX, 0.0_f64), |(l, h), &f| (l.min(f), h.max(f)));
    assert!(high > 2.0 * low, "the force does vary: {low} to {high}");
    assert_eq!(record.pivot_counts.iter().sum::<usize>(), steps);
    // Partner: without the geometric part (linearised kinematics) it is another force.
    let frozen = linearised::<2, 2>(&line, Scheme::BackwardDifference, h, f64::INFINITY);
    let frozen = run(&frozen, &two_masses(150.0), &way, Vec::new());
    let apart = frozen.force.iter().zip(&record.force);
    let apart = apart.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart > 1e-4 * scale, "{apart}");
}

/// What linearisation leaves out grows with the square of the motion: halving the static force, and
/// with it the motion, quarters the difference of the contact forces.
#[test]
fn small_motion_is_linearised_motion() {
    let mut line = simple_line_of(2, [1.45, 2.9]);
    line.0.links.iter_mut().for_each(|l| l.unilateral = false);
    let (h, scheme) = (2e-3, Scheme::generalised_alpha(0.5));
    let old = linearised::<2, 4>(&line, scheme, h, CONTACT);
    let new = updated::<2, 4>(&line, scheme, h, CONTACT);
    let way = travel(40.0, 40.0, h, 300, 0.0);
    let apart = |force: f64| {
        let rider = three_masses(force);
        let (a, b) = (
            run(&old, &rider, &way, Vec::new()),
            run(&new, &rider, &way, Vec::new()),
        );
        let pairs = a.force.iter().zip(&b.force);
        pairs.map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    let found = orders(&[400.0, 200.0, 100.0].map(apart));
    // Two, up to the cubic part and to a small linear one: the static slope of the wire times its
    // displacement along the track, which linearised contacts leave out.
    assert!(found.iter().all(|p| (p - 2.0).abs() < 0.05), "{found:?}");
}

/// A collector that stands still stays in its first equilibrium, whatever the force: nothing moves.
#[test]
fn the_first_equilibrium_lasts() {
    let line = simple_line_of(2, [1.45, 2.9]);
    for contact in [CONTACT, f64::INFINITY] {
        let scheme = Scheme::generalised_alpha(0.0);
        let p = updated::<2, 4>(&line, scheme, 1e-3, contact);
        for force in [100.0, 900.0] {
            let way = travel(52.0, 0.0, 1e-3, 60, 0.0);
            let r = run(&p, &three_masses(force), &way, vec![52.0]);
            // The balance is found to about 1e-6 N; heights to that over 1e3 N/m.
            // Forces balance to EA ε x / L; some droppers are slack at 900 N.
            assert!(
                r.force.iter().all(|f| (f - force).abs() < 1e-5),
                "{contact}"
            );
            assert_eq!(r.slack_max > 0, force > 500.0);
            let rise = &r.point_uplift;
            assert!(rise.iter().all(|z| (z - rise[0]).abs() < 1e-9));
        }
    }
}

/// Static lift of the middle of a taut string by a force that is not small: with the ends held,
/// T = T₀ + EA (ℓ/L − 1) and P = 4 T z / ℓ, ℓ² = L² + 4 z² (two straight halves).
#[test]
fn a_large_static_force_stiffens_the_string() {
    let (length, tension, axial) = (24.0, 12e3, 12e6);
    let single = Single {
        length,
        elements: 48,
        mass: 1e-3,
        axial,
        bending: 0.0,
        tension,
        gravity: 0.0,
    };
    let (structure, path) = single.structure(2);
    let line = (lumped(&structure), path);
    let p = updated::<2, 2>(&line, Scheme::BackwardDifference, 1e-3, f64::INFINITY);
    let force = 3000.0;
    let r = run(
        &p,
        &two_masses(force),
        &travel(12.0, 0.0, 1e-3, 2, 0.0),
        vec![12.0],
    );
    let unstretched = length / (1.0 + tension / axial);
    let lift = |z: f64| {
        let long = (length * length + 4.0 * z * z).sqrt();
        axial * (long / unstretched - 1.0) * 4.0 * z / long
    };
    let z = r.point_uplift[0];
    // Newton's method leaves the balance of the forces to 1e-7 N.
    assert!((lift(z) / force - 1.0).abs() < 1e-7, "{z}");
    assert!(
        4.0 * tension * z / length < 0.6 * force,
        "the partner: linear theory"
    );
}

#[test]
fn an_energy_ledger_is_refused() {
    let p = updated::<2, 2>(&wire(), Scheme::BackwardDifference, 1e-3, CONTACT);
    let with = RecordPlan {
        ledger: true,
        ledger_every: 1,
        ..plan(Vec::new())
    };
    let way = travel(6.0, 60.0, 1e-3, 3, 0.0);
    let refused = p.run(&[two_masses(100.0)], &way, &with, &mut |_| true);
    assert!(matches!(
        refused,
        Err(CoreError::Input { array: "plan", .. })
    ));
}

#[test]
fn a_wire_that_folds_back_is_noticed() {
    let (structure, elements) = wire();
    let (geometry, shape) = settled::<2, 2>(structure);
    let mut path = Path::new(&geometry, &shape, &elements).expect("a path");
    let mut u = vec![[0.0; 2]; shape.len()];
    u[20][0] = 0.49;
    assert!(path.follow(&u), "just not yet: elements of 0.5 m");
    u[20][0] = 0.51;
    assert!(!path.follow(&u));
}
