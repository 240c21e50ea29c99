"""Questions of the page → checked values: numbers, ranges, the file of a run."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from arcless.errors import ResultFormatError
from arcless.results import run_file
from arcless.studio.answers.answers import Refused
from arcless.studio.charts.plain.drawable import LEAST_POINTS, MOST_POINTS, USUAL_POINTS, Shown
from arcless.studio.project.project import Project
from arcless.units import show

# Parts of an address, which are texts, or an object of JSON.
Question = Mapping[str, Any]


def number(question: Question, name: str, otherwise: float) -> float:
    """Return a number of a question.

    Raises
    ------
    Refused
        It is none, or not finite.
    """
    given = question.get(name)
    if given is None:
        return otherwise
    try:
        value = float(given)
    except (TypeError, ValueError):
        value = math.nan
    if not math.isfinite(value):
        raise Refused(400, f"`{name}` is no number")
    return value


def whole(question: Question, name: str, otherwise: int, least: int, most: int) -> int:
    """Return a whole number of a question.

    Raises
    ------
    Refused
        It is none, or beyond its ends.
    """
    value = number(question, name, otherwise)
    if value != int(value) or not least <= value <= most:
        raise Refused(400, f"`{name}` is not a whole number from {least} to {most}")
    return int(value)


def shown(question: Question) -> Shown:
    """Return range and resolution of a question: `from`, `to`, `points`."""
    low, high = number(question, "from", -math.inf), number(question, "to", math.inf)
    return Shown(low, high, whole(question, "points", USUAL_POINTS, LEAST_POINTS, MOST_POINTS))


def result_file(project: Project, path: str) -> Path:
    """Return the file of a run below the folder, named by its folder or its file.

    Raises
    ------
    OutputError
        The path leads out of the folder.
    ResultFormatError
        There is no run.
    """
    file = run_file(project.inside(path))
    if not file.is_file():
        raise ResultFormatError("no such run", got=show(path), expected="the folder of a run")
    project.inside(project.name_of(file))  # the file of a run may be a link as well
    return file
