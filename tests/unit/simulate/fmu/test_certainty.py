"""Certainty of a run with an FMU: other starts, the refined run, and their end."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.model import Scenario
from arcless.results import Result
from tests.support import fmus, processes
from tests.unit.simulate.fmu.test_in_runs import outside, with_model

Short = Callable[..., Scenario]
pytestmark = fmus.can_run
# Eight spans, with room for starts within one.
ROOM = {
    "line.spans": [{"type": "span", "count": 8}],
    "travel": {"start": "60 m", "end": "340 m"},
    "analysis": {"from": "160 m", "to": "310 m"},
}


def ran(short: Short, file: Path, **certainty: Any) -> Result:
    """Run the short line with an FMU and additional runs; none of their processes is left."""
    scenario = with_model(short(**ROOM), outside(file), static_force=80.0)
    before = processes.below(os.getpid())
    found = arcless.run(scenario.with_(certainty=certainty), allow_fmu=True)
    assert set(processes.below(os.getpid())) <= set(before)
    return found


def test_starts_vary_and_the_force_stays(tmp_path: Path, short: Short) -> None:
    found = ran(short, fmus.fmu(tmp_path), starts=3, other_family=False)
    kept = found.metadata["certainty"]
    assert len(set(kept["starts_m"])) == 3
    # Nobody but the FMU knows of a spring to its base: the force is the same at every start.
    assert kept["static_force_N"] == [[80.0]] * 3
    assert (len(kept["draws"]), kept["refined"], kept["notes"]) == (2, None, [])
    [own] = found.assessment.to_dict()["pantographs"]
    assert own["certainty"]["std_force_N"]["spread"] > 0.0


def test_a_refined_step_that_the_fmu_cannot_take_is_a_note(tmp_path: Path, short: Short) -> None:
    """Steps of 2 ms are what it takes inside; the refined run has shorter ones."""
    file = fmus.fmu(tmp_path, fmi=3, attributes='fixedInternalStepSize="0.002"')
    found = ran(short, file, starts=3)
    kept = found.metadata["certainty"]
    assert (len(kept["draws"]), kept["refined"]) == (2, None)
    [note] = kept["notes"]
    assert note.startswith("the error of discretisation is not known, as the run by the other")
    assert "a time step that the FMU cannot take: got 0.5 ms, expected a multiple of 2 ms" in note
    [own] = found.assessment.to_dict()["pantographs"]
    assert own["certainty"]["std_force_N"].get("discretisation") is None


def test_an_additional_run_that_is_not_allowed_never_begins(
    tmp_path: Path, short: Short, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ARCLESS_ALLOW_FMU", raising=False)
    scenario = with_model(short(**ROOM), outside(fmus.fmu(tmp_path)), static_force=80.0)
    with pytest.raises(arcless.FmuError, match="not allowed to run"):
        arcless.run(scenario.with_(certainty={"starts": 3}))
