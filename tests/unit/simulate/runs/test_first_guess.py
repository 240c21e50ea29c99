"""The guess of a static force: closed forms, and that a search needs no more than two runs."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import Pantograph
from arcless.simulate.runs import first_guess
from arcless.simulate.runs.job import Job
from arcless.simulate.runs.mean_force import find_forces
from tests.support.small import laid_out

ELASTICITY, BASE, TARGET = 4e-4, 200.0, 150.0  # m/N, N/m, N


def uniform(speed: float, rise: float = 0.0, distance: float = 0.0) -> Any:
    """Make a job on a line alike everywhere, higher by `rise` in m where the section begins."""
    found = SimpleNamespace(
        elasticities=lambda places: [np.full(len(x), ELASTICITY) for x in places],
        elasticity_positions=lambda: np.array([150.0]),
        lowest_heights=lambda x: np.where(x >= 100.0, 5.0 + rise, 5.0),
    )
    model = Pantograph(name="p", masses=[{"mass": 9.0, "stiffness": BASE, "damping": 0.0}])  # type: ignore[arg-type]
    return SimpleNamespace(
        found=found,
        travel=SimpleNamespace(positions=np.array([50.0]), speeds=np.array([speed])),
        scenario=SimpleNamespace(
            analysis_range=lambda: (100.0, 200.0),
            line=SimpleNamespace(wave_speed=100.0),
            pantographs=[SimpleNamespace(model=model, distance=distance)],
        ),
    )


def guessed(job: Any) -> tuple[float, float]:
    forces, slopes = first_guess.guess(job, np.array([TARGET]))
    return float(forces[0]), float(slopes[0])


def test_a_slow_pantograph_on_a_uniform_line_needs_what_it_gives() -> None:
    # To rounding: the wire rises by the same everywhere, and the base spring is never stretched.
    assert guessed(uniform(0.0)) == pytest.approx((TARGET, 1.0), rel=1e-14)


def test_a_higher_wire_stretches_the_base_spring() -> None:
    force, _ = guessed(uniform(0.0, rise=0.02))
    assert force - TARGET == pytest.approx(BASE * 0.02 / (1.0 + BASE * ELASTICITY), rel=1e-12)


def test_a_moving_force_raises_a_string_on_springs_more() -> None:
    force, slope = guessed(uniform(60.0))
    moving = 1.0 + BASE * ELASTICITY / 0.8  # √(1 − 0.6²)
    assert force == pytest.approx(TARGET * moving / (1.0 + BASE * ELASTICITY), rel=1e-12)
    assert slope == pytest.approx((1.0 + BASE * ELASTICITY) / moving, rel=1e-12)


def test_beyond_the_wave_speed_the_guess_stays_finite() -> None:
    assert guessed(uniform(99.9)) == guessed(uniform(300.0))


def test_springs_one_on_the_other_yield_together() -> None:
    masses = [{"mass": 9.0, "stiffness": k, "damping": 0.0} for k in (100.0, 400.0)]
    assert first_guess.base_stiffness(
        Pantograph(name="p", masses=masses)  # type: ignore[arg-type]
    ) == pytest.approx(80.0, rel=1e-14)


def test_without_a_base_spring_the_mean_is_the_force() -> None:
    masses = [{"mass": 9.0, "stiffness": 0.0, "damping": 0.0}]
    assert first_guess.base_stiffness(Pantograph(name="p", masses=masses)) == 0.0  # type: ignore[arg-type]


def test_two_runs_are_enough(monkeypatch: pytest.MonkeyPatch) -> None:
    job = laid_out(arcless.load("en50318-ac-simple-320-planar"))
    count, step = [0], Job.step

    def counted(*given: Any, **named: Any) -> Any:
        count[0] += 1
        return step(*given, **named)

    monkeypatch.setattr(Job, "step", counted)
    search = find_forces(job)
    assert count[0] <= 2
    assert search.record is not None
