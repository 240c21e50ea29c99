//! Check of structures: arrays that contradict each other are refused before any arithmetic.

use crate::error::CoreError;
use crate::structure::Structure;

/// Largest number of nodes accepted: indices are stored in 32 bits.
const MOST_NODES: usize = 1 << 30;

/// Largest turn of the track along an element, rad: a metre or two on the tightest curves turn by a
/// tenth of it.
const MOST_TURN: f64 = 1.0;

fn positive(v: f64) -> bool {
    v.is_finite() && v > 0.0
}

fn not_negative(v: f64) -> bool {
    v.is_finite() && v >= 0.0
}

/// Checks indices, signs and finiteness. Nodes have `slots` vectors: a position, and a slope or
/// not.
///
/// # Errors
/// [`CoreError::Input`] naming the array.
pub fn check(s: &Structure, dim: usize, slots: usize) -> Result<(), CoreError> {
    let n = s.positions.len();
    if s.dim != dim {
        return Err(CoreError::invalid(
            "dim",
            format!("is {}, expected {dim}", s.dim),
        ));
    }
    if !(2..=MOST_NODES).contains(&n) || s.slopes.len() != n {
        return Err(CoreError::invalid(
            "positions",
            format!("{n} nodes and {} slopes", s.slopes.len()),
        ));
    }
    if s.positions
        .iter()
        .chain(&s.slopes)
        .flatten()
        .any(|v| !v.is_finite())
    {
        return Err(CoreError::invalid("positions", "not finite"));
    }
    check_model(s, slots)?;
    check_wires(s, n)?;
    check_chains(s, n)?;
    check_links(s, n)?;
    check_points(s, n, dim)?;
    if !s.gravity.is_finite() || s.gravity < 0.0 {
        return Err(CoreError::invalid("gravity", format!("is {}", s.gravity)));
    }
    let mut on_wire = vec![false; n];
    s.wires
        .iter()
        .flat_map(|w| w.coordinate_slots())
        .map(|(i, _)| i)
        .chain(s.segments.iter().flat_map(|k| k.nodes))
        .for_each(|i| on_wire[i] = true);
    match on_wire.iter().position(|on| !on) {
        Some(i) => Err(CoreError::invalid(
            "wires",
            format!("node {i} lies on no wire"),
        )),
        None => Ok(()),
    }
}

/// Checks that all wires of a structure are of one model.
fn check_model(s: &Structure, slots: usize) -> Result<(), CoreError> {
    if slots == 1 && !s.wires.is_empty() {
        let reason = "Hermite elements need nodes with slopes";
        return Err(CoreError::invalid("wires", reason));
    }
    if slots == 2 && !(s.segments.is_empty() && s.bends.is_empty()) {
        let reason = "chains of point masses do not mix with Hermite elements";
        return Err(CoreError::invalid("segments", reason));
    }
    Ok(())
}

fn check_wires(s: &Structure, n: usize) -> Result<(), CoreError> {
    for (i, w) in s.wires.iter().enumerate() {
        let inside = w.coordinate_slots().iter().all(|&(node, _)| node < n);
        let nodes = inside && w.nodes[0] != w.nodes[1];
        let section = positive(w.section.rest_length)
            && positive(w.section.axial_stiffness)
            && not_negative(w.section.bending_stiffness);
        let damping = not_negative(w.damping.alpha) && not_negative(w.damping.beta);
        // A wire without tension must resist bending, or nothing holds it up.
        let stiff = w.section.bending_stiffness > 0.0;
        let held = positive(w.design_tension) || (w.design_tension == 0.0 && stiff);
        let loaded = positive(w.mass) && held;
        if !(nodes && section && damping && loaded) {
            return Err(CoreError::invalid(
                "wires",
                format!("element {i} is impossible: {w:?}"),
            ));
        }
    }
    Ok(())
}

fn check_chains(s: &Structure, n: usize) -> Result<(), CoreError> {
    for (i, k) in s.segments.iter().enumerate() {
        let nodes = k.nodes[0] < n && k.nodes[1] < n && k.nodes[0] != k.nodes[1];
        let sizes = [k.rest_length, k.axial_stiffness, k.mass];
        let damping = not_negative(k.damping.alpha) && not_negative(k.damping.beta);
        let damping = damping && not_negative(k.design_tension);
        if !(nodes && damping && sizes.into_iter().all(positive)) {
            let reason = format!("segment {i} is impossible: {k:?}");
            return Err(CoreError::invalid("segments", reason));
        }
    }
    for (i, b) in s.bends.iter().enumerate() {
        let follow = match b.segments.map(|k| s.segments.get(k)) {
            [Some(p), Some(q)] => p.nodes[1] == q.nodes[0] && p.nodes[0] != q.nodes[1],
            _ => false,
        };
        if !(follow && not_negative(b.stiffness) && not_negative(b.beta)) {
            return Err(CoreError::invalid(
                "bends",
                format!("bend {i} is impossible: {b:?}"),
            ));
        }
    }
    Ok(())
}

fn check_links(s: &Structure, n: usize) -> Result<(), CoreError> {
    for (i, l) in s.links.iter().enumerate() {
        let nodes = l.nodes[0] < n && l.nodes[1] < n && l.nodes[0] != l.nodes[1];
        // Only links that pull at rest can be slack, or be given a length by their tension.
        let damper = l.stiffness == 0.0 && !l.unilateral && !l.adjust;
        let numbers = (positive(l.stiffness) || damper) && l.rest_length.is_finite();
        let damping = not_negative(l.viscosity)
            && not_negative(l.damping.alpha)
            && not_negative(l.damping.beta);
        if !(nodes && numbers && damping && not_negative(l.mass)) {
            return Err(CoreError::invalid(
                "links",
                format!("link {i} is impossible: {l:?}"),
            ));
        }
    }
    Ok(())
}

fn check_points(s: &Structure, n: usize, dim: usize) -> Result<(), CoreError> {
    for (i, t) in s.struts.iter().enumerate() {
        let numbers = t.direction.iter().chain(&t.anchor).all(|v| v.is_finite());
        let masses = not_negative(t.moving_mass) && not_negative(t.hanging_mass);
        let signs = positive(t.stiffness) && positive(t.rest_length) && masses;
        if t.node >= n || dim != 3 || !numbers || !signs || t.direction[1] == 0.0 {
            return Err(CoreError::invalid(
                "struts",
                format!("strut {i} is impossible: {t:?}"),
            ));
        }
    }
    for (i, p) in s.springs.iter().enumerate() {
        let signs = positive(p.stiffness) && not_negative(p.viscosity) && p.rest.is_finite();
        if p.node >= n || p.component >= dim || !signs {
            return Err(CoreError::invalid(
                "springs",
                format!("spring {i} is impossible: {p:?}"),
            ));
        }
    }
    if s.masses
        .iter()
        .any(|m| m.node >= n || !not_negative(m.mass) || !not_negative(m.alpha))
    {
        return Err(CoreError::invalid(
            "masses",
            "node out of range or mass negative",
        ));
    }
    if s.fixed.iter().any(|&(node, c)| node >= n || c >= dim) {
        return Err(CoreError::invalid(
            "fixed",
            "node or component out of range",
        ));
    }
    if s.ends.iter().any(|e| e.node >= n || !e.force.is_finite()) {
        return Err(CoreError::invalid(
            "ends",
            "node out of range or force not finite",
        ));
    }
    check_wire_loads(s)?;
    check_turns(s)?;
    if s.loads
        .iter()
        .any(|&(node, c, f)| node >= n || c >= dim || !f.is_finite())
    {
        return Err(CoreError::invalid(
            "loads",
            "node or component out of range or force not finite",
        ));
    }
    Ok(())
}

/// Checks that the track turns by little along each element.
fn check_turns(s: &Structure) -> Result<(), CoreError> {
    let turns = s.wires.iter().map(|wire| wire.turn);
    let mut turns = turns.chain(s.segments.iter().map(|segment| segment.turn));
    if turns.any(|turn| !turn.is_finite() || turn.abs() > MOST_TURN) {
        let reason = format!("more than {MOST_TURN} rad along an element, or not finite");
        return Err(CoreError::invalid("turns", reason));
    }
    Ok(())
}

/// Checks that there is one load for each wire element or segment, or none at all.
fn check_wire_loads(s: &Structure) -> Result<(), CoreError> {
    let (given, elements) = (s.wire_loads.len(), s.wires.len() + s.segments.len());
    let finite = s.wire_loads.iter().flatten().all(|f| f.is_finite());
    if (given != 0 && given != elements) || !finite {
        let reason = format!("{given} loads for {elements} elements, or one not finite");
        return Err(CoreError::invalid("wire_loads", reason));
    }
    Ok(())
}
