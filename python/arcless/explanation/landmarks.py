"""Parts of a line by their places: supports, droppers, masses, overlaps, changes as built."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from arcless.model import Scenario
from arcless.model.line.places.dropper_names import parse_name

# A part nearer than this is what a place is at, m: the length over which a strip stands on it.
AT = 0.25


@dataclass(frozen=True)
class Landmark:
    """A part of the line at one place, m; `name` without its span, such as ``dropper 4``."""

    x: float
    name: str
    span: int | None = None


@dataclass(frozen=True)
class Stretch:
    """A stretch of the line with a name, m."""

    begin: float
    end: float
    name: str


@dataclass(frozen=True)
class Landmarks:
    """Parts of a line that may be near to a place.

    Attributes
    ----------
    supports
        Positions of the supports, m.
    parts
        Supports, droppers (hangers), masses and inserts.
    stretches
        Overlaps, worn contact wire.
    changes
        Single parts that are not as designed, each with its difference.
    """

    supports: tuple[float, ...]
    parts: tuple[Landmark, ...]
    stretches: tuple[Stretch, ...]
    changes: tuple[Landmark, ...]

    @classmethod
    def of(cls, scenario: Scenario) -> "Landmarks":
        """Return the parts of a scenario's line; a dropper that is missing is none."""
        changes = tuple(_changes(scenario))
        gone = {one.x for one in changes if one.name.endswith("missing")}
        parts = [one for one in _parts(scenario) if one.x not in gone]
        supports = tuple(scenario.line.support_positions())
        return cls(supports, tuple(parts), tuple(_stretches(scenario)), changes)

    def span_at(self, x: float) -> int | None:
        """Return the number of the span that a place is in, from 1; None beyond the line."""
        place = int(np.searchsorted(self.supports, x, side="right"))
        return place if 0 < place < len(self.supports) else None

    def nearest(self, x: float) -> Landmark:
        """Return the part that is nearest to a place."""
        return min(self.parts, key=lambda one: abs(one.x - x))

    def change_near(self, x: float, reach: float) -> Landmark | None:
        """Return the nearest change within a distance in m; None where there is none."""
        near = [one for one in self.changes if abs(one.x - x) <= reach]
        return min(near, key=lambda one: abs(one.x - x), default=None)

    def stretches_at(self, x: float) -> list[str]:
        """Return the names of the stretches that a place is in."""
        return [one.name for one in self.stretches if one.begin <= x <= one.end]


def beside(distance: float, name: str) -> str:
    """Return where a place is: ``at dropper 4``, or ``5.8 m after dropper 4``; distance in m."""
    if abs(distance) < AT:
        return f"at {name}"
    return f"{abs(distance):.1f} m {'after' if distance > 0.0 else 'before'} {name}"


def _parts(scenario: Scenario) -> list[Landmark]:
    line = scenario.line
    supports = line.support_positions()
    found = [Landmark(x, f"support {number}") for number, x in enumerate(supports, start=1)]
    word = "dropper" if line.auxiliary_wire is None else "hanger"
    for number, (left, span) in enumerate(zip(supports, line.span_list(), strict=False), start=1):
        for count, place in enumerate(span.holders.positions, start=1):
            found.append(Landmark(left + place, f"{word} {count}", number))
    for mass in line.point_masses:
        found.append(Landmark(mass.position, mass.name or f"mass of {mass.mass:g} kg"))
    for insert in line.inserts:
        found.append(Landmark(insert.position, insert.name or f"insert of {insert.length:g} m"))
    return found


def _stretches(scenario: Scenario) -> list[Stretch]:
    line = scenario.line
    supports, lengths = line.support_positions(), line.tension_length_list()
    found = [
        Stretch(
            supports[behind.from_span - 1], supports[front.to_span],
            f"overlap of tension lengths {number} and {number + 1}",
        )
        for number, (front, behind) in enumerate(pairwise(lengths), start=1)
    ]  # fmt: skip
    for one in scenario.as_built.contact_wire_wear:
        found.append(Stretch(one.from_, one.to, f"contact wire worn by {one.fraction:.0%}"))
    return found


def _changes(scenario: Scenario) -> list[Landmark]:
    line, as_built = scenario.line, scenario.as_built
    supports, spans = line.support_positions(), line.span_list()

    def at(span: int, dropper: int) -> float:
        return supports[span - 1] + spans[span - 1].droppers.positions[dropper - 1]

    found = []
    for text in as_built.missing_droppers:
        name = parse_name(text)
        found.append(Landmark(at(name.span, name.dropper), f"{name} missing", name.span))
    for length in as_built.dropper_length_errors:
        words = f"{length.name} {_longer(length.length_error, 'longer', 'shorter')}"
        found.append(Landmark(at(length.span, length.dropper), words, length.span))
    for height in as_built.support_height_errors:
        words = f"{height.name} {_longer(height.height_error, 'higher', 'lower')}"
        found.append(Landmark(supports[height.support - 1], words))
    return found


def _longer(difference: float, more: str, less: str) -> str:
    return f"{1e3 * abs(difference):.3g} mm {more if difference >= 0.0 else less}"
