//! The planar line in space, straight or staggered.

use super::SPAN;
use arcless_core::structure::{Structure, Strut};

/// Component 1 becomes component 2, nothing across.
pub fn in_space(s: &Structure) -> Structure {
    let mut t = s.clone();
    t.dim = 3;
    let up = |v: [f64; 3]| [v[0], 0.0, v[1]];
    t.positions
        .iter_mut()
        .chain(&mut t.slopes)
        .for_each(|v| *v = up(*v));
    t.springs.iter_mut().for_each(|p| p.component *= 2);
    t.fixed = s.fixed.iter().map(|&(node, c)| (node, 2 * c)).collect();
    let ends: Vec<usize> = s.fixed.iter().map(|f| f.0).collect();
    t.fixed.extend(ends.iter().map(|&node| (node, 1)));
    t
}

/// Stagger of the contact wire at a support: 0 at both ends of the line, ±`most` by turns between.
fn at_support(number: usize, spans: usize, most: f64) -> f64 {
    match number {
        0 => 0.0,
        k if k >= spans => 0.0,
        k if k % 2 == 1 => most,
        _ => -most,
    }
}

/// Line in space whose contact wire (nodes at height 0) is staggered by ±`most`, m, by arms at the
/// supports.
pub fn staggered(s: &Structure, spans: usize, most: f64) -> Structure {
    let mut t = in_space(s);
    for p in t.positions.iter_mut().filter(|p| p[2] == 0.0) {
        let place = p[0] / SPAN;
        let number = (place + 1e-9).floor();
        let [a, b] = [0, 1].map(|k| at_support(number as usize + k, spans, most));
        p[1] = a + (b - a) * (place - number);
    }
    for number in 1..spans {
        let here = |p: &[f64; 3]| p[2] == 0.0 && (p[0] - number as f64 * SPAN).abs() < 1e-6;
        let node = t.positions.iter().position(here).expect("a support");
        let side = at_support(number, spans, most).signum();
        t.struts.push(Strut {
            node,
            direction: [0.0, side, 0.0],
            anchor: [0.0; 3],
            rest_length: 1.0,
            stiffness: 17e6,
            moving_mass: 0.5,
            hanging_mass: 0.5,
            adjust: true,
        });
    }
    t
}
