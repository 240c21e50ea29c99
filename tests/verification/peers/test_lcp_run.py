"""A run whose complementarity problems are solved by QuantEcon

The steps of docs/theory/dynamics.md and contact.md once more, written for this section: dense
matrices, K and M of the line by scikit-fem (section "Line at rest and its natural frequencies, by
scikit-fem"), every dropper in each problem, no short columns, no warm start, and each problem
solved by Lemke's method of QuantEcon. Nothing in it comes from Arcless's core but the lengths to
which the line was cut.

Three spans of `en50318-2002` with elements of 3 m and 6 m, 30 m of travel at 250 km/h under 200 N,
216 steps of 2 ms with generalised-α of spectral radius 0.9, linearised kinematics; up to two
droppers slacken. Contact forces are compared step by step, unfiltered.

Each of these problems has 28 unknowns, the contact and 27 droppers. They are also given to
`arcless.lcp.solve`; differences are in roundings, `ε cond(H) max x`, as in the other sections on
complementarity. They are gentle: at such steps what happens at one dropper hardly reaches the
next, and cond(H) is 1.01. Hard ones are in those sections.
"""

from functools import cache
from typing import Any

import numpy as np
import pytest

import arcless
from arcless import lcp
from arcless.equilibrium import equilibrium
from arcless.simulate.setup import trajectory
from tests.support import lcp_problems as problems
from tests.support.faults import Fault, forgotten, scaled
from tests.support.lcp_faults import complementarity
from tests.support.python_faults import wrong

pytest.importorskip("skfem", reason="scikit-fem is not installed: `make peers`")
pytest.importorskip("quantecon", reason="QuantEcon is not installed: `make peers`")

from quantecon import optimize

from tests.support.skfem_line import Line
from tests.support.skfem_run import Run

CHANGES = {
    "line.spans": [{"type": "standard", "count": 3}],
    "travel": {"start": "60 m", "end": "90 m"},
    "analysis.spans": None,
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": 3.0,
    "solver.messenger_wire_element": 6.0,
    "solver.time_step": 2e-3,
    # The other program has the mass of the elements as it is.
    "solver.period_correction": False,
    "pantographs.0.static_force": 200.0,
}


@cache
def run() -> tuple[Any, np.ndarray, int, list[problems.Problem]]:
    """Dataset of Arcless; forces by scikit-fem and QuantEcon, most slack droppers, the problems."""
    scenario = arcless.load("en50318-2002-250").with_(**CHANGES)
    data, met = arcless.run(scenario).dataset, []

    def lemke(H: np.ndarray, w: np.ndarray) -> np.ndarray:
        met.append((H, w))
        matrix, vector, scale = problems.unit_diagonal(H, w)
        found = optimize.lcp_lemke(matrix, vector)
        assert found.success, "Lemke's method ended on a ray"
        return np.asarray(scale * found.z)

    line = Line(scenario, equilibrium.find(scenario))
    forces, slack = Run(line, line.settle(), lemke).forces(data.attrs["steps"])
    return data, forces, slack, met


def test_contact_force(evidence) -> None:
    data, forces, slack, _ = run()
    assert slack == data.attrs["slack_droppers_max"] == 2
    apart = np.abs(data.contact_force.values[:, 0] - forces)
    assert apart.size == 216
    evidence.below(
        "contact force, largest difference in 216 steps", float(apart.max()), 2e-6, unit="N",
        reason="the two lines at rest differ by 1e-10 m and 1e-8 N; the contact makes 5e-6 N of"
        " 1e-10 m, but wire and strip share most of that",
    )  # fmt: skip


def test_problems_of_the_run(evidence) -> None:
    *_, met = run()
    assert len(met) == 216
    apart = []
    for H, w in met:
        matrix, vector, scale = problems.unit_diagonal(H, w)
        x, _, _ = lcp.solve(H, w, symmetric=False)
        other = scale * optimize.lcp_lemke(matrix, vector).z
        assert np.count_nonzero(other) > 0
        apart.append(problems.roundings(H, w, x, other))
    evidence.below(
        "forces in the 216 problems, largest difference", max(apart), 10.0, unit="roundings",
        reason="some exchanges, each with one rounding of each row",
    )  # fmt: skip


def other_sign(H: np.ndarray, w: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    H = H.copy()
    H[0, 1:] *= -1.0
    return H, w


FAULTS = [
    Fault(what, [forgotten(run), broken], check)
    for what, broken, check in (
        ("damping of droppers 1 % too large", scaled("links", "beta", 1.01), test_contact_force),
        ("contact 1e-4 too stiff",
         wrong(trajectory, "contact_stiffness", lambda stiffness: 1.0001 * stiffness),
         test_contact_force),
        ("droppers push the contact the wrong way", complementarity(other_sign),
         test_problems_of_the_run),
    )
]  # fmt: skip
