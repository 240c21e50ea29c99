//! Refuses structures whose arrays contradict each other, before any arithmetic.

use crate::error::CoreError;
use crate::structure::Structure;

fn refuse(array: &'static str, reason: String) -> CoreError {
    CoreError::Input { array, reason }
}

/// Largest number of nodes accepted: indices are stored in 32 bits.
const MOST_NODES: usize = 1 << 30;

/// Check indices, signs and finiteness.
///
/// # Errors
/// [`CoreError::Input`] naming the array.
pub fn check(s: &Structure, dim: usize) -> Result<(), CoreError> {
    let n = s.positions.len();
    if s.dim != dim {
        return Err(refuse("dim", format!("is {}, expected {dim}", s.dim)));
    }
    if !(2..=MOST_NODES).contains(&n) || s.slopes.len() != n {
        return Err(refuse(
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
        return Err(refuse("positions", "not finite".into()));
    }
    check_bars(s, n)?;
    check_points(s, n, dim)?;
    if !s.gravity.is_finite() || s.gravity < 0.0 {
        return Err(refuse("gravity", format!("is {}", s.gravity)));
    }
    let mut on_wire = vec![false; n];
    s.wires
        .iter()
        .flat_map(|w| w.places())
        .for_each(|(i, _)| on_wire[i] = true);
    match on_wire.iter().position(|on| !on) {
        Some(i) => Err(refuse("wires", format!("node {i} lies on no wire"))),
        None => Ok(()),
    }
}

fn check_bars(s: &Structure, n: usize) -> Result<(), CoreError> {
    let positive = |v: f64| v.is_finite() && v > 0.0;
    let not_negative = |v: f64| v.is_finite() && v >= 0.0;
    for (i, w) in s.wires.iter().enumerate() {
        let inside = w.places().iter().all(|&(node, _)| node < n);
        let nodes = inside && w.nodes[0] != w.nodes[1];
        let section = positive(w.section.rest_length)
            && positive(w.section.axial_stiffness)
            && not_negative(w.section.bending_stiffness);
        let damping = not_negative(w.damping.alpha) && not_negative(w.damping.beta);
        let loaded = positive(w.mass) && positive(w.design_tension);
        if !(nodes && section && damping && loaded) {
            return Err(refuse("wires", format!("element {i} is impossible: {w:?}")));
        }
    }
    for (i, l) in s.links.iter().enumerate() {
        let nodes = l.nodes[0] < n && l.nodes[1] < n && l.nodes[0] != l.nodes[1];
        let numbers = positive(l.stiffness) && l.rest_length.is_finite();
        let damping = not_negative(l.viscosity)
            && not_negative(l.damping.alpha)
            && not_negative(l.damping.beta);
        if !(nodes && numbers && damping && not_negative(l.mass)) {
            return Err(refuse("links", format!("link {i} is impossible: {l:?}")));
        }
    }
    Ok(())
}

fn check_points(s: &Structure, n: usize, dim: usize) -> Result<(), CoreError> {
    for (i, t) in s.struts.iter().enumerate() {
        let numbers = t.direction.iter().chain(&t.anchor).all(|v| v.is_finite());
        let signs = t.stiffness > 0.0 && t.rest_length > 0.0 && t.moving_mass >= 0.0;
        if t.node >= n || dim != 3 || !numbers || !signs || t.direction[1] == 0.0 {
            return Err(refuse("struts", format!("strut {i} is impossible: {t:?}")));
        }
    }
    for (i, p) in s.springs.iter().enumerate() {
        let signs = p.stiffness > 0.0 && p.viscosity >= 0.0 && p.rest.is_finite();
        if p.node >= n || p.component >= dim || !signs || !p.stiffness.is_finite() {
            return Err(refuse(
                "springs",
                format!("spring {i} is impossible: {p:?}"),
            ));
        }
    }
    let possible = |v: f64| v.is_finite() && v >= 0.0;
    if s.masses
        .iter()
        .any(|m| m.node >= n || !possible(m.mass) || !possible(m.alpha))
    {
        return Err(refuse(
            "masses",
            "node out of range or mass negative".into(),
        ));
    }
    if s.fixed.iter().any(|&(node, c)| node >= n || c >= dim) {
        return Err(refuse("fixed", "node or component out of range".into()));
    }
    if s.ends.iter().any(|e| e.node >= n || !e.force.is_finite()) {
        return Err(refuse(
            "ends",
            "node out of range or force not finite".into(),
        ));
    }
    if s.loads
        .iter()
        .any(|&(node, c, f)| node >= n || c >= dim || !f.is_finite())
    {
        return Err(refuse(
            "loads",
            "node or component out of range or force not finite".into(),
        ));
    }
    Ok(())
}
