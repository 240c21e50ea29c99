"""Complementarity problems, solved by Drake

The problems of the section "Complementarity problems, solved by QuantEcon", given to
`MobyLcpSolver` of Drake: Lemke's method of another hand, written for contacts of robots. It gets
them at unit diagonal, too. Differences are in roundings, `ε cond(H) max x`.

Where the methods differ: when Lemke's method fails, Moby adds λ to the diagonal, more and more
(1e-4 to 1 here), and reports success with the answer to the changed problem. It does so for nearly
singular problems (condition number 1e6, two thirds of them) and for rings with equal w, where
ratios tie. There its answer violates the conditions of what was asked. From it λ can be read,
`λ = −(Hx + w)_k / x_k`, the same for each closed contact k. So Arcless is given `H + λ 1` there,
and the answers agree again. The section of QuantEcon has the answers to what was asked.

The record was written with Drake 1.51.
"""

import numpy as np
import pytest

from arcless import lcp
from tests.support import lcp_problems as problems
from tests.support.faults import Fault
from tests.support.lcp_faults import complementarity, slips

solvers = pytest.importorskip("pydrake.solvers", reason="Drake is not installed: `make peers`")

KINDS = {
    "definite": problems.definite,
    "skew": problems.skew,
    "touching": problems.touching,
    "Murty": problems.murty,
    "ring": problems.circulant,
}
EXCHANGES = "some exchanges, each with one rounding of each row"
# At unit diagonal and |w| ≤ 1: rounding leaves 1e-8 in near-singular problems, λ more than 1e-6.
SOLVED = 1e-7


def moby(matrix: np.ndarray, vector: np.ndarray) -> np.ndarray:
    program = solvers.MathematicalProgram()
    unknown = program.NewContinuousVariables(vector.size)
    program.AddLinearComplementarityConstraint(matrix, vector, unknown)
    found = solvers.MobyLcpSolver().Solve(program)
    assert found.is_success(), "Moby says that it failed"
    return np.asarray(found.GetSolution(unknown))


def difference(H: np.ndarray, w: np.ndarray) -> float:
    matrix, vector, _ = problems.unit_diagonal(H, w)
    x, _, _ = lcp.solve(matrix, vector, symmetric=False)
    return problems.roundings(matrix, vector, x, moby(matrix, vector))


def compare(evidence, name: str, given: list[problems.Problem]) -> None:
    evidence.below(
        f"{name}: forces, largest difference in {len(given)} problems",
        max(difference(H, w) for H, w in given), 10.0, unit="roundings", reason=EXCHANGES,
    )  # fmt: skip


@pytest.mark.parametrize("name", KINDS)
def test_same_forces(evidence, name: str) -> None:
    largest = 17 if name == "Murty" else 33
    compare(evidence, name, problems.many(KINDS[name], largest=largest))


def test_same_forces_in_a_run(evidence) -> None:
    compare(evidence, "dropped beam", problems.dropped_beam())


def shifted(matrix: np.ndarray, vector: np.ndarray, other: np.ndarray) -> float:
    """Find λ that the answer is for; it is one number or the answer is wrong."""
    closed = other > 1e-9 * other.max()
    found = -(matrix @ other + vector)[closed] / other[closed]
    assert np.ptp(found) < 1e-6 * found.max(), "not the answer to H + λ 1 either"
    return float(np.median(found))


def test_same_forces_where_drake_changes_the_problem(evidence) -> None:
    tied = [(H, -np.ones_like(w)) for H, w in problems.many(problems.circulant, seeds=1)]
    changed, kept = [], []
    for H, w in problems.many(problems.near_singular) + tied:
        matrix, vector, _ = problems.unit_diagonal(H, w)
        other = moby(matrix, vector)
        if problems.violation(matrix, vector, other) < SOLVED:
            kept.append(difference(H, w))
            continue
        matrix = matrix + shifted(matrix, vector, other) * np.eye(vector.size)
        x, _, _ = lcp.solve(matrix, vector, symmetric=False)
        changed.append(problems.roundings(matrix, vector, x, other))
    assert len(kept) > 20
    assert len(changed) > 60
    evidence.below(
        "near singular, solved as asked: forces, largest difference", max(kept), 10.0,
        unit="roundings", reason=EXCHANGES,
    )  # fmt: skip
    evidence.below(
        "solved for H + λ 1: forces, largest difference", max(changed), 10.0, unit="roundings",
        reason=EXCHANGES,
    )  # fmt: skip


FAULTS = [
    *slips(test_same_forces, test_same_forces_in_a_run),
    Fault("H off by 1e-9", complementarity(lambda H, w: (H * (1.0 + 1e-9), w)),
          test_same_forces_where_drake_changes_the_problem),
]  # fmt: skip
