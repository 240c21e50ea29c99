//! Energy ledger of explicit steps: it closes to rounding with lift-off, slack links and friction,
//! and a wrong entry is noticed.

use super::islands::two_lengths;
use super::{Chain, explicit};
use crate::tests::common::chain::lumped;
use crate::tests::common::space::staggered;
use crate::tests::common::{everything, oblique, run, simple_line_of, three_masses, travel};
use crate::tests::islands::{near, way};
use crate::tests::resume::{compare, part};
use arcless_core::CoreError;
use arcless_core::energy_terms::EnergyTerms;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::loads::Load;
use arcless_core::simulation::recording::record::{Record, RecordPlan};
use arcless_core::simulation::run::Part;

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

fn explicit_rigid(chain: &Chain) -> WireModel<2, 2> {
    crate::tests::common::chain::explicit(chain, H, f64::INFINITY).expect("short steps")
}

fn last(r: &Record) -> EnergyTerms {
    let mut known = r.energy.iter().filter(|e| !e.kinetic.is_nan());
    *known.next_back().expect("energies are recorded")
}

#[test]
fn balances_with_slack_links_lift_off_friction_and_two_pantographs() {
    for r in [
        hard::<2, 2>(H, &everything()),
        hard::<3, 3>(H, &everything()),
    ] {
        let relative = r.energy_residual / r.energy_turnover;
        assert!(r.slack_max > 2, "droppers go slack");
        assert!(r.gap.iter().any(|g| *g > 0.0), "contact is lost");
        assert!(relative < BALANCE, "{relative:e}");
    }
}

#[test]
fn balances_with_dampers_that_have_no_stiffness() {
    let (mut structure, path) = simple_line_of(6, [0.45, 0.6]);
    let plain = (lumped(&structure), vec![path.clone()]);
    for span in 0..6 {
        let damper = oblique(&structure, 9 * span + 4, 0.0, 500.0);
        structure.links.push(damper);
    }
    let damped = (lumped(&structure), vec![path]);
    let dissipated = [damped, plain].map(|chain| {
        let p = explicit::<2, 2>(&chain, H);
        let way = travel(110.0, 270.0, SPEED, H);
        let r = run(&p, &[three_masses(200.0)], &way, &everything());
        assert!(r.slack_max > 0, "droppers go slack");
        assert!(r.energy_residual < BALANCE * r.energy_turnover);
        last(&r).dissipated_links
    });
    let [damped, plain] = dissipated;
    assert!(damped > 1.3 * plain, "{damped} J, {plain} J");
}

#[test]
fn measured_steps_close_as_all_steps_do() {
    let all = hard::<3, 3>(H, &everything());
    let some = RecordPlan {
        ledger_every: 50,
        ..everything()
    };
    let some = hard::<3, 3>(H, &some);
    assert_eq!(all.force, some.force);
    // Rounding of a step, which stands for fifty.
    assert!(some.energy_residual < 50.0 * BALANCE * some.energy_turnover);
    let (known, rest): (Vec<_>, Vec<_>) = some
        .energy
        .iter()
        .enumerate()
        .partition(|(_, e)| !e.kinetic.is_nan());
    assert!(known.iter().all(|(k, _)| k % 50 == 0) && rest.iter().all(|(k, _)| k % 50 > 0));
    for (k, e) in known {
        // Dissipation of wires between measured steps is the remainder of the balance: rounding of
        // both.
        let apart = e.dissipated_line + e.dissipated_scheme
            - all.energy[k].dissipated_line
            - all.energy[k].dissipated_scheme;
        assert!(
            apart.abs() < BALANCE * all.energy_turnover,
            "step {k}: {apart:e}"
        );
        assert_eq!(e.work_traction, all.energy[k].work_traction);
        assert_eq!(e.kinetic, all.energy[k].kinetic);
    }
}

/// Rigid contacts store nothing; the balance closes all the same.
#[test]
fn balances_with_rigid_contact() {
    let (structure, lanes) = chain(2);
    let p = explicit_rigid(&(structure, lanes));
    let way = travel(110.0, 200.0, SPEED, H);
    let r = run(&p, &[three_masses(120.0)], &way, &everything());
    assert!(r.energy_residual < BALANCE * r.energy_turnover);
}

/// Partner of the balance: with any entry left out, or one per cent wrong, it does not close.
#[test]
fn every_entry_is_needed_for_the_balance() {
    let r = hard::<2, 2>(H, &everything());
    let e = last(&r);
    for (name, value) in [
        ("kinetic", e.kinetic),
        ("elastic", e.elastic),
        ("contact", e.contact),
        ("pantographs", e.pantographs),
        ("dissipated_line", e.dissipated_line),
        ("dissipated_links", e.dissipated_links),
        ("dissipated_springs", e.dissipated_springs),
        ("dissipated_pantographs", e.dissipated_pantographs),
        ("switching", e.switching),
        ("work_uplift", e.work_uplift),
        ("work_traction", e.work_traction),
        ("work_friction", e.work_friction),
    ] {
        let fault = (0.01 * value).abs() / r.energy_turnover;
        // The smallest entries are 2e-5 of the turnover; a hundredth of that is far above rounding.
        assert!(fault > 1e4 * BALANCE, "{name}: {fault:e} could hide");
    }
}

/// The energy of a length laid to rest leaves with it, and later balances close without it; a run
/// in parts equals the whole run.
#[test]
fn a_length_laid_to_rest_leaves_the_ledger() {
    let p = two_lengths();
    let pantographs = [three_masses(90.0)];
    for ledger_every in [1, 50] {
        let plan = RecordPlan {
            nodes: vec![3, 11, p.line.nodes() - 5],
            near: Some(near(&p)),
            ledger_every,
            ..everything()
        };
        let way = way(2300);
        let (r, _) = part(&p, &pantographs, (&way, &plan), Part::default()).expect("a run");
        assert!(
            last(&r).dissipated_scheme > 0.01,
            "something is laid to rest"
        );
        assert!(r.energy_residual < 50.0 * BALANCE * r.energy_turnover);
        compare(&p, &pantographs, (&way, &plan), &[300, 800, 2100]);
    }
}

/// A force beyond all bounds on a node that no contact, link or record reads.
#[test]
fn what_is_not_finite_is_noticed_in_its_step() {
    let p = explicit::<2, 2>(&chain(2), H);
    let mut way = travel(60.0, 100.0, SPEED, H);
    let far = p
        .line
        .shape
        .iter()
        .position(|r| r[0] > 250.3)
        .expect("a node far away");
    let mut sizes = vec![0.0; way.positions.len()];
    sizes[101] = f64::MAX;
    way.loads = vec![Load {
        pattern: vec![(far, 1, 1.0); 2],
        sizes,
    }];
    for ledger in [false, true] {
        let plan = RecordPlan {
            nodes: vec![3],
            ledger,
            ledger_every: 1000,
            ..everything()
        };
        let failed = p.run(&[three_masses(120.0)], &way, &plan, &mut |_| true);
        // The force acts in step 100; waves of it are beyond all numbers in the next one or two.
        match failed {
            Err(CoreError::NotFinite { step, .. }) => assert!((100..104).contains(&step), "{step}"),
            other => panic!("{:?}", other.map(|r| r.steps)),
        }
    }
}
