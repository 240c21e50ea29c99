"""What the energies of explicit steps notice: a term that is lost, a step that is no shorter.

Faults inside of the core are in tests/faults/core/explicit.py: contacts that press elsewhere,
guests that stay behind, a damper that is off.
"""

from collections.abc import Callable
from typing import Any
from unittest.mock import patch

import pytest

from arcless.simulate.recording import record
from tests.verification.conservation import test_energy_explicit

Noticed = Callable[..., None]
variables = record.dynamic_variables
LOST = {
    "energy_dissipated_line": "compliant contact",
    "energy_dissipated_supports": "compliant contact",
    "energy_switching": "loss of contact",
    "energy_contact": "rigid contact",
    "energy_work_friction": "friction along the wire",
    "energy_work_wind": "gusts",
    "energy_work_control": "controlled force",
}


@pytest.fixture(autouse=True)
def anew() -> Any:
    """Forget the runs before and after a fault."""
    kept = (
        test_energy_explicit.ran,
        test_energy_explicit.shipped,
        test_energy_explicit.switched,
    )
    [one.cache_clear() for one in kept]
    yield
    [one.cache_clear() for one in kept]


@pytest.mark.parametrize("name", LOST)
def test_a_term_that_is_not_booked(noticed: Noticed, name: str) -> None:
    def without(*given: Any, **options: Any) -> dict[str, Any]:
        found = variables(*given, **options)
        assert found[name].any()
        return found | {name: 0.0 * found[name]}

    with patch.object(record, "dynamic_variables", without):
        check = test_energy_explicit.test_the_ledger_closes
        noticed(f"`{name}` not booked", check, case=LOST[name])


def test_a_term_that_is_not_booked_on_a_shipped_line(noticed: Noticed) -> None:
    def without(*given: Any, **options: Any) -> dict[str, Any]:
        found = variables(*given, **options)
        return found | {"energy_elastic": 0.999999 * found["energy_elastic"]}

    with patch.object(record, "dynamic_variables", without):
        check = test_energy_explicit.test_wires_at_points_of_others
        for case in test_energy_explicit.SHIPPED:
            noticed(f"elastic energy off by 1e-6, {case}", check, case=case)


def test_steps_that_do_not_shrink(noticed: Noticed) -> None:
    switched = test_energy_explicit.switched

    def lasting(step: str) -> float:
        return switched("1 ms") * (1.0 + 0.01 * len(step))

    with patch.object(test_energy_explicit, "switched", lasting):
        check = test_energy_explicit.test_switching_falls_with_the_step
        noticed("switching that does not fall", check)
