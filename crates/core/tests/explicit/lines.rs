//! Pantograph under a line with links: its forces approach those of implicit steps of the same
//! chain and curves as elements shrink.

use super::{Chain, every, explicit, fitted, pass, plan, way};
use crate::tests::common::chain::lumped;
use crate::tests::common::simple_line_of;
use crate::tests::common::space::staggered;
use arcless_core::simulation::recording::record::Record;
use arcless_core::structure::{Spring, SpringMode};

fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0), |(s, n), v| (s + v * v, n + 1));
    (sum / f64::from(count)).sqrt()
}

/// Root mean square of the difference of contact forces, for that of their fluctuation.
fn apart<const DIM: usize, const D: usize>(chain: &Chain, h: f64) -> (f64, [Record; 2]) {
    let (speed, seconds, force) = (60.0, 1.6, 250.0);
    let ours = explicit::<DIM, D>(chain, h);
    let ours = pass(
        &ours,
        force,
        &way(60.0, speed, h, seconds),
        &plan(Vec::new()),
    );
    let fine = fitted::<DIM, D>(chain, 0.25 * h);
    let fine = pass(
        &fine,
        force,
        &way(60.0, speed, 0.25 * h, seconds),
        &plan(Vec::new()),
    );
    let theirs = every(4, &fine.force);
    let mean = theirs.iter().sum::<f64>() / theirs.len() as f64;
    let differences = ours.force.iter().zip(&theirs).map(|(a, b)| a - b);
    let found = rms(differences) / rms(theirs.iter().map(|f| f - mean));
    (found, [ours, fine])
}

/// Check of the order: the implicit chain delays waves by (kℓ)²/24, the explicit one does not;
/// points and curves are the same in both. Second order is a factor 0.25 once waves are long for
/// all elements; the partner, a lasting difference, gives 1.
fn shrinks(errors: &[f64]) {
    assert!(errors.windows(2).all(|e| e[1] < 0.5 * e[0]), "{errors:?}");
}

#[test]
fn a_moving_pantograph_feels_the_line_of_implicit_steps() {
    let errors = [1.0, 0.5, 0.25].map(|longest| {
        let (structure, path) = simple_line_of(4, [longest; 2]);
        let chain = (lumped(&structure), vec![path]);
        let (found, [ours, fine]) = apart::<2, 2>(&chain, 2e-3 * longest);
        let slack = [ours.slack_max, fine.slack_max];
        // One of the links may fall short of slack in one of them.
        assert!(slack[0] > 1 && slack[0].abs_diff(slack[1]) < 2, "{slack:?}");
        found
    });
    shrinks(&errors);
    // Estimate: waves of 2 m, kℓ = 0.8, are late by (kℓ)²/24 = 3 %, longer ones by less.
    assert!(errors[2] < 0.05, "{errors:?}");
}

#[test]
fn so_it_does_in_space() {
    let errors = [1.0, 0.5].map(|longest| {
        let (structure, path) = simple_line_of(4, [longest; 2]);
        let chain = (lumped(&staggered(&structure, 4, 0.2)), vec![path]);
        apart::<3, 3>(&chain, 2e-3 * longest).0
    });
    shrinks(&errors);
}

/// Springs along the track at the supports: the wire moves along the track between them, not at
/// them.
#[test]
fn springs_along_the_wire_act_where_they_are() {
    let found = [1.0, 1e6].map(|stiffness| {
        let (mut structure, path) = simple_line_of(4, [0.5; 2]);
        let held = structure
            .springs
            .iter()
            .filter(|s| s.mode == SpringMode::Held);
        let along = held.map(|spring| Spring {
            component: 0,
            stiffness,
            viscosity: 0.0,
            mode: SpringMode::Unloaded,
            ..*spring
        });
        let along: Vec<Spring> = along.collect();
        assert!(along.len() > 2);
        structure.springs.extend(along);
        apart::<2, 2>(&(lumped(&structure), vec![path]), 1e-3).0
    });
    // Springs at masters of their own leave the error as it is without springs; spread over two
    // masters, they make it several times as large.
    assert!(found[1] < 1.2 * found[0], "{found:?}");
}
