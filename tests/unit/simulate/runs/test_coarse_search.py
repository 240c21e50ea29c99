"""A static force is searched for on a coarse copy first: what that costs, and that nothing else
depends on it."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import ContactError
from arcless.model import Scenario
from arcless.simulate import Look, batch
from arcless.simulate.runs import mean_force
from arcless.simulate.runs.job import Job, Line
from arcless.simulate.runs.mean_force import TOLERANCE, find_forces, searching
from tests.support.small import differing, laid_out

Make = Callable[..., Scenario]
EXPLICIT = {"solver.scheme": "auto", "solver.time_step": "auto"}
TARGET = {"pantographs.0.static_force": None, "pantographs.0.mean_force": "85 N"}


@pytest.fixture
def steps(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return the point-steps of all runs that are made."""
    made: list[float] = []
    step = Job.step

    def counted(job: Job, *given: Any, **named: Any) -> Any:
        raw = step(job, *given, **named)
        made.append(raw["steps"] * len(job.found.mesh.positions))
        return raw

    monkeypatch.setattr(Job, "step", counted)
    return made


def whole(job: Job) -> int:
    """Return the point-steps of one run."""
    return job.travel.steps * len(job.found.mesh.positions)


def known(short: Make) -> list[Scenario]:
    two = [
        {"model": "ac-simple", "mean_force": "85 N", "name": "front"},
        {"model": "ac-simple", "mean_force": "75 N", "name": "rear", "distance": "35 m"},
    ]
    return [
        arcless.load("en50318-ac-simple-320"),
        arcless.load("france-lgv-est-320"),
        short(**EXPLICIT, **TARGET),
        short(**EXPLICIT, pantographs=two, travel={"end": "245 m"}),
    ]


@pytest.mark.parametrize("number", range(4), ids=["AC simple", "LGV Est", "short", "two"])
def test_a_search_costs_a_run_and_a_copy(short: Make, steps: list[float], number: int) -> None:
    job = laid_out(known(short)[number])
    search = find_forces(job)
    assert search.record is not None
    assert sum(steps) < 1.3 * whole(job)
    asked = [placement.mean_force for placement in job.scenario.pantographs]
    assert mean_force._means(job, search.record) == pytest.approx(asked, abs=TOLERANCE)


def test_a_wrong_mean_of_the_copy_is_put_right_by_the_run(
    short: Make, steps: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    means = mean_force._means

    def wrong(job: Job, raw: dict[str, Any], of: Job | None = None) -> Any:
        return means(job, raw, of) + (0.0 if of is None else 0.7)

    monkeypatch.setattr(mean_force, "_means", wrong)
    job = laid_out(short(**EXPLICIT, **TARGET))
    search = find_forces(job)
    assert search.record is not None
    assert means(job, search.record) == pytest.approx([85.0], abs=TOLERANCE)
    assert [made == whole(job) for made in steps] == [False, True, True]


def test_a_far_guess_is_tried_again_on_the_copy(
    short: Make, steps: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    far = np.array([93.0]), np.array([0.9])
    monkeypatch.setattr(mean_force, "guess", lambda *_: far)
    job = laid_out(short(**EXPLICIT, **TARGET))
    find_forces(job)
    assert [made == whole(job) for made in steps] == [False, False, True]


@pytest.mark.parametrize("what", ["line", "step", "nonsense"])
def test_a_copy_that_fails_leaves_whole_runs(
    short: Make, steps: list[float], monkeypatch: pytest.MonkeyPatch, what: str
) -> None:
    job = laid_out(short(**EXPLICIT, **TARGET))
    step, means = Job.step, mean_force._means

    def failing(one: Job, *given: Any, **named: Any) -> Any:
        if one.travel.steps < job.travel.steps:
            raise ContactError("too coarse")
        return step(one, *given, **named)

    if what == "line":
        monkeypatch.setattr(Line, "of_copies", lambda *_: None)
    elif what == "step":
        monkeypatch.setattr(Job, "step", failing)
    else:
        monkeypatch.setattr(
            mean_force, "_means", lambda *of: means(*of) * (1.0 if len(of) < 3 else np.nan)
        )
    search = find_forces(job)
    assert search.record is not None
    assert means(job, search.record) == pytest.approx([85.0], abs=TOLERANCE)
    assert len([made for made in steps if made == whole(job)]) >= 2


def test_a_controlled_run_has_no_copy(short: Make) -> None:
    pid = {"sample_time": "10 ms", "pid": {"target": "85 N", "proportional": 0.1}}
    controlled = short(**EXPLICIT, **TARGET, **{"pantographs.0.controller": pid})
    assert laid_out(controlled).copy() is None
    assert laid_out(short(**EXPLICIT, **TARGET)).copy() is not None


@pytest.mark.parametrize("every", [1, 3])
def test_a_run_has_its_own_mean_at_its_own_instants(short: Make, every: int) -> None:
    job = laid_out(short(**EXPLICIT, **{"output.contact_every": every}))
    raw = job.step([80.0], full=False)
    own = mean_force._at_instants(job, raw["time"], raw["force"].reshape(-1, 1), job)
    # To rounding, of instants and places alike.
    if every == 1:
        np.testing.assert_allclose(own[0], raw["force"].reshape(-1, 1), rtol=1e-9)
    np.testing.assert_allclose(own[1], raw["position"].reshape(-1, 1), rtol=1e-12)


def test_members_of_a_batch_share_the_line_of_their_copies(
    short: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    from arcless.simulate.runs import job

    made: list[float] = []
    real = job.ready_line
    monkeypatch.setattr(
        job, "ready_line", lambda s, tell: (made.append(s.time_step_s), real(s, tell))[1]
    )
    speeds = "120 km/h", "140 km/h", "160 km/h"
    scenarios = [short(**EXPLICIT, **TARGET, speed=speed) for speed in speeds]
    outcomes = batch(scenarios, keep="result", workers=2)
    assert len(made) == 1
    for scenario, outcome in zip(scenarios, outcomes, strict=True):
        assert outcome.result is not None
        alone = arcless.run(scenario)
        found = "static_force_found"
        assert outcome.result.metadata[found] == alone.metadata[found]
        for name, variable in alone.dataset.data_vars.items():
            assert differing(outcome.result.dataset[name], variable)[1] == 0, name


class Looker:
    places = (0.3, 0.6)

    def __init__(self) -> None:
        self.looks: list[Look] = []

    def see(self, look: Look) -> str | None:
        self.looks.append(look)
        return None


def test_looks_are_at_whole_runs_and_a_copy_counts_as_what_it_costs(short: Make) -> None:
    scenario, looker = short(**EXPLICIT, **TARGET), Looker()
    (outcome,) = batch([scenario], watch=lambda _index, _scenario: looker)
    assert [(look.run, look.number) for look in looker.looks] == [(1, 0), (1, 1)]
    assert 1.2 < outcome.steps / outcome.steps_of_run < 1.3


def test_a_copy_can_be_cancelled(short: Make) -> None:
    told: list[str] = []
    with pytest.raises(KeyboardInterrupt):
        arcless.run(
            short(**EXPLICIT, **TARGET),
            progress=lambda _fraction, text: told.append(text),
            cancel=lambda: "finding the static force" in told,
        )


def test_nothing_is_searched_where_nothing_is_asked_for(short: Make, steps: list[float]) -> None:
    with pytest.raises(StopIteration):
        next(searching(laid_out(short(**EXPLICIT))))
    assert steps == []
