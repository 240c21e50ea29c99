//! Parts of a run one after the other are the whole run, bit for bit.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::checkpoint::Checkpoint;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::loads::Load;
use arcless_core::linear::model::LinearModel;
use arcless_core::pantograph::actuator::{Actuator, Sample};
use arcless_core::pantograph::breakpoint::ForceKind;
use arcless_core::pantograph::bump_stop::BumpStop;
use arcless_core::pantograph::excitation::{BaseMotion, ForceHistory};
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::piecewise_force::PiecewiseForce;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::{Record, RecordPlan};
use arcless_core::simulation::run::Part;
use arcless_core::slideline::Slideline;
use common::chain::{lumped, settled};
use common::lanes::{At, STRING, lined, strings};
use common::{everything, simple_line, three_masses};

type Answer<'a> = &'a mut dyn FnMut(usize, &Sample) -> Result<f64, String>;

pub fn part<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    pantographs: &[Pantograph],
    (travel, plan): (&Trajectory, &RecordPlan),
    part: Part<'_>,
) -> Result<(Record, Checkpoint), CoreError> {
    let ask: Answer<'_> = &mut |_, s| Ok(0.3 * (70.0 - s.force) + s.number as f64);
    p.run_part(pantographs, travel, plan, part, &mut |_| true, ask)
}

/// All numbers of a record, as bits.
pub fn bits(r: &Record) -> Vec<Vec<u64>> {
    let mut series: Vec<Vec<f64>> = [
        &r.time,
        &r.force,
        &r.gap,
        &r.height,
        &r.lateral,
        &r.position,
        &r.speed,
        &r.control,
        &r.masses,
        &r.line_time,
        &r.link_force,
        &r.uplift,
        &r.link_first,
        &r.uplift_first,
        &r.point_uplift,
        &r.point_along,
        &r.slack,
    ]
    .map(Clone::clone)
    .to_vec();
    let energies = r.energy.iter().map(|e| e.residual() + 3.0 * e.turnover());
    series.push(energies.collect());
    let bits = |v: &f64| v.to_bits();
    series
        .iter()
        .map(|s| s.iter().map(bits).collect())
        .collect()
}

/// Extremes and counts of a record.
pub fn sums(r: &Record) -> Vec<Vec<u64>> {
    let extremes = [
        &r.link_min,
        &r.link_max,
        &r.uplift_max,
        &r.stop_max,
        &r.law_ranges,
    ];
    let last = [r.lcp_residual, r.energy_residual, r.energy_turnover].to_vec();
    let counts = [r.slack_max, r.pivots, r.pivots_max, r.fallbacks, r.steps];
    let numbers = extremes.into_iter().chain(std::iter::once(&last));
    let numbers = numbers.map(|v| v.iter().map(|v| v.to_bits()).collect());
    let whole = counts.iter().chain(&r.pivot_counts).map(|&n| n as u64);
    numbers.chain(std::iter::once(whole.collect())).collect()
}

/// Compare a whole run with parts of it that end at the given steps; the states meanwhile pass
/// through their numbers alone.
pub fn compare<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    pantographs: &[Pantograph],
    way: (&Trajectory, &RecordPlan),
    stops: &[usize],
) -> Checkpoint {
    let (whole, end) = part(p, pantographs, way, Part::default()).expect("the whole run");
    assert!(whole.force.iter().any(|f| *f > 0.0), "it touches");
    let mut from: Option<Checkpoint> = None;
    let mut joined: Vec<Vec<u64>> = Vec::new();
    let ends = stops.iter().map(|&s| Some(s)).chain([None]);
    for until in ends {
        let this = Part {
            from: from.as_ref(),
            until,
        };
        let (record, state) = part(p, pantographs, way, this).expect("a part");
        let new = bits(&record);
        joined.resize(new.len(), Vec::new());
        joined
            .iter_mut()
            .zip(new)
            .for_each(|(all, new)| all.extend(new));
        if until.is_none() {
            assert_eq!(sums(&record), sums(&whole));
            assert_eq!(state, end);
        }
        from = Some(state);
    }
    for (channel, (joined, whole)) in joined.iter().zip(bits(&whole)).enumerate() {
        assert!(*joined == whole, "channel {channel}");
    }
    end
}

/// Pantograph with every part that has a memory: stops, tables, an actuator with a long delay,
/// moving ground, prescribed force.
fn full(instants: usize) -> Pantograph {
    let mut pantograph = three_masses(70.0);
    let wave = |amplitude: f64, rate: f64| -> Vec<f64> {
        let at = |i: usize| amplitude * (rate * i as f64).sin();
        (0..instants).map(at).collect()
    };
    let first = vec![1.0, 0.0, 0.0];
    pantograph.excitation.forces.push(ForceHistory {
        direction: first.clone(),
        values: wave(40.0, 0.02),
    });
    pantograph.excitation.base = Some(BaseMotion {
        influence: vec![1.0; 3],
        displacement: wave(2e-3, 0.03),
        rate: wave(6e-2, 0.03),
    });
    pantograph.stops.push(BumpStop {
        direction: vec![0.0, -1.0, 1.0],
        gap: 2e-4,
        stiffness: 1e5,
    });
    pantograph.piecewise_forces.push(PiecewiseForce {
        direction: vec![0.0, -1.0, 1.0],
        kind: ForceKind::Damper,
        points: vec![[-0.5, -60.0], [-0.02, -4.0], [0.02, 1.0], [0.5, 13.0]],
    });
    pantograph.actuator = Some(Actuator {
        direction: first,
        every: 3,
        delay: 17,
    });
    pantograph
}

pub fn way(instants: usize, distances: Vec<f64>) -> Trajectory {
    let step = 0.075;
    Trajectory {
        positions: (0..instants).map(|i| 75.0 + step * i as f64).collect(),
        speeds: vec![75.0; instants],
        distances,
        friction: 0.2,
        loads: Vec::new(),
    }
}

const SCHEMES: [fn() -> Scheme; 3] = [
    || Scheme::generalised_alpha(1.0),
    || Scheme::hht(0.1),
    || Scheme::BackwardDifference,
];

#[test]
fn pantographs_with_all_their_parts_go_on() {
    let instants = 700;
    let mut travel = way(instants, vec![0.0, 12.0]);
    travel.loads.push(Load {
        pattern: vec![(40, 1, 1.0)],
        sizes: (0..instants).map(|i| (0.05 * i as f64).sin()).collect(),
    });
    let mut second = three_masses(120.0);
    second.stops = full(instants).stops;
    let pantographs = [full(instants), second];
    let mut plan = everything();
    (plan.contact_every, plan.line_every) = (2, 7);
    (plan.nodes, plan.points) = (vec![30, 41], vec![90.0]);
    for scheme in SCHEMES {
        for contact in [50e3, f64::INFINITY] {
            let p = common::prepare(simple_line(4), |_| (), scheme(), 1e-3, contact);
            let end = compare(&p, &pantographs, (&travel, &plan), &[1, 2, 250, 333]);
            // Asked for in steps 684 to 696, due in 701 and later: step and force of each.
            assert_eq!(end.numbers["rider_0_waiting"].len(), 10);
            assert!(end.numbers["stop_max"].iter().any(|f| *f > 0.0));
            assert!(end.numbers["slack_pivots_fallbacks"][0] > 0.0);
            assert!(end.numbers["rider_0_law_range"][0] < -0.02);
        }
    }
}

#[test]
fn strips_on_several_lanes_in_space_go_on() {
    // The second wire is reached only later, and lies aside.
    let wires = [
        At::level(0.0, 0.0),
        At {
            x: 10.0,
            across: [0.6, -0.1],
            up: [0.02, -0.01],
        },
    ];
    let p = lined(
        strings(&STRING, &wires),
        Scheme::generalised_alpha(0.9),
        5e4,
    );
    let mut pantograph = three_masses(60.0);
    pantograph.strips = vec![Strip {
        offset: 0.0,
        half_width: 0.4,
        knots: vec![-0.3, 0.0, 0.3],
        vectors: vec![
            vec![0.0, 0.1, 0.9],
            vec![0.0, 0.0, 1.0],
            vec![0.0, 0.1, 0.9],
        ],
    }];
    let mut travel = way(400, vec![0.0]);
    travel.positions.iter_mut().for_each(|x| *x -= 60.0);
    let end = compare(&p, &[pantograph], (&travel, &everything()), &[3, 190, 260]);
    assert_eq!(end.numbers["contact_meets"], [1.0, 1.0]);
}

#[test]
fn updated_kinematics_go_on() {
    let plan = RecordPlan {
        ledger: false,
        ledger_every: 1,
        ..everything()
    };
    let travel = way(60, vec![0.0]);
    let scheme = Scheme::generalised_alpha(0.5);
    let (structure, path) = simple_line(3);
    let (geometry, shape) = settled::<2, 4>(structure.clone());
    let lanes =
        Slideline::from_elements(&geometry, &shape, std::slice::from_ref(&path)).expect("a path");
    let p = WireModel::updated(
        &geometry,
        LinearModel::new(&geometry, shape.clone()),
        lanes,
        scheme,
        1e-3,
        5e4,
    )
    .expect("regular");
    compare(&p, &[three_masses(90.0)], (&travel, &plan), &[20, 21]);
    let chain = lumped(&structure);
    let (geometry, shape) = settled::<2, 2>(chain);
    let lanes = Slideline::from_elements(&geometry, &shape, &[path]).expect("a path");
    let p = WireModel::updated(
        &geometry,
        LinearModel::new(&geometry, shape.clone()),
        lanes,
        scheme,
        1e-3,
        5e4,
    )
    .expect("regular");
    compare(&p, &[three_masses(90.0)], (&travel, &plan), &[20]);
}

#[test]
fn a_state_of_another_run_is_refused() {
    let p = common::prepare(simple_line(3), |_| (), Scheme::hht(0.1), 1e-3, 5e4);
    let (travel, plan, pantographs) = (way(60, vec![0.0]), everything(), [three_masses(90.0)]);
    let stop = Part {
        from: None,
        until: Some(30),
    };
    let (_, good) = part(&p, &pantographs, (&travel, &plan), stop).expect("a part");
    let told = |state: &Checkpoint, plan: &RecordPlan| {
        let from = Part {
            from: Some(state),
            until: None,
        };
        match part(&p, &pantographs, (&travel, plan), from) {
            Err(CoreError::Input { array, reason }) => format!("{array}: {reason}"),
            other => panic!("{other:?}"),
        }
    };
    let names: Vec<String> = good.numbers.keys().cloned().collect();
    assert!(names.len() > 25);
    for name in &names {
        let mut bad = good.clone();
        bad.numbers.remove(name);
        assert_eq!(told(&bad, &plan), format!("state: `{name}` is missing"));
        let mut bad = good.clone();
        bad.numbers.get_mut(name).expect("there").push(f64::NAN);
        assert_eq!(told(&bad, &plan), format!("state: `{name}` is not finite"));
    }
    for (name, value, reason) in [
        ("contact_element", 0.5, "is no count"),
        ("contact_element", -1.0, "is no count"),
        ("contact_meets", 2.0, "is neither 0 nor 1"),
        ("pivot_counts", 0.5, "is no count"),
    ] {
        let mut bad = good.clone();
        bad.numbers.get_mut(name).expect("there")[0] = value;
        assert_eq!(told(&bad, &plan), format!("state: `{name}` {reason}"));
    }
    let mut bad = good.clone();
    bad.numbers.get_mut("contact_element").expect("there")[0] = 1e6;
    assert_eq!(told(&bad, &plan), "state: `contact_element` is no element");
    let mut bad = good.clone();
    bad.numbers.get_mut("datum").expect("there").push(0.0);
    assert_eq!(told(&bad, &plan), "state: `datum` has 2 numbers, not 1");
    let mut less = plan.clone();
    less.ledger = false;
    assert!(told(&good, &less).contains("parts that this run does not have"));
    for step in [59, 60, usize::MAX] {
        let bad = Checkpoint {
            step,
            ..good.clone()
        };
        assert!(told(&bad, &plan).contains("does not lie between"));
    }
}
