//! Contacts on the curve between the points of a chain, against closed forms of the wire.
//!
//! T w″ − EI w⁗ = −F δ, with λ² = EI/T: far from the ends of a wire, a distance L apart, a force F
//! at y raises the wire at x by
//!
//!   F G(x, y) = F (x̲ (L − x̄)/L − λ e^{−|x−y|/λ}/2)/T
//!
//! with x̲ the smaller and x̄ the larger of x and y: the corner of a string,
//! κ g(s) = (F/T) (|s| + λ e^{−|s|/λ})/2, rounded over λ.
//!
//! Points of the chain yield in a slightly different way. With K = 4 sin² (kℓ/2) and
//! ε* = EI x coth x/(Tℓ²) the response of the chain is 1/(K + ε* K²) = 1/K − 1/(K + 1/ε*), for
//! points n elements away
//!
//!   (ℓ/T) (c − |n|/2 − e^{−μ|n|}/(2 sinh μ)),   4 sinh² (μ/2) = 1/ε*
//!
//! Its corner is rounded by ℓ/(2 sinh μ) instead of λ/2. The difference is residual flexibility,
//! negative at points: parts attached to a point and contacts on the curve have it in addition.

use super::{Chain, WIRE, angular, explicit, pass, plan, seen, stiffer, way};
use crate::tests::common::chain::lumped;
use crate::tests::common::{Single, peak};
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::static_response::StaticSolver;
use arcless_core::session::{Collector, Session, SessionStart};
use arcless_core::slideline::Slideline;
use arcless_core::statics::{Geometry, Shape};
use std::sync::Arc;

const LENGTH: f64 = 60.0;

/// λ, m.
fn radius() -> f64 {
    (WIRE.bending / WIRE.tension).sqrt()
}

/// e^{−|s|/λ}
fn faded(s: f64) -> f64 {
    (-s.abs() / radius()).exp()
}

/// g(s), m.
fn corner(s: f64) -> f64 {
    0.5 * (s.abs() + radius() * faded(s))
}

/// T G(x, y) of the wire, m.
fn yields(x: f64, y: f64) -> f64 {
    x.min(y) * (LENGTH - x.max(y)) / LENGTH - 0.5 * radius() * faded(x - y)
}

/// Corner of a chain with elements of ℓ, m.
fn of_chain(length: f64, s: f64) -> f64 {
    let unit = WIRE.tension * length * length;
    let stiffness = unit / stiffer(WIRE.bending, WIRE.tension, length);
    let mu = 2.0 * (0.5 * stiffness.sqrt()).asinh();
    0.5 * (s.abs() + length / mu.sinh() * (-mu * s.abs() / length).exp())
}

/// Effect of the stretch, m: EI counts per unstretched length, which changes λ by a share T/EA, and
/// the corner of the chain by twice that.
fn stretched() -> f64 {
    3.0 * WIRE.tension / WIRE.axial * radius()
}

/// A straight wire of 60 m in elements of a given length.
fn straight(length: f64) -> Chain {
    let wire = Single {
        length: LENGTH,
        elements: (LENGTH / length).round() as usize,
        gravity: 0.0,
        ..WIRE
    };
    let (structure, path) = wire.structure(2);
    (lumped(&structure), vec![path])
}

const UNEVEN: [f64; 10] = [0.0, 0.7, 1.0, 1.9, 2.3, 2.5, 4.0, 4.4, 5.5, 6.0];

/// A wire in unequal elements through given heights, with what holds it at some points.
fn uneven(height: impl Fn(f64) -> f64, held: &[usize]) -> (Geometry<2, 2>, Shape<2>) {
    let wire = Single {
        length: 6.0,
        elements: UNEVEN.len() - 1,
        ..WIRE
    };
    let mut s = lumped(&wire.structure(2).0);
    for (place, x) in s.positions.iter_mut().zip(UNEVEN) {
        *place = [x, height(x), 0.0];
    }
    for segment in &mut s.segments {
        let [a, b] = segment.nodes.map(|node| s.positions[node]);
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        segment.rest_length = length / (1.0 + wire.tension / wire.axial);
    }
    s.springs = held.iter().map(|&node| seen(node, 1)).collect();
    s.fitted_bends = true;
    let geometry = Geometry::new(s).expect("a valid structure");
    let shape = geometry.initial_shape();
    (geometry, shape)
}

/// Its lane with chords, and with curves.
fn both(height: impl Fn(f64) -> f64, held: &[usize]) -> [Slideline<2>; 2] {
    let (geometry, shape) = uneven(height, held);
    let lane: Vec<usize> = (0..UNEVEN.len() - 1).collect();
    let lanes = || {
        Slideline::from_elements(&geometry, &shape, std::slice::from_ref(&lane)).expect("a lane")
    };
    [lanes(), Slideline::smoothed(lanes(), &geometry, &shape)].map(|mut lanes| lanes.remove(0))
}

/// Places all along it, both ends among them.
fn along() -> impl Iterator<Item = f64> {
    (0..=600).map(|i| 0.01 * f64::from(i))
}

/// Largest difference of heights from those expected at some places.
fn off(lane: &Slideline<2>, x: impl Iterator<Item = f64>, height: impl Fn(f64) -> f64) -> f64 {
    let apart = x.map(|x| lane.locate(x, 0).expect("on the wire").height - height(x));
    peak(&apart.collect::<Vec<_>>())
}

#[test]
fn a_straight_line_and_a_parabola_are_met() {
    for height in [|x: f64| 0.02 * x - 0.03, |x: f64| 0.003 * (x - 2.2).powi(2)] {
        let [chords, curves] = both(height, &[]);
        // Rounding of heights and coordinates of some metres.
        assert!(off(&curves, along(), height) < 1e-15);
        for x in along() {
            let place = curves.locate(x, 0).expect("on the wire");
            let field = |of: fn(f64) -> f64| {
                let u: Vec<[f64; 2]> = UNEVEN.iter().map(|&x| [0.0, of(x)]).collect();
                place.displacement(&u, 1)
            };
            assert!((place.weights.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            assert!((field(|x| x) - x).abs() < 1e-14);
            assert!((field(|x| x * x) - x * x).abs() < 1e-13);
        }
        if height(1.0) > 0.0 {
            // The parabola: chords miss ℓ²/8 of the curvature, of 1.5 m.
            let missed = off(&chords, along(), height);
            assert!((missed / (0.006 * 1.5 * 1.5 / 8.0) - 1.0).abs() < 1e-9);
        }
    }
}

/// Jump of the slope at a point, by differences of second order to both sides.
fn jump(lane: &Slideline<2>, node: usize, u: &[[f64; 2]]) -> f64 {
    let step = 1e-5;
    let at = |x: f64| lane.locate(x, 0).expect("on the wire").displacement(u, 1);
    let towards = |side: f64| {
        let [a, b, c] = [1e-12, 1.0, 2.0].map(|n| at(UNEVEN[node] + n * side * step));
        side * (-3.0 * a + 4.0 * b - c) / (2.0 * step)
    };
    towards(1.0) - towards(-1.0)
}

/// Displacements that turn by 1 and more at every point: chords jump by that.
#[test]
fn slopes_do_not_jump() {
    let zigzag = |n: usize| [0.0, if n.is_multiple_of(2) { 0.4 } else { -0.3 }];
    let u: Vec<[f64; 2]> = (0..UNEVEN.len()).map(zigzag).collect();
    // Rounding, 1e-16 over the step, and the third derivative, 1/ℓ³ of 0.2 m, times the square of
    // the step.
    let rounding = 1e-7;
    let [chords, free] = both(|_| 0.0, &[]);
    let [_, held] = both(|_| 0.0, &[4]);
    for node in 1..UNEVEN.len() - 1 {
        assert!(jump(&free, node, &u).abs() < rounding, "{node}");
        assert!(jump(&chords, node, &u).abs() > 1.0, "{node}");
        assert!(jump(&held, node, &u).abs() < rounding, "{node}");
    }
}

/// Height error of a curve at a corner g, m: it keeps height and slope of the cubic at the next
/// point, a away; the point behind is b away. The slope is (b/(a + b)) (λ/2a) short of g′, and the
/// cubic has 4a/27 of that in between.
fn kept() -> f64 {
    0.5 * radius() * 4.0 / 27.0
}

/// Heights of a corner g* of the chain: the wire has g, on both sides of the point that makes it.
#[test]
fn a_point_that_is_held_has_a_rounded_corner() {
    // Of a thousandth, so that slopes stretch nothing.
    const SIZE: f64 = 1e-3;
    for node in [2, 4, 6] {
        let (at, mean) = (UNEVEN[node], 0.5 * (UNEVEN[node + 1] - UNEVEN[node - 1]));
        let near = || along().filter(|x| (UNEVEN[node - 1]..=UNEVEN[node + 1]).contains(x));
        let points = |x: f64| SIZE * of_chain(mean, x - at);
        let height = |x: f64| SIZE * corner(x - at);
        let [[chords, free], [_, held]] = [both(points, &[]), both(points, &[node])];
        let found = off(&held, near(), height) / SIZE;
        // Difference of wire and chain at the ends of the adjacent elements.
        let apart = [node - 1, node + 1].map(|k| UNEVEN[k] - at);
        let next = apart.map(|s| (corner(s) - of_chain(mean, s)).abs());
        let most = kept() + next[0].max(next[1]);
        assert!(found < most, "{node}: {found} {most}");
        // Height at the point itself: exact except for the tension that follows from unstretched
        // lengths, T/EA.
        let met = off(&held, std::iter::once(at), height) / SIZE;
        assert!(met < stretched(), "{node}: {met}");
        // The corner of the cubic is rounded over elements, and not over λ.
        for other in [chords, free] {
            let missed = off(&other, near(), height) / SIZE;
            assert!(missed > 1.5 * found, "{node}: {missed} {found}");
        }
    }
}

fn elasticity(p: &WireModel<2, 2>, x: &[f64]) -> Vec<f64> {
    let mut still = StaticSolver::new(&p.line).expect("a firm line");
    still
        .elasticity(&p.slidelines, x, 0.0)
        .expect("on the wire")
}

/// Largest difference from the wire, times T, m.
fn wrong(p: &WireModel<2, 2>, exact: impl Fn(f64) -> f64) -> f64 {
    let x: Vec<f64> = (0..80).map(|i| 28.0 + 0.053 * f64::from(i)).collect();
    let apart = x.iter().zip(elasticity(p, &x));
    let apart = apart.map(|(x, found)| WIRE.tension * found - exact(*x));
    peak(&apart.collect::<Vec<_>>())
}

#[test]
fn a_wire_yields_as_a_tensioned_beam_also_between_points() {
    for length in [0.25, 0.5, 1.0, 2.5] {
        let chain = straight(length);
        let h = 1e-3 * length;
        let found = wrong(&explicit(&chain, h), |x| yields(x, x));
        assert!(found < stretched(), "{length}: {found} {}", stretched());
        // In the middle of a chord (g(ℓ) − g(0))/2 is missing.
        let chords = wrong(&angular(&chain, h), |x| yields(x, x));
        let missing = 0.5 * (corner(length) - corner(0.0));
        assert!((chords / missing - 1.0).abs() < 0.2, "{length}: {chords}");
    }
}

/// A spring k at y takes G(x, y)²/(G(y, y) + 1/k) of it.
#[test]
fn so_it_does_beside_a_spring() {
    let (length, at, k) = (0.5, 30.0, 5e5);
    let mut chain = straight(length);
    let mut spring = seen((at / length) as usize, 1);
    spring.stiffness = k;
    chain.0.springs.push(spring);
    let exact = |x: f64| {
        let held = yields(at, at) + WIRE.tension / k;
        yields(x, x) - yields(x, at).powi(2) / held
    };
    let found = wrong(&explicit(&chain, 5e-4), exact);
    // Twice the error of the curve in G(x, y): of the slope that it keeps, and of the height at the
    // next point.
    let most = 2.0 * (kept() + of_chain(length, length) - corner(length));
    assert!(found < most, "{found} {most}");
    let chords = wrong(&angular(&chain, 5e-4), exact);
    assert!(chords > 2.0 * most, "{chords}");
}

/// Heights of the wire at two strips of a standing head.
fn heights(p: WireModel<2, 2>, [first, second]: [f64; 2], forces: [f64; 2]) -> Vec<f64> {
    let begin = SessionStart {
        position: first,
        speed: 0.0,
        friction: 0.0,
    };
    let strips = [0.0, first - second].map(|behind| Collector {
        behind,
        half_width: f64::INFINITY,
    });
    let live = Session::with_forces(Arc::new(p), strips.into(), &forces, begin);
    live.expect("it stands").outputs().height.clone()
}

/// Each strip rises by its own force and by that of the other.
#[test]
fn strips_feel_one_another() {
    let (length, forces) = (1.0, [90.0, 60.0]);
    let chain = straight(length);
    // Strips on one element, on two with a point between them, on two that do not touch; the first
    // ahead and behind.
    for x in [[30.7, 30.2], [30.3, 29.8], [30.9, 28.3], [30.2, 30.7]] {
        let exact = x.map(|at| {
            let by = |k: usize| forces[k] / WIRE.tension * yields(at, x[k]);
            by(0) + by(1)
        });
        let wrong = |p| {
            let found = heights(p, x, forces).into_iter().zip(exact);
            let apart = found.map(|(found, exact)| found - exact);
            peak(&apart.collect::<Vec<_>>())
        };
        let most = stretched() * (forces[0] + forces[1]) / WIRE.tension;
        let found = wrong(explicit(&chain, 1e-3));
        assert!(found < most, "{x:?}: {found:e} {most:e}");
        // The partner misses (g(ℓ) − g(0))/2 of its own force and, where the strips are near, as
        // much of the other.
        let chords = wrong(angular(&chain, 1e-3));
        assert!(chords > 5.0 * most, "{x:?}: {chords:e} {most:e}");
    }
}

const SPEED: f64 = 89.0;
const FORCE: f64 = 200.0;
const PER_ELEMENT: usize = 4;

/// Contact force of a pantograph at 0.7 of the wave speed, over two thirds of a second, N: mean for
/// each part of an element.
fn by_part(p: &WireModel<2, 2>, h: f64) -> [f64; PER_ELEMENT] {
    let travel = way(40.1, SPEED, h, 60.0 / SPEED);
    let force = pass(p, FORCE, &travel, &plan(Vec::new())).force;
    // The transient of the start is slow, and gone after half of the run.
    let late = &force[force.len() / 2 / PER_ELEMENT * PER_ELEMENT..];
    let (whole, _) = late.as_chunks::<PER_ELEMENT>();
    let mean = |k: usize| whole.iter().map(|part| part[k]).sum::<f64>() / whole.len() as f64;
    std::array::from_fn(mean)
}

fn ripple(p: &WireModel<2, 2>, h: f64) -> f64 {
    let parts = by_part(p, h);
    let [low, high] = [f64::min, f64::max].map(|of| parts.into_iter().reduce(of).expect("parts"));
    high - low
}

/// On chords a force passes a corner at every point, and between points the chain lacks
/// (g(ℓ) − g(0))/2T, which the motion multiplies by 1/(1 − v²/c²) = 1.9: a ripple of v/ℓ = 178 Hz
/// for elements of half a metre. A curve lacks 0.4 of that, and R, a value at rest, supplies half
/// of it. The rest remains, with the waves that points send as the force goes from one to the next.
#[test]
fn a_pantograph_at_speed_feels_elements_less() {
    let of = [0.5, 0.25].map(|length| {
        let wire = Single {
            length: 140.0,
            elements: (140.0 / length) as usize,
            gravity: 0.0,
            ..WIRE
        };
        let (structure, path) = wire.structure(2);
        let chain = (lumped(&structure), vec![path]);
        let h = length / SPEED / PER_ELEMENT as f64;
        let found = ripple(&explicit(&chain, h), h);
        let chords = ripple(&angular(&chain, h), h);
        assert!(chords > 2.0 * found, "{length}: {found} {chords}");
        found
    });
    // Half as much for a string, which has no length except ℓ; less here: in shorter elements a
    // corner rounded over λ is closer to a cubic.
    assert!(of[0] > 2.0 * of[1], "{of:?}");
}
