"""Ends of a task that are neither a result nor an error of Arcless."""

from typing import Any

from arcless.errors import ArclessError
from arcless.studio.answers.answers import Refused, complaint

_FAULT, _CONFLICT = 500, 409


class Failed(Refused):
    """A fault, of the program or of the machine.

    Attributes
    ----------
    complaint
        Its sentence and its parts, as `answers.complaint` tells an error.
    """

    def __init__(self, what: str, hint: str | None = None) -> None:
        text = what if hint is None else f"{what}; hint: {hint}"
        super().__init__(_FAULT, text)
        self.complaint = {"text": text, "what": what} | ({} if hint is None else {"hint": hint})


class Gone(Failed):
    """The process has ended in the midst of it, or before."""


class Cancelled(Refused):
    """It was cancelled."""

    def __init__(self) -> None:
        super().__init__(_CONFLICT, "it was cancelled")


def told(error: ArclessError | Failed) -> dict[str, Any]:
    """Return an error as pages show it."""
    return complaint(error) if isinstance(error, ArclessError) else error.complaint
