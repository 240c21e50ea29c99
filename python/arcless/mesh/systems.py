"""Wire systems: what a line is meshed from, each with its own two anchors."""

from collections.abc import Mapping
from dataclasses import dataclass

from arcless.model.line import Line, SpanType


@dataclass(frozen=True)
class WireSystem:
    """The wires of one tension length: heights and lateral positions at its supports, in m.

    Attributes
    ----------
    label : what the names of its droppers and supports begin with; empty for the only one
    first : number of its first span in the line, which is also that of its first support
    spans : its spans in order
    supports : where its supports stand, one more than it has spans; the outer two are anchors
    contact_heights, messenger_heights : of the wires at the supports, by design
    contact_stagger, messenger_stagger, auxiliary_stagger : lateral positions there
    measured : heights of the contact wire at places along the track, in place of those drawn
    """

    label: str
    first: int
    spans: list[SpanType]
    supports: list[float]
    contact_heights: list[float]
    messenger_heights: list[float]
    contact_stagger: list[float]
    messenger_stagger: list[float]
    auxiliary_stagger: list[float]
    measured: Mapping[float, float]

    def named(self, what: str) -> str:
        """Return the name of a part of this system."""
        return f"{self.label} {what}" if self.label else what


def wire_systems(line: Line, measured: Mapping[float, float]) -> list[WireSystem]:
    """Return the wire systems of a line in the order of the track."""
    geometry, supports = line.geometry, line.support_positions()
    auxiliary = geometry.stagger_auxiliary_wire or geometry.stagger_contact_wire
    heights = line.contact_wire_heights()

    def repeated(pattern: tuple[float, ...]) -> list[float]:
        return [pattern[i % len(pattern)] for i in range(len(supports))]

    return [
        WireSystem(
            label="",
            first=1,
            spans=line.span_list(),
            supports=supports,
            contact_heights=heights,
            messenger_heights=[height + geometry.encumbrance for height in heights],
            contact_stagger=repeated(geometry.stagger_contact_wire),
            messenger_stagger=repeated(geometry.stagger_messenger_wire),
            auxiliary_stagger=repeated(auxiliary),
            measured=measured,
        )
    ]
