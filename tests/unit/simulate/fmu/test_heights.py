"""Heights of the strips of an FMU within a step: against masses whose motion is known."""

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless.errors import FmuError
from arcless.simulate.fmu.heights import ExtrapolatedHeights, MeasuredHeights, sound

Floats = NDArray[np.float64]
STEP = 1e-3


class Masses:
    """Masses under held forces: z' = z + h v + h²/2 a, exactly; a spring that may harden."""

    def __init__(self, mass: Floats, hardening: float = 0.0) -> None:
        self.mass, self.hardening = mass, hardening
        self.z, self.v = np.zeros(len(mass)), np.zeros(len(mass))

    def after(self, forces: Floats) -> tuple[Floats, Floats]:
        inverse = np.linalg.inv(self.mass)
        # Implicit in the hardening spring, so that the heights of a step are not linear in forces.
        z = self.z
        for _ in range(60):
            a = inverse @ (100.0 - forces - self.hardening * z**3)
            z = self.z + STEP * self.v + STEP**2 / 2.0 * a
        return z, self.v + STEP * a

    def trial(self, forces: Floats) -> Floats:
        return np.array([self.after(row)[0] for row in forces])

    def go(self, forces: Floats) -> Floats:
        self.z, self.v = self.after(forces)
        return self.z


TWO = np.array([[9.0, 2.0], [2.0, 7.0]])


def test_a_linear_fmu_is_measured_once() -> None:
    masses = Masses(TWO)
    asked: list[Floats] = []

    def trial(forces: Floats) -> Floats:
        asked.append(forces)
        return masses.trial(forces)

    heights = MeasuredHeights(trial)
    forces = np.array([90.0, 110.0])
    for number in range(20):
        free, compliance = heights.predict(forces)
        np.testing.assert_allclose(compliance, STEP**2 / 2.0 * np.linalg.inv(TWO), rtol=1e-9)
        forces = np.array([90.0 + number, 110.0 - 3.0 * number])
        expected = free - compliance @ forces
        found = masses.go(forces)
        # Rounding of heights below 1 mm.
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-18)
        heights.reached(found, expected, compliance @ forces)
    assert heights.measured == 1
    assert [len(rows) for rows in asked] == [3] + 19 * [1]


def test_a_force_of_zero_is_no_trial() -> None:
    masses = Masses(TWO)
    heights = MeasuredHeights(masses.trial)
    _, compliance = heights.predict(np.zeros(2))
    np.testing.assert_allclose(compliance, STEP**2 / 2.0 * np.linalg.inv(TWO), rtol=1e-9)


def test_an_fmu_that_is_not_linear_is_measured_again() -> None:
    # At 10 mm the spring has 3 · 3e11 · 1e-4 = 9e7 N/m: h² k/2m is 6, far from small.
    masses = Masses(np.eye(1) * 7.0, hardening=3e10)
    masses.z += 4e-3
    heights = MeasuredHeights(masses.trial)
    forces, misses = np.array([100.0]), []
    for number in range(50):
        free, compliance = heights.predict(forces)
        forces = np.array([100.0 + 5.0 * np.sin(0.3 * number)])
        expected, found = free - compliance @ forces, masses.go(forces)
        heights.reached(found, expected, compliance @ forces)
        misses.append(float(abs(found - expected)[0] / (compliance @ forces)[0]))
    assert heights.measured > 25
    # Between the two forces that were asked and the one that came there is a twentieth of them.
    assert max(misses) < 0.02


@pytest.mark.parametrize(
    ("compliance", "words"),
    [
        ([[1e-7, 0.0], [0.0, -1e-8]], "a contact force raises a strip of the FMU"),
        ([[1e-7, 2e-8], [1e-8, 1e-7]], "the strips of the FMU do not act on each other alike"),
    ],
)
def test_what_no_strip_does_is_refused(compliance: list[list[float]], words: str) -> None:
    with pytest.raises(FmuError, match=words):
        sound(np.array(compliance))


def test_rounding_is_no_fault() -> None:
    found = sound(np.array([[1e-7, 1e-7], [1e-7 * (1 + 1e-9), 1e-7]]))
    assert np.array_equal(found, found.T)
    assert np.linalg.eigvalsh(found)[0] > -1e-22
    assert not sound(np.zeros((1, 1))).any()


def _forward(push: Callable[[int], float], mass_share: float = 1.0) -> tuple[Floats, Floats]:
    """Return what was expected and reached of a mass of 7 kg that only goes forward."""
    masses = Masses(np.eye(1) * 7.0)
    start = np.array([100.0])
    yielding = STEP**2 / (2.0 * 7.0 * mass_share)
    heights = ExtrapolatedHeights(yielding, masses.z, start)
    before, rows = start, []
    for number in range(40):
        free, compliance = heights.predict(before)
        before = np.array([push(number)])
        expected, found = free - compliance @ before, masses.go(before)
        heights.reached(found, expected, compliance @ before)
        rows.append((expected[0], found[0]))
    return tuple(np.array(rows).T)  # type: ignore[return-value]


def test_a_free_mass_is_extrapolated_exactly() -> None:
    expected, found = _forward(lambda number: 100.0 + 50.0 * np.sin(number))
    # The forces vary by their own size from step to step; rounding of 1 mm is all that is left.
    np.testing.assert_allclose(expected, found, rtol=0, atol=1e-17)
    assert np.ptp(found) > 1e-4


def test_a_wrong_mass_shows() -> None:
    expected, found = _forward(lambda number: 100.0 + 50.0 * np.sin(number), mass_share=1.1)
    assert np.max(np.abs(expected - found)) > 1e-8
