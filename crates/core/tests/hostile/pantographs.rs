//! Sound pantographs from a few decisions, and what is spoilt in them.

use super::feed::Feed;
use arcless_core::pantograph::actuator::Actuator;
use arcless_core::pantograph::breakpoint::ForceKind;
use arcless_core::pantograph::bump_stop::BumpStop;
use arcless_core::pantograph::excitation::{BaseMotion, Excitation, ForceHistory};
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::piecewise_force::PiecewiseForce;
use arcless_core::pantograph::strip::Strip;

/// Chains of one to three masses with one or two strips, for a run of so many instants.
pub fn pantograph(feed: &mut Feed<'_>, instants: usize) -> Pantograph {
    let n = 1 + feed.below(3);
    let mut pantograph = Pantograph {
        mass: diagonal(n, feed.number(7.0)),
        damping: diagonal(n, feed.number(50.0)),
        stiffness: chain(n, feed.number(7e3)),
        strips: vec![Strip::plain(last(n))],
        preload: first(n),
        lift: vec![0.0; n],
        start_force: feed.number(100.0),
        excitation: Excitation::default(),
        stops: Vec::new(),
        piecewise_forces: Vec::new(),
        actuator: None,
        is_external: false,
    };
    let extras = feed.byte();
    if extras & 1 != 0 {
        add_strips(feed, &mut pantograph, n);
    }
    if extras & 2 != 0 {
        pantograph.excitation = given(feed, n, instants);
    }
    if extras & 4 != 0 {
        pantograph.stops.push(BumpStop {
            direction: first(n),
            gap: feed.number(0.01),
            stiffness: [1e5, f64::INFINITY][feed.below(2)],
        });
    }
    if extras & 8 != 0 {
        pantograph.piecewise_forces.push(law(feed, n));
    }
    if extras & 16 != 0 {
        pantograph.actuator = Some(Actuator {
            direction: first(n),
            every: feed.index(3),
            delay: feed.index(3),
        });
    }
    pantograph
}

fn diagonal(n: usize, value: f64) -> Vec<f64> {
    let entry = |k: usize| if k.is_multiple_of(n + 1) { value } else { 0.0 };
    (0..n * n).map(entry).collect()
}

/// Springs between the masses, and a soft one to the ground.
fn chain(n: usize, k: f64) -> Vec<f64> {
    let mut all = vec![0.0; n * n];
    all[0] = 0.01 * k;
    for i in 1..n {
        all[i * n + i] += k;
        all[(i - 1) * n + i - 1] += k;
        all[i * n + i - 1] -= k;
        all[(i - 1) * n + i] -= k;
    }
    all
}

fn first(n: usize) -> Vec<f64> {
    (0..n).map(|i| if i == 0 { 1.0 } else { 0.0 }).collect()
}

fn last(n: usize) -> Vec<f64> {
    (0..n).map(|i| if i + 1 == n { 1.0 } else { 0.0 }).collect()
}

fn add_strips(feed: &mut Feed<'_>, pantograph: &mut Pantograph, n: usize) {
    let half_width = feed.number(0.8);
    pantograph.strips[0].half_width = half_width;
    pantograph.strips.push(Strip {
        offset: feed.number(0.5),
        half_width,
        knots: vec![-half_width, half_width],
        vectors: vec![last(n), last(n)],
    });
}

fn given(feed: &mut Feed<'_>, n: usize, instants: usize) -> Excitation {
    let values = vec![feed.number(10.0); instants];
    let ground = BaseMotion {
        influence: vec![1.0; n],
        displacement: vec![feed.number(0.01); instants],
        rate: vec![0.0; instants],
    };
    Excitation {
        forces: vec![ForceHistory {
            direction: last(n),
            values,
        }],
        base: feed.flag().then_some(ground),
    }
}

/// A table that hardens or softens.
fn law(feed: &mut Feed<'_>, n: usize) -> PiecewiseForce {
    let mut points = vec![[-0.5, -50.0], [-0.1, -10.0], [0.1, 10.0], [0.5, 20.0]];
    points[0][1] = feed.number(-50.0);
    points[3][1] = feed.number(20.0);
    PiecewiseForce {
        direction: last(n),
        kind: [ForceKind::Spring, ForceKind::Damper][feed.below(2)],
        points,
    }
}

/// Every number of a pantograph.
fn numbers(r: &mut Pantograph) -> Vec<&mut f64> {
    let mut all = vec![&mut r.start_force];
    all.extend(r.mass.iter_mut().chain(&mut r.damping));
    all.extend(r.stiffness.iter_mut().chain(&mut r.preload));
    all.extend(&mut r.lift);
    for strip in &mut r.strips {
        all.extend([&mut strip.offset, &mut strip.half_width]);
        all.extend(&mut strip.knots);
        all.extend(strip.vectors.iter_mut().flatten());
    }
    for force in &mut r.excitation.forces {
        all.extend(force.direction.iter_mut().chain(&mut force.values));
    }
    if let Some(ground) = &mut r.excitation.base {
        all.extend(ground.influence.iter_mut().chain(&mut ground.displacement));
        all.extend(&mut ground.rate);
    }
    for stop in &mut r.stops {
        all.extend([&mut stop.gap, &mut stop.stiffness]);
        all.extend(&mut stop.direction);
    }
    for law in &mut r.piecewise_forces {
        all.extend(&mut law.direction);
        all.extend(law.points.iter_mut().flatten());
    }
    all.extend(r.actuator.iter_mut().flat_map(|a| &mut a.direction));
    all
}

/// Spoil a number or the length of a list.
pub fn spoil(feed: &mut Feed<'_>, r: &mut Pantograph) {
    match feed.below(16) {
        0..=8 => {
            let mut all = numbers(r);
            let at = feed.place(all.len());
            feed.spoil(all[at]);
        }
        9 => feed.disturb(&mut r.strips),
        10 => feed.disturb(&mut r.stops),
        11 => feed.disturb(&mut r.piecewise_forces),
        12 => {
            let which = feed.below(3);
            feed.disturb([&mut r.mass, &mut r.preload, &mut r.lift][which]);
        }
        13 => r.strips.iter_mut().for_each(|s| feed.disturb(&mut s.knots)),
        14 => r
            .piecewise_forces
            .iter_mut()
            .for_each(|l| feed.disturb(&mut l.points)),
        _ => r
            .excitation
            .forces
            .iter_mut()
            .for_each(|f| feed.disturb(&mut f.values)),
    }
}
