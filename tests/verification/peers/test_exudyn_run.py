"""EN 50318:2002 line under a running pantograph, in Exudyn

The line of the section "EN 50318:2002 line at rest, in Exudyn" with the pantograph of the case
under it: two masses that fly along the track with constant speed, springs and dampers between, 116
N at the start. The contact is a spring of 50 kN/m that only pushes, from the head to that point of
a cable that stands above it. Damping of the wires is `α M + β K` with M and K as Exudyn has them
at rest; droppers have `max(0, k e + c ė)` with `c = β k`. Both programs take generalised-α steps
with spectral radius 0.9.

What differs, and what it does:

- Kinematics. Exudyn forms all forces on the moved wires. So does Arcless with
  `solver.kinematics: updated`. The default, `linearised`, keeps the stiffness of the line at rest:
  the forces of the two differ by 1 N (root mean square) where the deviation is 31 N.
- Time. Exudyn (after Arnold & Brüls) balances forces at the end of a step and smooths the
  accelerations; Arcless (after Chung & Hulbert) balances between beginning and end. Both are of
  second order, so the difference falls with the square of the step.
- Droppers. Exudyn finds slack droppers by Newton's method, Arcless by a complementarity problem.
- The law of the wire. Exudyn's EA is 0.4 % less for a small change of the stretch about 1.0013.
- The place of the contact. Exudyn gets the point of the wire that stood there at rest; `updated`
  looks again on the moved wire.
- There is no friction in either.

Short runs are on three spans with elements of 3 and 6 m, 0.4 s at 250 km/h. The long one is the
reference case itself, ten spans with elements of 1.5 and 3 m; its values are those of the
assessed spans 5 and 6 (Arcless's filter for both). The record was written with Exudyn 1.13.6.
"""

from functools import cache
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.equilibrium import equilibrium
from arcless.simulate.setup import trajectory
from tests.support.faults import Fault, scaled
from tests.support.python_faults import wrong

pytest.importorskip("exudyn", reason="Exudyn is not installed: `make peers`")

from tests.support.exudyn_built import Built
from tests.support.exudyn_run import Record, Run, filtered, low_pass, statistics

# The other program has no correction of the period: its waves are as late as its scheme makes them.
SAME = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.period_correction": False,
}
UPDATED = {"solver.kinematics": "updated"}
SHORT = {
    "line.spans": [{"type": "standard", "count": 3}],
    "travel": {"start": "60 m", "end": "90 m"},
    "analysis.spans": None,
    "solver.contact_wire_element": 3.0,
    "solver.messenger_wire_element": 6.0,
}
LONG = {"solver.contact_wire_element": 1.5, "solver.messenger_wire_element": 3.0}


def both(changes: dict[str, Any]) -> tuple[Any, Record]:
    """Dataset of Arcless, and what Exudyn records at the same times."""
    scenario = arcless.load("en50318-2002-250").with_(**SAME, **changes)
    data = arcless.run(scenario).dataset
    steps, step = data.attrs["steps"], scenario.time_step_s
    built = Built.of(scenario, equilibrium.find(scenario))
    other = Run(scenario, built, steps, step).record()
    force = np.interp(data.time.values, step * np.arange(steps + 1), other.force[:, 0])
    return data, Record(force, other.uplift)


def difference(changes: dict[str, Any]) -> float:
    """Root mean square of the difference of the unfiltered forces, N."""
    data, other = both({**SHORT, **UPDATED, **changes})
    force = data.contact_force.values[:, 0]
    assert force.std() > 20.0, "the wire is not straight enough to compare nothing"
    return float(np.sqrt(np.mean((force - other.force) ** 2)))


def test_force_over_half_a_span(evidence) -> None:
    evidence.below(
        "unfiltered force, steps of 1 ms: difference, root mean square", difference({}), 0.5,
        unit="N",
        reason="half of what 2 ms give, a quarter of which would be second order; the deviation"
        " of the force is 34 N",
    )  # fmt: skip


@pytest.mark.evidence
def test_difference_goes_with_the_square_of_the_step(evidence) -> None:
    steps = [2e-3, 1e-3, 0.5e-3]
    evidence.order(
        "difference of the unfiltered forces over the step", steps,
        [difference({"solver.time_step": step}) for step in steps], 2.0, tolerance=0.25, unit="h",
        reason="both schemes are of second order; the instants at which droppers go slack are not,"
        " and what the other differences leave (0.02 N) does not fall",
    )  # fmt: skip


@cache
def long_run() -> tuple[dict[str, Any], Record]:
    scenario = arcless.load("en50318-2002-250").with_(**SAME, **LONG)
    moved, other = both({**LONG, **UPDATED})
    return {"updated": moved, "linearised": arcless.run(scenario).dataset}, other


ALLOWED = {
    "updated": {
        "mean force": 5e-4, "standard deviation": 0.1, "standard deviation, 0 to 5 Hz": 0.02,
        "maximum": 0.5, "minimum": 0.2, "difference": 0.2, "uplift": 1e-4,
    },
    "linearised": {
        "mean force": 0.05, "standard deviation": 0.3, "standard deviation, 0 to 5 Hz": 0.1,
        "maximum": 4.0, "minimum": 2.0, "difference": 2.0, "uplift": 2e-3,
    },
}  # fmt: skip
REASON = {
    "updated": "the schemes differ by terms of second order, 0.06 N root mean square at 1 ms;"
    " statistics average most of it, single peaks do not",
    "linearised": "what keeping the stiffness of the line at rest does: 1 N root mean square;"
    " statistics average most of it, single peaks do not",
}


@pytest.mark.evidence
@pytest.mark.parametrize("kinematics", ["updated", "linearised"])
def test_reference_case(evidence, kinematics: str) -> None:
    runs, other = long_run()
    data = runs[kinematics]
    time, force = data.time.values, data.contact_force.values[:, 0]
    mine, theirs = statistics(time, force), statistics(time, other.force)
    allowed, reason = ALLOWED[kinematics], REASON[kinematics]
    for name, value in mine.items():
        evidence.close(
            f"{kinematics}: {name}", value, theirs[name], unit="N", absolute=allowed[name],
            reason=reason,
        )  # fmt: skip
    apart = filtered(time, force) - filtered(time, other.force)
    assert apart.size > 1000
    evidence.below(
        f"{kinematics}: filtered force, difference, root mean square",
        float(np.sqrt(np.mean(apart**2))), allowed["difference"], unit="N", reason=reason,
    )  # fmt: skip
    inner = slice(3, 8)
    lifted = data.support_uplift_max.values[inner] - other.uplift.max(axis=0)[inner]
    evidence.below(
        f"{kinematics}: highest uplift of the supports 4 to 8, largest difference",
        float(np.abs(lifted).max()), allowed["uplift"], unit="m", reason=reason,
    )  # fmt: skip
    x, shown = 60.0 + 250.0 / 3.6 * time, slice(None, None, 10)
    curves = {"Exudyn": other.force, f"Arcless, {kinematics}": force}
    evidence.figure(
        f"force-{kinematics}",
        {name: (x[shown], low_pass(one, 1e3, 20.0)[shown]) for name, one in curves.items()},
        x="position (m)", y="contact force to 20 Hz (N)", title="EN 50318:2002 at 250 km/h",
    )  # fmt: skip


FAULTS = [
    Fault("β of the wires halved", scaled("wires", "beta", 0.5), test_force_over_half_a_span),
    Fault("droppers without damping", scaled("links", "beta", 0.0), test_force_over_half_a_span),
    Fault("contact 20 % too soft",
          wrong(trajectory, "contact_stiffness", lambda stiffness: 0.8 * stiffness),
          test_force_over_half_a_span),
]  # fmt: skip
