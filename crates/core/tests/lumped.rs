//! Wires as chains of point masses: against closed forms of the chain and of the continuous wire,
//! and against Hermite elements on a whole line.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::recording::record::Record;
use arcless_core::statics::Geometry;
use arcless_core::structure::Structure;
use common::chain::{lumped, settled};
use common::space::{in_space, staggered};
use common::{
    Single, difference, everything, orders, peak, prepare_any, run, simple_line_of, three_masses,
    travel,
};
use std::f64::consts::PI;

const SPEED: f64 = 320.0 / 3.6;
const STEP: f64 = 1e-3;
const CONTACT: f64 = 50e3;

/// Order of the error of differences for derivatives, O(ℓ²). On the line it is reached by segments
/// shorter than the √(EI/T) = 0.09 m over which bending rounds a kink.
const ORDER: f64 = 2.0;

fn scheme() -> Scheme {
    Scheme::generalised_alpha(0.9)
}

const BEAM: Single = Single {
    length: 10.0,
    elements: 10,
    mass: 1.35,
    axial: 15e6,
    bending: 2e4,
    tension: 22e3,
    gravity: 0.0,
};

/// Strain T/EA of a chain, for which the elongation counts, not Green's strain.
fn stretch(s: &Single) -> f64 {
    s.tension / s.axial
}

/// Bending stiffness of the stretched chain: r″ counts along the unstretched length.
fn bending(s: &Single) -> f64 {
    s.bending * (1.0 + stretch(s)).powi(3)
}

/// Hinged beam under tension T: w = P L/4T − P tanh(kL/2)/(2 T k), k² = T/EI.
/// Source: Timoshenko, Strength of Materials II, section 5 (direct axial tension).
#[test]
fn beam_under_tension_and_a_point_force() {
    let force = 10.0;
    let exact = |s: &Single| {
        let k = (s.tension / bending(s)).sqrt();
        force / s.tension * (0.25 * s.length - (0.5 * k * s.length).tanh() / (2.0 * k))
    };
    let dip = |s: &Single| {
        let mut structure = lumped(&s.structure(2).0);
        structure.loads.push((s.elements / 2, 1, -force));
        -settled::<2, 2>(structure).1[s.elements / 2][1]
    };
    let errors = [10, 20, 40, 80].map(|elements| {
        let s = Single { elements, ..BEAM };
        (dip(&s) / exact(&s) - 1.0).abs()
    });
    // √(EI/T) = 0.95 m is resolved. Measured 1.81, 1.95, 1.99.
    assert!((orders(&errors)[2] - ORDER).abs() < 0.1, "{errors:?}");
    assert!(errors[3] < 1e-3, "{errors:?}");
    let fault = Single {
        bending: 1.01 * BEAM.bending,
        ..BEAM
    };
    // The partner: 1 % of EI moves the answer by more than the tolerance.
    assert!((exact(&fault) / exact(&BEAM) - 1.0).abs() > 1e-3);
}

fn frequencies(s: &Single, count: usize) -> Vec<f64> {
    let (g, shape) = settled::<2, 2>(lumped(&s.structure(2).0));
    let line = LinearModel::new(&g, shape);
    line.frequencies(count).expect("regular")
}

/// Hinged chain of N masses μL at distance ℓ: ω² μL = (T/ℓ) q + (EI/L³) q², q = 4 sin²(nπ/2N).
/// The sine is exact for differences too, and its curvature vanishes at the hinges.
fn of_the_chain(s: &Single, n: usize) -> f64 {
    let l = s.length / s.elements as f64;
    let rest = l / (1.0 + stretch(s));
    let q = 4.0 * (n as f64 * PI / (2 * s.elements) as f64).sin().powi(2);
    let stiffness = s.tension / l * q + s.bending / rest.powi(3) * q * q;
    (stiffness / (s.mass * rest)).sqrt() / (2.0 * PI)
}

/// f = (n/2L) √(T/m) √(1 + (nπ/L)² EI/T) of the continuous wire.
/// Source: reference-data.md, section 6.
fn of_the_wire(s: &Single, n: usize) -> f64 {
    let (mass, k) = (s.mass / (1.0 + stretch(s)), n as f64 * PI / s.length);
    let stiffness = s.tension + k * k * bending(s);
    0.5 * n as f64 / s.length * (stiffness / mass).sqrt()
}

#[test]
fn frequencies_of_a_chain_under_tension() {
    let wire = Single {
        length: 55.0,
        elements: 110,
        bending: 195.0,
        ..BEAM
    };
    let found = frequencies(&wire, 10);
    for n in 1..=10 {
        // Rounding of forces of EA in a frequency of T: 1e-13 · EA/T.
        let relative = found[n - 1] / of_the_chain(&wire, n) - 1.0;
        assert!(relative.abs() < 1e-10, "{n}: {relative:e}");
    }
    let errors = [20, 40, 80].map(|elements| {
        let s = Single { elements, ..wire };
        1.0 - frequencies(&s, 6)[5] / of_the_wire(&s, 6)
    });
    assert!(
        orders(&errors).iter().all(|p| (p - 2.0).abs() < 0.05),
        "{errors:?}"
    );
    let fault = Single {
        tension: 1.01 * wire.tension,
        ..wire
    };
    // The partner: 1 % of tension is 0.5 % of a frequency.
    assert!((found[5] / of_the_chain(&fault, 6) - 1.0).abs() > 4e-3);
}

/// A chain and Hermite elements that bend alike: EI of the chain counts per unstretched length,
/// (1 + δ)³ in the stretched wire, that of the Hermite element 1/(1 + δ).
fn bending_alike(hermite: &Structure) -> Structure {
    let mut s = lumped(hermite);
    for bend in &mut s.bends {
        let k = &s.segments[bend.segments[0]];
        bend.stiffness /= (1.0 + k.design_tension / k.axial_stiffness).powi(4);
    }
    s
}

fn lengths(s: &Structure) -> Vec<f64> {
    s.links.iter().map(|l| l.rest_length).collect()
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    peak(&a.iter().zip(b).map(|(x, y)| x - y).collect::<Vec<_>>())
}

#[test]
fn dropper_lengths_converge_to_those_of_hermite_elements() {
    let line = |size: f64| simple_line_of(2, [size, size]).0;
    // Differs by 6e-7 m from a mesh of half the size.
    let reference = lengths(&settled::<2, 4>(line(0.0625)).0.structure);
    let errors = [0.25, 0.125, 0.0625, 0.03125].map(|size| {
        let (g, _) = settled::<2, 2>(bending_alike(&line(size)));
        largest_difference(&lengths(&g.structure), &reference)
    });
    let slopes = orders(&errors);
    // Measured 1.22, 1.69, 1.91.
    assert!(
        slopes.is_sorted() && (slopes[2] - ORDER).abs() < 0.15,
        "{slopes:?}"
    );
    // A kink of 1300 N at the support of the messenger wire, F √(EI/T)/2T = 3 mm, is what coarse
    // segments do not round.
    assert!(errors[0] < 2e-3 && errors[3] < 1e-4, "{errors:?}");
}

#[test]
fn settling_after_the_design_moves_nothing() {
    let mut s = lumped(&simple_line_of(3, [0.5, 1.0]).0);
    s.ends.iter_mut().for_each(|e| e.released = true);
    let drawn = s.positions.clone();
    let mut g = Geometry::<2, 2>::new(s).expect("a valid structure");
    let shape = g.design().expect("the design converges");
    let moved = g
        .find_equilibrium(&shape)
        .expect("the equilibrium converges");
    let pairs = || shape.iter().zip(&moved);
    let largest = pairs().map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
    // Forces balance to 1e-5 N; over the softest stiffness (100 N/m) that is 1e-7 m.
    assert!(largest.fold(0.0, f64::max) < 1e-7);
    assert!(shape.iter().zip(&drawn).all(|(r, x)| r[0] == x[0]));
    // Partner: without bends the same lengths are no equilibrium.
    g.structure.bends.clear();
    let other = g
        .find_equilibrium(&shape)
        .expect("the equilibrium converges");
    let gone = pairs().zip(&other).map(|((a, _), b)| (a[1] - b[1]).abs());
    assert!(gone.fold(0.0, f64::max) > 1e-6);
}

const SPANS: usize = 4;

fn crossing<const DIM: usize, const D: usize>(line: (Structure, Vec<usize>)) -> Record {
    let p: WireModel<DIM, D> = prepare_any(line, |_| (), scheme(), STEP, CONTACT);
    let mut plan = everything();
    plan.ledger = false;
    run(
        &p,
        &[three_masses(170.0)],
        &travel(75.0, 145.0, SPEED, STEP),
        &plan,
    )
}

/// Root of the mean square of the difference.
fn mean_difference(a: &[f64], b: &[f64]) -> f64 {
    let squares = a.iter().zip(b).map(|(x, y)| (x - y).powi(2));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}

/// Between nodes the contact runs along a chord, and its compliance changes with the place on it:
/// both vanish with ℓ², once the kink under the force is rounded over more than one segment.
#[test]
fn contact_force_converges_to_that_of_hermite_elements() {
    let line = |size: f64| simple_line_of(SPANS, [size, 2.0 * size]);
    let reference = crossing::<2, 4>(line(0.125));
    let errors = [0.25, 0.125, 0.0625].map(|size| {
        let (s, path) = line(size);
        mean_difference(
            &crossing::<2, 2>((lumped(&s), path)).force,
            &reference.force,
        )
    });
    let slopes = orders(&errors);
    // Measured 8.4, 2.6 and 0.8 N: orders 1.67, 1.73.
    assert!(
        slopes.is_sorted() && (slopes[1] - ORDER).abs() < 0.3,
        "{slopes:?}"
    );
    assert!(errors[2] < 1.5, "{errors:?} N of 170");
}

#[test]
fn planar_chain_is_the_spatial_one_without_stagger() {
    let (s, path) = simple_line_of(SPANS, [1.0, 2.0]);
    let flat = crossing::<2, 2>((lumped(&s), path.clone()));
    let deep = crossing::<3, 3>((lumped(&in_space(&s)), path));
    assert!(peak(&deep.lateral) == 0.0);
    // Blocks of another size round differently: rounding of 1e-5 N in the statics of 170 N.
    assert!(difference(&deep.force, &flat.force) < 1e-6);
    assert!(difference(&deep.link_force, &flat.link_force) < 1e-6);
}

#[test]
fn staggered_chain_follows_hermite_elements() {
    let stagger = 0.2;
    let line = |size: f64| {
        let (s, path) = simple_line_of(SPANS, [size, 2.0 * size]);
        (staggered(&s, SPANS, stagger), path)
    };
    let reference = crossing::<3, 6>(line(0.25));
    let runs = [0.25, 0.125].map(|size| {
        let (s, path) = line(size);
        crossing::<3, 3>((lumped(&s), path))
    });
    let of = |read: fn(&Record) -> &[f64]| {
        runs.each_ref()
            .map(|r| mean_difference(read(r), read(&reference)))
    };
    let (force, lateral) = (of(|r| &r.force), of(|r| &r.lateral));
    // Measured 9.0 and 3.2 N, as on the planar line.
    assert!(orders(&force)[0] > 1.2 && force[1] < 4.0, "{force:?}");
    assert!(lateral[1] < 1e-3 && lateral[1] < lateral[0], "{lateral:?}");
    assert!(peak(&reference.lateral) > 0.9 * stagger, "the partner");
}

#[test]
fn arms_carry_the_stagger_of_a_chain() {
    let stagger = 0.2;
    let line = staggered(&simple_line_of(SPANS, [0.5, 1.0]).0, SPANS, stagger);
    let (chain, shape) = settled::<3, 3>(lumped(&line));
    let (hermite, same) = settled::<3, 6>(line);
    for (a, b) in chain.structure.struts.iter().zip(&hermite.structure.struts) {
        let found = Geometry::<3, 3>::strut_state(&shape, a).linear_tension;
        let known = Geometry::<3, 6>::strut_state(&same, b).linear_tension;
        // Both round the kink at the arm, over 0.1 m or an element of 0.5 m, of spans of 55 m.
        assert!((found / known - 1.0).abs() < 5e-3, "{found} {known}");
        assert!((shape[a.node][1].abs() - stagger).abs() < 1e-6);
    }
}

/// Rounding, as on the Hermite line: measured 4e-13 to 7e-13; the issue asks for 1e-9.
const BALANCE: f64 = 1e-11;

#[test]
fn energy_balances_with_slack_links_friction_and_two_pantographs() {
    for contact in [CONTACT, f64::INFINITY] {
        for scheme in [
            Scheme::generalised_alpha(1.0),
            Scheme::generalised_alpha(0.5),
        ] {
            let (s, path) = simple_line_of(6, [1.0, 2.0]);
            let loose = |s: &mut Structure| s.links[22].rest_length += 0.015;
            let line = (lumped(&s), path);
            let p: WireModel<2, 2> = prepare_any(line, loose, scheme, STEP, contact);
            let mut way = travel(110.0, 270.0, SPEED, STEP);
            way.distances = vec![0.0, 50.0];
            way.friction = 0.2;
            let pantographs = [three_masses(200.0), three_masses(60.0)];
            let r = run(&p, &pantographs, &way, &everything());
            assert!(r.slack_max > 5, "droppers go slack");
            assert!(r.gap.iter().any(|g| *g > 0.0), "contact is lost");
            let relative = r.energy_residual / r.energy_turnover;
            assert!(relative < BALANCE, "{contact}: {relative:e}");
            let taken = peak(
                &r.energy
                    .iter()
                    .map(|e| e.dissipated_scheme)
                    .collect::<Vec<_>>(),
            );
            let is_trapezoidal = scheme == Scheme::generalised_alpha(1.0);
            assert!((taken < BALANCE * r.energy_turnover) == is_trapezoidal);
        }
    }
}

/// Array that a changed structure is refused for.
fn refused<const D: usize>(change: impl FnOnce(&mut Structure)) -> &'static str {
    let (mut s, _) = simple_line_of(1, [2.0, 4.0]);
    if D == 2 {
        s = lumped(&s);
    }
    change(&mut s);
    match Geometry::<2, D>::new(s) {
        Err(CoreError::Input { array, .. }) => array,
        Err(other) => panic!("{other}"),
        Ok(_) => "",
    }
}

#[test]
fn contradictions_are_refused() {
    assert_eq!(refused::<2>(|_| ()), "");
    assert_eq!(refused::<4>(|_| ()), "");
    assert_eq!(
        refused::<4>(|s| s.segments = lumped(s).segments),
        "segments"
    );
    assert_eq!(
        refused::<2>(|s| s.wires = simple_line_of(1, [2.0, 4.0]).0.wires),
        "wires"
    );
    assert_eq!(
        refused::<2>(|s| s.segments[3].nodes[1] = 10_000),
        "segments"
    );
    assert_eq!(
        refused::<2>(|s| s.segments[3].rest_length = 0.0),
        "segments"
    );
    assert_eq!(refused::<2>(|s| s.segments[3].mass = f64::NAN), "segments");
    assert_eq!(
        refused::<2>(|s| s.segments[3].axial_stiffness = -1.0),
        "segments"
    );
    assert_eq!(
        refused::<2>(|s| s.segments[3].damping.beta = -1.0),
        "segments"
    );
    assert_eq!(refused::<2>(|s| s.bends[3].stiffness = -1.0), "bends");
    assert_eq!(refused::<2>(|s| s.bends[3].beta = f64::INFINITY), "bends");
    assert_eq!(refused::<2>(|s| s.bends[3].segments = [3, 5]), "bends");
    assert_eq!(refused::<2>(|s| s.bends[3].segments = [3, 10_000]), "bends");
    assert_eq!(refused::<2>(|s| s.segments.clear()), "bends");
    let lonely = |s: &mut Structure| {
        s.positions.push([60.0, 0.0, 0.0]);
        s.slopes.push([0.0; 3]);
    };
    assert_eq!(refused::<2>(lonely), "wires");
}
