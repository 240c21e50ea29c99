"""Wire systems: what a line is meshed from, each with its own two anchors."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from arcless.mesh.division.wire_names import CONTACT, TWINS
from arcless.model.line.line import Line
from arcless.model.line.parts.spans import SpanType
from arcless.model.line.parts.tension_lengths import Meeting, Overlap, TensionLength, meetings


@dataclass(frozen=True)
class WireSystem:
    """The wires of one tension length: heights and lateral positions at its supports, in m.

    Attributes
    ----------
    number : which tension length it is, from 1
    label : what the names of its droppers and supports begin with; empty for the only one
    first : number of its first span in the line, which is also that of its first support
    spans : its spans in order
    supports : where its supports stand, one more than it has spans; the outer two are anchors
    contact_heights, messenger_heights : of the wires at the supports, by design
    rises : how much of these heights is due to an overlap
    contact_stagger, messenger_stagger, auxiliary_stagger : lateral positions there
    measured : heights of the contact wire at places along the track, in place of those drawn
    contact_wires : name of each contact wire and its distance from the stagger at the supports
    """

    number: int
    label: str
    first: int
    spans: list[SpanType]
    supports: list[float]
    contact_heights: list[float]
    messenger_heights: list[float]
    rises: list[float]
    contact_stagger: list[float]
    messenger_stagger: list[float]
    auxiliary_stagger: list[float]
    measured: Mapping[float, float]
    contact_wires: dict[str, list[float]]

    @property
    def held_heights(self) -> list[float]:
        """Heights in m of the contact wire at the supports, in an overlap with its rise."""
        drawn = [own + rise for own, rise in zip(self.contact_heights, self.rises, strict=True)]
        pairs = zip(self.supports, drawn, strict=True)
        return [self.measured.get(place, height) for place, height in pairs]

    def stagger_of(self, contact_wire: str) -> list[float]:
        """Return the lateral positions of one of the contact wires at the supports, in m."""
        aside = self.contact_wires[contact_wire]
        return [y + own for y, own in zip(self.contact_stagger, aside, strict=True)]

    def named(self, what: str) -> str:
        """Return the name of a part of this system."""
        return f"{self.label} {what}" if self.label else what


def wire_systems(line: Line, measured: Mapping[float, float]) -> list[WireSystem]:
    """Return the wire systems of a line in the order of the track."""
    lengths = line.tension_length_list()
    met = meetings(lengths)
    sides = [
        _Sides(line.overlap, index, met[max(index - 1, 0) : index + 1])
        for index in range(len(lengths))
    ]
    return [
        _system(line, own, between, measured) for own, between in zip(lengths, sides, strict=True)
    ]


def _system(
    line: Line, own: TensionLength, sides: "_Sides", measured: Mapping[float, float]
) -> WireSystem:
    geometry = line.geometry
    places = range(own.from_span - 1, own.to_span + 1)
    supports, nominal = line.support_positions(), line.contact_wire_heights()
    heights = [nominal[place] for place in places]
    rises = [sides.rise(place) for place in places]
    auxiliary = geometry.stagger_auxiliary_wire or geometry.stagger_contact_wire

    def shifted(pattern: tuple[float, ...]) -> list[float]:
        return [pattern[place % len(pattern)] + sides.shift(place) for place in places]

    contact = shifted(geometry.stagger_contact_wire)
    given = [sides.given(place) for place in places]
    return WireSystem(
        number=sides.index + 1,
        label=f"tension length {sides.index + 1}" if line.has_overlaps else "",
        first=own.from_span,
        spans=line.span_list()[own.from_span - 1 : own.to_span],
        supports=[supports[place] for place in places],
        contact_heights=heights,
        messenger_heights=[
            height + (geometry.encumbrance or 0.0) + rise
            for height, rise in zip(heights, rises, strict=True)
        ],
        rises=rises,
        contact_stagger=[
            own if set_ is None else set_ for own, set_ in zip(contact, given, strict=True)
        ],
        messenger_stagger=shifted(geometry.stagger_messenger_wire),
        auxiliary_stagger=shifted(auxiliary),
        measured=measured,
        contact_wires=_contact_wires(line, places),
    )


def _contact_wires(line: Line, places: Sequence[int]) -> dict[str, list[float]]:
    twin = line.twin_contact_wires
    if twin is None:
        return {CONTACT: [0.0] * len(places)}
    return {
        name: [0.5 * side * twin.apart(place) for place in places]
        for name, side in zip(TWINS, (1.0, -1.0), strict=True)
    }


@dataclass(frozen=True)
class _Sides:
    """Where the wires of a tension length are in the overlaps at its two ends."""

    overlap: Overlap | None
    index: int
    met: Sequence[Meeting]

    def rise(self, place: int) -> float:
        """Height in m of the wires above their own at a support."""
        for one in self.met:
            if self.overlap is not None and place in one.supports:
                inwards = self._inwards(one, place)
                if inwards < len(self.overlap.raise_):
                    return self.overlap.raise_[inwards]
        return 0.0

    def shift(self, place: int) -> float:
        """Lateral distance in m from the staggers: the wire that begins is on the positive side."""
        for one in self.met:
            if self.overlap is not None and place in one.supports:
                return (0.5 if self._begins(one) else -0.5) * self.overlap.apart
        return 0.0

    def given(self, place: int) -> float | None:
        """Stagger in m that the overlap gives by itself."""
        for one in self.met:
            if self.overlap is not None and place in one.supports:
                begins = self._begins(one)
                given = self.overlap.stagger_in if begins else self.overlap.stagger_out
                return None if given is None else given[place - one.supports[0]]
        return None

    def _begins(self, meeting: Meeting) -> bool:
        return meeting.before < self.index

    def _inwards(self, meeting: Meeting, place: int) -> int:
        """Return how many supports lie between a support and the anchor."""
        supports = meeting.supports
        return place - supports[0] if self._begins(meeting) else supports[-1] - place
