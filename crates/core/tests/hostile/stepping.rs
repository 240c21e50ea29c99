//! Runs over a prepared line, in one piece or stopped and resumed from a spoilt state.

use super::feed::Feed;
use super::finite::check;
use super::{motion, pantographs};
use arcless_core::CoreError;
use arcless_core::checkpoint::Checkpoint;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::simulation::run::Part;

pub fn run<const DIM: usize, const D: usize>(
    feed: &mut Feed<'_>,
    p: &WireModel<DIM, D>,
) -> Result<(), CoreError> {
    let (count, nodes) = (1 + feed.below(2), p.line.nodes());
    let mut travel = motion::travel(feed, count, nodes);
    let instants = travel.positions.len();
    let mut found: Vec<Pantograph> = (0..count)
        .map(|_| pantographs::pantograph(feed, instants))
        .collect();
    let plan = motion::plan(feed, nodes);
    for _ in 0..feed.below(4) {
        match feed.below(3) {
            0 => motion::spoil(feed, &mut travel),
            _ => pantographs::spoil(feed, &mut found[0]),
        }
    }
    let answer = feed.number(20.0);
    let mut ask = |_: usize, _: &_| Ok(answer);
    let mut part = |from: Option<&Checkpoint>, until: Option<usize>| {
        let (mut go_on, part) = (|_: usize| true, Part { from, until });
        p.run_part(&found, &travel, &plan, part, &mut go_on, &mut ask)
    };
    let cut = feed.below(instants);
    if cut == 0 {
        check(&part(None, None)?.0);
        return Ok(());
    }
    let (record, mut state) = part(None, Some(cut))?;
    check(&record);
    for _ in 0..feed.below(3) {
        spoil(feed, &mut state);
    }
    check(&part(Some(&state), None)?.0);
    Ok(())
}

/// Spoil a number, the length or the name of a list, or the number of steps.
fn spoil(feed: &mut Feed<'_>, state: &mut Checkpoint) {
    let at = feed.place(state.numbers.len());
    let name = state.numbers.keys().nth(at).cloned().unwrap_or_default();
    let list = state.numbers.entry(name.clone()).or_default();
    match feed.below(8) {
        0..=4 => {
            let at = feed.place(list.len());
            if let Some(number) = list.get_mut(at) {
                feed.spoil(number);
            }
        }
        5 => feed.disturb(list),
        6 => drop(state.numbers.remove(&name)),
        _ => state.step = feed.index(state.step),
    }
}
