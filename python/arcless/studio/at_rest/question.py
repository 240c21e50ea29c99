"""Questions of the page about a line at rest."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, get_args

from arcless.studio.answers.answers import Refused
from arcless.studio.project import texts
from arcless.studio.project.project import Project, is_shipped

Part = Literal["line", "elasticity", "droppers", "frequencies", "supports", "schedule"]
PARTS = frozenset(get_args(Part))
# Fields that are changed at once. A form has some dozens; more would be no person at a slider.
MOST_CHANGES = 1000


@dataclass(frozen=True)
class Question:
    """A question about a line at rest, ready to be sent to another process.

    Attributes
    ----------
    file
        The model file, whose folder is where references begin.
    within
        Whole path of the folder that no reference may lead out of.
    text
        What the file has, or will have.
    changes
        New values by dotted path, as typed.
    want
        Parts of the answer.
    number
        Counted up by the page; the answer repeats it.
    draft
        Whether the line may be divided coarsely, see `bench`.
    moving
        Whether a slider moves, so that the line of the question before is a good start.
    allowance
        Of the schedule: length that the cut length has beyond the unstretched length, as typed.
    """

    file: Path
    within: Path
    text: str
    changes: Mapping[str, Any]
    want: frozenset[str]
    number: int
    draft: bool = False
    moving: bool = False
    allowance: str | None = None

    @property
    def is_slow(self) -> bool:
        """True where it asks for natural frequencies: these take a second, all else takes 0.1 s."""
        return "frequencies" in self.want


def question_of(project: Project, asked: Mapping[str, Any]) -> Question:
    """Return the question that a JSON object is.

    Raises
    ------
    Refused
        It is none.
    ArclessError
        There is no such file.
    """
    text, changes, want = (asked.get(name) for name in ("text", "changes", "want"))
    number, path, allowance = (asked.get(name) for name in ("question", "path", "allowance"))
    is_question = (
        isinstance(path, str)
        and isinstance(text, str | None)
        and isinstance(allowance, str | None)
        and isinstance(changes, dict | None)
        and len(changes or ()) <= MOST_CHANGES
        and isinstance(want, list)
        and all(isinstance(part, str) for part in want)
        and PARTS.issuperset(want)
        and type(number) is int
    )
    if not is_question:
        raise Refused(400, "No question about a line at rest")
    assert isinstance(path, str)
    assert isinstance(want, list)
    assert isinstance(number, int)
    file = texts.model_file(project, path)
    return Question(
        file=file,
        within=file.resolve().parent if is_shipped(path) else project.folder,
        text=texts.read(project, path)["text"] if text is None else text,
        changes=changes or {},
        want=frozenset(want),
        number=number,
        draft=asked.get("draft") is True,
        moving=asked.get("moving") is True,
        allowance=allowance,
    )
