//! What the fuzzer found at the border of the core, each written down as arrays.

mod common;

use arcless_core::CoreError;
use arcless_core::dynamics::actuator::Actuator;
use arcless_core::dynamics::still::Still;
use arcless_core::scheme::Scheme;
use arcless_core::statics::Geometry;
use arcless_core::structure::{Spring, SpringMode, Strut};
use common::lanes::{At, STRING, lined, strings};
use common::{Single, everything, free_mass, prepare, travel};

fn scheme() -> Scheme {
    Scheme::generalised_alpha(0.9)
}

fn is_refused<T>(found: Result<T, CoreError>, array: &str) -> bool {
    matches!(found, Err(CoreError::Input { array: given, .. }) if given == array)
}

/// It was read beyond the end of the displacements.
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
fn a_delay_without_end_is_a_force_that_never_acts() {
    let p = prepare(STRING.structure(2), |_| (), scheme(), 1e-3, 5e4);
    let way = travel(24.0, 24.2, 10.0, 1e-3);
    let mut rider = free_mass(5.0, 100.0);
    rider.actuator = Some(Actuator {
        direction: vec![1.0],
        every: 2,
        delay: usize::MAX,
    });
    let (mut go_on, mut ask) = (|_: usize| true, |_: usize, _: &_| Ok(50.0));
    let found = p.run_controlled(&[rider], &way, &everything(), &mut go_on, &mut ask);
    let found = found.expect("the run is done");
    assert!(!found.control.is_empty() && found.control.iter().all(|&q| q == 0.0));
}

/// Their lifts were solved for all the same, and infinite.
#[test]
fn wires_that_yield_as_one_have_no_elasticity() {
    let pair = [At::level(0.0, 0.0), At::level(0.0, 1.0)];
    let p = lined(strings(&STRING, &pair), scheme(), 5e4);
    let mut still = Still::new(&p.line).expect("a firm line");
    for force in [0.0, 100.0] {
        // At the fixed ends none of the two yields at all.
        assert!(is_refused(
            still.elasticity(&p.lanes, &[0.0], force),
            "lanes"
        ));
        let inside = still.elasticity(&p.lanes, &[24.0], force);
        assert!(inside.expect("two wires")[0] > 0.0);
    }
    for force in [f64::NAN, f64::INFINITY, -1.0] {
        assert!(is_refused(
            still.elasticity(&p.lanes, &[24.0], force),
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
