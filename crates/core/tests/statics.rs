//! Static equilibrium against closed forms, and the round trip between its two questions.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::element::hermite;
use arcless_core::statics::{Geometry, Shape};
use arcless_core::structure::{Structure, Strut};
use common::{Single, orders};

const GRAVITY: f64 = 9.81;

const MESSENGER: Single = Single {
    length: 55.0,
    elements: 20,
    mass: 1.08,
    axial: 11.64e6,
    bending: 0.0,
    tension: 16e3,
    gravity: GRAVITY,
};

/// Design calculation and what it completed.
fn designed(s: Structure) -> (Geometry<2, 4>, Shape<4>) {
    let mut g = Geometry::<2, 4>::new(s).expect("a valid structure");
    let shape = g.design().expect("the design converges");
    (g, shape)
}

fn single(s: &Single) -> (Geometry<2, 4>, Shape<4>) {
    designed(s.structure(2).0)
}

/// Stretched slope vector length λ of a wire under tension T with Green's strain:
/// EA ½ (λ² − 1) λ = T, by Newton's method.
fn stretch(tension: f64, axial: f64) -> f64 {
    (0..30).fold(1.0, |l: f64, _| {
        let excess = 0.5 * (l * l - 1.0) * l - tension / axial;
        l - excess / (1.5 * l * l - 0.5)
    })
}

/// Elastic catenary: horizontal force H, weight w per unstretched metre, unstretched length S.
/// Span ∫ λ H/T ds and sag ∫ λ |V|/T ds over one half, V = w s, T² = H² + V².
/// Source: Irvine, Cable Structures (1981), section 1.3, for the material law of this program.
/// Simpson's rule with 2000 intervals on a smooth integrand is exact to rounding.
fn catenary(h: f64, w: f64, s: f64, axial: f64) -> (f64, f64) {
    let n = 2000;
    let step = 0.5 * s / f64::from(n);
    let (mut span, mut sag) = (0.0, 0.0);
    for i in 0..=n {
        let v = w * step * f64::from(i);
        let t = h.hypot(v);
        let simpson = match i {
            0 => 1.0,
            i if i == n => 1.0,
            i => 2.0 + 2.0 * f64::from(i % 2),
        };
        let weight = simpson * step / 3.0 * stretch(t, axial) / t;
        span += 2.0 * weight * h;
        sag += weight * v;
    }
    (span, sag)
}

/// Unstretched length and sag for a given span, by bisection on the length.
fn hanging(s: &Single, w: f64) -> (f64, f64) {
    let (mut low, mut high) = (0.5 * s.length, 2.0 * s.length);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if catenary(s.tension, w, middle, s.axial).0 < s.length {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low, catenary(s.tension, w, low, s.axial).1)
}

fn unstretched(g: &Geometry<2, 4>) -> f64 {
    g.structure
        .wires
        .iter()
        .map(|w| w.section.rest_length)
        .sum()
}

fn sag_and_length(s: &Single) -> (f64, f64) {
    let (g, shape) = single(s);
    (-shape[s.elements / 2][1], unstretched(&g))
}

/// Cubic elements: the sag converges with h⁴.
#[test]
fn hanging_wire_is_the_elastic_catenary() {
    let s = Single {
        tension: 8e3,
        ..MESSENGER
    };
    let (length, sag) = hanging(&s, s.mass * GRAVITY);
    let meshes = [4, 8, 16, 32].map(|elements| sag_and_length(&Single { elements, ..s }));
    let errors = meshes.map(|found| (found.0 - sag).abs());
    // Theory says 4; one tenth for the terms of higher order.
    assert!(orders(&errors)[1..].iter().all(|&p| p > 3.9), "{errors:?}");
    assert!(errors[3] < 1e-9, "{errors:?}");
    // Forces balance to 1e-6 N of EA = 1e7 N: 1e-13 of the length, and 1e-11 m for the sag's share.
    assert!((meshes[3].1 - length).abs() < 1e-10, "{meshes:?}");
    for fault in [
        Single {
            axial: 1.01 * s.axial,
            ..s
        },
        Single {
            tension: 1.01 * s.tension,
            ..s
        },
        Single {
            mass: 1.01 * s.mass,
            ..s
        },
    ] {
        let (wrong_length, wrong_sag) = hanging(&fault, fault.mass * GRAVITY);
        // The partner: 1 % is far more than what the finest mesh leaves.
        assert!((meshes[3].1 - wrong_length).abs() > 1e-4);
        assert!((meshes[3].0 - wrong_sag).abs() > 1e-7);
    }
}

/// Sag w L²/8H of a taut wire. Source: reference-data.md, section 6; the next terms are the stretch
/// −T/EA (the weight is spread over a longer wire) and +(wL/H)²/48 of the catenary.
#[test]
fn taut_wire_hangs_in_a_parabola() {
    let weight = MESSENGER.mass * GRAVITY;
    let parabola = weight * MESSENGER.length.powi(2) / (8.0 * MESSENGER.tension);
    let steepness = weight * MESSENGER.length / MESSENGER.tension;
    let expected = parabola * (1.0 - MESSENGER.stretch() + steepness.powi(2) / 48.0);
    let sag = sag_and_length(&MESSENGER).0;
    // The terms after that are squares and products of 1e-3 and 1e-5.
    assert!((sag / expected - 1.0).abs() < 1e-5, "{sag} {expected}");
    assert!(
        (sag / parabola - 1.0).abs() > 1e-3,
        "the partner: without the stretch"
    );
}

const BEAM: Single = Single {
    length: 10.0,
    elements: 2,
    mass: 1.35,
    axial: 15e6,
    bending: 2e4,
    tension: 22e3,
    gravity: 0.0,
};

/// Deflection under a force at the middle.
fn dip(s: &Single, force: f64) -> f64 {
    let (mut structure, _) = s.structure(2);
    structure.loads.push((s.elements / 2, 1, -force));
    -designed(structure).1[s.elements / 2][1]
}

/// Hinged beam under tension T: w = P L/4T − P tanh(kL/2)/(2 T k), k² = T/EI.
/// Source: Timoshenko, Strength of Materials II, section 5 (direct axial tension).
#[test]
fn beam_under_tension_and_a_point_force() {
    let force = 10.0;
    let exact = |s: &Single| {
        // EI acts per unstretched metre.
        let k = (s.tension * (1.0 + s.stretch()) / s.bending).sqrt();
        force / s.tension * (0.25 * s.length - (0.5 * k * s.length).tanh() / (2.0 * k))
    };
    let errors: Vec<f64> = [2, 4, 8, 16]
        .iter()
        .map(|&elements| {
            let s = Single { elements, ..BEAM };
            dip(&s, force) / exact(&s) - 1.0
        })
        .collect();
    // Theory says 4 once the boundary layer √(EI/T) = 0.95 m is resolved; the last step shows it.
    let slopes = orders(&errors);
    assert!(slopes.is_sorted() && slopes[2] > 3.8, "{slopes:?}");
    assert!(errors[3].abs() < 5e-5, "{errors:?}");
    let finest = dip(
        &Single {
            elements: 16,
            ..BEAM
        },
        force,
    );
    let fault = Single {
        bending: 1.01 * BEAM.bending,
        ..BEAM
    };
    // The partner: 1 % of EI moves the answer by more than the tolerance.
    assert!((finest / exact(&fault) - 1.0).abs() > 1e-3);
}

/// Two straight lines, w = P L/4T. Slopes are continuous at nodes, so the kink under the force is
/// rounded off over an element: the point of the force stays behind by a share of P h/T.
#[test]
fn string_under_a_point_force() {
    let force = 100.0;
    let s = Single {
        bending: 0.0,
        ..BEAM
    };
    let exact = 0.25 * force * s.length / s.tension;
    let errors = [4, 8, 16, 32].map(|elements| exact - dip(&Single { elements, ..s }, force));
    // Theory says 1: the energy of the missing kink is that of one element.
    assert!(orders(&errors).iter().all(|&p| p > 0.99), "{errors:?}");
    let share = errors[3] * s.tension / (force * s.length / 32.0);
    assert!(
        (share - 0.0589).abs() < 1e-4,
        "the constant that decisions about meshes may use: {share}"
    );
    // Partner: one per cent of tension is more than the finest mesh misses.
    assert!((exact / 1.01 - (exact - errors[3])).abs() > 2e-3 * exact);
}

/// Two spans between ends at −s; the node between them is held at +s by a strut.
fn staggered(elements: usize, stagger: f64) -> (Structure, usize) {
    let s = Single {
        length: 110.0,
        elements,
        bending: 0.0,
        ..BEAM
    };
    let (mut structure, _) = s.structure(3);
    let middle = elements / 2;
    for p in &mut structure.positions {
        p[1] = stagger * (1.0 - (p[0] - 55.0).abs() / 27.5);
    }
    structure.struts.push(Strut {
        node: middle,
        direction: [0.0, 1.0, 0.0],
        anchor: [0.0; 3],
        rest_length: 1.0,
        stiffness: 17e6,
        moving_mass: 0.0,
        hanging_mass: 0.0,
        adjust: true,
    });
    (structure, middle)
}

/// Lateral force 2T · 2s/L; vertical stiffness 2T/L of the wire and F/ℓ of the arm.
/// Source: Kiessling et al., Contact Lines for Electric Railways, section 4.1 (radial force).
#[test]
fn strut_carries_the_stagger() {
    let stagger = 0.2;
    let lateral = 2.0 * BEAM.tension * 2.0 * stagger / 55.0;
    let (mut of_force, mut of_stiffness) = (Vec::new(), Vec::new());
    for elements in [20, 40, 80] {
        let (structure, middle) = staggered(elements, stagger);
        let mut g = Geometry::<3, 6>::new(structure).expect("a valid structure");
        let shape = g.design().expect("the design converges");
        let arm = Geometry::<3, 6>::strut_state(&shape, &g.structure.struts[0]);
        assert!(shape[middle][1] == stagger, "the stagger is exact");
        of_force.push((arm.linear_tension / lateral - 1.0).abs());
        let push = 10.0;
        g.structure.loads.push((middle, 2, push));
        let moved = g
            .find_equilibrium(&shape)
            .expect("the equilibrium converges");
        let stiffness = push / (moved[middle][2] - shape[middle][2]);
        let wire = 2.0 * BEAM.tension / 55.0;
        let arm_alone = arm.linear_tension / arm.length;
        assert!(
            (stiffness / wire - 1.0).abs() > 0.3,
            "the partner: the arm counts"
        );
        of_stiffness.push((stiffness / (wire + arm_alone) - 1.0).abs());
    }
    // The kink at the support is rounded off as above, so the order is 1.
    for errors in [of_force, of_stiffness] {
        assert!(orders(&errors).iter().all(|&p| p > 0.95), "{errors:?}");
        assert!(errors[2] < 4e-3, "{errors:?}");
    }
}

fn tensions(g: &Geometry<2, 4>, shape: &Shape<4>) -> Vec<f64> {
    g.structure
        .links
        .iter()
        .map(|l| Geometry::<2, 4>::link_state(shape, l).linear_tension)
        .collect()
}

/// The 55 m line with pre-sag, its contact wire released at the far end.
fn line() -> (Structure, Vec<f64>) {
    let (mut s, _) = common::simple_line(4);
    let presag = |i: usize| -0.01 * (1.0 - ((i % 9) as f64 / 5.0 - 0.8).powi(2));
    let heights: Vec<f64> = (0..s.links.len()).map(presag).collect();
    for (link, &z) in s.links.iter().zip(&heights) {
        s.positions[link.nodes[1]][1] = z;
    }
    s.ends.iter_mut().for_each(|e| e.released = true);
    (s, heights)
}

#[test]
fn settling_after_the_design_moves_nothing() {
    let (structure, heights) = line();
    let drawn: Vec<f64> = structure.positions.iter().map(|p| p[0]).collect();
    let (g, shape) = designed(structure);
    let moved = g
        .find_equilibrium(&shape)
        .expect("the equilibrium converges");
    let largest = shape
        .iter()
        .flatten()
        .zip(moved.iter().flatten())
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    // Forces balance to 5e-6 N in the design; over the softest stiffness (100 N/m) that is 5e-8 m.
    assert!(largest < 1e-7, "{largest:e}");
    for (link, z) in g.structure.links.iter().zip(&heights) {
        assert!(shape[link.nodes[1]][1] == *z, "heights of links are exact");
    }
    let along = shape
        .iter()
        .zip(&drawn)
        .map(|(r, x)| (r[0] - x).abs())
        .fold(0.0, f64::max);
    assert!(along < 1e-9, "nodes stand where they were drawn");
    // Partner: one dropper one per cent too long.
    let mut fault = g.clone();
    fault.structure.links[12].rest_length *= 1.01;
    let moved = fault
        .find_equilibrium(&shape)
        .expect("the equilibrium converges");
    let node = fault.structure.links[12].nodes[1];
    assert!(shape[node][1] - moved[node][1] > 1e-3);
}

#[test]
fn tension_at_a_released_end_is_exact() {
    let (g, shape) = designed(line().0);
    for perturbed in [false, true] {
        let mut g = g.clone();
        if perturbed {
            // A changed dropper, of which the tension must be independent.
            g.structure.links[12].rest_length += 0.01;
        }
        let shape = g
            .find_equilibrium(&shape)
            .expect("the equilibrium converges");
        for end in &g.structure.ends {
            let wire = g
                .structure
                .wires
                .iter()
                .find(|w| w.nodes[1] == end.node)
                .expect("a wire ends there");
            let mut force = [[0.0; 2]; 4];
            hermite::add_force(
                &wire.section,
                &Geometry::<2, 4>::coordinates(&shape, wire),
                &mut force,
            );
            assert!((force[2][0] - end.force).abs() <= g.force_rounding());
            assert!((force[2][0] - 1.01 * end.force).abs() > 100.0);
        }
    }
}

#[test]
fn link_that_would_have_to_push_is_refused() {
    let (mut s, _) = line();
    s.positions[s.links[13].nodes[1]][1] = -0.08;
    let mut g = Geometry::<2, 4>::new(s).expect("a valid structure");
    match g.design() {
        Err(CoreError::PushingLink { link, force }) => assert!(link == 13 && force < 0.0),
        other => panic!("expected a pushing link, found {other:?}"),
    }
}

#[test]
fn too_long_link_is_slack_and_its_neighbours_carry() {
    let (mut g, shape) = designed(line().0);
    let before = tensions(&g, &shape);
    g.structure.links[13].rest_length += 0.1;
    let settled = g
        .find_equilibrium(&shape)
        .expect("the equilibrium converges");
    let after = tensions(&g, &settled);
    assert!(after[13] < 0.0, "the linear law would push");
    // A taut wire hands the share on to the two neighbours.
    let gained = after[12] + after[14] - before[12] - before[14];
    assert!((gained / before[13] - 1.0).abs() < 0.05, "{gained}");
    // Partner: the next but one feel less than one per cent of it.
    assert!((after[11] - before[11]).abs() < 0.01 * before[13]);
}
