//! Kernels of a time step on the planar 55 m line of 20 spans, and a warm step with and without
//! the energy ledger. Wall times are for comparison within one run only.

#[path = "../tests/common/mod.rs"]
mod common;

use arcless_core::dynamics::record::RecordPlan;
use arcless_core::dynamics::run::Travel;
use arcless_core::dynamics::stepper::Prepared;
use arcless_core::linalg::BlockLdl;
use arcless_core::scheme::Scheme;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn line() -> Prepared<2, 4> {
    common::prepared(20, Scheme::generalised_alpha(0.9), 1e-3, 50e3)
}

fn vector(n: usize) -> Vec<[f64; 4]> {
    (0..n).map(|i| [0.1, 0.2, -0.3, (i % 7) as f64]).collect()
}

#[divan::bench]
fn factorisation(bencher: Bencher) {
    let p = line();
    let c = &p.coefficients;
    let a = p.line.combine(c.mass, c.damping, c.stiffness);
    bencher.bench(|| BlockLdl::new(black_box(&a)));
}

#[divan::bench]
fn solve(bencher: Bencher) {
    let p = line();
    let c = &p.coefficients;
    let factor = BlockLdl::new(&p.line.combine(c.mass, c.damping, c.stiffness)).expect("regular");
    let b = vector(p.line.nodes());
    let (mut x, mut work) = (b.clone(), b.clone());
    bencher.bench_local(|| {
        x.copy_from_slice(&b);
        factor.solve(black_box(&mut x), &mut work);
    });
}

#[divan::bench]
fn mass_product(bencher: Bencher) {
    let p = line();
    let x = vector(p.line.nodes());
    let mut y = x.clone();
    bencher.bench_local(|| p.line.mass.product(black_box(&x), &mut y));
}

#[divan::bench]
fn advance(bencher: Bencher) {
    let p = line();
    let mut state = p.at_rest(vector(p.line.nodes()));
    bencher.bench_local(|| p.advance(black_box(&mut state)));
}

#[divan::bench]
fn stiffness_form(bencher: Bencher) {
    let p = line();
    let x = vector(p.line.nodes());
    bencher.bench_local(|| p.line.stiffness.quadratic(black_box(&x)));
}

/// 2000 steps in one go; divide by 2000.
#[divan::bench(args = [false, true], sample_count = 10)]
fn two_thousand_steps(bencher: Bencher, ledger: bool) {
    let p = line();
    let speed = 320.0 / 3.6;
    let travel = Travel {
        positions: (0..=2000)
            .map(|i| 300.0 + speed * 1e-3 * f64::from(i))
            .collect(),
        speeds: vec![speed; 2001],
        distances: vec![0.0],
        friction: 0.0,
        loads: Vec::new(),
    };
    let plan = RecordPlan {
        contact_every: 1,
        line_every: 5,
        links: true,
        nodes: Vec::new(),
        points: Vec::new(),
        ledger,
    };
    let riders = [common::three_masses(170.0)];
    bencher.bench_local(|| p.run(&riders, black_box(&travel), &plan, &mut |_| true));
}
