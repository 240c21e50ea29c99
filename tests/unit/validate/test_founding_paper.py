"""The paper's conclusions, held against observations that were drawn."""

import json
from typing import Any

import numpy as np
import pytest

from arcless.model import load
from arcless.results import Result
from arcless.validate import founding_paper
from arcless.validate.hanger_joints import Joint, JointChanges
from arcless.validate.observation import Observation, observe
from tests.support.synthetic import synthetic_dataset

KMH = (180, 250, 340, 360)


def observation(kmh: int, low: float, high: float, gap: float = 0.0, **changes: Any) -> Observation:
    joint = {"change": 50.0, "elsewhere": 5.0, "near": 20.0, "rest": 2.0} | changes
    one = Joint(55.0, 55.125, joint["change"], joint["elsewhere"], 55.125)
    found = JointChanges((one,), joint["near"], joint["rest"])
    places = (55.0,) if gap else ()
    return Observation(kmh / 3.6, low, high, found, gap, places, 1.0 if gap else 0.0)


def as_published() -> list[Observation]:
    return [
        observation(180, 80.0, 110.0),
        observation(250, 60.0, 120.0),
        observation(340, 0.0, 240.0, 0.1),
        observation(360, 0.0, 430.0, 0.08),
    ]


def verdicts(seen: list[Observation]) -> list[bool]:
    return list(founding_paper.held(founding_paper.rows(seen)).values())


def test_all_three_hold() -> None:
    assert verdicts(as_published()) == [True, True, True]


def test_every_row_says_what_was_checked_and_under_which_assumption() -> None:
    rows = founding_paper.rows(as_published())
    assert len(rows) == 4 * (2 + 1 + 1)
    assert all(row.note and row.checked and row.assumption for row in rows)
    assert {row.mark for row in rows} == {"A"}


def test_a_force_that_falls_has_a_real_minus_sign() -> None:
    seen = as_published()
    seen[2] = observation(340, 0.0, 240.0, 0.1, change=-50.0)
    notes = " ".join(row.note for row in founding_paper.rows(seen))
    assert "largest: −50.0 N" in notes
    assert "largest: +50.0 N" in notes


@pytest.mark.parametrize("place", range(4))
@pytest.mark.parametrize("changes", [{"elsewhere": 50.0}, {"rest": 10.1}])
def test_one_speed_without_fast_change_at_a_joint(place: int, changes: dict[str, float]) -> None:
    seen = as_published()
    gap = seen[place].gap
    seen[place] = observation(KMH[place], seen[place].low, seen[place].high, gap, **changes)
    assert verdicts(seen) == [False, True, True]


def test_an_interval_that_does_not_grow() -> None:
    seen = as_published()
    seen[1] = observation(250, 85.0, 115.0)  # as wide as at 180 km/h
    assert verdicts(seen) == [True, False, True]


@pytest.mark.parametrize(
    ("place", "low", "gap"), [(0, 0.0, 0.2), (1, 0.0, 0.0), (2, 0.0, 0.0), (3, 5.0, 1e-4)]
)
def test_a_gap_too_many_or_too_few(place: int, low: float, gap: float) -> None:
    seen = as_published()
    seen[place] = observation(KMH[place], low, low + seen[place].width, gap)
    assert verdicts(seen) == [True, True, False]


def test_no_joint_in_the_section_is_no_evidence() -> None:
    seen = as_published()
    bare = JointChanges((), 0.0, 1.0)
    seen[0] = Observation(50.0, 80.0, 110.0, bare, 0.0, (), 0.0)
    assert verdicts(seen) == [False, True, True]


def test_what_is_observed() -> None:
    """Contact lost at 260 and 300 m of a section from 200 to 400 m, and once outside of it."""

    def lost(t: np.ndarray) -> np.ndarray:
        x = 20.0 * t
        return np.any([np.abs(x - at) < 1.0 for at in (100.0, 260.0, 300.0)], axis=0)

    def gap(t: np.ndarray) -> np.ndarray:
        return np.where(lost(t), 2e-3 - 1e-3 * np.abs(20.0 * t - 260.0).clip(max=1.0), 0.0)

    dataset = synthetic_dataset(
        force=lambda t: np.where(lost(t), 0.0, 100.0 + 30.0 * np.sin(t)), gap=gap
    )
    seen = observe(Result(dataset, load(json.loads(dataset.attrs["scenario"]))))
    assert seen.kmh == "72 km/h"
    assert (seen.low, seen.high) == pytest.approx((0.0, 130.0), abs=1e-3)  # sampled every 1 ms
    assert seen.gap == pytest.approx(2.0, rel=1e-9)
    assert seen.gaps_at == pytest.approx((260.0, 299.0), abs=0.05)
    # 4 m of 200 m; of the 100 samples in each gap one more or less.
    assert seen.loss == pytest.approx(2.0, abs=0.021)
    assert [joint.x for joint in seen.changes.joints] == list(range(205, 400, 10))
