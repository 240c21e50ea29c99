"""Gusts on pantographs: the 1 − cos course of discrete gusts, and the lift that it adds.

The form is that of discrete gusts in standards of aircraft and vehicles (CS-25.341 has it for
aircraft; source mark C, from memory). The lift follows from the pantograph's own law, at the speed
of the train with the gust against it, less that at the speed of the train. It acts where the static
force does, as all lift does in the equation of motion of a session.
"""

from dataclasses import dataclass
from math import cos, isfinite, pi

from arcless.errors import ModelError
from arcless.model import Pantograph
from arcless.units import show

# Wind in m/s that no train runs in; more is a slip of the keyboard.
MOST_WIND = 60.0
# Duration in s. Shorter than some steps a gust has no course; longer ones are steady wind.
SHORTEST, LONGEST = 0.05, 60.0
# Peak of the added lift in N of a pantograph without a law of lift, a stated force (mark C): about
# that of a gust of 10 m/s at 75 m/s on a pantograph that the air lifts by 100 N.
STATED_LIFT = 30.0


@dataclass(frozen=True)
class Gust:
    """A gust against the train.

    Attributes
    ----------
    wind_m_s
        Its peak w, m/s.
    duration_s
        From its start to its end, s.
    """

    wind_m_s: float
    duration_s: float

    @classmethod
    def of(cls, wind_m_s: object, duration_s: object) -> "Gust":
        """Return a gust of numbers that somebody gave.

        Raises
        ------
        ModelError
            They are none, or out of range.
        """
        wind = number("wind of the gust", wind_m_s, "m/s", 0.0, MOST_WIND)
        return cls(wind, number("duration of the gust", duration_s, "s", SHORTEST, LONGEST))

    def course(self, time_s: float) -> float:
        """Return its share of the peak, 0 to 1: (1 − cos(2π t/T))/2 within 0 ≤ t ≤ T, else 0."""
        if not 0.0 <= time_s <= self.duration_s:
            return 0.0
        return 0.5 * (1.0 - cos(2.0 * pi * time_s / self.duration_s))

    def lift(self, pantograph: Pantograph, speed_m_s: float, time_s: float) -> float:
        """Return the added lift in N, F(v + w) − F(v); of F = k v² that is k((v + w)² − v²).

        Without a law of lift it is `STATED_LIFT` at the peak.
        """
        share = self.course(time_s)
        if not has_lift(pantograph):
            return STATED_LIFT * share
        faster = speed_m_s + share * self.wind_m_s
        return pantograph.lift_at(faster) - pantograph.lift_at(speed_m_s)


def has_lift(pantograph: Pantograph) -> bool:
    """Return whether a pantograph has a law of lift."""
    return pantograph.lift_at(1.0) != 0.0


def number(what: str, given: object, unit: str, least: float, most: float) -> float:
    """Return a number that somebody gave, within limits.

    Raises
    ------
    ModelError
        It is none, or out of range.
    """
    is_number = isinstance(given, int | float) and not isinstance(given, bool)
    if not is_number or not isfinite(given) or not least <= given <= most:  # type: ignore[arg-type, operator]
        expected = f"a number from {least:g} to {most:g} {unit}"
        raise ModelError(what, got=show(given), expected=expected)
    return float(given)  # type: ignore[arg-type]
