//! Kernels of a time step on the 55 m line of 20 spans, planar and staggered in space. Wall times
//! are for comparison within one run only; whole steps are timed by `benchmarks/`.

#[path = "../tests/common/mod.rs"]
mod common;

use arcless_core::constraint::columns::ComplianceColumns;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::lcp::LcpSolver;
use arcless_core::linalg::BlockLdl;
use arcless_core::scheme::Scheme;
use common::{prepare_any, simple_line, simple_line_of, space};
use divan::{Bencher, black_box};

const SPANS: usize = 20;
const STEP: f64 = 1e-3;

fn main() {
    divan::main();
}

fn scheme() -> Scheme {
    Scheme::generalised_alpha(0.9)
}

fn planar_line() -> WireModel<2, 4> {
    prepare_any(simple_line(SPANS), |_| (), scheme(), STEP, 50e3)
}

/// With the elements of the shipped line in space, half as long.
fn spatial_line() -> WireModel<3, 6> {
    let (structure, path) = simple_line_of(SPANS, [0.72, 1.45]);
    let staggered = space::staggered(&structure, SPANS, 0.2);
    prepare_any((staggered, path), |_| (), scheme(), STEP, 50e3)
}

fn factor<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) -> BlockLdl<D> {
    let c = &p.coefficients;
    BlockLdl::new(&p.line.combine(c.mass, c.damping, c.stiffness)).expect("regular")
}

fn vector<const D: usize>(n: usize) -> Vec<[f64; D]> {
    (0..n)
        .map(|i| std::array::from_fn(|c| 0.1 * (c + i % 7) as f64))
        .collect()
}

fn factorises<const DIM: usize, const D: usize>(bencher: Bencher, p: &WireModel<DIM, D>) {
    let c = &p.coefficients;
    let a = p.line.combine(c.mass, c.damping, c.stiffness);
    bencher.bench(|| BlockLdl::new(black_box(&a)));
}

fn solves<const DIM: usize, const D: usize>(bencher: Bencher, p: &WireModel<DIM, D>) {
    let (factor, b) = (factor(p), vector(p.line.nodes()));
    let (mut x, mut work) = (b.clone(), b.clone());
    bencher.bench_local(|| {
        x.copy_from_slice(&b);
        factor.solve(black_box(&mut x), &mut work);
    });
}

/// Solve for a unit force on the wire in the middle of the line and keep what is not negligible.
fn finds_column<const DIM: usize, const D: usize>(bencher: Bencher, p: &WireModel<DIM, D>) {
    let factor = factor(p);
    let node = p.slidelines[0].nodes[p.slidelines[0].nodes.len() / 2];
    let mut force = [0.0; D];
    force[DIM - 1] = 1.0;
    let [mut x, mut work] = [0, 1].map(|_| vec![[0.0; D]; p.line.nodes()]);
    bencher.bench_local(|| {
        let mut columns = ComplianceColumns::new(1);
        columns.set(0, &factor, &[(node, force)], [&mut x, &mut work]);
        columns
    });
}

fn multiplies_mass<const DIM: usize, const D: usize>(bencher: Bencher, p: &WireModel<DIM, D>) {
    let x = vector(p.line.nodes());
    let mut y = x.clone();
    bencher.bench_local(|| p.line.mass.product(black_box(&x), &mut y));
}

fn advances<const DIM: usize, const D: usize>(bencher: Bencher, p: &WireModel<DIM, D>) {
    let mut state = p.at_rest(vector(p.line.nodes()));
    bencher.bench_local(|| p.commit(black_box(&mut state)));
}

macro_rules! kernels {
    ($space:ident, $line:ident) => {
        mod $space {
            use super::*;

            #[divan::bench]
            fn factorisation(bencher: Bencher) {
                factorises(bencher, &$line());
            }

            #[divan::bench]
            fn solve(bencher: Bencher) {
                solves(bencher, &$line());
            }

            #[divan::bench]
            fn contact_column(bencher: Bencher) {
                finds_column(bencher, &$line());
            }

            #[divan::bench]
            fn mass_product(bencher: Bencher) {
                multiplies_mass(bencher, &$line());
            }

            #[divan::bench]
            fn new_state(bencher: Bencher) {
                advances(bencher, &$line());
            }
        }
    };
}

kernels!(planar, planar_line);
kernels!(spatial, spatial_line);

/// A closed contact and some droppers that would push, from the solution of the step before; the
/// numbers are of the size they have on the planar line.
#[divan::bench(args = [0, 2, 5])]
fn lcp_warm(bencher: Bencher, droppers: usize) {
    let n = droppers + 1;
    let (mut h, mut w) = (vec![0.0; n * n], vec![-1e-3; n]);
    for i in 0..n {
        for j in 0..n {
            h[i * n + j] = match (i, j) {
                (0, 0) => 4e-5,
                (0, _) => -1e-6 / j as f64,
                (_, 0) => 1e-6 / i as f64,
                _ if i == j => 4e-6,
                _ => -2e-7 / i.abs_diff(j) as f64,
            };
        }
    }
    w[0] = -7e-3;
    let (mut x, mut y, warm) = (vec![0.0; n], vec![0.0; n], vec![true; n]);
    let mut solver = LcpSolver::new();
    bencher.bench_local(|| solver.solve(black_box(&h), &w, &mut x, &mut y, &warm));
}
