"""Comparison of a run on the disk with the scenario as it is now, whatever was edited since."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from arcless.dataset.netcdf.store import read_facts
from arcless.model import load
from arcless.studio.project.project import Project
from arcless.studio.runs.order import changed_scenario
from arcless.studio.runs.places import run_of

# Words, and fields of what is recorded or repeated: they change no number of a run.
_NO_CONTENT = frozenset({"name", "description", "sources", "provenance", "output", "certainty"})


def is_current(project: Project, asked: Mapping[str, Any]) -> bool:
    """Return whether a scenario with changes, run now, would be computed as a run was.

    Parameters
    ----------
    project
        The project.
    asked
        Path of the `run`, path of the `scenario`, and its `changes` as for an order.

    Raises
    ------
    Refused
        There is no such run, or the rest is no order.
    ArclessError
        The scenario is wrong.
    """
    file = run_of(project, asked.get("run"))
    now, _ = changed_scenario(project, asked)
    return bool(_content(_scenario_of(file)) == _content(now.to_dict()))


def _scenario_of(file: Path) -> Mapping[str, Any]:
    # Through the model: a scenario of an earlier version has no fields that came later.
    return load(read_facts(file)["scenario"]).to_dict()


def _content(scenario: Mapping[str, Any]) -> Any:
    # Through JSON, which has no tuples.
    return json.loads(json.dumps(scenario), object_hook=_without_words)


def _without_words(part: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in part.items() if key not in _NO_CONTENT}
