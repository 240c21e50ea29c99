"""Reference runs: halving elements or time step

The promise: halving the element lengths or the time step changes mean, standard deviation and
uplift of the reference runs by less than 1 %. The static force is the one found by the first run of
each case, so that only the refinement differs. Orders of convergence stand in the other topics of
this group; here is what is left at the mesh that ships.

Asked as the reference scenarios of simple lines, planar and in space.
"""

from collections.abc import Callable
from functools import wraps
from typing import Any

import pytest

import arcless
from arcless.model.settings.schemes import EXPLICIT
from arcless.results import Result
from tests.support import fresh
from tests.support.evidence import Evidence
from tests.support.faults import Fault

RunOnce = Callable[..., Result]
ALLOWED = 1.0
SLOW = (
    "en50318-2002-300",
    *(f"en50318-ac-simple-{case}" for case in ("275", "320", "275-planar", "320-planar")),
)


def numbers(result: Result) -> dict[str, float]:
    pantograph = result.assessment.pantographs[0]
    uplift = result.assessment.max_uplift_at_support_mm
    assert uplift is not None
    return {
        "mean force": pantograph.mean_force_N,
        "standard deviation": pantograph.std_force_N,
        "uplift": uplift,
    }


def halved(scenario: str, refined: str) -> list[dict[str, Any]]:
    """Return what is refined less and what more.

    Explicit steps of elements half as long are not stable with half of the step: both have a
    quarter of it then. The family is named, which `auto` would choose anew.
    """
    solver = arcless.load(scenario).stepping
    explicit = solver.scheme.name == EXPLICIT
    named = {"solver.scheme": EXPLICIT} if explicit else {}
    if refined == "time step":
        return [{}, named | {"solver.time_step": solver.time_step / 2}]
    both = named | {"solver.time_step": solver.time_step / 4} if explicit else {}
    finer = {
        "solver.contact_wire_element": solver.contact_wire_element_m / 2,
        "solver.messenger_wire_element": solver.messenger_wire_element_m / 2,
    }
    return [both, both | finer]


@pytest.mark.parametrize("refined", ["elements", "time step"])
@pytest.mark.parametrize(
    "scenario",
    ["en50318-2002-250", *(pytest.param(name, marks=pytest.mark.evidence) for name in SLOW)],
)
def test_halving(evidence: Evidence, run_once: RunOnce, scenario: str, refined: str) -> None:
    result = run_once(scenario)
    force = {"pantographs.0.static_force": result.metadata["static_force_found"]["P1"]}
    coarse, fine = (
        numbers(run_once(scenario, {**force, **changes})) for changes in halved(scenario, refined)
    )
    for name, value in coarse.items():
        evidence.below(
            f"{scenario}, {refined} halved: change of the {name}",
            100 * abs(fine[name] / value - 1.0),
            ALLOWED,
            unit="%",
            reason="the bound that the project promises for its reference runs",
        )


@wraps(test_halving)
def against_10_ms(evidence: Evidence, run_once: RunOnce, **given: str) -> None:
    def coarse(name: str, changes: dict[str, Any] | None = None) -> Result:
        if "solver.time_step" in (changes or {}):
            # Explicit steps refuse to be so long: with a matrix.
            far = {"solver.scheme": "generalised-alpha", "solver.time_step": 10e-3}
            return fresh.run(name, {**(changes or {}), **far})
        return run_once(name, changes)

    test_halving(evidence, coarse, **given)


FAULTS = [
    Fault("10 ms where 0.5 ms should be", (), against_10_ms, scenario="en50318-2002-250",
          refined="time step"),
]  # fmt: skip
