"""What the comparison of random lines with their limit notices."""

from collections.abc import Callable
from typing import Any
from unittest.mock import patch

import pytest

from tests.verification.limits import test_random_lines as topic

Noticed = Callable[..., None]
CUBIC = {"solver.scheme": "generalised-alpha", "solver.residual_flexibility": False}
CHAINS = {"solver.scheme": "central-difference"}
# Fault, a seed that shows it, and what is asked for.
FAULTS: dict[str, tuple[int, dict[str, Any]]] = {
    "cubic elements of 1.45 m and 2.9 m that miss point forces": (
        0,
        CUBIC | {"solver.contact_wire_element": 1.45, "solver.messenger_wire_element": 2.9},
    ),
    "point masses every 0.9 m and 1.2 m": (
        2,
        CHAINS | {"solver.contact_wire_element": 0.9, "solver.messenger_wire_element": 1.2},
    ),
}


@pytest.mark.evidence
@pytest.mark.parametrize("fault", FAULTS)
def test_other_elements(noticed: Noticed, fault: str) -> None:
    seed, asked = FAULTS[fault]
    with patch.object(topic, "ASKED", asked):
        noticed(fault, topic.test_random_line, seed=seed)


@pytest.mark.evidence
def test_a_heavier_wire(noticed: Noticed) -> None:
    mass = topic.scenario_of(4).line.contact_wire.mass
    with patch.object(topic, "ASKED", {"line.contact_wire.mass": 1.02 * mass}):
        noticed("contact wire 2 % heavier", topic.test_random_line, seed=4)
