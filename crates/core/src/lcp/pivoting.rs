//! Pivoting rules: the row that is exchanged next, and why that ends.
//!
//! *Energy criterion*: the violated row with the largest `q_k² / (2 T_kk)`. It is quick (often one
//! pivot per active row), but it can return to an active set it has seen. As the choice depends on
//! the active set alone, one repetition means an endless cycle; Brent's method finds it without a
//! list of visited sets.
//!
//! *Least index* (Murty 1974): the first violated row. Visits no active set twice when `H` is a
//! P-matrix, hence finite, but can need `2ⁿ` pivots. It therefore runs only until fewer rows are
//! violated than ever before, and the energy criterion takes over again (Júdice & Pires 1994). The
//! record falls at most `n` times, so the whole remains finite.

use super::FailureReason;
use super::tableau::Tableau;

/// Bound on all pivots of one solve: `PIVOTS_BASE + PIVOTS_PER_ROW · n`.
///
/// The base covers all `2ⁿ` active sets up to `n = 12`, so that the bound can be reached only
/// beyond; random problems need about `n` pivots.
pub const PIVOTS_BASE: usize = 5000;
/// See [`PIVOTS_BASE`].
pub const PIVOTS_PER_ROW: usize = 100;

/// Pivots per row after which one run of the energy criterion ends even without a cycle.
///
/// Rounding in near ties can break an exact repetition; ten times the usual number tells the same.
pub const ENERGY_PIVOTS_PER_ROW: usize = 10;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Rule {
    #[default]
    Energy,
    LeastIndex,
}

/// Detector of cycles by Brent's method: comparison with the active set of the last step number
/// `2^j`.
#[derive(Debug, Clone, Default)]
struct CycleDetector {
    mark: Vec<bool>,
    window: usize,
    since_mark: usize,
    steps: usize,
}

impl CycleDetector {
    fn start(&mut self, active: &[bool]) {
        self.mark.clear();
        self.mark.extend_from_slice(active);
        (self.window, self.since_mark, self.steps) = (1, 0, 0);
    }

    /// Records the set after a pivot; returns whether the sequence repeats itself or is far too
    /// long.
    fn repeats(&mut self, active: &[bool]) -> bool {
        self.steps += 1;
        self.since_mark += 1;
        if self.mark == active || self.steps > ENERGY_PIVOTS_PER_ROW * (active.len() + 1) {
            return true;
        }
        if self.since_mark == self.window {
            self.mark.copy_from_slice(active);
            self.window *= 2;
            self.since_mark = 0;
        }
        false
    }
}

/// Violated rows of the current table, for the choice of the next one.
struct Violation {
    count: usize,
    first: usize,
    most_energy: usize,
}

/// Pivoting rules and their counters for one problem.
#[derive(Debug, Clone, Default)]
pub struct Pivoting {
    cycle: CycleDetector,
    rule: Rule,
    fewest_violated: usize,
    pivots: usize,
    limit: usize,
    fallback_used: bool,
}

impl Pivoting {
    pub(super) fn start(&mut self, n: usize) {
        self.rule = Rule::Energy;
        self.fewest_violated = usize::MAX;
        self.pivots = 0;
        self.limit = PIVOTS_BASE + PIVOTS_PER_ROW * n;
        self.fallback_used = false;
    }

    /// Exchanges rows until none is violated.
    pub(super) fn run(&mut self, tableau: &mut Tableau) -> Result<(), FailureReason> {
        self.cycle.start(tableau.active());
        while let Some(violation) = violated(tableau) {
            if self.pivots == self.limit {
                return Err(FailureReason::PivotLimit { limit: self.limit });
            }
            if violation.count < self.fewest_violated {
                self.fewest_violated = violation.count;
                if self.rule == Rule::LeastIndex {
                    self.rule = Rule::Energy;
                    self.cycle.start(tableau.active());
                }
            }
            match self.rule {
                Rule::Energy => tableau.checked_exchange(violation.most_energy)?,
                Rule::LeastIndex => tableau.checked_exchange(violation.first)?,
            }
            self.pivots += 1;
            if self.rule == Rule::Energy && self.cycle.repeats(tableau.active()) {
                self.rule = Rule::LeastIndex;
                self.fallback_used = true;
            }
        }
        Ok(())
    }

    pub(super) fn pivots(&self) -> usize {
        self.pivots
    }

    pub(super) fn fallback_used(&self) -> bool {
        self.fallback_used
    }
}

fn violated(tableau: &Tableau) -> Option<Violation> {
    let (active_limit, inactive_limit) = tableau.thresholds(tableau.values());
    let mut violation: Option<Violation> = None;
    let mut largest = f64::NEG_INFINITY;
    for k in 0..tableau.size() {
        let value = tableau.values()[k];
        let limit = if tableau.active()[k] {
            active_limit
        } else {
            inactive_limit
        };
        // Written so that a NaN counts as violated and ends in a pivot error, not in an answer.
        if value >= limit {
            continue;
        }
        let rows = violation.get_or_insert(Violation {
            count: 0,
            first: k,
            most_energy: k,
        });
        rows.count += 1;
        let energy = value * value / (2.0 * tableau.pivot(k));
        if energy > largest {
            largest = energy;
            rows.most_energy = k;
        }
    }
    violation
}
