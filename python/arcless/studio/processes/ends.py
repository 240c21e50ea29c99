"""Ends of a task that are neither a result nor an error of Arcless."""

from arcless.studio.answers.answers import Refused

_FAULT, _CONFLICT = 500, 409


class Failed(Refused):
    """A fault, of the program or of the machine: what it is, and a hint where there is one."""

    def __init__(self, what: str, hint: str | None = None) -> None:
        super().__init__(_FAULT, what if hint is None else f"{what}; hint: {hint}")
        self.what, self.hint = what, hint


class Gone(Failed):
    """The process has ended in the midst of it, or before."""


class Cancelled(Refused):
    """End of a task that was cancelled, by itself or by force."""

    def __init__(self) -> None:
        super().__init__(_CONFLICT, "it was cancelled")
