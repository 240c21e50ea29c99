"""Runs that are looked at while they step: the same looks, the same bits, and where they stop."""

from collections.abc import Callable
from typing import Any

import pytest

import arcless
from arcless.assess import assess
from arcless.model import Scenario
from arcless.simulate import Look, Outcome, batch
from tests.support.small import differing

Make = Callable[..., Scenario]
FINE = {"solver.time_step": "1 ms"}  # the core hands on its record every 256 steps


class Looker:
    """Keeps what it sees, and stops at a look of a run."""

    def __init__(self, places: list[float], stop: tuple[int, int] | None = None) -> None:
        self.places, self.stop = places, stop
        self.looks: list[Look] = []

    def see(self, look: Look) -> str | None:
        self.looks.append(look)
        return "enough" if (look.run, look.number) == self.stop else None


def watched(scenario: Scenario, looker: Looker, **options: Any) -> Outcome:
    (outcome,) = batch([scenario], watch=lambda _index, _scenario: looker, **options)
    return outcome


@pytest.mark.parametrize(
    "changes",
    [{}, {"pantographs.0.mean_force": "80 N"}, {"output.energy": "always"},
     {"output.contact_every": 2, "output.line_every": 3}],
    ids=["plain", "mean force", "ledger", "sparse"],
)  # fmt: skip
def test_what_is_not_stopped_is_what_it_is_alone(short: Make, changes: dict[str, Any]) -> None:
    scenario = short(**FINE, **changes)
    looker = Looker([0.25, 0.5, 0.75])
    outcome = watched(scenario, looker, keep="result")
    assert outcome.result is not None
    alone = arcless.run(scenario).dataset
    assert set(outcome.result.dataset.variables) == set(alone.variables)
    for name, variable in alone.data_vars.items():
        assert differing(outcome.result.dataset[name], variable)[1] == 0, name
    assert [look.number for look in looker.looks if look.run == 1] == [0, 1, 2]
    assert outcome.steps == max(look.run for look in looker.looks) * outcome.steps_of_run


def test_a_look_is_an_assessment_of_the_part_travelled(short: Make) -> None:
    scenario = short(**FINE)
    looker = Looker([0.5])
    watched(scenario, looker)
    (look,) = looker.looks
    begin, end = scenario.analysis_range()
    assert look.assessment.section_m == [begin, 0.5 * (begin + end)]
    whole = arcless.run(scenario)
    part = assess(whole.dataset, section=(begin, 0.5 * (begin + end)))
    # What comes later moves the filter by what a fifth of a second leaves of it.
    assert look.assessment.pantographs[0].mean_force_N == pytest.approx(
        part.pantographs[0].mean_force_N, rel=1e-3
    )
    now, then = look.assessment.pantographs[0], part.pantographs[0]
    assert now.unfiltered_max_force_N == then.unfiltered_max_force_N
    assert look.position_m > 0.5 * (begin + end)
    uplift = (look.assessment.max_uplift_at_support_mm, part.max_uplift_at_support_mm)
    assert uplift[0] is not None and uplift[1] is not None and uplift[0] <= uplift[1]
    # Half of the section at one speed; a sample or two lie on its ends.
    assert look.share == pytest.approx(0.5, abs=2e-3)


@pytest.mark.parametrize("force", [{}, {"pantographs.0.mean_force": "80 N"}])
def test_a_stopped_run_says_where_and_why(short: Make, force: dict[str, Any]) -> None:
    looker = Looker([0.25, 0.5, 0.75], stop=(1, 1))
    outcome = watched(short(**FINE, **force), looker)
    assert outcome.assessment is None and outcome.error is None
    assert outcome.stopped is not None
    assert outcome.stopped.why == "enough"
    last = looker.looks[-1]
    assert (outcome.stopped.position_m, outcome.stopped.time_s) == (last.position_m, last.time_s)
    assert len(looker.looks) == 2
    assert 0 < outcome.steps < outcome.steps_of_run
    assert outcome.steps % 256 == 0


def test_looks_do_not_depend_on_who_else_runs(short: Make) -> None:
    speeds = ["120 km/h", "140 km/h", "160 km/h"]
    seen: list[dict[int, Looker]] = []
    for workers in (1, 3):
        lookers = {index: Looker([0.3, 0.6]) for index in range(len(speeds))}
        scenarios = [short(**FINE, speed=speed) for speed in speeds]
        batch(scenarios, workers=workers, watch=lambda i, _s, known=lookers: known[i])
        seen.append(lookers)
    for one, other in zip(*(lookers.values() for lookers in seen), strict=True):
        assert [look.time_s for look in one.looks] == [look.time_s for look in other.looks]
        for a, b in zip(one.looks, other.looks, strict=True):
            assert a.assessment.pantographs == b.assessment.pantographs


def test_settled_forces_do_not_change_any_more(short: Make) -> None:
    # Twenty periods of 60 Hz are a third of a second: a part of this short run.
    section = {"from": "60 m", "to": "190 m", "low_pass": "60 Hz"}
    scenario = short(**FINE, analysis=section)
    settled = []

    class Settled(Looker):
        def see(self, look: Look) -> str | None:
            settled.append(look.settled())
            return None

    watched(scenario, Settled([0.5, 0.75]))
    known = [one for one in settled if one is not None]
    assert known
    whole = arcless.run(scenario)
    for one in known:
        begin, end = one.section_m
        then = assess(whole.dataset, section=(begin, end)).pantographs[0]
        # The filter forgets e^(-2π·20·sin(π/12)), some 1e-14, of forces of some 100 N.
        assert one.pantographs[0].max_force_N == pytest.approx(then.max_force_N, abs=1e-9)
        assert one.pantographs[0].min_force_N == pytest.approx(then.min_force_N, abs=1e-9)
