//! Lines of any kind and sessions made of plain data; nodes that are watched.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::line::{AnyLine, AnyWireModel, Stepping};
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::Scheme;
use arcless_core::session::{AnySession, Collector, Drive, Prepared, SessionStart};
use arcless_core::simulation::recording::record::RecordPlan;
use arcless_core::structure::Structure;
use common::chain::{lumped, yielding};
use common::space::staggered;
use common::{SPAN, everything, peak, simple_line, steady, three_masses};

const H: f64 = 1e-3;
const SPEED: f64 = 80.0;
const START: f64 = 1.3 * SPAN;
const FORCE: f64 = 250.0;

fn position(step: usize) -> f64 {
    START + SPEED * H * step as f64
}

fn start() -> SessionStart {
    SessionStart {
        position: START,
        speed: SPEED,
        friction: 0.1,
    }
}

fn stepping(explicit: bool) -> Stepping {
    Stepping {
        scheme: if explicit {
            Scheme::newmark(0.25, 0.5)
        } else {
            Scheme::generalised_alpha(0.9)
        },
        step: H,
        contact_stiffness: 50e3,
        explicit,
        updated: false,
        period_correction: !explicit,
    }
}

/// Structures of the four kinds of line, each with its lane and its steps.
fn kinds() -> Vec<(Structure, Vec<usize>, Stepping)> {
    let (planar, path) = simple_line(5);
    let spatial = staggered(&planar, 5, 0.2);
    let chains = [&planar, &spatial].map(|s| yielding(&lumped(s)));
    let [chain, chain_in_space] = chains;
    vec![
        (planar, path.clone(), stepping(false)),
        (spatial, path.clone(), stepping(false)),
        (chain, path.clone(), stepping(true)),
        (chain_in_space, path, stepping(true)),
    ]
}

fn drives() -> [Drive; 3] {
    let collectors = [0.0, 31.0].map(|behind| Collector {
        behind,
        half_width: 0.6,
    });
    let strip = Strip {
        half_width: 0.8,
        ..Strip::plain(vec![1.0])
    };
    let outside = Pantograph::external(vec![strip], 1, FORCE);
    [
        Drive::Forces {
            collectors: collectors.into(),
            forces: vec![FORCE; 2],
        },
        Drive::Pantographs {
            pantographs: vec![three_masses(FORCE); 2],
            distances: vec![0.0, 31.0],
        },
        Drive::Strips {
            pantographs: vec![outside; 2],
            distances: vec![0.0, 31.0],
        },
    ]
}

/// Outputs of some steps of a session, whichever its kind.
fn steps(session: &mut AnySession) -> Vec<f64> {
    let mut seen = Vec::new();
    for step in 0..60 {
        let next = position(step + 1);
        let rise = 0.01 * (0.1 * step as f64).sin();
        let done = match session.inputs() {
            0 => session.step_strips(&[rise, 0.0], &[1e-4; 2], next, SPEED),
            count => {
                let is_given = session.outputs().contacts.is_empty();
                let forces = vec![if is_given { FORCE } else { 0.0 }; count];
                session.step(&forces, next, SPEED)
            }
        };
        done.expect("a step");
        let outputs = session.outputs();
        seen.extend_from_slice(&outputs.force);
        seen.extend_from_slice(&outputs.height);
        seen.extend_from_slice(&outputs.uplift);
    }
    seen
}

/// A session made of its data, and of a copy of them, takes the steps of one on the line itself.
#[test]
fn a_session_made_of_plain_data_takes_the_same_steps() {
    for (structure, path, with) in kinds() {
        let line = AnyLine::new(structure, true, !with.explicit, None).expect("it stands");
        let lanes = vec![path];
        let model = line.prepare(&lanes, &with).expect("it can be stepped");
        let watched = line.structure().links.iter().map(|link| link.nodes[1]);
        let watched: Vec<usize> = watched.skip(8).step_by(5).collect();
        for drive in drives() {
            let begun = match drive.clone() {
                Drive::Forces { collectors, forces } => {
                    AnySession::with_forces(&model, collectors, &forces, start())
                }
                Drive::Pantographs {
                    pantographs,
                    distances,
                } => AnySession::with_pantographs(&model, pantographs, distances, start()),
                Drive::Strips {
                    pantographs,
                    distances,
                } => AnySession::with_strips(&model, pantographs, distances, start()),
            };
            let mut session = begun.expect("it stands");
            session.watch(&watched).expect("nodes of the line");
            let data = Prepared::new(&line, lanes.clone(), with, drive, start(), watched.clone());
            let expected = steps(&mut session);
            assert!(expected.iter().all(|v| v.is_finite()));
            let mut again = data.session().expect("it stands again");
            assert_eq!(steps(&mut again), expected);
        }
    }
}

#[test]
fn data_that_do_not_fit_are_refused() {
    let (structure, path, with) = kinds().swap_remove(2);
    let line = AnyLine::new(structure, true, false, None).expect("it stands");
    let [drive, ..] = drives();
    let data = Prepared::new(&line, vec![path], with, drive, start(), Vec::new());
    let array = |data: &Prepared| match data.session() {
        Err(CoreError::Input { array, .. }) => array,
        other => panic!("{other:?}"),
    };
    let mut short = data.clone();
    short.shape.pop();
    assert_eq!(array(&short), "shape");
    let mut endless = data.clone();
    endless.shape[3] = f64::INFINITY;
    assert_eq!(array(&endless), "shape");
    let mut watched = data.clone();
    watched.watched = vec![usize::MAX];
    assert_eq!(array(&watched), "nodes");
    let mut session = data.session().expect("it stands");
    steps(&mut session);
    let late = session.watch(&[1]);
    assert!(matches!(late, Err(CoreError::Input { array: "nodes", .. })));
    let state = session.save().expect("a state");
    let mut watching = Prepared {
        watched: vec![1],
        ..data
    }
    .session()
    .expect("it stands");
    assert!(
        watching.restore(&state).is_err(),
        "of a loop that watches other nodes"
    );
}

/// The uplift of watched nodes is the one that a run records, where its balance is at the end of
/// the step.
#[test]
fn the_uplift_of_watched_nodes_is_that_of_a_run() {
    const STEPS: usize = 600;
    for (structure, path, with) in kinds().into_iter().step_by(2) {
        let with = Stepping {
            scheme: Scheme::newmark(0.25, 0.5),
            period_correction: false,
            ..with
        };
        let line = AnyLine::new(structure, true, true, None).expect("it stands");
        let model = line.prepare(&[path], &with).expect("it can be stepped");
        let nodes: Vec<usize> = line.structure().springs.iter().map(|s| s.node).collect();
        let plan = RecordPlan {
            nodes: nodes.clone(),
            ..everything()
        };
        let way = steady(START, SPEED, H, STEPS);
        let pantographs = vec![three_masses(FORCE)];
        let record = arcless_core::each_kind!(&model, AnyWireModel, p => {
            common::run(p, &pantographs, &way, &plan)
        });
        let without_friction = SessionStart {
            friction: 0.0,
            ..start()
        };
        let session =
            AnySession::with_pantographs(&model, pantographs, vec![0.0], without_friction);
        let mut session = session.expect("it stands");
        session.watch(&nodes).expect("nodes of the line");
        for step in 0..STEPS {
            session
                .step(&[0.0], position(step + 1), SPEED)
                .expect("a step");
            let recorded = &record.uplift[step * nodes.len()..][..nodes.len()];
            for (found, expected) in session.outputs().uplift.iter().zip(recorded) {
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{found} {expected} in step {step}"
                );
            }
        }
        assert!(peak(&record.uplift) > 0.01, "supports rise");
    }
}
