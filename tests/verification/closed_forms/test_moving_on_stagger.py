"""Contacts that move along a wire with stagger that swings aside: what the plane has stays

A wire that runs from side to side, T along the track, slope ± s across it, is held across the track
where it turns. Up to the square of its slopes, its motion up and down

    (T/cos) w″ − EI w⁗ = μ ẅ + what presses,   along its length, V √(1 + s²)

knows nothing of its motion across the track, nor of what holds it there: tension pulls alike in all
directions, and a strip pushes upward only. So the closed forms of the plane must hold as they are:
a kink, a thrown head, a head on a spring, the wire's answer to a moving force, the mode that a mass
traps, a second pantograph. Derived here. What stagger does change is what is fastened to the wire:
an arm, which its radial force makes a spring (section on bands; group conservation, line with
stagger in space), and where on the strip the wire lies.

The program is asked as in those sections, in space: s = 0.03, turns 28.8 m apart (± 0.43 m, corners
of 60 mrad). Together with what is sent upward, 200 N push the wire 20 mm aside; the run that is
taken away has neither. Corners of 0.2 rad would show: a wire that is bent there already bends
upward more easily, 0.05 µm/N of 230 at 2 Hz, and 1/45 of that with 60 mrad.
"""

from dataclasses import replace

import pytest

from arcless.simulate.setup.core_data import LoadData
from tests.support.evidence import Evidence
from tests.support.families import FAMILIES, Family
from tests.support.faults import Fault, scaled
from tests.support.moving_runs import CHAIN_FIRST, SPEEDS
from tests.support.plans import STAGGERED, Plan
from tests.support.python_faults import wrong
from tests.support.straight import UPWARDS
from tests.verification.closed_forms import test_moving_head as heads
from tests.verification.closed_forms import test_moving_kink as kinks
from tests.verification.closed_forms import test_moving_pair as pairs
from tests.verification.closed_forms import test_moving_stiffness as answers

NUMBERS = [0, pytest.param(1, marks=pytest.mark.evidence)]


def coarse(name: str) -> Family:
    """Return a family without its smallest elements, which take longest in space."""
    family = FAMILIES[name]
    return replace(family, sizes=family.sizes[:3])


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("name", CHAIN_FIRST)
def test_kink(evidence: Evidence, name: str, number: int) -> None:
    kinks.check(evidence, coarse(name), SPEEDS[number], STAGGERED)


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("name", CHAIN_FIRST)
def test_head(evidence: Evidence, name: str, number: int) -> None:
    heads.check_thrown(evidence, coarse(name), SPEEDS[number], STAGGERED)
    heads.check_spring(evidence, coarse(name), SPEEDS[number], STAGGERED)


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("name", CHAIN_FIRST)
def test_harmonic_force(evidence: Evidence, name: str, number: int) -> None:
    answers.check_answer(evidence, coarse(name), SPEEDS[number], STAGGERED)


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("name", CHAIN_FIRST)
def test_trapped_mode(evidence: Evidence, name: str, number: int) -> None:
    answers.check_mode(evidence, coarse(name), SPEEDS[number], STAGGERED)


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("name", CHAIN_FIRST)
def test_damped_follower(evidence: Evidence, name: str, number: int) -> None:
    pairs.check_damped(evidence, coarse(name), SPEEDS[number], STAGGERED)


def upward(loads: list[LoadData]) -> list[LoadData]:
    """Let a twentieth of what pushes the wire aside push it upward."""
    return [
        *loads,
        *(LoadData([(node, UPWARDS, 0.05) for node, _, _ in own.pattern], own.sizes)
          for own in loads),
    ]  # fmt: skip


TILTED = wrong(Plan, "loads", upward)
HEAVIER = scaled("wires", "mass", 1.05)
FAULTS = [
    Fault("kink: a twentieth of the push aside is upward", TILTED, test_kink, name="chain",
          number=0),
    *(Fault(f"{name}: wire 5 % too heavy", HEAVIER, check, name=name, number=0)
      for name in ("chain", "cubic")
      for check in (test_kink, test_head, test_harmonic_force, test_damped_follower)),
    *(Fault(f"{name}: foundation 2 % too stiff", scaled("springs", "stiffness", 1.02),
            test_trapped_mode, name=name, number=0) for name in ("chain", "cubic")),
    *(Fault("a twentieth of the push aside is upward", TILTED, check, name="chain", number=0)
      for check in (test_head, test_harmonic_force, test_damped_follower)),
]  # fmt: skip
