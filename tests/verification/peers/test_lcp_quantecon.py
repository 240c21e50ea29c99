"""Complementarity problems, solved by QuantEcon

`y = Hx + w`, `x ≥ 0`, `y ≥ 0`, `xᵀy = 0` has one solution if every principal minor of H is
positive (a P-matrix; Cottle, Pang & Stone, The Linear Complementarity Problem, theorem 3.3.7).
Arcless finds it by principal pivoting, QuantEcon (`lcp_lemke`) by Lemke's method with
lexicographic ties: another path to the same point. 120 problems of a kind with n = 2 to 33, 100 of
Murty's with n up to 17:

- definite: symmetric, condition number some hundreds;
- skew: contacts and droppers of a step, two definite blocks coupled with opposite signs;
- touching: small whole numbers, so that forces and gaps vanish together;
- Murty (Math. Programming 15 (1978)): the simplest pivoting rules need 2ⁿ exchanges;
- ring: `x_k + 1.5 x_k+1`, for which the criterion of Arcless runs in circles and its finite
  fallback decides;
- near singular: contacts that move almost together, condition number 1e6;
- the first second of `examples/dropped_beam.py`: those steps in which a support is touched.

The tolerances of `lcp_lemke` are absolute, so it gets each problem at unit diagonal and with
`|w| ≤ 1`. Differences are in roundings: `ε cond(H) max x`, which is what one rounding of H or w
may move the answer by. Answers are compared, and that x and y are not negative and have no
product. The record was written with QuantEcon 0.11.4.
"""

import numpy as np
import pytest

from arcless import lcp
from tests.support import lcp_problems as problems
from tests.support.lcp_faults import slips

optimize = pytest.importorskip(
    "quantecon.optimize", reason="QuantEcon is not installed: `make peers`"
)

KINDS = {
    "definite": problems.definite,
    "skew": problems.skew,
    "touching": problems.touching,
    "Murty": problems.murty,
    "ring": problems.circulant,
    "near singular": problems.near_singular,
}
# Lemke's table gathers the rounding of its exchanges, about 2 n of them, and those of a ring grow
# on the way; principal pivoting ends with a solution of the equations of the closed contacts.
LIMITS = {"ring": 200.0}
REASON = {"ring": "Lemke's table gathers the roundings of some 70 exchanges, and the ring stretches"
          " them (Drake's answers are within 1)"}  # fmt: skip


def lemke(H: np.ndarray, w: np.ndarray) -> np.ndarray:
    matrix, vector, scale = problems.unit_diagonal(H, w)
    found = optimize.lcp_lemke(matrix, vector)
    assert found.success, "Lemke's method ended on a ray"
    return np.asarray(scale * found.z)


def compare(evidence, name: str, given: list[problems.Problem]) -> None:
    apart, violated, pushing = [], [], 0
    for H, w in given:
        x, _, _ = lcp.solve(H, w, symmetric=False)
        other = lemke(H, w)
        apart.append(problems.roundings(H, w, x, other))
        violated.append(problems.violation(H, w, x) / np.linalg.cond(H))
        pushing += np.count_nonzero(other)
    assert pushing > len(given), "problems without forces show nothing"
    evidence.below(
        f"{name}: forces, largest difference in {len(given)} problems", max(apart),
        LIMITS.get(name, 10.0), unit="roundings",
        reason=REASON.get(name, "some exchanges, each with one rounding of each row"),
    )  # fmt: skip
    evidence.below(
        f"{name}: conditions violated, over cond(H)", max(violated), 2e-15, unit="1",
        reason="ten roundings of 1; each row adds up some products",
    )  # fmt: skip


@pytest.mark.parametrize("name", KINDS)
def test_same_forces(evidence, name: str) -> None:
    largest = 17 if name == "Murty" else 33
    compare(evidence, name, problems.many(KINDS[name], largest=largest))


def test_same_forces_in_a_run(evidence) -> None:
    compare(evidence, "dropped beam", problems.dropped_beam())


FAULTS = slips(test_same_forces, test_same_forces_in_a_run)
