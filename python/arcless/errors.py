"""The one family of errors that Arcless raises on purpose.

Every error says what went wrong, where, what was given, what was expected, and a hint. The command
line prints ``str(error)`` and leaves with ``error.exit_code``: 1 when a computation failed, 2 when
the input is wrong.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import ClassVar, Self

# Separators that messages of our own have: lines of a table, thin spaces in numbers.
_KEPT = "\n\u00a0\u202f"


class ArclessError(Exception):
    """Base of all errors raised on purpose.

    Parameters
    ----------
    what : str
        The field or the thing that is wrong.
    where : str, optional
        File and line, time step, or other place.
    got : str, optional
        What was given, ready to print.
    expected : str, optional
        What would have been accepted.
    hint : str, optional
        What to try.
    """

    exit_code: ClassVar[int] = 1

    def __init__(
        self,
        what: str,
        *,
        where: str | None = None,
        got: str | None = None,
        expected: str | None = None,
        hint: str | None = None,
    ) -> None:
        super().__init__(what)
        self.what = what
        self.where = where
        self.got = got
        self.expected = expected
        self.hint = hint

    def __str__(self) -> str:
        """One message: ``where: what: got …, expected …; hint: …``.

        What does not print, as what steers a terminal, is a question mark: names of files and
        fields come from anywhere.
        """
        message = self.what if self.where is None else f"{self.where}: {self.what}"
        facts = ", ".join(
            f"{word} {text}"
            for word, text in (("got", self.got), ("expected", self.expected))
            if text is not None
        )
        message = f"{message}: {facts}" if facts else message
        message = message if self.hint is None else f"{message}; hint: {self.hint}"
        if message.isprintable():
            return message
        return "".join(c if c.isprintable() or c in _KEPT else "?" for c in message)


class ModelError(ArclessError, ValueError):
    """A model file, a field of it, or an override is wrong.

    Parameters
    ----------
    field : tuple of str or int
        Path of the field below the place where the error was raised.
    also : sequence of ModelError
        Further mistakes found in the same file; printed below the first one.
    """

    exit_code = 2

    def __init__(
        self,
        what: str,
        *,
        where: str | None = None,
        got: str | None = None,
        expected: str | None = None,
        hint: str | None = None,
        field: tuple[str | int, ...] = (),
        also: Sequence["ModelError"] = (),
    ) -> None:
        super().__init__(what, where=where, got=got, expected=expected, hint=hint)
        self.field = field
        self.also = tuple(also)

    def __str__(self) -> str:
        """Return the message of this mistake, then one line for each further one."""
        one = super().__str__()
        return "\n".join([one, *(str(error) for error in self.also)]) if self.also else one


class MeshError(ArclessError):
    """The model is valid, but cannot be divided into elements as asked."""

    exit_code = 2


class OutputError(ArclessError):
    """A result cannot be written where it was asked for."""

    exit_code = 2

    @classmethod
    def of(cls, error: OSError, what: str, where: object, hint: str | None = None) -> Self:
        """Return what the system refused to write, and why, as one of ours."""
        expected = "a folder that exists or can be made, is not read-only, and has room on its disk"
        got = error.strerror or str(error)
        return cls(what, where=str(where), got=got, expected=expected, hint=hint)


class MachineError(ArclessError):
    """The machine, or its system, does not give what was asked for."""

    exit_code = 2


class EquilibriumError(ArclessError):
    """The static equilibrium was not found."""


class NotConvergedError(EquilibriumError):
    """The search for the static equilibrium failed, and says nothing against the line itself."""


class ContactError(ArclessError):
    """The complementarity problem of a time step could not be solved.

    Attributes
    ----------
    time_s : float or None
        Time of the run at which it failed, s; None where that is not known.
    positions_m : mapping of str to float
        Positions of the pantographs along the track at that time, m, by name.
    """

    time_s: float | None = None
    positions_m: Mapping[str, float] = MappingProxyType({})


class ControlError(ArclessError):
    """The controller of a pantograph is missing, or failed."""


class FmuError(ArclessError):
    """An FMU is not allowed to run, cannot be loaded, failed, crashed or hangs."""


class ResultFormatError(ArclessError):
    """A file is not a result that this version can read."""

    exit_code = 2


class FigureError(ArclessError):
    """A figure cannot be drawn as asked: its key, the kind of its file, or a package says no."""

    exit_code = 2


class ComparisonError(ArclessError):
    """Runs cannot be compared as asked: too few or too many, one twice, one that is not whole."""

    exit_code = 2


class ExplanationError(ArclessError):
    """A standard deviation cannot be explained: the section is too short, or the force constant."""

    exit_code = 2


class StudyError(ArclessError):
    """A study cannot be begun or continued as asked: its folder or a package says no."""

    exit_code = 2


class ExecutorError(ArclessError):
    """The executor that computes the variants of a study does not answer, or went away."""


class MeasurementError(ArclessError):
    """A measured record cannot be read or assessed: its file, its clock, or its sensors say no."""

    exit_code = 2


class FitError(ArclessError):
    """No model of the order asked for follows the measured data, or none was found."""
