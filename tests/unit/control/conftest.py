"""A short line with a controlled pantograph, prepared once."""

from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless import control
from arcless.model import Scenario

SHORT = Path(__file__).parents[2] / "interface" / "data" / "short.yaml"
# A delay that is no multiple of the sample time, and limits that laws of these tests reach.
ACTUATOR: dict[str, Any] = {
    "sample_time": "4 ms",
    "delay": "6 ms",
    "minimum_force": "-60 N",
    "maximum_force": "60 N",
    "rate_limit": "3 kN/s",
}
FEW_ELEMENTS = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": 1.45,
    "solver.messenger_wire_element": 2.9,
}
SETTINGS: dict[str, Any] = {
    "actuator": ACTUATOR,
    "spans": 1,
    "lead_in_spans": 1,
    "action_in": "N",
    "observe": tuple(control.SIGNALS),
}


@pytest.fixture(scope="session")
def scenario() -> Scenario:
    return arcless.load(SHORT).with_(**FEW_ELEMENTS)


@pytest.fixture(scope="session")
def task(scenario: Scenario) -> control.Task:
    """Return a task that sees every signal, with actions in N."""
    return control.task(scenario, **SETTINGS)
