//! Static equilibrium of a rider under its contact forces, with springs given by tables.
//!
//!   k u + Σ g f(gᵀ(u − r z₀)) − b p = g V² + f − Σ e λ,   sᵀ u = z
//!
//! s is e where there is one contact.
//!
//! On given pieces of the tables this is one linear system, and the equilibrium is exact but for
//! rounding. The first table that is not on its piece moves on by one, and the system is solved
//! again. As in a step ([law](crate::pantograph::piecewise_force)) the pieces passed are never met again while the later
//! tables keep theirs, so it ends.

use crate::error::CoreError;
use crate::linalg::dense;
use crate::pantograph::breakpoint::ForceKind;
use crate::pantograph::piecewise_force::{PiecewiseForce, add_outer};
use crate::pantograph::system::{Pantograph, inner};

/// How far beyond the end of its piece a displacement may lie, as a share of the size of the table:
/// rounding of the linear system.
const ROUNDING: f64 = 1e-12;
/// Slope that replaces a level piece on the way to others, as a share of the steepest.
const LEVEL: f64 = 1e-9;
/// Pieces of all tables together are some dozens; more solutions than this and they run in a circle.
const MOST_SOLUTIONS: usize = 100_000;

/// A rider in equilibrium.
pub(crate) struct Rest {
    pub(crate) u: Vec<f64>,
    pub(crate) preload: f64,
    /// K with the slopes of the tables.
    stiffness: Vec<f64>,
}

impl Rest {
    /// Change of the displacements for more force, N, on the coordinates, and sᵀu changed by `z`.
    pub(crate) fn respond(
        &self,
        rider: &Pantograph,
        force: Vec<f64>,
        s: &[f64],
        z: f64,
    ) -> Result<Vec<f64>, CoreError> {
        let found = solve(rider, &self.stiffness, force, (s, z));
        found.map(|(u, _)| u).ok_or_else(unbalanced)
    }
}

/// Displacements and preload under the forces `load` = Σ e λ, with `level` = (s, z).
pub(crate) fn settle(
    rider: &Pantograph,
    load: &[f64],
    level: (&[f64], f64),
    speed: f64,
) -> Result<Rest, CoreError> {
    let laws = rider.laws.iter().enumerate();
    let springs: Vec<(usize, &PiecewiseForce)> = laws
        .filter(|(_, l)| l.motion == ForceKind::Spring)
        .collect();
    let mut pieces: Vec<usize> = springs.iter().map(|(_, law)| law.steepest()).collect();
    let ground = rider.given.ground.as_ref();
    let carried = |law: &PiecewiseForce| {
        let of = |g: &crate::pantograph::excitation::BaseMotion| {
            inner(&law.direction, &g.carried) * g.displacement[0]
        };
        ground.map_or(0.0, of)
    };
    for _ in 0..MOST_SOLUTIONS {
        let balance = |floor: f64| {
            let (mut stiffness, mut given) = (rider.stiffness.clone(), rider.at_start(speed));
            for ((_, law), &piece) in springs.iter().zip(&pieces) {
                let slope = law.slope(piece).max(floor * law.slope(law.steepest()));
                let [x, f] = law.points[piece];
                add_outer(slope, &law.direction, &mut stiffness);
                let pull = slope * (x + carried(law)) - f;
                let pulled = given.iter_mut().zip(&law.direction);
                pulled.for_each(|(sum, g)| *sum += pull * g);
            }
            let pushed = given.iter_mut().zip(load);
            pushed.for_each(|(sum, load)| *sum -= load);
            let found = solve(rider, &stiffness, given, level);
            found.map(|(u, preload)| Rest {
                u,
                preload,
                stiffness,
            })
        };
        let exact = balance(0.0);
        let is_loose = exact.is_none();
        let found = exact.or_else(|| balance(LEVEL));
        let found = found.ok_or_else(unbalanced)?;
        let at: Vec<f64> = springs
            .iter()
            .map(|(_, law)| inner(&law.direction, &found.u) - carried(law))
            .collect();
        let springs_at = springs.iter().zip(&at);
        if springs_at
            .clone()
            .zip(&mut pieces)
            .any(|(((_, law), q), piece)| move_on(law, piece, *q))
        {
            continue;
        }
        for ((number, law), q) in springs_at {
            check_end(*number, law, *q)?;
        }
        return if is_loose {
            Err(unbalanced())
        } else {
            Ok(found)
        };
    }
    Err(unbalanced())
}

/// Rounding of a displacement, for a table.
fn slack(law: &PiecewiseForce) -> f64 {
    ROUNDING
        * law.points[0][0]
            .abs()
            .max(law.points[law.pieces()][0].abs())
}

/// Move to the next piece when a displacement lies there; tells whether it does.
fn move_on(law: &PiecewiseForce, piece: &mut usize, q: f64) -> bool {
    let [left, right] = [law.points[*piece][0], law.points[*piece + 1][0]];
    if q < left - slack(law) && *piece > 0 {
        *piece -= 1;
        return true;
    }
    if q > right + slack(law) && *piece + 1 < law.pieces() {
        *piece += 1;
        return true;
    }
    false
}

/// Refuse a start beyond the end of a table.
fn check_end(table: usize, law: &PiecewiseForce, q: f64) -> Result<(), CoreError> {
    let [first, last] = [law.points[0][0], law.points[law.pieces()][0]];
    let end = if q < first { first } else { last };
    if q >= first - slack(law) && q <= last + slack(law) {
        return Ok(());
    }
    Err(CoreError::BeyondTable {
        rider: 0,
        table,
        place: q,
        end,
    })
}

/// The linear system of displacements and preload.
fn solve(
    rider: &Pantograph,
    stiffness: &[f64],
    given: Vec<f64>,
    (s, z): (&[f64], f64),
) -> Option<(Vec<f64>, f64)> {
    let n = rider.size();
    let m = n + 1;
    let mut a = vec![0.0; m * m];
    let mut rhs = given;
    for i in 0..n {
        a[i * m..i * m + n].copy_from_slice(&stiffness[i * n..(i + 1) * n]);
        a[i * m + n] = -rider.preload[i];
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
    CoreError::Input {
        array: "riders",
        reason: "the preload cannot balance the contact force".into(),
    }
}
