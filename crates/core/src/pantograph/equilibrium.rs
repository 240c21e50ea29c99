//! Static equilibrium of a pantograph under its contact forces, with springs given by tables.
//!
//!   k u + Σ g f(gᵀ(u − r z₀)) − b p = g V² + f − Σ e λ,   sᵀ u = z
//!
//! s is e where there is one contact.
//!
//! On given pieces of the tables this is one linear system, and the equilibrium is exact up to
//! rounding. The first table that is not on its piece moves to the next one, and the system is
//! solved again. As in a step ([piecewise force](crate::pantograph::piecewise_force)) the pieces
//! passed are never met again while the later tables keep theirs, so it ends.

use crate::error::CoreError;
use crate::linalg::dense;
use crate::linalg::small::{add_outer, inner, scaled};
use crate::pantograph::breakpoint::ForceKind;
use crate::pantograph::excitation::BaseMotion;
use crate::pantograph::model::Pantograph;
use crate::pantograph::piecewise_force::PiecewiseForce;

/// Tolerance of a displacement beyond the end of its piece, as a share of the size of the table:
/// rounding of the linear system.
const ROUNDING: f64 = 1e-12;
/// Slope that replaces a level piece on the way to others, as a share of the steepest.
const LEVEL: f64 = 1e-9;
/// Bound on the linear systems solved: pieces of all tables together are some dozens; with more
/// solutions than this the search runs in a circle.
const MOST_SOLUTIONS: usize = 100_000;

/// Pantograph in static equilibrium.
pub(crate) struct PantographEquilibrium {
    /// Displacements, m.
    pub(crate) u: Vec<f64>,
    /// Preload p, N.
    pub(crate) preload: f64,
    /// Stiffness matrix K with the slopes of the tables, N/m.
    stiffness: Vec<f64>,
}

impl PantographEquilibrium {
    /// Change of the displacements, m, for more `force` on the coordinates, N, and a change `z` of
    /// sᵀu, m.
    pub(crate) fn displacement_change(
        &self,
        pantograph: &Pantograph,
        force: Vec<f64>,
        s: &[f64],
        z: f64,
    ) -> Result<Vec<f64>, CoreError> {
        if pantograph.is_external {
            return at_one_height(pantograph, (s, z));
        }
        let solution = solve(pantograph, &self.stiffness, force, (s, z));
        solution.map(|(u, _)| u).ok_or_else(unbalanced)
    }
}

/// Finds the static equilibrium under a force λ on the first strip, which is at height `z`:
/// displacements and preload from  k u − b p = g V² + f − e λ,  eᵀ u = z, with f as given for the
/// start.
///
/// # Errors
/// [`CoreError::Input`] when the pantograph has no such equilibrium, [`CoreError::BeyondTable`].
pub fn under_one_contact(
    pantograph: &Pantograph,
    force: f64,
    z: f64,
    speed: f64,
) -> Result<(Vec<f64>, f64), CoreError> {
    let e = &pantograph.strips[0].vectors[0];
    let equilibrium = find_equilibrium(pantograph, &scaled(force, e), (e, z), speed)?;
    Ok((equilibrium.u, equilibrium.preload))
}

/// Finds displacements and preload under the contact forces `load` = Σ e λ, with `level` = (s, z).
pub(crate) fn find_equilibrium(
    pantograph: &Pantograph,
    load: &[f64],
    level: (&[f64], f64),
    speed: f64,
) -> Result<PantographEquilibrium, CoreError> {
    if pantograph.is_external {
        return Ok(PantographEquilibrium {
            u: at_one_height(pantograph, level)?,
            preload: 0.0,
            stiffness: pantograph.stiffness.clone(),
        });
    }
    let forces = pantograph.piecewise_forces.iter().enumerate();
    let springs: Vec<(usize, &PiecewiseForce)> = forces
        .filter(|(_, f)| f.kind == ForceKind::Spring)
        .collect();
    let mut pieces: Vec<usize> = springs
        .iter()
        .map(|(_, spring)| spring.steepest())
        .collect();
    let base = pantograph.excitation.base.as_ref();
    let base_displacement = |spring: &PiecewiseForce| {
        let along_spring =
            |base: &BaseMotion| inner(&spring.direction, &base.influence) * base.displacement[0];
        base.map_or(0.0, along_spring)
    };
    for _ in 0..MOST_SOLUTIONS {
        let balance = |floor: f64| {
            let mut stiffness = pantograph.stiffness.clone();
            let mut force = pantograph.start_forces(speed);
            for ((_, spring), &piece) in springs.iter().zip(&pieces) {
                let slope = spring
                    .slope(piece)
                    .max(floor * spring.slope(spring.steepest()));
                let [x, f] = spring.points[piece];
                add_outer(slope, &spring.direction, &mut stiffness);
                let intercept = slope * (x + base_displacement(spring)) - f;
                let coordinates = force.iter_mut().zip(&spring.direction);
                coordinates.for_each(|(sum, g)| *sum += intercept * g);
            }
            let coordinates = force.iter_mut().zip(load);
            coordinates.for_each(|(sum, load)| *sum -= load);
            let solution = solve(pantograph, &stiffness, force, level);
            solution.map(|(u, preload)| PantographEquilibrium {
                u,
                preload,
                stiffness,
            })
        };
        let exact = balance(0.0);
        let is_singular = exact.is_none();
        let equilibrium = exact.or_else(|| balance(LEVEL)).ok_or_else(unbalanced)?;
        let elongations: Vec<f64> = springs
            .iter()
            .map(|(_, spring)| inner(&spring.direction, &equilibrium.u) - base_displacement(spring))
            .collect();
        let pairs = springs.iter().zip(&elongations);
        if pairs
            .clone()
            .zip(&mut pieces)
            .any(|(((_, spring), q), piece)| move_to_next_piece(spring, piece, *q))
        {
            continue;
        }
        for ((number, spring), q) in pairs {
            check_end(*number, spring, *q)?;
        }
        return if is_singular {
            Err(unbalanced())
        } else {
            Ok(equilibrium)
        };
    }
    Err(unbalanced())
}

/// Displacements of an external pantograph, m: all coordinates at one height, with sᵀu = z.
fn at_one_height(pantograph: &Pantograph, (s, z): (&[f64], f64)) -> Result<Vec<f64>, CoreError> {
    let share: f64 = s.iter().sum();
    if share > 0.0 {
        return Ok(vec![z / share; pantograph.size()]);
    }
    let reason = "a strip of an external one that does not rise with its coordinates";
    Err(CoreError::invalid("pantographs", reason))
}

/// Rounding of a displacement, m, for a table.
fn tolerance(spring: &PiecewiseForce) -> f64 {
    ROUNDING
        * spring.points[0][0]
            .abs()
            .max(spring.points[spring.pieces()][0].abs())
}

/// Moves to the next piece when the displacement `q`, m, lies there; returns whether it does.
fn move_to_next_piece(spring: &PiecewiseForce, piece: &mut usize, q: f64) -> bool {
    let [left, right] = [spring.points[*piece][0], spring.points[*piece + 1][0]];
    if q < left - tolerance(spring) && *piece > 0 {
        *piece -= 1;
        return true;
    }
    if q > right + tolerance(spring) && *piece + 1 < spring.pieces() {
        *piece += 1;
        return true;
    }
    false
}

/// Refuses a start beyond the end of a table.
fn check_end(table: usize, spring: &PiecewiseForce, q: f64) -> Result<(), CoreError> {
    let [first, last] = [spring.points[0][0], spring.points[spring.pieces()][0]];
    let end = if q < first { first } else { last };
    if q >= first - tolerance(spring) && q <= last + tolerance(spring) {
        return Ok(());
    }
    Err(CoreError::BeyondTable {
        pantograph: 0,
        table,
        displacement: q,
        end,
    })
}

/// Solves the linear system of displacements and preload.
fn solve(
    pantograph: &Pantograph,
    stiffness: &[f64],
    force: Vec<f64>,
    (s, z): (&[f64], f64),
) -> Option<(Vec<f64>, f64)> {
    let n = pantograph.size();
    let m = n + 1;
    let mut a = vec![0.0; m * m];
    let mut rhs = force;
    for i in 0..n {
        a[i * m..i * m + n].copy_from_slice(&stiffness[i * n..(i + 1) * n]);
        a[i * m + n] = -pantograph.preload[i];
        a[n * m + i] = s[i];
    }
    rhs.push(z);
    if !dense::solve_in_place(&mut a, &mut rhs) {
        return None;
    }
    let preload = rhs[n];
    rhs.truncate(n);
    Some((rhs, preload))
}

fn unbalanced() -> CoreError {
    CoreError::invalid(
        "pantographs",
        "the preload cannot balance the contact force",
    )
}
