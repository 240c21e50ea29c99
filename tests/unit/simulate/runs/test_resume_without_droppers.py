"""Runs on lines without droppers are resumed, too: a series without columns is in no file."""

from pathlib import Path

import pytest

import arcless
from arcless.model import Scenario
from tests.support.parts import in_parts, unlike

NAMES = [
    "conductor-rail-1-120", "conductor-rail-2-120", "conductor-rail-3-120", "trolley-bridles-60",
]  # fmt: skip


def cut_short(name: str) -> Scenario:
    scenario = arcless.load(name)
    start = scenario.travel_range()[0]
    travel = {"start": start, "end": start + 30.0}
    changes = {"travel": travel, "analysis": {"from": start, "to": start + 29.0}}
    return scenario.with_(**changes, certainty=None)


@pytest.mark.parametrize("name", NAMES)
def test_parts_are_the_whole_run(name: str, tmp_path: Path) -> None:
    scenario = cut_short(name)
    whole = arcless.run(scenario)
    assert "dropper_force" not in whole.dataset or whole.dataset["dropper_force"].size
    compared, differing = unlike(whole, in_parts(scenario, tmp_path, "0.2 s", "0.5 s"))
    assert compared > 1000
    assert differing == 0


def test_the_rest_may_go_to_the_disk(tmp_path: Path) -> None:
    scenario = cut_short(NAMES[0])
    arcless.run(scenario, until="0.2 s").save(tmp_path / "part.nc")
    rest = arcless.resume(arcless.open(tmp_path / "part.nc"), to=tmp_path / "whole.nc")
    assert unlike(arcless.run(scenario), rest)[1] == 0
