"""What the comparison of shipped scenarios with their limit notices."""

from collections.abc import Callable
from typing import Any
from unittest.mock import patch

import pytest

from tests.verification.limits import test_shipped_scenarios as topic

Noticed = Callable[..., None]
FAULTS: dict[str, tuple[str, dict[str, Any]]] = {
    "messenger wire in links of 1.5 m": (
        "en50318-ac-simple-320-planar",
        {"solver.scheme": "central-difference", "solver.messenger_wire_element": 1.5},
    ),
    "elements of a conductor rail of 4 m": (
        "conductor-rail-1-120",
        {"solver.contact_wire_element": 4.0},
    ),
}


@pytest.mark.evidence
@pytest.mark.parametrize("fault", FAULTS)
def test_other_elements(noticed: Noticed, fault: str) -> None:
    name, asked = FAULTS[fault]
    with patch.object(topic, "ASKED", asked):
        noticed(fault, topic.test_shipped_scenario, name=name)
