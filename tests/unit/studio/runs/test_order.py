"""Orders of runs: a folder that holds a run is refused, replaced, or kept with the new one."""

from pathlib import Path

import pytest

from arcless.results.run_folder.run_folder import FILES
from arcless.studio.answers.answers import Refused
from arcless.studio.project.project import Project
from arcless.studio.runs.order import order_of

ASKED = {"scenario": "shipped:scenario/en50318-ac-simple-320-planar"}


def test_keep_both_takes_the_first_free_number(tmp_path: Path) -> None:
    project = Project.of(tmp_path)
    first = order_of(project, {**ASKED, "keep_both": True}).folder
    for number in (2, 3):
        taken = order_of(project, {**ASKED, "keep_both": True}).folder
        taken.mkdir(parents=True)
        (taken / FILES[0]).touch()
        next_free = order_of(project, {**ASKED, "keep_both": True}).folder
        assert next_free == first.with_name(f"{first.name}-{number}")


def test_a_run_that_is_there_stays_without_a_word(tmp_path: Path) -> None:
    project = Project.of(tmp_path)
    folder = order_of(project, ASKED).folder
    folder.mkdir(parents=True)
    (folder / FILES[0]).touch()
    with pytest.raises(Refused, match="holds a run already"):
        order_of(project, ASKED)
    assert order_of(project, {**ASKED, "replace": True}).folder == folder
