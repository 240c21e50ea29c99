//! Findings of the fuzzer at the border of the core, each written out as arrays.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::linear::static_response::StaticSolver;
use arcless_core::pantograph::actuator::Actuator;
use arcless_core::pantograph::excitation::ForceHistory;
use arcless_core::scheme::Scheme;
use arcless_core::slideline::Slideline;
use arcless_core::statics::Geometry;
use arcless_core::structure::{Link, Spring, SpringMode, Strut};
use common::lanes::{At, STRING, lined, strings};
use common::{Single, everything, free_mass, oblique, prepare, simple_line, travel};

fn scheme() -> Scheme {
    Scheme::generalised_alpha(0.9)
}

fn is_refused<T>(found: Result<T, CoreError>, array: &str) -> bool {
    matches!(found, Err(CoreError::Input { array: given, .. }) if given == array)
}

/// Finding: a read beyond the end of the displacements.
#[test]
fn a_watched_node_beyond_the_last_one_is_refused() {
    let p = prepare(STRING.structure(2), |_| (), scheme(), 1e-3, 5e4);
    let way = travel(24.0, 24.2, 10.0, 1e-3);
    for (node, refused) in [(STRING.elements, false), (STRING.elements + 1, true)] {
        let mut plan = everything();
        plan.nodes = vec![node];
        let found = p.run(&[free_mass(5.0, 100.0)], &way, &plan, &mut |_| true);
        assert_eq!(is_refused(found, "plan"), refused);
    }
}

/// The step from which the force acts was counted beyond the largest number there is.
#[test]
fn a_delay_without_end_is_refused() {
    let p = prepare(STRING.structure(2), |_| (), scheme(), 1e-3, 5e4);
    let way = travel(24.0, 24.2, 10.0, 1e-3);
    for (delay, refused) in [(1000, false), (usize::MAX, true)] {
        let mut pantograph = free_mass(5.0, 100.0);
        pantograph.actuator = Some(Actuator {
            direction: vec![1.0],
            every: 2,
            delay,
        });
        let (mut go_on, mut ask) = (|_: usize| true, |_: usize, _: &_| Ok(50.0));
        let found = p.run_controlled(&[pantograph], &way, &everything(), &mut go_on, &mut ask);
        assert_eq!(is_refused(found, "pantographs"), refused);
    }
}

/// Their lifts were solved for all the same, and infinite.
#[test]
fn wires_that_yield_as_one_have_no_elasticity() {
    let pair = [At::level(0.0, 0.0), At::level(0.0, 1.0)];
    let p = lined(strings(&STRING, &pair), scheme(), 5e4);
    let mut still = StaticSolver::new(&p.line).expect("a firm line");
    for force in [0.0, 100.0] {
        // At the fixed ends none of the two yields at all.
        assert!(is_refused(
            still.elasticity(&p.slidelines, &[0.0], force),
            "lanes"
        ));
        let inside = still.elasticity(&p.slidelines, &[24.0], force);
        assert!(inside.expect("two wires")[0] > 0.0);
    }
    for force in [f64::NAN, f64::INFINITY, -1.0] {
        assert!(is_refused(
            still.elasticity(&p.slidelines, &[24.0], force),
            "force"
        ));
    }
}

/// Infinite stiffnesses, masses and dampers went into the matrices.
#[test]
fn struts_and_springs_are_finite() {
    let strut = Strut {
        node: 2,
        direction: [0.0, 1.0, 0.0],
        anchor: [0.0; 3],
        rest_length: 1.0,
        stiffness: 1e7,
        moving_mass: 0.3,
        hanging_mass: 0.5,
        adjust: true,
    };
    let spring = Spring {
        node: 2,
        component: 2,
        stiffness: 5e5,
        viscosity: 1e3,
        rest: 0.0,
        mode: SpringMode::Held,
    };
    let single = Single {
        elements: 4,
        ..STRING
    };
    let with = |strut: Strut, spring: Spring| {
        let (mut s, _) = single.structure(3);
        s.struts.push(strut);
        s.springs.push(spring);
        Geometry::<3, 6>::new(s)
    };
    assert!(with(strut, spring).is_ok());
    let numbers: [fn(&mut Strut) -> &mut f64; 4] = [
        |t| &mut t.rest_length,
        |t| &mut t.stiffness,
        |t| &mut t.moving_mass,
        |t| &mut t.hanging_mass,
    ];
    for number in numbers {
        for value in [f64::INFINITY, f64::NAN, -1.0] {
            let mut spoilt = strut;
            *number(&mut spoilt) = value;
            assert!(is_refused(with(spoilt, spring), "struts"));
        }
    }
    let viscosity = f64::INFINITY;
    let spoilt = Spring {
        viscosity,
        ..spring
    };
    assert!(is_refused(with(strut, spoilt), "springs"));
}

/// Slack links and lengths that follow from a tension divide by the stiffness.
#[test]
fn only_links_that_need_no_stiffness_may_have_none() {
    let (line, _) = simple_line(1);
    for [unilateral, adjust] in [[false, false], [true, false], [false, true]] {
        let mut s = line.clone();
        s.links.push(Link {
            unilateral,
            adjust,
            ..oblique(&line, 3, 0.0, 500.0)
        });
        let found = Geometry::<2, 4>::new(s);
        assert_eq!(is_refused(found, "links"), unilateral || adjust);
    }
}

/// They were added up to infinite forces.
#[test]
fn loads_whose_sums_are_not_finite_are_refused() {
    let long = Single {
        elements: 6,
        ..STRING
    };
    let (s, _) = long.structure(2);
    let geometry = Geometry::<2, 4>::new(s).expect("sound");
    assert!(geometry.nodal_forces(&[[1e300; 3]; 6]).is_ok());
    assert!(is_refused(
        geometry.nodal_forces(&[[f64::MAX; 3]; 6]),
        "load"
    ));
}

/// Only every 256th step was looked at, and what came after the last of them went out as it was.
#[test]
fn a_run_that_ends_beyond_all_numbers_is_an_error() {
    let p = prepare(STRING.structure(2), |_| (), scheme(), 1e-3, 5e4);
    let way = travel(24.0, 24.2, 10.0, 1e-3);
    let steps = way.positions.len();
    // With the second force the energy, a product, overflows, and no balance can be checked; the
    // motion itself stays finite.
    for (pull, ends) in [(-1e3, true), (-1e200, false)] {
        let mut values = vec![pull; steps];
        values[0] = 0.0;
        let mut pantograph = free_mass(5.0, 100.0);
        pantograph.excitation.forces.push(ForceHistory {
            direction: vec![1.0],
            values,
        });
        let found = p.run(&[pantograph], &way, &everything(), &mut |_| true);
        match found {
            Ok(record) => assert!(ends && record.masses.iter().all(|u| u.is_finite())),
            Err(error) => {
                let said = matches!(
                    error,
                    CoreError::NotFinite { .. } | CoreError::Balance { .. }
                );
                assert!(!ends && said, "{error}");
            }
        }
    }
}

/// The time of its steps was infinite, and nothing said so.
#[test]
fn steps_that_no_line_takes_are_refused() {
    let (s, lanes) = STRING.structure(2);
    let geometry = Geometry::<2, 4>::new(s).expect("sound");
    let shape = geometry
        .find_equilibrium(&geometry.initial_shape())
        .expect("firm");
    let prepare = |h: f64| {
        let paths = Slideline::from_elements(&geometry, &shape, std::slice::from_ref(&lanes))?;
        let line = LinearModel::new(&geometry, shape.clone());
        WireModel::new(line, paths, scheme(), h, 5e4)
    };
    assert!(prepare(1e-3).is_ok());
    for h in [0.0, -1e-3, 1e-200, 1e100, 1e308, f64::INFINITY, f64::NAN] {
        assert!(is_refused(prepare(h), "solver"), "{h}");
    }
}

/// A basis that spans everything went on in rounding, and nobody could stop it.
#[test]
fn frequencies_are_bounded_and_can_be_given_up() {
    let (s, _) = STRING.structure(2);
    let geometry = Geometry::<2, 4>::new(s).expect("sound");
    let shape = geometry
        .find_equilibrium(&geometry.initial_shape())
        .expect("firm");
    let line = LinearModel::new(&geometry, shape);
    let all = line.frequencies(1000).expect("a firm line");
    assert!(all.len() <= line.free.iter().flatten().filter(|f| **f).count());
    assert!(all.iter().all(|f| f.is_finite()));
    for count in [1001, 1 << 20, 1 << 63, usize::MAX] {
        assert!(is_refused(line.frequencies(count), "count"));
    }
    let mut asked = 0;
    let given_up = line.frequencies_while(1000, &mut || {
        asked += 1;
        false
    });
    assert!(matches!(given_up, Err(CoreError::Cancelled { .. })));
    assert_eq!(asked, 1);
}
