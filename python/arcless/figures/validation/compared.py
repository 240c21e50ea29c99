"""Interface of a value that was held against a range, and the colour of its verdict."""

from typing import Literal, Protocol

State = Literal["met", "not_met", "open"]
INSIDE, OUTSIDE = "inside", "outside"


class Compared(Protocol):
    """A value, its range and its verdict; `arcless.validate.Row` is one."""

    @property
    def case(self) -> str:
        """Title of the case."""

    @property
    def quantity(self) -> str:
        """Name of the quantity."""

    @property
    def unit(self) -> str:
        """Unit of value and range; empty for a number without one."""

    @property
    def value(self) -> float | None:
        """The value; None where a run gave none."""

    @property
    def digits(self) -> int:
        """Decimals of the value."""

    @property
    def low(self) -> float | None:
        """Lower bound; None where there is none."""

    @property
    def high(self) -> float | None:
        """Upper bound; None where there is none."""

    @property
    def limit(self) -> str:
        """Range as text."""

    @property
    def mark(self) -> str:
        """Confidence mark of the range."""

    @property
    def verdict(self) -> str:
        """Where the value is: inside, outside, outside (unverified), or too close to tell."""

    @property
    def note(self) -> str:
        """Where or how the value was found; empty for nothing to say."""

    @property
    def uncertainty(self) -> float | None:
        """Half of the interval that the value is known within; None where nobody asked."""


def state_of(verdict: str) -> State:
    """Return the state of a verdict: what is unverified or too close to tell is open."""
    if verdict == INSIDE:
        return "met"
    return "not_met" if verdict == OUTSIDE else "open"
