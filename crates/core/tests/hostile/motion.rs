//! Scheme, travel and what is recorded, from a few decisions.

use super::feed::Feed;
use arcless_core::linear::loads::Load;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::RecordPlan;

/// Instants of a run at most; short, so that many runs fit into a minute.
const MOST_INSTANTS: usize = 24;

pub fn scheme(feed: &mut Feed<'_>) -> Scheme {
    match feed.below(5) {
        0 => Scheme::generalised_alpha(feed.number(0.8)),
        1 => Scheme::hht(feed.number(0.1)),
        2 => Scheme::newmark(feed.number(0.25), feed.number(0.5)),
        3 => Scheme::generalised_alpha(1.0),
        _ => Scheme::BackwardDifference,
    }
}

/// Motion of pantographs over a line of the given number of nodes.
pub fn travel(feed: &mut Feed<'_>, pantographs: usize, nodes: usize) -> Trajectory {
    let instants = 2 + feed.below(MOST_INSTANTS - 1);
    let (start, speed) = (feed.number(4.0), feed.number(50.0));
    let mut travel = Trajectory {
        positions: (0..instants)
            .map(|i| start + 1e-3 * speed * i as f64)
            .collect(),
        speeds: vec![speed; instants],
        distances: (0..pantographs).map(|j| -3.0 * j as f64).collect(),
        friction: 0.0,
        loads: Vec::new(),
    };
    if feed.flag() {
        travel.friction = feed.number(0.2);
        travel.loads.push(Load {
            pattern: vec![(feed.index(nodes), feed.below(3), feed.number(1.0))],
            sizes: vec![1.0; instants],
        });
    }
    travel
}

/// Spoil a number or the length of a list.
pub fn spoil(feed: &mut Feed<'_>, t: &mut Trajectory) {
    let list = [&mut t.positions, &mut t.speeds, &mut t.distances];
    let list = list.into_iter().nth(feed.below(3)).into_iter().flatten();
    let mut all: Vec<&mut f64> = list.collect();
    let at = feed.place(all.len());
    match feed.below(4) {
        0 => feed.disturb(&mut t.positions),
        1 => feed.disturb(&mut t.distances),
        _ if all.is_empty() => (),
        _ => feed.spoil(all[at]),
    }
}

pub fn plan(feed: &mut Feed<'_>, nodes: usize) -> RecordPlan {
    let is_usual = !feed.flag();
    let mut plan = RecordPlan {
        contact_every: 1,
        line_every: 1,
        links: true,
        nodes: vec![1],
        supports: Vec::new(),
        points: vec![4.0],
        ledger: feed.flag(),
        ledger_every: 1,
        near: None,
        motion: None,
    };
    if !is_usual {
        (plan.contact_every, plan.line_every) = (feed.index(3), feed.index(3));
        plan.nodes = vec![feed.index(nodes)];
        plan.points = vec![feed.number(4.0)];
    }
    plan
}
