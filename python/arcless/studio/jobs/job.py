"""A job: what is computed, how far it is, how it ended."""

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

Kind = Literal["run", "study", "report", "hands on", "explanation", "motion"]
State = Literal["waiting", "running", "done", "failed", "cancelled"]
ENDED = ("done", "failed", "cancelled")


@dataclass(frozen=True)
class Task:
    """A task for a worker process.

    Attributes
    ----------
    function
        A function of a module, called with a `Talk` and the arguments. It asks `Talk.cancel` now
        and then and raises KeyboardInterrupt when that is true. What it returns pickles.
    arguments
        Arguments, which pickle.
    folder
        Folder whose unfinished files go if the process is killed.
    shows
        Whether it spools motion.
    about
        For those who start it: what it is about.
    """

    function: Callable[..., Any]
    arguments: tuple[Any, ...] = ()
    folder: Path | None = None
    shows: bool = False
    about: Any = None


@dataclass
class Job:
    """A job as the page sees it.

    Attributes
    ----------
    id, kind, title, state
        Name, kind, words for the user, state.
    fraction, doing
        Part that is done, from 0 to 1, and what is being done.
    path
        Where its result is, below the folder, once it is there.
    error
        Why it failed, as `answers.complaint` tells it.
    notes
        Warnings, whole sentences.
    outcome
        What the page wants to know of the result: of a run what `arcless runs --json` has of it.
    """

    id: str
    kind: Kind
    title: str
    state: State = "waiting"
    fraction: float = 0.0
    doing: str = ""
    path: str | None = None
    error: dict[str, Any] | None = None
    notes: list[str] = field(default_factory=list)
    outcome: Any = None

    @property
    def has_ended(self) -> bool:
        """True when it is done, failed or cancelled."""
        return self.state in ENDED

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, ready for JSON."""
        plain = {name: value for name, value in vars(self).items() if value is not None}
        return plain | {"path": self.path, "notes": list(self.notes)}
