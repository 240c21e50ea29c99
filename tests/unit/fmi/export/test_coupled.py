"""The FMUs of a line and of a pantograph, coupled as stiffly as they are inside, or not."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from examples.coupled_fmus import Exchange, by_compliance, by_strip, compared, plain

import arcless
from arcless.model import Scenario
from tests.support.exported import Driven, driven
from tests.unit.fmi.conftest import GIVEN, Short

Fmu = Callable[..., Path]
STEPS = 900
# A line that is given forces has friction from those of the step, a run from those of the last.
SMOOTH = {**GIVEN, "contact.friction_coefficient": 0.0}
SCHEMES: dict[str, dict[str, Any]] = {
    "newmark": {"solver.scheme": {"name": "newmark", "beta": 0.3025, "gamma": 0.6}},
    "generalised-alpha": {},
}


class ByName:
    """The FMU of the example, with the instance that the tests drive."""

    def __init__(self, run: Driven) -> None:
        self.run = run

    def get(self, name: str) -> float:
        return self.run.value(name)

    def set(self, name: str, value: float) -> None:
        self.run.put({name: value})

    def step(self, count: int = 1) -> None:
        self.run.step(count * self.run.h)


def inside(scenario: Scenario) -> list[float]:
    loop = arcless.realtime(scenario, simulated=True)
    return [float(loop.step(0.0)[0]) for _ in range(STEPS)]


def outside(fmu: Fmu, scenario: Scenario, given: str, exchange: Exchange) -> list[float]:
    with (
        driven(fmu(2, of=scenario, given=given)) as line,
        driven(fmu(3, of=scenario, pantograph="P1")) as pantograph,
    ):
        pair: Any = (ByName(line), ByName(pantograph))
        return [exchange(*pair) for _ in range(STEPS)]


@pytest.mark.parametrize("changes", SCHEMES.values(), ids=SCHEMES.keys())
def test_a_strip_with_its_compliance_is_a_pantograph_inside(
    short: Short, fmu: Fmu, changes: dict[str, Any]
) -> None:
    scenario = short(**GIVEN, **changes)
    found, expected = outside(fmu, scenario, "strip-height", by_strip), inside(scenario)
    assert max(expected) - min(expected) > 40.0
    # Rounding of heights of 6 m, 1e-15 m, over compliances of 1e-5 m/N, and how the line grows it.
    assert found == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("changes", SCHEMES.values(), ids=SCHEMES.keys())
def test_both_compliances_solve_the_contact(
    short: Short, fmu: Fmu, changes: dict[str, Any]
) -> None:
    scenario = short(**SMOOTH, **changes)
    found, expected = outside(fmu, scenario, "contact-force", by_compliance), inside(scenario)
    # As above.
    assert found == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize(("stiffness", "is_lost"), [(50e3, False), (800e3, True)])
def test_plain_exchange_is_lost_with_a_stiff_contact(
    short: Short, fmu: Fmu, stiffness: float, is_lost: bool
) -> None:
    """Forces a step late are near with a soft contact, and swing without bounds with a stiff one.

    Where waves leave it the wire yields as a damper of 2 √(T μ) ≈ 0.3 kN s/m: with a spring k the
    force of a step later is 1 − k h/(2 √(T μ)) times that of now, whose size is above 1 for
    k h > 0.6 kN s/m, k > 600 kN/m at 1 ms; with the strip, that yields too, for less.
    """
    scenario = short(**SMOOTH, **{"contact.stiffness": stiffness})
    with (
        driven(fmu(2, of=scenario)) as line,
        driven(fmu(3, of=scenario, pantograph="P1")) as pantograph,
    ):
        pair: Any = (ByName(line), ByName(pantograph))
        largest, lost = compared(*pair, plain(stiffness), inside(scenario))
    assert largest > 1.0
    assert (lost is not None) == is_lost
