"""What the energies notice: a term that is lost, a damper or a force that is off."""

from collections.abc import Callable
from typing import Any
from unittest.mock import patch

import pytest

from arcless.simulate.recording import record
from arcless.simulate.setup import pantographs
from tests.verification.conservation import test_energy

Noticed = Callable[..., None]
variables, chain = record.dynamic_variables, pantographs._chain
LOST = {
    "energy_dissipated_supports": "generalised-alpha",
    "energy_switching": "rigid contact, loss of contact",
    "energy_work_friction": "friction along the wire",
    "energy_work_wind": "gusts",
    "energy_work_control": "controlled force",
}


@pytest.fixture(autouse=True)
def anew() -> Any:
    """Forget the runs before and after a fault."""
    test_energy.ran.cache_clear()
    test_energy.on_a_damper.cache_clear()
    yield
    test_energy.ran.cache_clear()
    test_energy.on_a_damper.cache_clear()


@pytest.mark.parametrize("name", LOST)
def test_a_term_that_is_not_booked(noticed: Noticed, name: str) -> None:
    def without(*given: Any, **options: Any) -> dict[str, Any]:
        found = variables(*given, **options)
        assert found[name].any()
        return found | {name: 0.0 * found[name]}

    with patch.object(record, "dynamic_variables", without):
        noticed(f"`{name}` not booked", test_energy.test_the_ledger_closes, case=LOST[name])


def test_a_scheme_that_damps(noticed: Noticed) -> None:
    damping = {"solver.scheme": {"name": "generalised-alpha", "spectral_radius": 0.999}}
    with patch.dict(test_energy.CASES, {"trapezoidal rule": damping}):
        check = test_energy.test_the_trapezoidal_rule_takes_nothing
        noticed("spectral radius 0.999 in place of 1", check)


def test_a_damper_of_the_pantograph_that_is_off(noticed: Noticed) -> None:
    def damped(pantograph: Any) -> Any:
        (mass, damping, stiffness), lift, strips = chain(pantograph)
        return [mass, 1.0001 * damping, stiffness], lift, strips

    with patch.object(pantographs, "_chain", damped):
        noticed("dampers 0.01 % off", test_energy.test_energies_of_the_pantograph)


def test_a_force_that_is_recorded_a_step_late(noticed: Noticed) -> None:
    def late(*given: Any, **options: Any) -> dict[str, Any]:
        found = variables(*given, **options)
        force = found["contact_force"].copy()
        force[1:] = force[:-1]
        return found | {"contact_force": force}

    with patch.object(record, "dynamic_variables", late):
        noticed("contact force one step late", test_energy.test_energies_of_the_pantograph)
