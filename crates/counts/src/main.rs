//! Work whose instructions are counted: `counts CASE` under callgrind, which collects inside of
//! [`counted`] alone. Prints how many times the work was done, and the unknowns of one time.
//!
//! Counts repeat where wall times do not, so a change that makes a step dearer is seen at once.
#![allow(clippy::print_stdout)] // how a program answers

#[path = "../../core/tests/common/mod.rs"]
mod common;

use arcless_core::integrator::wire_model::WireModel;
use arcless_core::lcp::LcpSolver;
use arcless_core::linalg::BlockLdl;
use arcless_core::scheme::Scheme;
use arcless_core::session::{Collector, Session, SessionStart};
use arcless_core::structure::Structure;
use common::chain::lumped;
use common::space::staggered;
use std::hint::black_box;
use std::sync::Arc;

const SPANS: usize = 20;
const H: f64 = 1e-3;
const SPEED: f64 = 320.0 / 3.6;
const START: f64 = 6.0 * common::SPAN;
/// Steps before the counted ones: waves run along the line by then, links have gone slack.
const WARM: usize = 600;
/// About a span.
const STEPS: usize = 600;
const SOLUTIONS: usize = 200;

/// Everything between entering and leaving this function is counted.
#[inline(never)]
fn counted(work: &mut dyn FnMut()) {
    work();
}

fn main() {
    let case = std::env::args().nth(1);
    let done = match case.as_deref() {
        Some("step-planar") => steps(pantographs(&planar())),
        Some("step-spatial") => steps(pantographs(&spatial())),
        Some("step-explicit-planar") => steps(pantographs(&explicit::<2, 2>())),
        Some("step-explicit-spatial") => steps(pantographs(&explicit::<3, 3>())),
        Some("step-forces-given") => steps(forces(&planar())),
        Some("solve-planar") => solutions(&planar()),
        Some("solve-spatial") => solutions(&spatial()),
        Some("lcp-1") => problems(1),
        Some("lcp-8") => problems(8),
        _ => return,
    };
    println!("{} {}", done[0], done[1]);
}

fn scheme() -> Scheme {
    Scheme::generalised_alpha(0.9)
}

fn planar() -> Arc<WireModel<2, 4>> {
    Arc::new(common::prepared(SPANS, scheme(), H, 50e3))
}

fn spatial() -> Arc<WireModel<3, 6>> {
    let (structure, path) = common::simple_line(SPANS);
    let line = (staggered(&structure, SPANS, 0.2), path);
    Arc::new(common::prepare_any(line, |_| (), scheme(), H, 50e3))
}

/// A chain and its lane; in space with stagger.
fn chain(is_spatial: bool) -> (Structure, Vec<Vec<usize>>) {
    let (mut structure, path) = common::simple_line_of(SPANS, [0.45; 2]);
    if is_spatial {
        structure = staggered(&structure, SPANS, 0.2);
    }
    (lumped(&structure), vec![path])
}

fn explicit<const DIM: usize, const D: usize>() -> Arc<WireModel<DIM, D>> {
    let steps = common::chain::explicit(&chain(DIM == 3), H, 50e3);
    Arc::new(steps.expect("short steps"))
}

fn begin() -> SessionStart {
    SessionStart {
        position: START,
        speed: SPEED,
        friction: 0.0,
    }
}

fn pantographs<const DIM: usize, const D: usize>(p: &Arc<WireModel<DIM, D>>) -> Session<DIM, D> {
    let pantograph = common::three_masses(170.0);
    Session::with_pantographs(p.clone(), vec![pantograph], vec![0.0], begin()).expect("it stands")
}

fn forces<const DIM: usize, const D: usize>(p: &Arc<WireModel<DIM, D>>) -> Session<DIM, D> {
    let collector = Collector {
        behind: 0.0,
        half_width: f64::INFINITY,
    };
    Session::with_forces(p.clone(), vec![collector], &[170.0], begin()).expect("it stands")
}

fn steps<const DIM: usize, const D: usize>(mut live: Session<DIM, D>) -> [usize; 2] {
    // A pantograph without actuator takes no force; a force that is given swings about its mean.
    let size = if live.outputs().contacts.is_empty() {
        1.0
    } else {
        0.0
    };
    let mut take = |step: usize| {
        let force = size * (170.0 + 80.0 * (0.04 * step as f64).sin());
        let position = START + SPEED * H * (step + 1) as f64;
        live.step(&[force], position, SPEED).expect("a step");
    };
    (0..WARM).for_each(&mut take);
    counted(&mut || (WARM..WARM + STEPS).for_each(&mut take));
    [STEPS, D * live.nodes()]
}

fn solutions<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) -> [usize; 2] {
    let c = &p.coefficients;
    let factor = BlockLdl::new(&p.line.combine(c.mass, c.damping, c.stiffness)).expect("regular");
    let mut x = vec![[1.0; D]; p.line.nodes()];
    let mut work = x.clone();
    counted(&mut || (0..SOLUTIONS).for_each(|_| factor.solve(black_box(&mut x), &mut work)));
    [SOLUTIONS, D * x.len()]
}

/// Complementarity problem like that of a step: a closed contact, and slack links whose weak
/// coupling to it is skew-symmetric.
fn problems(n: usize) -> [usize; 2] {
    let entry = |i: usize, j: usize| match (i, j) {
        _ if i == j => 1.0 + 0.1 * i as f64,
        (0, _) => -0.2,
        (_, 0) => 0.2,
        _ => -0.1,
    };
    let h: Vec<f64> = (0..n * n).map(|k| entry(k / n, k % n)).collect();
    let w: Vec<f64> = (0..n)
        .map(|i| if i % 3 == 2 { 0.4 } else { -1.0 })
        .collect();
    let (mut x, mut y, warm) = (vec![0.0; n], vec![0.0; n], vec![true; n]);
    let mut solver = LcpSolver::new();
    let mut solve = || {
        let done = solver.solve(black_box(&h), &w, &mut x, &mut y, &warm);
        done.expect("a P-matrix");
    };
    solve();
    counted(&mut || (0..SOLUTIONS).for_each(|_| solve()));
    [SOLUTIONS, n]
}
