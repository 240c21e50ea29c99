"""Pantographs that a program of Python moves: the same bounces as a simulated one, and failures."""

from dataclasses import dataclass, field
from math import inf, nan
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless import _core
from arcless.simulate.setup.core_data import PantographData
from arcless.simulate.setup.pantographs import plain
from tests.support import bare
from tests.support.schemes import Member

Floats = NDArray[np.float64]
AVERAGE = Member("newmark", (0.25, 0.5), beta=0.25, gamma=0.5)
MASS, FORCE, STEPS, H = 8.0, 100.0, 400, 1e-3
STIFFNESS = 50e3


def given() -> Floats:
    """Return a force in N that throws the mass off the wall, at the start and after each step."""
    return 160.0 * np.sin(np.arange(STEPS + 1) * 0.05)


@dataclass
class Mass:
    """A mass under a force of its own, stepped by Newmark's method with average acceleration."""

    fails_in: int = -1
    heights: Any = None
    compliance: Any = None
    begun: list[tuple[Floats, Floats]] = field(default_factory=list)
    asked: list[tuple[int, float, float, float]] = field(default_factory=list)
    motion: Floats = field(default_factory=lambda: np.zeros(3))
    inertia: float = 4.0 * MASS / H**2

    def begin(self, heights: Floats, forces: Floats) -> None:
        self.begun.append((heights, forces))
        self.motion = np.array([heights[0], 0.0, 0.0])

    def predict(self, step: int, time: float, position: float, speed: float) -> Any:
        if step == self.fails_in:
            raise LookupError("the program has lost its model")
        self.asked.append((step, time, position, speed))
        u, v, a = self.motion
        self.force = FORCE + given()[step + 1]
        free = u + (self.force + MASS * (4.0 * v / H + a)) / self.inertia
        heights = [free] if self.heights is None else self.heights
        return heights, [[1.0 / self.inertia]] if self.compliance is None else self.compliance

    def advance(self, forces: Floats) -> list[float]:
        u, v, a = self.motion
        delta = (self.force - forces[0] + MASS * (4.0 * v / H + a)) / self.inertia
        self.motion = np.array(
            [u + delta, 2.0 * delta / H - v, 4.0 / H**2 * (delta - H * v) - a],
        )
        return [u + delta]


def external(program: Any) -> PantographData:
    return PantographData(
        mass=[],
        damping=[],
        stiffness=[],
        strips=[plain([1.0], None)],
        preload=[],
        lift=[],
        start_force=FORCE,
        external=program,
    )


def asked(*, ledger: bool = True) -> bare.Asked:
    places = bare.stand(0.0, STEPS)
    return bare.Asked(AVERAGE, H, places, contact_stiffness=STIFFNESS, ledger=ledger)


def test_a_mass_moved_by_a_program_bounces_as_a_simulated_one() -> None:
    program = Mass()
    found = bare.run(bare.wall(), external(program), asked())
    inside = bare.run(bare.wall(), bare.free_mass(MASS, FORCE, given()), asked())
    force = np.asarray(inside["force"])
    assert np.count_nonzero(force == 0.0) > 20, "it leaves the wall"
    # Rounding of heights times the contact stiffness, over a few impacts.
    np.testing.assert_allclose(found["force"], force, atol=1e-6)
    np.testing.assert_allclose(found["masses"], inside["masses"], atol=1e-11)
    assert len(program.begun) == 1
    heights, forces = program.begun[0]
    # The strip lies in the wall by the compression of the contact.
    np.testing.assert_allclose(heights, [FORCE / STIFFNESS], rtol=1e-9)
    np.testing.assert_allclose(forces, [FORCE], rtol=1e-12)
    assert program.asked[0] == (0, 0.0, 0.0, 0.0)
    assert program.asked[-1] == (STEPS - 1, (STEPS - 1) * H, 0.0, 0.0)


def test_work_on_the_strip_is_what_the_mass_does_not_keep() -> None:
    program = Mass()
    found = bare.run(bare.wall(), external(program), asked())["energy"]
    inside = bare.run(bare.wall(), bare.free_mass(MASS, FORCE, given()), asked())["energy"]
    assert not np.any(found["pantograph"])
    by_scheme = inside["dissipated_scheme"] - found["dissipated_scheme"]
    passed_on = inside["work_uplift"] - inside["pantograph"] - by_scheme
    assert np.ptp(passed_on) > 0.1
    # Rounding of heights times the contact force.
    np.testing.assert_allclose(found["work_uplift"], passed_on, atol=1e-8)


def test_an_exception_of_the_program_reaches_the_caller() -> None:
    with pytest.raises(LookupError, match="lost its model"):
        bare.run(bare.wall(), external(Mass(fails_in=7)), asked())


@pytest.mark.parametrize(
    ("program", "message"),
    [
        (Mass(heights=[nan]), "the height is NaN m"),
        (Mass(compliance=[[inf]]), "the compliance is inf m/N"),
        (Mass(compliance=[[-1e-6]]), "the compliance is negative"),
    ],
    ids=["height", "compliance", "negative"],
)
def test_a_motion_that_cannot_be_ends_the_run(program: Mass, message: str) -> None:
    with pytest.raises(_core.NativeError) as caught:
        bare.run(bare.wall(), external(program), asked())
    kind, text, details = caught.value.args
    assert kind == "external"
    assert message in text
    assert (details["pantograph"], details["step"], details["time"]) == (0, 0, 0.0)


def test_numbers_that_are_not_as_many_as_strips_are_refused() -> None:
    with pytest.raises(ValueError, match="2 heights of an external pantograph, expected 1"):
        bare.run(bare.wall(), external(Mass(heights=[0.0, 0.0])), asked())


def test_an_external_pantograph_has_no_matrices() -> None:
    heavy = external(Mass())._replace(mass=[1.0])
    with pytest.raises(ValueError, match="no matrices"):
        bare.run(bare.wall(), heavy, asked())
