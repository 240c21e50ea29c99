"""Halving element lengths or time step changes mean, deviation and uplift by less than 1 %."""

from collections.abc import Callable
from typing import Any

import pytest

import arcless
from arcless.results import Result

RunOnce = Callable[..., Result]

# The bound that the project promises for its reference runs.
ALLOWED = 0.01
CASES = (
    "en50318-ac-simple-320",
    "en50318-ac-simple-275",
    "en50318-2002-250",
    "en50318-2002-300",
)


def numbers(result: Result) -> dict[str, float]:
    pantograph = result.assessment.pantographs[0]
    return {
        "mean": pantograph.mean_force_N,
        "deviation": pantograph.std_force_N,
        "uplift": result.assessment.max_uplift_at_support_mm,
    }


def same_force(result: Result) -> dict[str, Any]:
    """Fix the static force that was found: a refined run must not search its own."""
    force = result.metadata["static_force_found"]["P1"]
    return {"pantographs.0.static_force": force}


@pytest.mark.parametrize("refined", ["elements", "time step"])
@pytest.mark.parametrize("name", CASES)
def test_halving_changes_less_than_1_percent(run_once: RunOnce, name: str, refined: str) -> None:
    result = run_once(name)
    solver = arcless.load(name).solver
    halved = (
        {
            "solver.contact_wire_element": solver.contact_wire_element / 2,
            "solver.messenger_wire_element": solver.messenger_wire_element / 2,
        }
        if refined == "elements"
        else {"solver.time_step": solver.time_step / 2}
    )
    fine = numbers(run_once(name, {**same_force(result), **halved}))
    changes = {key: fine[key] / value - 1.0 for key, value in numbers(result).items()}
    assert max(map(abs, changes.values())) < ALLOWED, changes
