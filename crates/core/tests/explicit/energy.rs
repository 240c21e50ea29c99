//! The energy ledger of explicit steps: it closes to rounding, whatever opens, slackens or slides, and notices what is off.

use super::{Chain, explicit};
use crate::common::chain::lumped;
use crate::common::space::staggered;
use crate::common::{everything, run, simple_line_of, three_masses, travel};
use arcless_core::dynamics::ledger::Entries;
use arcless_core::dynamics::record::{Record, RecordPlan};

const SPEED: f64 = 320.0 / 3.6;
const H: f64 = 1e-3;

/// Rounding of thousands of steps, as of steps with a matrix.
const BALANCE: f64 = 1e-11;

/// Six spans, a dropper that is slack at rest.
fn chain(dim: usize) -> Chain {
    let (mut structure, path) = simple_line_of(6, [0.45, 0.6]);
    structure.links[22].rest_length += 0.015;
    if dim == 3 {
        structure = staggered(&structure, 6, 0.2);
    }
    (lumped(&structure), vec![path])
}

/// Two pantographs 50 m apart; the second is so light that it loses contact.
fn hard<const DIM: usize, const D: usize>(h: f64, plan: &RecordPlan) -> Record {
    let p = explicit::<DIM, D>(&chain(DIM), h);
    let mut way = travel(110.0, 270.0, SPEED, h);
    way.distances = vec![0.0, 50.0];
    way.friction = 0.2;
    run(&p, &[three_masses(200.0), three_masses(60.0)], &way, plan)
}

fn last(r: &Record) -> Entries {
    let known = r.energy.iter().filter(|e| !e.kinetic.is_nan());
    *known.last().expect("energies are recorded")
}

#[test]
fn balances_with_slack_links_lift_off_friction_and_two_riders() {
    for r in [
        hard::<2, 2>(H, &everything()),
        hard::<3, 3>(H, &everything()),
    ] {
        let relative = r.energy_residual / r.energy_turnover;
        println!("{relative:e} {} {:?}", r.slack_max, last(&r));
        assert!(r.slack_max > 2, "droppers go slack");
        assert!(r.gap.iter().any(|g| *g > 0.0), "contact is lost");
        assert!(relative < BALANCE, "{relative:e}");
    }
}

#[test]
fn measured_steps_close_as_all_steps_do() {
    let all = hard::<2, 2>(H, &everything());
    let some = RecordPlan {
        ledger_every: 50,
        ..everything()
    };
    let some = hard::<2, 2>(H, &some);
    println!(
        "{:e} {:?}",
        some.energy_residual / some.energy_turnover,
        last(&some)
    );
    assert_eq!(all.force, some.force);
    assert!(some.energy_residual < 1e-10 * some.energy_turnover);
}
