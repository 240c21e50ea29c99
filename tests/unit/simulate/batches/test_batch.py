"""A batch: every member is what it is alone, failures are outcomes, and what is done stays done."""

import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.assess import Assessment
from arcless.equilibrium import equilibrium
from arcless.model import Scenario
from arcless.simulate.batches.fingerprints import SharedKeys, member_key, shared_key
from arcless.simulate.runs.job import Line, ready_line
from tests.support.small import differing

Make = Callable[..., Scenario]
TIMES = ("setup_time_s", "wall_time_s", "real_time_factor")


def numbers(assessment: Assessment | None) -> dict[str, Any]:
    """Return an assessment without what the clock says."""
    assert assessment is not None
    return {key: value for key, value in assessment.to_dict().items() if key not in TIMES}


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return the names of the scenarios whose line was put at rest."""
    from arcless.simulate.batches import groups

    names: list[str] = []
    real = groups.ready_line

    def noticed(scenario: Scenario, tell: Any) -> Line:
        names.append(scenario.name)
        return real(scenario, tell)

    monkeypatch.setattr(groups, "ready_line", noticed)
    return names


def varied(short: Make) -> list[Scenario]:
    """Return scenarios that differ in speed, force, pantograph and what is asked of them."""
    return [
        short(),
        short(speed="120 km/h"),
        short(**{"pantographs.0.static_force": "90 N"}),
        short(**{"pantographs.0.mean_force": "80 N"}),
        short(**{"pantographs.0.model.masses.0.damping": "120 N s/m"}),
        short(**{"output.energy": "always", "output.contact_every": 2}),
        short(**{"travel.end": "180 m", "analysis.to": "170 m"}),
    ]


def test_members_are_what_they_are_alone(short: Make, made: list[str]) -> None:
    scenarios = varied(short)
    outcomes = arcless.batch(scenarios, workers=2)
    assert [outcome.index for outcome in outcomes] == list(range(len(scenarios)))
    for scenario, outcome in zip(scenarios, outcomes, strict=True):
        assert outcome.error is None
        assert outcome.result is None
        assert numbers(outcome.assessment) == numbers(arcless.run(scenario).assessment)
    assert len(made) == 1, "one line for all"


def test_results_are_those_of_single_runs(short: Make) -> None:
    scenarios = varied(short)[:4]
    for scenario, outcome in zip(scenarios, arcless.batch(scenarios, keep="result"), strict=True):
        assert outcome.result is not None
        alone = arcless.run(scenario).dataset
        assert set(outcome.result.dataset.variables) == set(alone.variables)
        for name, variable in alone.data_vars.items():
            assert differing(outcome.result.dataset[name], variable)[1] == 0, name


def test_a_batch_is_split_where_members_do_not_share(short: Make, made: list[str]) -> None:
    scenarios = [
        short(**{field: value})
        for value in ("21 kN", "23 kN")
        for field in ("line.contact_wire.tension", "line.messenger_wire.tension")
    ]
    scenarios += [short(**{"solver.time_step": "3 ms"}), scenarios[0]]
    outcomes = arcless.batch(scenarios)
    assert len(made) == 5
    for scenario, outcome in zip(scenarios, outcomes, strict=True):
        assert numbers(outcome.assessment) == numbers(arcless.run(scenario).assessment)


def test_a_failing_member_does_not_lose_the_others(short: Make, tmp_path: Path) -> None:
    error = {"span": 3, "dropper": 2, "length_error": "-2 m"}
    loose = {"as_built.dropper_length_errors": [error]}
    scenarios = [
        short(),
        short(**loose),
        short(**{"pantographs.0.controller": {"sample_time": "20 ms"}}),
        short(**loose, speed="120 km/h"),
        short(speed="120 km/h"),
    ]
    heard: list[str] = []
    outcomes = arcless.batch(
        scenarios, folder=tmp_path, progress=lambda _fraction, text: heard.append(text)
    )
    assert [outcome.error is None for outcome in outcomes] == [True, False, False, False, True]
    for scenario, outcome in zip(scenarios, outcomes, strict=True):
        if outcome.error is not None:
            with pytest.raises(type(outcome.error)) as alone:
                _ = arcless.run(scenario).assessment
            assert alone.value.what == outcome.error.what
    assert heard[-1] == "5 of 5 runs, 3 failed"


def test_what_nobody_has_foreseen_is_an_outcome_too(
    short: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    from arcless.simulate.batches import workers

    real = workers.lay_out

    def slips(scenario: Scenario, *others: Any, **more: Any) -> Any:
        if scenario.speed == short(speed="120 km/h").speed:
            raise ZeroDivisionError("a slip")
        return real(scenario, *others, **more)

    monkeypatch.setattr(workers, "lay_out", slips)
    outcomes = arcless.batch([short(), short(speed="120 km/h"), short()])
    assert [outcome.error is None for outcome in outcomes] == [True, False, True]
    assert "ZeroDivisionError: a slip" in str(outcomes[1].error)


def test_a_folder_goes_on_where_it_stopped(short: Make, tmp_path: Path) -> None:
    scenarios = [short(speed=f"{speed} km/h") for speed in (120, 130, 140, 150)]
    whole = arcless.batch(scenarios, folder=tmp_path / "whole")

    def stop(outcome: arcless.Outcome) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        arcless.batch(scenarios, folder=tmp_path / "other", take=stop)
    again = arcless.batch(scenarios, folder=tmp_path / "other")
    assert any(outcome.was_there for outcome in again)
    assert not all(outcome.was_there for outcome in again)
    for one, other in zip(whole, again, strict=True):
        assert numbers(one.assessment) == numbers(other.assessment)
    listed = (tmp_path / "other" / "members.csv").read_text().splitlines()
    assert listed == (tmp_path / "whole" / "members.csv").read_text().splitlines()
    assert listed[1].startswith(f"0,{scenarios[0].name},")
    assert "; speed=120 km/h; " in listed[1]


def test_members_with_one_name_are_told_apart_by_what_was_set(short: Make, tmp_path: Path) -> None:
    scenarios = [short().with_(speed=f"{speed} km/h") for speed in (120, 130)]
    scenarios.append(short().with_(**{"line.contact_wire.tension": "1 N"}))  # which fails
    last = {"line.contact_wire.tension": "1 N"}
    own = [{"speed": "120 km/h"}, {"speed": "130 km/h"}, last]
    expected = [short().changes | one for one in own]
    taken: dict[int, dict[str, str]] = {}
    for _ in range(2):  # the second time they are there
        outcomes = arcless.batch(
            scenarios, folder=tmp_path, take=lambda one: taken.update({one.index: one.changes})
        )
        assert [one.changes for one in outcomes] == expected
        assert [taken[index] for index in range(3)] == expected
    assert [one.was_there for one in outcomes] == [True, True, False]
    assert len({one.name for one in outcomes}) == 1


def test_what_was_changed_or_damaged_is_run_again(short: Make, tmp_path: Path) -> None:
    scenarios = [short(speed=f"{speed} km/h") for speed in (120, 130, 140)]
    first = arcless.batch(scenarios, folder=tmp_path)
    assert first[0].path is not None
    first[0].path.write_text(first[0].path.read_text()[:200])
    scenarios[1] = scenarios[1].with_(**{"analysis.low_pass": "15 Hz"})
    again = arcless.batch(scenarios, folder=tmp_path)
    assert [outcome.was_there for outcome in again] == [False, False, True]
    assert numbers(again[0].assessment) == numbers(first[0].assessment)


def test_results_go_to_files_that_open(short: Make, tmp_path: Path) -> None:
    scenarios = [short(), short(speed="120 km/h")]
    arcless.batch(scenarios, folder=tmp_path)
    outcomes = arcless.batch(scenarios, keep="result", folder=tmp_path)
    for outcome in outcomes:
        assert not outcome.was_there, "only assessments were"
        assert outcome.path is not None
        assert numbers(arcless.open(outcome.path).assessment) == numbers(outcome.assessment)
    assert all(o.was_there for o in arcless.batch(scenarios, keep="result", folder=tmp_path))


def test_taken_outcomes_are_not_kept(short: Make) -> None:
    taken: list[arcless.Outcome] = []
    threads: set[int] = set()

    def take(outcome: arcless.Outcome) -> None:
        threads.add(threading.get_ident())
        taken.append(outcome)

    outcomes = arcless.batch([short(), short(speed="120 km/h")], take=take)
    assert all(outcome.assessment is not None for outcome in taken)
    assert all(outcome.assessment is None for outcome in outcomes)
    assert threads == {threading.get_ident()}


def test_members_are_made_when_they_are_needed(
    short: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys.modules["arcless.simulate.batches.batch"], "AHEAD", 2)
    base, done, most = short(), 0, 0

    def many() -> Iterator[Scenario]:
        nonlocal most
        for number in range(8):
            most = max(most, number - done)
            yield base

    def take(_outcome: arcless.Outcome) -> None:
        nonlocal done
        done += 1

    assert len(arcless.batch(many(), workers=1, take=take)) == 8
    assert most <= 2


def test_members_that_come_one_at_a_time_share_their_line(
    short: Make, made: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys.modules["arcless.simulate.batches.batch"], "AHEAD", 1)
    other = short(**{"line.contact_wire.tension": "21 kN"})
    arcless.batch(iter([short(), short(), other, other]), workers=1)
    assert len(made) == 2


def test_a_batch_that_is_cancelled_stops(short: Make) -> None:
    with pytest.raises(KeyboardInterrupt):
        arcless.batch([short(**{"solver.time_step": "0.01 ms"})] * 3, cancel=lambda: True)
    assert arcless.batch([]) == []


@pytest.mark.parametrize("wrong", [{"workers": 0}, {"keep": "everything"}])
def test_wrong_wishes_are_refused(short: Make, wrong: dict[str, Any]) -> None:
    with pytest.raises(arcless.errors.ModelError):
        arcless.batch([short()], **wrong)


def test_a_folder_that_is_a_file_is_refused(short: Make, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(arcless.errors.OutputError, match="folder"):
        arcless.batch([short()], folder=tmp_path / "file")


def test_what_is_shared_follows_from_the_data(short: Make) -> None:
    base = short()
    same = [
        short(name="another", **{"line.name": "another"}),
        short(speed="100 km/h"),
        short(**{"pantographs.0.static_force": "90 N", "output.points": [100.0]}),
    ]
    gusty = {"as_built.gusts": {"time": [0.0, 9.0], "speed": [0.0, 9.0]}}
    wires = [f"line.{wire}.diameter" for wire in ("contact_wire", "messenger_wire")]
    spatial = {"solver.dimension": "spatial", **dict.fromkeys(wires, "12 mm")}
    assert shared_key(short(**spatial, **gusty)) == shared_key(short(**spatial))
    other = [
        short(**{"line.contact_wire.tension": "21 kN"}),
        short(**{"as_built.temperature_difference": "5 K"}),
        short(**{"solver.time_step": "3 ms"}),
        short(**{"solver.scheme": "trapezoidal"}),
        short(**{"solver.kinematics": "updated"}),
        short(**{"contact.stiffness": "60 kN/m"}),
        short(**{"contact.law": "rigid"}),
    ]
    assert {shared_key(scenario) for scenario in same} == {shared_key(base)}
    assert len({shared_key(scenario) for scenario in [base, *other]}) == len(other) + 1
    # What is remembered of one member is not taken for another one.
    known, mixed = SharedKeys(), [base, *same, base, *other, base]
    assert [known.of(scenario) for scenario in mixed] == [shared_key(s) for s in mixed]


def test_a_time_step_that_follows_the_speed_is_part_of_what_is_shared(short: Make) -> None:
    base = short(**{"solver.time_step": "one element", "solver.contact_wire_element": "0.5 m"})
    known, faster = SharedKeys(), base.with_(speed="200 km/h")
    assert faster.solver is base.solver
    assert known.of(base) == shared_key(base) != known.of(faster) == shared_key(faster)


class Noticed:
    """Stands for a scenario, and notes which of its fields are read."""

    def __init__(self, scenario: Scenario, read: set[str]) -> None:
        self._scenario, self._read = scenario, read

    def __getattr__(self, name: str) -> Any:
        self._read.add(name)
        return getattr(self._scenario, name)


def test_a_line_is_made_from_nothing_that_its_key_lacks(short: Make) -> None:
    read: set[str] = set()
    scenario: Any = Noticed(short(**{"as_built.temperature_difference": "5 K"}), read)
    ready_line(scenario, lambda _fraction, _text: None)
    assert read == {"line", "as_built", "solver", "stepping", "time_step_s", "contact"}


def test_a_controllers_file_is_part_of_its_member(short: Make, tmp_path: Path) -> None:
    file = tmp_path / "controller.py"
    file.write_text("def force(seen):\n    return 0.0\n")
    scenario = short(
        **{
            "pantographs.0.controller": {
                "function": f"{file}:force", "sample_time": "20 ms", "mass": 1,
            }
        }
    )  # fmt: skip
    before = member_key(scenario)
    file.write_text("def force(seen):\n    return 1.0\n")
    assert member_key(scenario) != before
    file.unlink()
    assert member_key(scenario) != before


def test_elasticities_are_found_once(short: Make) -> None:
    found = equilibrium.find(short())
    x = np.linspace(60.0, 190.0, 20)
    first = found.elasticity(x)
    again = found.elasticity(x)
    assert differing(first, again)[1] == 0
    again[:] = 0.0
    assert differing(first, found.elasticity(x))[1] == 0
