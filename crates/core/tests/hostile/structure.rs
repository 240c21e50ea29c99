//! A sound structure from a few decisions, and what is spoilt in it.
//!
//! Two wires, one above the other, with links between them, springs and masses: the same parts as a
//! real line, of few elements. Nodes 2 i lie on the lower wire, nodes 2 i + 1 on the upper one.

use super::feed::Feed;
use arcless_core::structure::Section;
use arcless_core::structure::{
    Bend, Link, PointMass, Rayleigh, Segment, Spring, SpringMode, Structure, Strut, TensionedEnd,
    Wire,
};

const STEP: f64 = 5.0;
const DAMPING: Rayleigh = Rayleigh {
    alpha: 0.0125,
    beta: 1e-4,
};

/// A structure with its lanes: the lower wire, or both.
pub fn structure(feed: &mut Feed<'_>, dim: usize, chain: bool) -> (Structure, Vec<Vec<usize>>) {
    let (elements, upper) = (3 + feed.below(5), !feed.flag());
    let mut s = Structure {
        dim,
        gravity: feed.number(9.81),
        ..Structure::default()
    };
    for i in 0..=elements {
        for height in [0.0, 1.2].into_iter().take(1 + usize::from(upper)) {
            let mut position = [STEP * i as f64, 0.0, 0.0];
            position[dim - 1] = height;
            s.positions.push(position);
            s.slopes.push([1.001, 0.0, 0.0]);
        }
    }
    let mut lanes = Vec::new();
    for wire in 0..=usize::from(upper) {
        lanes.push(add_wire(feed, &mut s, elements, wire, chain));
    }
    add_parts(feed, &mut s, elements, upper);
    if !feed.flag() {
        lanes.truncate(1);
    }
    (s, lanes)
}

/// Elements of a wire, and what holds its ends; returns their numbers.
fn add_wire(
    feed: &mut Feed<'_>,
    s: &mut Structure,
    elements: usize,
    wire: usize,
    chain: bool,
) -> Vec<usize> {
    let stride = s.positions.len() / (elements + 1);
    let node = |i: usize| stride * i + wire;
    let [tension, axial] = [feed.number(20e3), feed.number(15e6)];
    let [bending, mass] = [feed.number(200.0), feed.number(1.35)];
    let rest_length = STEP / (1.0 + tension / axial);
    let first = s.wires.len() + s.segments.len();
    for i in 0..elements {
        let nodes = [node(i), node(i + 1)];
        if chain {
            s.segments.push(Segment {
                nodes,
                rest_length,
                axial_stiffness: axial,
                turn: 0.0,
                mass,
                damping: DAMPING,
                design_tension: tension,
            });
            if i > 0 {
                s.bends.push(Bend {
                    segments: [first + i - 1, first + i],
                    stiffness: bending,
                    beta: 1e-4,
                });
            }
        } else {
            s.wires.push(Wire {
                nodes,
                slope_nodes: nodes,
                section: Section {
                    rest_length,
                    axial_stiffness: axial,
                    bending_stiffness: bending,
                },
                mass,
                turn: 0.0,
                damping: DAMPING,
                design_tension: tension,
            });
        }
    }
    let (dim, last) = (s.dim, node(elements));
    let ends = [node(0), last];
    s.fixed
        .extend(ends.iter().flat_map(|&n| (0..dim).map(move |c| (n, c))));
    s.ends.push(TensionedEnd {
        node: last,
        force: tension,
        released: feed.flag(),
    });
    (first..first + elements).collect()
}

/// Links, springs, masses and loads.
fn add_parts(feed: &mut Feed<'_>, s: &mut Structure, elements: usize, upper: bool) {
    let stride = 1 + usize::from(upper);
    for i in (1..elements).filter(|_| upper) {
        s.links.push(Link {
            nodes: [2 * i + 1, 2 * i],
            rest_length: 1.2,
            stiffness: 2e5,
            viscosity: 0.0,
            damping: DAMPING,
            mass: 0.1,
            unilateral: true,
            adjust: true,
        });
    }
    let node = stride * (elements / 2) + stride - 1;
    s.springs.push(Spring {
        node,
        component: s.dim - 1,
        stiffness: 5e5,
        viscosity: 1e3,
        rest: 0.0,
        mode: SpringMode::Held,
    });
    s.masses.push(PointMass {
        node: stride,
        mass: 0.2,
        alpha: 0.0125,
    });
    if feed.flag() {
        s.loads.push((stride, s.dim - 1, feed.number(10.0)));
        let load = [0.0, feed.number(1.0), feed.number(1.0)];
        s.wire_loads = vec![load; s.wires.len() + s.segments.len()];
    }
    if s.dim == 3 && feed.flag() {
        s.struts.push(Strut {
            node: stride * (elements / 2),
            direction: [0.0, 1.0, 0.0],
            anchor: [0.0; 3],
            rest_length: 1.0,
            stiffness: 17e6,
            moving_mass: 0.3,
            hanging_mass: 0.5,
            adjust: true,
        });
    }
}

/// Every number of a structure.
fn numbers(s: &mut Structure) -> Vec<&mut f64> {
    let mut all = vec![&mut s.gravity];
    let shape = s.positions.iter_mut().chain(&mut s.slopes);
    all.extend(shape.chain(&mut s.wire_loads).flatten());
    for w in &mut s.wires {
        let section = &mut w.section;
        all.extend([&mut section.rest_length, &mut section.axial_stiffness]);
        all.extend([&mut section.bending_stiffness, &mut w.mass]);
        all.extend([&mut w.damping.alpha, &mut w.damping.beta]);
        all.push(&mut w.design_tension);
    }
    for k in &mut s.segments {
        all.extend([&mut k.rest_length, &mut k.axial_stiffness, &mut k.mass]);
        all.extend([&mut k.damping.alpha, &mut k.damping.beta]);
        all.push(&mut k.design_tension);
    }
    for b in &mut s.bends {
        all.extend([&mut b.stiffness, &mut b.beta]);
    }
    for l in &mut s.links {
        all.extend([&mut l.rest_length, &mut l.stiffness, &mut l.viscosity]);
        all.extend([&mut l.damping.alpha, &mut l.damping.beta, &mut l.mass]);
    }
    for t in &mut s.struts {
        all.extend(t.direction.iter_mut().chain(&mut t.anchor));
        all.extend([&mut t.rest_length, &mut t.stiffness]);
        all.extend([&mut t.moving_mass, &mut t.hanging_mass]);
    }
    for p in &mut s.springs {
        all.extend([&mut p.stiffness, &mut p.viscosity, &mut p.rest]);
    }
    for m in &mut s.masses {
        all.extend([&mut m.mass, &mut m.alpha]);
    }
    all.extend(s.ends.iter_mut().map(|e| &mut e.force));
    all.extend(s.loads.iter_mut().map(|l| &mut l.2));
    all
}

/// Every index of a structure.
fn indices(s: &mut Structure) -> Vec<&mut usize> {
    let mut all: Vec<&mut usize> = Vec::new();
    let wires = s.wires.iter_mut();
    all.extend(wires.flat_map(|w| w.nodes.iter_mut().chain(&mut w.slope_nodes)));
    all.extend(s.segments.iter_mut().flat_map(|k| &mut k.nodes));
    all.extend(s.bends.iter_mut().flat_map(|b| &mut b.segments));
    all.extend(s.links.iter_mut().flat_map(|l| &mut l.nodes));
    all.extend(s.struts.iter_mut().map(|t| &mut t.node));
    for p in &mut s.springs {
        all.extend([&mut p.node, &mut p.component]);
    }
    all.extend(s.masses.iter_mut().map(|m| &mut m.node));
    all.extend(s.fixed.iter_mut().flat_map(|(n, c)| [n, c]));
    all.extend(s.ends.iter_mut().map(|e| &mut e.node));
    all.extend(s.loads.iter_mut().flat_map(|(n, c, _)| [n, c]));
    all
}

/// Spoil a number, an index, a flag or the length of a list.
pub fn spoil(feed: &mut Feed<'_>, s: &mut Structure) {
    let nodes = s.positions.len();
    match feed.below(8) {
        0..=2 => {
            let mut all = numbers(s);
            let at = feed.place(all.len());
            feed.spoil(all[at]);
        }
        3 | 4 => {
            let mut all = indices(s);
            let at = feed.place(all.len());
            if let Some(index) = all.get_mut(at) {
                **index = feed.index(nodes);
            }
        }
        5 => spoil_flag(feed, s),
        _ => spoil_length(feed, s),
    }
}

fn spoil_flag(feed: &mut Feed<'_>, s: &mut Structure) {
    let (links, at) = (s.links.len(), feed.byte());
    let one = |n: usize| usize::from(at) % n.max(1);
    match feed.below(6) {
        0 => s.links.iter_mut().for_each(|l| l.unilateral ^= true),
        1 => s.links.iter_mut().for_each(|l| l.adjust ^= true),
        2 if links > 0 => s.links[one(links)].adjust ^= true,
        3 => s.struts.iter_mut().for_each(|t| t.adjust ^= true),
        4 => s.springs.iter_mut().for_each(|p| {
            p.mode = [SpringMode::Given, SpringMode::Unloaded][one(2)];
        }),
        _ => s.dim = usize::from(at) % 5,
    }
}

fn spoil_length(feed: &mut Feed<'_>, s: &mut Structure) {
    match feed.below(13) {
        0 => feed.disturb(&mut s.positions),
        1 => feed.disturb(&mut s.slopes),
        2 => feed.disturb(&mut s.wires),
        3 => feed.disturb(&mut s.segments),
        4 => feed.disturb(&mut s.bends),
        5 => feed.disturb(&mut s.links),
        6 => feed.disturb(&mut s.struts),
        7 => feed.disturb(&mut s.springs),
        8 => feed.disturb(&mut s.masses),
        9 => feed.disturb(&mut s.fixed),
        10 => feed.disturb(&mut s.ends),
        11 => feed.disturb(&mut s.loads),
        _ => feed.disturb(&mut s.wire_loads),
    }
}
