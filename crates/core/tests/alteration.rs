//! Changes after the design, against closed forms of a single wire, for both models of wires.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::statics::assembly::LinkLaw;
use arcless_core::statics::{Alteration, Shape};
use arcless_core::structure::Structure;
use common::Single;
use common::chain::{lumped, settled};

const GRAVITY: f64 = 9.81;
const EXPANSION: f64 = 17e-6;

const WIRE: Single = Single {
    length: 55.0,
    elements: 40,
    mass: 1.08,
    axial: 11.64e6,
    bending: 0.0,
    tension: 16e3,
    gravity: GRAVITY,
};

/// Nothing is changed.
fn unchanged(s: &Structure) -> Alteration {
    let elements = s.wires.len() + s.segments.len();
    let wires = s.wires.iter().map(|w| w.mass);
    Alteration {
        length_factor: vec![1.0; elements],
        axial_factor: vec![1.0; elements],
        bending_factor: vec![1.0; s.wires.len() + s.bends.len()],
        mass: wires.chain(s.segments.iter().map(|k| k.mass)).collect(),
        load: vec![[0.0; 3]; elements],
        link_factor: vec![1.0; s.links.len()],
        link_offset: vec![0.0; s.links.len()],
        spring_offset: vec![0.0; s.springs.len()],
        strut_offset: vec![0.0; s.struts.len()],
        end_force: s
            .ends
            .iter()
            .map(|e| e.released.then_some(e.force))
            .collect(),
        removed: Vec::new(),
    }
}

/// State of a wire after a change: horizontal force at its first end in N, position of its middle
/// and of its last node in m.
struct Seen {
    force: f64,
    middle: [f64; 3],
    end: f64,
}

fn seen<const DIM: usize, const D: usize>(s: Structure, change: &Alteration) -> Seen {
    let (geometry, shape) = settled::<DIM, D>(s);
    let (geometry, shape) = geometry.altered(&shape, change).expect("it settles");
    let mut residual: Shape<D> = vec![[0.0; D]; shape.len()];
    geometry.service_residual(&shape, LinkLaw::Unilateral, &mut residual);
    let last = shape.len() - 1;
    let mut middle = [0.0; 3];
    middle[..DIM].copy_from_slice(&shape[last / 2][..DIM]);
    Seen {
        force: -residual[0][0],
        middle,
        end: shape[last][0],
    }
}

/// State after a change: of a wire of Hermite elements, and of a chain of the same wire.
fn both(wire: &Single, released: bool, change: impl Fn(&mut Alteration)) -> [Seen; 2] {
    let mut s = wire.structure(2).0;
    s.ends[0].released = released;
    let chain = lumped(&s);
    let [mut of_wire, mut of_chain] = [unchanged(&s), unchanged(&chain)];
    change(&mut of_wire);
    change(&mut of_chain);
    [seen::<2, 4>(s, &of_wire), seen::<2, 2>(chain, &of_chain)]
}

/// Change-of-state equation of a shallow wire between fixed ends, by bisection:
/// (T₁ − T₀)/EA + α ΔT = (w₁²/T₁² − w₀²/T₀²) L²/24.
/// It says that the unstretched length S = (L + w²L³/24T²)/(1 + T/EA) grows by α ΔT alone.
fn change_of_state(wire: &Single, strain: f64, load: f64) -> f64 {
    let sag = |w: f64, t: f64| (w * wire.length / t).powi(2) / 24.0;
    let before = sag(wire.mass * GRAVITY, wire.tension);
    let excess = |t: f64| (t - wire.tension) / wire.axial + strain - sag(load, t) + before;
    let (mut low, mut high) = (1.0, 1e6);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[test]
fn fixed_ends_follow_the_change_of_state_equation() {
    for (warmer, ice) in [(40.0, 0.0), (-30.0, 0.0), (0.0, 2.0), (20.0, 1.0)] {
        let strain = EXPANSION * warmer;
        let load = (WIRE.mass + ice) * GRAVITY;
        let tension = change_of_state(&WIRE, strain, load);
        let found = both(&WIRE, false, |change| {
            change.length_factor.fill(1.0 + strain);
            change.mass.fill(WIRE.mass + ice);
        });
        for at in found {
            // Neglected in the equation: terms of the strain, 2e-3, and of the square of the slope,
            // 2e-3 with ice; Green's strain raises EA by three strains.
            assert!(
                (at.force / tension - 1.0).abs() < 5e-3,
                "{} {tension}",
                at.force
            );
            let sag = load * WIRE.length.powi(2) / (8.0 * tension);
            assert!(
                (-at.middle[1] / sag - 1.0).abs() < 7e-3,
                "{} {sag}",
                at.middle[1]
            );
            // The partner: a wire that keeps its tension.
            assert!((at.force / WIRE.tension - 1.0).abs() > 0.05);
        }
    }
}

#[test]
fn an_end_under_constant_force_travels_and_keeps_the_tension() {
    let straight = Single {
        gravity: 0.0,
        ..WIRE
    };
    let strain = EXPANSION * 40.0;
    let [free, free_chain] = both(&straight, true, |c| c.length_factor.fill(1.0 + strain));
    for at in [free, free_chain] {
        // A straight wire under constant force only lengthens: exact to rounding. A relative
        // rounding ε of x changes the force by EA ε x/L, N.
        assert!((at.end - WIRE.length * (1.0 + strain)).abs() < 1e-9);
        assert!((at.force - WIRE.tension).abs() < 1e-3);
    }
    let [held, held_chain] = both(&straight, false, |c| c.length_factor.fill(1.0 + strain));
    for at in [held, held_chain] {
        assert_eq!(at.end, WIRE.length, "the partner stays");
        assert!(
            at.force < 0.6 * WIRE.tension,
            "and loses tension: {}",
            at.force
        );
    }
}

#[test]
fn ends_are_freed_under_another_force_and_held_where_they_were() {
    for share in [0.97, 1.0 / 0.97] {
        let tension = share * WIRE.tension;
        let found = both(&WIRE, false, |change| {
            change.end_force = vec![Some(tension)]
        });
        let weight = WIRE.mass * GRAVITY * WIRE.length;
        let sag = |t: f64| (weight / t).powi(2) / 24.0;
        let strain = (tension - WIRE.tension) / WIRE.axial - sag(tension) + sag(WIRE.tension);
        for at in found {
            // Force of the tensioning device, to the tolerance of the statics.
            assert!((at.force / tension - 1.0).abs() < 1e-9, "{}", at.force);
            let way = at.end - WIRE.length;
            // Green's strain, 1.4e-3, makes EA stiffer by three times that.
            assert!((way / (strain * WIRE.length) - 1.0).abs() < 6e-3, "{way}");
        }
    }
    let warmer = 1.0 + EXPANSION * 40.0;
    let [fixed, held] = [false, true].map(|released| {
        both(&WIRE, released, |change| {
            change.length_factor.fill(warmer);
            change.end_force = vec![None];
        })
    });
    for (fixed, held) in fixed.iter().zip(&held) {
        assert_eq!((fixed.force, fixed.end), (held.force, held.end));
    }
}

#[test]
fn a_side_load_blows_the_wire_off_by_a_parabola() {
    let (across, up) = (20.0, 1.5);
    let blown = |released: bool| {
        let mut s = WIRE.structure(3).0;
        s.ends[0].released = released;
        let chain = lumped(&s);
        let load = |s: &Structure| Alteration {
            load: vec![[0.0, across, up]; WIRE.elements],
            ..unchanged(s)
        };
        let [first, second] = [load(&s), load(&chain)];
        [seen::<3, 6>(s, &first), seen::<3, 3>(chain, &second)]
    };
    let parabola = |force: f64| force * WIRE.length.powi(2) / (8.0 * WIRE.tension);
    for at in blown(true) {
        // Loads act per metre of the unstretched wire, which is stretched by 1.4e-3; squares of
        // slopes: 1.2e-3.
        assert!(
            (at.middle[1] / parabola(across) - 1.0).abs() < 4e-3,
            "{:?}",
            at.middle
        );
        // Tolerance as above.
        let weight = WIRE.mass * GRAVITY - up;
        assert!((-at.middle[2] / parabola(weight) - 1.0).abs() < 4e-3);
    }
    for at in blown(false) {
        // The partner: between fixed ends the load raises the tension, here by 10 %.
        assert!(
            (at.middle[1] / parabola(across) - 1.0).abs() > 5e-2,
            "{:?}",
            at.middle
        );
    }
}

#[test]
fn a_worn_stretch_yields_more() {
    // Half of the elements lose a fifth of EA. Springs in series: the end travels by
    // ½ (1/0.8 − 1) T L/EA.
    let straight = Single {
        gravity: 0.0,
        ..WIRE
    };
    let found = both(&straight, true, |c| {
        c.axial_factor[..WIRE.elements / 2].fill(0.8);
    });
    let travel = 0.125 * WIRE.tension * WIRE.length / WIRE.axial;
    for at in found {
        // Green's strain of 1.4e-3 to 1.7e-3 makes EA stiffer by 3 strains, and the formula counts
        // the wire as long as it is stretched.
        let error = (at.end - WIRE.length) / travel - 1.0;
        assert!(error.abs() < 1e-2, "{error}");
    }
}

#[test]
fn no_change_moves_nothing() {
    let s = WIRE.structure(2).0;
    let change = unchanged(&s);
    let (geometry, shape) = settled::<2, 4>(s);
    let (_, after) = geometry.altered(&shape, &change).expect("it settles");
    assert_eq!(shape, after, "not one bit");
}

#[test]
fn a_large_change_is_put_on_in_parts() {
    // From a taut wire to one that is 5 % too long and carries 40 times its weight.
    let found = both(&WIRE, false, |change| {
        change.length_factor.fill(1.05);
        change.mass.fill(40.0 * WIRE.mass);
    });
    // A parabola 5 % longer than its span: sag = L √(3/8 · 0.05) and a trifle of stretch.
    let sag = WIRE.length * (0.375_f64 * 0.05).sqrt();
    for at in found {
        assert!(
            (-at.middle[1] / sag - 1.0).abs() < 0.05,
            "{} {sag}",
            at.middle[1]
        );
    }
}

#[test]
fn lists_that_do_not_fit_are_refused() {
    let s = WIRE.structure(2).0;
    let right = unchanged(&s);
    let (geometry, shape) = settled::<2, 4>(s);
    let refused = |wrong: Alteration| match geometry.altered(&shape, &wrong) {
        Err(CoreError::Input { array, .. }) => array,
        other => panic!("accepted: {:?}", other.map(|_| ())),
    };
    let short = vec![1.0; 3];
    let list = |change: &dyn Fn(&mut Alteration)| {
        let mut wrong = right.clone();
        change(&mut wrong);
        refused(wrong)
    };
    assert_eq!(list(&|c| c.length_factor = short.clone()), "length_factor");
    assert_eq!(list(&|c| c.mass = short.clone()), "mass");
    assert_eq!(list(&|c| c.load = vec![[0.0; 3]; 2]), "load");
    assert_eq!(list(&|c| c.removed = vec![0]), "removed");
    assert_eq!(list(&|c| c.link_offset = short.clone()), "link_offset");
    assert_eq!(list(&|c| c.spring_offset = short.clone()), "spring_offset");
    assert_eq!(list(&|c| c.strut_offset = short.clone()), "strut_offset");
    assert_eq!(list(&|c| c.end_force = vec![None; 3]), "end_force");
    assert_eq!(list(&|c| c.end_force[0] = Some(f64::NAN)), "ends");
    assert_eq!(list(&|c| c.mass[2] = -1.0), "wires");
    assert_eq!(list(&|c| c.load[0][1] = f64::NAN), "wire_loads");
}
