//! Residual flexibility: wires yield under point forces as they should, whatever the mesh.

use crate::tests::common;

use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::static_response::StaticSolver;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::Scheme;
use arcless_core::session::{Collector, Session, SessionStart};
use arcless_core::statics::{Alteration, Geometry, Shape};
use arcless_core::structure::Structure;
use common::{
    SPAN, Single, difference, everything, oblique, peak, prepare, run, simple_line_of,
    three_masses, travel,
};
use std::f64::consts::PI;
use std::sync::Arc;

const CONTACT: f64 = 50e3;
const H: f64 = 1e-3;

fn scheme() -> Scheme {
    Scheme::generalised_alpha(0.9)
}

/// A taut wire of 60 m with elements as long as those between droppers.
const WIRE: Single = Single {
    length: 60.0,
    elements: 24,
    mass: 1.35,
    axial: 15e6,
    bending: 195.0,
    tension: 22e3,
    gravity: 0.0,
};

/// With residual flexibility or without.
fn prepared(line: (Structure, Vec<usize>), yields: bool) -> WireModel<2, 4> {
    if yields {
        common::yielding(line, |_| (), scheme(), H, CONTACT)
    } else {
        prepare(line, |_| (), scheme(), H, CONTACT)
    }
}

fn elasticity(p: &WireModel<2, 4>, x: &[f64]) -> Vec<f64> {
    let mut still = StaticSolver::new(&p.line).expect("a firm line");
    still
        .elasticity(&p.slidelines, x, 0.0)
        .expect("on the wire")
}

fn worst(found: &[f64], expected: &[f64]) -> f64 {
    let pairs = found.iter().zip(expected);
    pairs.fold(0.0, |most, (f, e)| most.max((f / e - 1.0).abs()))
}

/// Hinged beam under tension with a unit force at x: w(x) = (2/ℓ) Σ sin²(kx)/(T k² + EI k⁴).
#[test]
fn a_wire_yields_as_a_tensioned_beam_also_between_nodes() {
    let x: Vec<f64> = (0..40).map(|i| 28.0 + 0.13 * f64::from(i)).collect();
    let exact = x.iter().map(|x| {
        let term = |n: i32| {
            let k = f64::from(n) * PI / WIRE.length;
            2.0 / WIRE.length * (k * x).sin().powi(2)
                / (WIRE.tension * k * k + WIRE.bending * k.powi(4))
        };
        (1..20_000).map(term).sum::<f64>()
    });
    let exact: Vec<f64> = exact.collect();
    let of = |yields: bool| elasticity(&prepared(WIRE.structure(2), yields), &x);
    // Green's strain couples the force to the stretch, T/EA = 1.5e-3 of the rest of the wire.
    assert!(
        worst(&of(true), &exact) < 2e-4,
        "{}",
        worst(&of(true), &exact)
    );
    assert!(
        worst(&of(false), &exact) > 5e-3,
        "{}",
        worst(&of(false), &exact)
    );
}

/// Elasticity of a whole line with droppers and supports: long elements yield as short ones, which
/// need no correction.
#[test]
fn elasticity_hardly_depends_on_the_mesh() {
    let x: Vec<f64> = (0..110).map(|i| 1.5 * SPAN + 0.5 * f64::from(i)).collect();
    let of = |elements, yields| elasticity(&prepared(simple_line_of(4, elements), yields), &x);
    let fine = of([0.15, 0.3], true);
    let fine_alone = of([0.15, 0.3], false);
    // Elements of twice √(EI/T): what they miss is 3 % of ℓ/T, a thousandth of the elasticity.
    assert!(worst(&fine_alone, &fine) < 1e-3);
    let (with, without) = (of([1.45, 2.9], true), of([1.45, 2.9], false));
    assert!(worst(&with, &fine) < 3e-3, "{}", worst(&with, &fine));
    assert!(worst(&without, &fine) > 0.01, "{}", worst(&without, &fine));
}

/// Heights of the wire of a standing head with two strips, of which each feels the other.
#[test]
fn strips_feel_one_another() {
    let begin = |position: f64| SessionStart {
        position,
        speed: 0.0,
        friction: 0.0,
    };
    let heights = |elements: usize, yields: bool, position: f64| {
        let wire = Single { elements, ..WIRE };
        let p = Arc::new(prepared(wire.structure(2), yields));
        let pair = [0.0, 0.6].map(|behind| Collector {
            behind,
            half_width: f64::INFINITY,
        });
        let live = Session::with_forces(p, pair.into(), &[80.0, 80.0], begin(position));
        live.expect("it stands").outputs().height.clone()
    };
    // On one element, on two, and with a node between them.
    for position in [28.9, 30.2, 30.5] {
        let fine = heights(600, true, position);
        let error = |yields: bool| {
            let found = heights(24, yields, position);
            let apart = found.iter().zip(&fine).map(|(a, b)| a - b);
            peak(&apart.collect::<Vec<_>>())
        };
        // Of some 100 mm; without, each strip misses up to 0.03 ℓ/T of its own force, 0.3 mm.
        assert!(error(true) < 2e-6, "{position}: {}", error(true));
        assert!(error(false) > 5e-5, "{position}: {}", error(false));
    }
}

/// A head with two strips 0.6 m apart.
fn pair_of_strips(force: f64) -> Pantograph {
    let strip = |offset: f64| Strip {
        offset,
        ..Strip::plain(vec![0.0, 0.0, 1.0])
    };
    Pantograph {
        strips: vec![strip(0.0), strip(0.6)],
        ..three_masses(force)
    }
}

/// Pantographs in equilibrium near slack links do not move: start and steps agree.
#[test]
fn what_stands_stays() {
    let p = prepared(simple_line_of(3, [1.45, 2.9]), true);
    for (pantograph, position) in [
        (three_masses(300.0), 71.3),
        (three_masses(300.0), 77.1),
        (pair_of_strips(300.0), 76.5),
    ] {
        let mut way = travel(0.0, 1.0, 1.0, H);
        way.positions.fill(position);
        way.speeds.fill(0.0);
        let r = run(&p, &[pantograph], &way, &everything());
        assert!(r.slack[0] > 0.0, "a link is slack");
        let columns = r.contacts.len();
        let moved = r.force.iter().enumerate();
        let moved = moved.map(|(i, f)| f - r.force[i % columns]);
        // Rounding of heights, 1e-14 m on 50 kN/m, and of the forces that hold them.
        assert!(peak(&moved.collect::<Vec<_>>()) < 1e-6);
        let turnover = r.energy_turnover;
        assert!(turnover < 1e-9, "nothing moves: {turnover}");
    }
}

/// Energy supplied is stored, dissipated or lost while links slacken and strips part and meet.
/// Closed to rounding (measured below 1e-12), as the ledger without residual flexibility.
#[test]
fn the_ledger_closes() {
    for (scheme, contact) in [
        (Scheme::generalised_alpha(1.0), CONTACT),
        (scheme(), CONTACT),
        (Scheme::generalised_alpha(0.0), f64::INFINITY),
    ] {
        let line = simple_line_of(6, [1.45, 2.9]);
        let loose = |s: &mut Structure| s.links[22].rest_length += 0.015;
        let p: WireModel<2, 4> = common::yielding(line, loose, scheme, H, contact);
        let mut way = travel(110.0, 270.0, 320.0 / 3.6, H);
        (way.distances, way.friction) = (vec![0.0, 50.0], 0.2);
        let pantographs = [pair_of_strips(200.0), three_masses(60.0)];
        let r = run(&p, &pantographs, &way, &everything());
        assert!(r.slack_max > 0 && r.gap.iter().any(|g| *g > 0.0));
        let share = r.energy_residual / r.energy_turnover;
        // Rounding, as in `ledger.rs`.
        assert!(share < 1e-11, "{share}");
    }
}

/// Without lift-off, switching loses no energy: work at a contact that moves along a wire of
/// varying flexibility is traction.
#[test]
fn a_contact_that_moves_loses_nothing() {
    let p: WireModel<2, 4> = common::yielding(
        simple_line_of(4, [1.45, 2.9]),
        |_| (),
        Scheme::generalised_alpha(1.0),
        H,
        CONTACT,
    );
    let r = run(
        &p,
        &[three_masses(60.0)],
        &travel(75.0, 145.0, 30.0, H),
        &everything(),
    );
    assert!(r.slack_max == 0 && r.gap.iter().all(|&g| g == 0.0));
    let last = r.energy.last().expect("a ledger");
    // A step of 1 ms sees the slope of the wire at its middle: an error of its square.
    assert!(
        last.switching.abs() < 1e-4 * r.energy_turnover,
        "{}",
        last.switching
    );
}

/// A force that moves along a wire does not notice the elements.
#[test]
fn a_force_that_moves_meets_no_elements() {
    let heights = |elements: usize, yields: bool| {
        let wire = Single { elements, ..WIRE };
        let p = Arc::new(prepared(wire.structure(2), yields));
        let (from, speed) = (25.0, 20.0);
        let begin = SessionStart {
            position: from,
            speed,
            friction: 0.0,
        };
        let one = Collector {
            behind: 0.0,
            half_width: f64::INFINITY,
        };
        let mut live = Session::with_forces(p, vec![one], &[100.0], begin).expect("it stands");
        let after = (1..400).map(|step| {
            let x = from + speed * H * f64::from(step);
            live.step(&[100.0], x, speed).expect("a step");
            live.outputs().height[0]
        });
        after.collect::<Vec<_>>()
    };
    let fine = heights(400, true);
    let (with, without) = (heights(24, true), heights(24, false));
    // Error without R: 0.03 ℓ/T · 100 N = 0.34 mm between nodes, twice that as the force moves on;
    // with R: inertia within the element, a tenth of it.
    let apart = |found: &[f64]| difference(found, &fine) * peak(&fine);
    let (with, without) = (apart(&with), apart(&without));
    assert!(with < 1e-4 && without > 5e-4, "{with:e} {without:e}");
}

/// Settled under other tensions, R is that of those tensions.
#[test]
fn after_changes_the_line_yields_with_its_own_tension() {
    let (structure, _) = simple_line_of(3, [1.45, 2.9]);
    let mut geometry = Geometry::<2, 4>::new(structure).expect("a valid structure");
    geometry.add_residual_flexibility();
    let start = geometry.design().expect("the design converges");
    let shape = geometry
        .find_equilibrium(&start)
        .expect("the equilibrium converges");
    let s = &geometry.structure;
    let longer = Alteration {
        length_factor: vec![1.0003; s.wires.len()],
        axial_factor: vec![1.0; s.wires.len()],
        bending_factor: vec![1.0; s.wires.len()],
        mass: s.wires.iter().map(|w| w.mass).collect(),
        load: vec![[0.0; 3]; s.wires.len()],
        link_factor: vec![1.0; s.links.len()],
        link_offset: vec![0.0; s.links.len()],
        spring_offset: vec![0.0; s.springs.len()],
        strut_offset: vec![0.0; s.struts.len()],
        end_force: s
            .ends
            .iter()
            .map(|e| e.released.then_some(e.force))
            .collect(),
        removed: vec![3],
    };
    let (altered, _): (_, Shape<4>) = geometry.altered(&shape, &longer).expect("it settles");
    let yields = |g: &Geometry<2, 4>, link: usize| {
        let given = g.structure.residual.as_ref().expect("it yields").links[link];
        1.0 / g.structure.links[link].stiffness - 1.0 / given
    };
    // 15e6 · 3e-4 of 22 kN and 11.64e6 · 3e-4 of 16 kN are a fifth; what is left is in 1/(1 − 0.2).
    let ratio = yields(&altered, 12) / yields(&geometry, 13);
    assert!((1.15..1.35).contains(&ratio), "{ratio}");
}

/// A pure damper shares no kink with the dropper at whose node it is: lengths, stiffnesses with R
/// and shape keep their bits.
#[test]
fn a_damper_changes_nothing_at_rest() {
    let (plain, _) = simple_line_of(3, [1.45, 2.9]);
    let with = |stiffness: Option<f64>| {
        let mut s = plain.clone();
        s.links
            .extend(stiffness.map(|k| oblique(&plain, 12, k, 500.0)));
        let mut geometry = Geometry::<2, 4>::new(s).expect("a valid structure");
        geometry.add_residual_flexibility();
        let start = geometry.design().expect("the design converges");
        let shape = geometry.find_equilibrium(&start);
        let droppers = geometry.structure.links[..plain.links.len()].iter();
        let numbers: Vec<_> = droppers.map(|l| [l.rest_length, l.stiffness]).collect();
        (numbers, shape.expect("the equilibrium converges"))
    };
    let (without, damped, pulled) = (with(None), with(Some(0.0)), with(Some(1e-9)));
    assert_eq!(damped, without);
    // A spring counts, however soft: two bars at a node, each with R of both.
    assert!((pulled.0[12][0] - without.0[12][0]).abs() > 1e-6);
}

/// Heights of the drawing are those of the real wire at its clamps.
#[test]
fn the_design_puts_the_real_wire_where_it_is_drawn() {
    let (structure, _) = simple_line_of(3, [1.45, 2.9]);
    let mut geometry = Geometry::<2, 4>::new(structure).expect("a valid structure");
    geometry.add_residual_flexibility();
    let shape = geometry.design().expect("the design converges");
    let real = geometry.real_shape(&shape);
    for link in &geometry.structure.links {
        let node = link.nodes[1];
        // The tolerance of the design.
        assert!((real[node][1] - geometry.structure.positions[node][1]).abs() < 2e-9);
        assert!(
            real[node][1] - shape[node][1] > 1e-5,
            "the clamp pulls a kink"
        );
    }
}
