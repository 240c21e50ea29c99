"""What the comparison of explicit steps notices: links that are too long, waves that are damped."""

from collections.abc import Callable
from typing import Any
from unittest.mock import patch

import pytest

from arcless.results import Result
from tests.support.explicit import EXPLICIT
from tests.verification.orders import test_explicit_steps

Noticed = Callable[..., None]
RunOnce = Callable[..., Result]
FAULTS: dict[str, dict[str, Any]] = {
    "contact wire in links of 0.9 m": {"solver.contact_wire_element": 0.9},
    "messenger wire in links of 1.5 m": {"solver.messenger_wire_element": 1.5},
    "point masses without their period correction (steps that are solved for)": {
        "solver.scheme": "trapezoidal",
    },
}


@pytest.mark.parametrize("fault", FAULTS)
def test_steps_of_another_line(noticed: Noticed, run_once: RunOnce, fault: str) -> None:
    other = {**EXPLICIT, **FAULTS[fault]}
    with patch.object(test_explicit_steps, "EXPLICIT", other):
        check = test_explicit_steps.test_shorter_cubic_elements
        noticed(fault, check, run_once=run_once, line="planar")
