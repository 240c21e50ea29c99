"""Runs from other starts: where they begin, that they are the same passage, what comes of it."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.assess.certainty import student_factor
from arcless.errors import ContactError, EquilibriumError, ModelError
from arcless.model import Scenario
from arcless.simulate.certainty import (
    additional_runs,
    other_starts,
    places,
    run_additional,
    sequential_runner,
)
from arcless.simulate.setup import trajectory
from tests.support.small import laid_out

Make = Callable[..., Scenario]
AC = "en50318-ac-simple-320-planar"
# Eight spans of 50 m: a run-in of two spans, and 150 m that are assessed.
LONG = {
    "line.spans": [{"type": "span", "count": 8}],
    "travel": {"start": "60 m", "end": "340 m"},
    "analysis": {"from": "160 m", "to": "310 m"},
}
TIMES = ("setup_time_s", "wall_time_s", "real_time_factor")


def asked(scenario: Scenario, count: int = 8, **more: Any) -> Scenario:
    return scenario.with_(certainty={"starts": count, **more})


def test_starts_go_forward_through_a_span() -> None:
    found = places(asked(arcless.load(AC)))
    assert found == pytest.approx([55.0 + 55.0 * k / 8 for k in range(8)])


def test_what_would_come_too_near_to_the_section_begins_a_span_before() -> None:
    scenario = asked(arcless.load(AC).with_(**{"analysis": {"from": "190 m", "to": "600 m"}}), 4)
    # 190 m less two spans is 80 m: starts from there on begin a span before.
    assert places(scenario) == pytest.approx([55.0, 68.75, 27.5, 41.25])


def test_starts_share_what_room_there_is() -> None:
    scenario = asked(arcless.load(AC).with_(**{"analysis": {"from": "150 m", "to": "600 m"}}), 4)
    found = places(scenario)
    # From a quarter of a span from the end of the line to the run's own start.
    assert found[0] == 55.0
    room = 55.0 - 13.75
    assert np.diff([13.75, *sorted(found)]) == pytest.approx(room / 4)
    assert other_starts.window(scenario) == pytest.approx((13.75, room))


def test_no_room_is_an_error_before_anything_is_computed() -> None:
    near = {"travel.start": "20 m", "analysis": {"from": "30 m", "to": "600 m"}}
    with pytest.raises(ModelError, match="no room for other starts") as caught:
        arcless.run(arcless.load(AC).with_(**near), certainty=3)
    assert caught.value.hint is not None
    [outcome] = arcless.batch([asked(arcless.load(AC).with_(**near))])
    assert isinstance(outcome.error, ModelError)


def test_the_last_pantograph_stays_on_the_line() -> None:
    scenario = asked(
        arcless.load("ac-simple-320-two-pantographs").with_(analysis={"from": "300 m"})
    )
    behind = scenario.pantographs[-1].distance
    assert min(places(scenario)) >= 0.25 * 55.0 + behind


def test_a_roof_that_moves_bounds_the_starts() -> None:
    over = {"position": [50.0, 1100.0], "displacement": [0.0, 0.0]}
    timed = {"time": [0.0, (1045.0 - 55.0) / (320 / 3.6)], "displacement": [0.0, 0.0]}
    for roof in (over, timed):
        changes = {
            "pantographs.0.roof_motion": roof,
            "analysis": {"from": "178.75 m", "to": "600 m"},
        }
        found = places(asked(arcless.load(AC).with_(**changes)))
        first = 50.0 if roof is over else 55.0
        assert min(found) >= first - 1e-9
        assert max(found) <= 178.75 - 110.0 + 1e-9


def test_a_train_that_changes_speed_has_the_same_speed_at_every_place(short: Make) -> None:
    profile = {"time": [0.0, 3.0, 6.0], "speed": [30.0, 45.0, 40.0]}
    scenario = asked(short(**LONG, speed_profile=profile), 4)
    job = laid_out(scenario)
    own = job.travel
    for place in [*places(scenario)[1:], 40.0]:
        [other] = other_starts.started_at(job, [80.0], [place])
        there = trajectory.motion(other)
        assert there.positions[0] == pytest.approx(place)
        inside = own.positions[(own.positions > max(place, 60.0)) & (own.positions < 330.0)]
        # A step cuts the corners of the profile by up to 5 m/s² times half a millisecond.
        speeds = np.interp(inside, own.positions, own.speeds)
        assert np.interp(inside, there.positions, there.speeds) == pytest.approx(speeds, abs=5e-3)
    [before] = other_starts.started_at(job, [80.0], [40.0])
    assert before.speed_profile is not None
    assert before.speed_profile.speed[0] == 30.0


def test_a_train_that_stands_first_comes_from_nowhere(short: Make) -> None:
    profile = {"time": [0.0, 3.0, 9.0], "speed": [0.0, 45.0, 45.0]}
    scenario = asked(short(**{**LONG, "analysis": {"from": "130 m"}}, speed_profile=profile))
    with pytest.raises(ModelError, match="no room"):
        places(scenario)


def test_the_pantograph_is_the_same_at_every_start(short: Make) -> None:
    """Over the height of the contact its forces lie on one line: that of its springs."""
    # A step in which the contact moves by a millimetre: what is recorded first is the start.
    scenario = asked(short(**LONG, **{"solver.time_step": "0.02 ms"}), 4)
    job = laid_out(scenario)
    points = []
    for place in places(scenario):
        [other] = other_starts.started_at(job, [80.0], [place])
        force = other.pantographs[0].static_force
        raw = laid_out(other).step([force], full=False, until=2)
        points.append((raw["height"][0], force))
    heights, forces = np.array(points).T
    assert np.ptp(heights) > 5e-3
    stiffness = 1.0 / (1.0 / 50.0 + 1.0 / 4200.0)  # N/m, both springs one behind the other
    # To half a millimetre of 40, by which the elasticity misses what the line does under 80 N.
    assert forces == pytest.approx(80.0 - stiffness * (heights - heights[0]), abs=0.5e-3 * 53.0)
    assert np.ptp(forces) > 0.5


def test_a_base_without_a_spring_keeps_its_force(short: Make) -> None:
    free = short(**LONG, **{"pantographs.0.model.masses.0.stiffness": 0.0})
    job = laid_out(asked(free))
    for other in other_starts.started_at(job, [80.0], places(asked(free))):
        assert other.pantographs[0].static_force == 80.0


def known(assessment: dict[str, Any]) -> dict[str, Any]:
    """Return an assessment without what the clock says."""
    found = {key: value for key, value in assessment.items() if key not in TIMES}
    method = found.get("certainty_method")
    if method is not None:
        found["certainty_method"] = {k: v for k, v in method.items() if k != "wall_time_s"}
    return found


def test_a_run_says_how_sure_its_numbers_are(short: Make, tmp_path: Path) -> None:
    scenario = short(**LONG)
    plain, sure = arcless.run(scenario), arcless.run(scenario, certainty=4)
    assert sure.scenario.certainty is not None
    for name in ("contact_force", "position", "support_uplift_max"):
        assert np.array_equal(plain.dataset[name].values, sure.dataset[name].values)
    [own] = sure.assessment.to_dict()["pantographs"]
    for key, value in own["certainty"].items():
        assert own[key] is not None
        assert value["spread"] >= 0.0
        assert value["discretisation"] >= 0.0
    assert own["certainty"]["std_force_N"]["spread"] > 0.0
    by_hand = [own["std_force_N"]]
    job = laid_out(sure.scenario)
    for place in places(sure.scenario)[1:]:
        [other] = other_starts.started_at(job, [80.0], [place])
        by_hand.append(arcless.run(other).assessment.pantographs[0].std_force_N)
    spread = student_factor(3) * float(np.std(by_hand, ddof=1))
    # The runs are the same, bit for bit; sums of four numbers round.
    assert own["certainty"]["std_force_N"]["spread"] == pytest.approx(spread, rel=1e-12)
    sure.save(tmp_path / "sure.nc")
    opened = arcless.open(tmp_path / "sure.nc")
    assert opened.assessment.to_dict() == sure.assessment.to_dict()


def test_a_batch_gives_what_a_run_gives(short: Make, tmp_path: Path) -> None:
    searched = {"pantographs.0.mean_force": "80 N"}
    scenarios = [asked(short(**LONG), 3), asked(short(**LONG, **searched), 3)]
    outcomes = arcless.batch(scenarios, folder=tmp_path, workers=2)
    again = arcless.batch(scenarios, folder=tmp_path)
    for scenario, outcome, stored in zip(scenarios, outcomes, again, strict=True):
        assert outcome.assessment is not None
        assert stored.was_there
        assert stored.assessment == outcome.assessment
        alone = arcless.run(scenario).assessment.to_dict()
        assert known(outcome.assessment.to_dict()) == known(alone)
        assert outcome.assessment.certainty_method is not None
    [kept] = arcless.batch(scenarios[:1], keep="result")
    assert kept.result is not None
    assert known(kept.result.assessment.to_dict()) == known(outcomes[0].assessment.to_dict())  # type: ignore[union-attr]


def test_variants_on_a_line_share_the_line_of_the_other_family(
    short: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    from arcless.simulate.batches import groups

    made: list[str] = []
    real = groups.ready_line
    monkeypatch.setattr(
        groups, "ready_line", lambda s, tell: (made.append(s.solver.wires), real(s, tell))[1]
    )
    forces = ("70 N", "80 N", "90 N")
    scenarios = [
        asked(short(**LONG, **{"pantographs.0.static_force": force}), 2) for force in forces
    ]
    assert all(outcome.error is None for outcome in arcless.batch(scenarios, workers=2))
    assert sorted(made) == ["hermite", "lumped"]


def test_a_run_that_goes_on_says_it_at_its_end(short: Make, tmp_path: Path) -> None:
    scenario = asked(short(**LONG), 3)
    part = arcless.run(scenario, until="200 m")
    assert part.metadata["certainty"] is None
    part.save(tmp_path / "part.nc")
    whole = arcless.resume(arcless.open(tmp_path / "part.nc"))
    assert known(whole.assessment.to_dict()) == known(arcless.run(scenario).assessment.to_dict())


def test_a_run_that_is_written_while_it_steps_says_it(short: Make, tmp_path: Path) -> None:
    scenario = asked(short(**LONG), 3)
    streamed = arcless.run(scenario, to=tmp_path / "long.nc")
    assert known(streamed.assessment.to_dict()) == known(arcless.run(scenario).assessment.to_dict())


def test_every_run_has_controllers_of_its_own(short: Make) -> None:
    class Counting:
        """Decides by how often it was asked."""

        def __init__(self) -> None:
            self.asked = 0

        def __call__(self, _seen: arcless.ControlInput) -> float:
            self.asked += 1
            return 5.0 if self.asked < 100 else 0.0

    scenario = short(**LONG)
    name = scenario.pantographs[0].name
    once, again = (
        arcless.run(scenario, controllers={name: Counting}, certainty=3).assessment.to_dict()
        for _ in range(2)
    )
    assert known(once) == known(again)
    assert once["pantographs"][0]["certainty"]["std_force_N"]["spread"] > 0.0


def test_several_pantographs_each_say_it(placement: dict[str, Any], short: Make) -> None:
    second = {**placement, "name": "P2", "distance": 30.0}
    two = short(**{**LONG, "travel.start": "90 m", "travel.end": "340 m"} | {
        "pantographs": [placement, second], "travel": {"start": "90 m", "end": "340 m"},
        "analysis": {"from": "200 m", "to": "300 m"},
    })  # fmt: skip
    found = arcless.run(two, certainty=3).assessment.to_dict()
    assert [p["certainty"]["std_force_N"]["spread"] > 0.0 for p in found["pantographs"]] == [
        True
    ] * 2
    assert len(found["certainty_method"]["static_force_N"][1]) == 2


def failing(job: Any, fails: Callable[[Scenario], Exception | None]) -> additional_runs.Runs:
    """Return who runs scenarios but those that are to fail."""
    real = sequential_runner(job, lambda: False, beside_line)

    def runs(scenarios: Any) -> Any:
        outcomes = []
        for scenario in scenarios:
            error = fails(scenario)
            [outcome] = real([scenario])
            outcomes.append(
                outcome if error is None else arcless.Outcome(0, scenario.name, error=error)  # type: ignore[arg-type]
            )
        return outcomes

    return runs


def beside_line(scenario: Scenario) -> Any:
    from arcless.simulate.runs.job import ready_line

    return ready_line(scenario, lambda _done, _text: None)


def test_starts_that_fail_are_told_and_the_others_count(short: Make) -> None:
    scenario = asked(short(**LONG), 4, other_family=False)
    job, bad = laid_out(scenario), places(scenario)[2]
    error = ContactError("the motion grew beyond all bounds", hint="/tmp/somewhere")
    runs = failing(job, lambda s: error if s.travel.start == bad else None)
    found = run_additional(job, [80.0], runs)
    assert len(found["draws"]) == 2
    assert found["notes"] == [
        "1 of 3 runs from other starts failed, and the spread is that of the others: the motion"
        " grew beyond all bounds"
    ]


def test_where_a_line_refuses_chains_cubic_elements_are_refined(short: Make) -> None:
    scenario = asked(short(**LONG), 2)
    job = laid_out(scenario)
    error = EquilibriumError("no chain stands here")
    found = run_additional(
        job, [80.0], failing(job, lambda s: error if s.solver.wires == "lumped" else None)
    )
    assert found["other_family"]["wire_model"] == "hermite"
    assert found["refined"] is not None
    assert found["notes"] == []
    nothing = run_additional(
        job, [80.0], failing(job, lambda s: error if s.solver is not scenario.solver else None)
    )
    assert nothing["refined"] is None
    assert "error of discretisation is not known" in nothing["notes"][0]


def test_asking_from_python_keeps_what_the_scenario_says_beside(short: Make) -> None:
    scenario = asked(short(**LONG), 3, other_family=False)
    found = arcless.run(scenario, certainty=2)
    assert found.scenario.certainty is not None
    assert found.scenario.certainty.model_dump() == {"starts": 2, "other_family": False}
    method = found.assessment.certainty_method
    assert method is not None
    assert method["other_family"] is None
    assert all(
        value["discretisation"] is None
        for value in found.assessment.to_dict()["pantographs"][0]["certainty"].values()
    )


def test_cancelling_leaves_within_the_repeats(short: Make) -> None:
    seen: list[str] = []

    def cancel() -> bool:
        return any("repeats" in text for text in seen)

    with pytest.raises(KeyboardInterrupt):
        arcless.run(
            short(**LONG), certainty=100, progress=lambda _f, text: seen.append(text), cancel=cancel
        )
    assert sum("repeats" in text for text in seen) < 50
