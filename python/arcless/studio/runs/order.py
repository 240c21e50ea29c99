"""An order of the page to run a scenario, checked before anything is computed."""

import json
import os
import shlex
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from arcless.errors import ModelError
from arcless.model import Scenario
from arcless.model.advice.speeds import check_typed_speed
from arcless.model.files.yaml_reader import Origin
from arcless.model.load import load_text
from arcless.model.scenario.overrides import apply
from arcless.results.kept_runs.places import is_study_folder
from arcless.results.run_folder.run_folder import FILES, folder_of
from arcless.studio.answers.answers import Refused
from arcless.studio.project import texts
from arcless.studio.project.project import Project, is_shipped

# Fields that are changed at once; a form has some dozens.
MOST_CHANGES = 1000
# Starts of `certainty`, where the scenario names none.
STARTS = 4
_SHIPPED = "shipped:scenario/"


@dataclass(frozen=True)
class Order:
    """A run that is to be computed, ready to be sent to another process.

    Attributes
    ----------
    scenario
        What is run, resolved, with its changes.
    folder
        Whole path of the folder that takes it.
    replace
        Whether a run that is there goes.
    command
        The command that runs this again.
    """

    scenario: Scenario
    folder: Path
    replace: bool
    command: str


def order_of(project: Project, asked: Mapping[str, Any]) -> Order:
    """Return the order that a JSON object is.

    Raises
    ------
    Refused
        It is none; or a run is in its folder, which `replace` would replace. With `keep_both` the
        new one takes a folder of that name with a number.
    ArclessError
        The scenario is wrong.
    """
    scenario, command = changed_scenario(project, asked)
    check_typed_speed(scenario)
    if asked.get("certainty") is True and scenario.certainty is None:
        scenario = scenario.with_(certainty={"starts": STARTS})
        command = f"{command} --certainty {STARTS}"
    # A link inside of the folder could lead out of it.
    folder = project.inside(folder_of(scenario).as_posix())
    replace = asked.get("replace") is True
    if asked.get("keep_both") is True:
        folder = _free(project, folder)
    _check_free(project, folder, replace=replace)
    return Order(scenario, folder, replace, command)


def changed_scenario(project: Project, asked: Mapping[str, Any]) -> tuple[Scenario, str]:
    """Return the scenario of an order with its changes, and the command that runs it.

    Raises
    ------
    Refused
        It is no order.
    ArclessError
        The scenario is wrong.
    """
    path, changes = asked.get("scenario"), asked.get("changes") or {}
    if not isinstance(path, str) or not isinstance(changes, dict) or len(changes) > MOST_CHANGES:
        raise Refused(400, "no order of a run")
    scenario = _loaded(project, path)
    if asked.get("record_motion") is True and scenario.output.motion is None:
        changes = {**changes, "output.motion": True}
    if changes:
        scenario = apply(scenario, changes, place=_place(project, path))
    return scenario, _command(path, changes)


def _loaded(project: Project, path: str) -> Scenario:
    file = texts.model_file(project, path)
    within = file.resolve().parent if is_shipped(path) else project.folder
    loaded = load_text(texts.read(project, path)["text"], file, within)
    if not isinstance(loaded, Scenario):
        raise ModelError("no scenario", where=path, expected="a scenario, which can be run")
    return loaded


def _place(project: Project, path: str) -> Origin:
    """Return where files that changes name are looked for: next to the scenario, in the project."""
    folder = project.folder if is_shipped(path) else project.inside(path).parent
    return Origin(folder=folder, within=project.folder)


def _free(project: Project, folder: Path) -> Path:
    """Return the folder, or the first of its name with a number that holds no run or study."""
    free, number = folder, 1
    while is_study_folder(free) or _holds_run(free):
        number += 1
        free = project.inside(f"{project.name_of(folder)}-{number}")
    return free


def _holds_run(folder: Path) -> bool:
    return any(os.path.lexists(folder / file) for file in FILES)


def _check_free(project: Project, folder: Path, *, replace: bool) -> None:
    name = project.name_of(folder)
    if is_study_folder(folder):
        raise Refused(409, f"{name} holds a study")
    if not replace and _holds_run(folder):
        raise Refused(409, f"{name} holds a run already", path=name, may_replace=True)


def _command(path: str, changes: Mapping[str, Any]) -> str:
    name = path.removeprefix(_SHIPPED) if is_shipped(path) else path
    words = ["arcless", "run", name]
    for field, value in changes.items():
        words += ["--set", f"{field}={value if isinstance(value, str) else json.dumps(value)}"]
    return shlex.join(words)
