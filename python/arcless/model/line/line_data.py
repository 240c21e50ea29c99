"""Fields of an overhead line, and what follows from them: places, heights, wave speed."""

from collections.abc import Iterator
from itertools import accumulate
from math import sqrt
from typing import Annotated, Literal

from pydantic import ConfigDict, Field

from arcless.model.fields.document import Document
from arcless.model.line.parts.components import (
    AuxiliaryWire,
    DropperType,
    MessengerSupport,
    NoSteadyArm,
    SteadyArm,
    StitchWire,
    TensionedWire,
    Wire,
)
from arcless.model.line.parts.contact_supports import Bridle, ContactSupport, ContactWire
from arcless.model.line.parts.geometry import DesignSpace, Geometry
from arcless.model.line.parts.heights import heights_at
from arcless.model.line.parts.masses_and_inserts import MAX_PARTS, Insert, LumpedMass
from arcless.model.line.parts.midpoint_anchor import MidpointAnchor
from arcless.model.line.parts.spans import MAX_SPANS, SpanRun, SpanType
from arcless.model.line.parts.tension_lengths import Overlap, TensionLength
from arcless.model.line.parts.track import Track
from arcless.model.line.parts.twin_contact_wires import TwinContactWires

# Positions typed with few digits may lie this far outside the line's exact length. In m.
POSITION_TOLERANCE = 1e-6
# Fields of a line that hold a wire.
WIRES = ("contact_wire", "messenger_wire", "auxiliary_wire", "stitch_wire", "bridle")


class LineData(Document):
    """An overhead line as its file has it: spans, wires, heights, and what follows from them."""

    # Validated is only what follows from it: a validator of its own costs 10 ms of every start.
    model_config = ConfigDict(defer_build=True)

    format: Literal["arcless-line/1"] = Field(
        default="arcless-line/1", description="Format, version."
    )
    contact_wire: ContactWire = Field(description="Contact wire, or conductor rail.")
    messenger_wire: Wire | None = Field(
        default=None, description="Messenger wire; without it, a trolley wire or conductor rail."
    )
    dropper: DropperType | None = Field(default=None, description="Droppers.")
    support: MessengerSupport | None = Field(
        default=None, description="Supports of the messenger wire."
    )
    steady_arm: SteadyArm = Field(
        default_factory=lambda: NoSteadyArm(kind="none"),
        description="Steady arm: kind spring, arm or none.",
    )
    contact_support: ContactSupport | None = Field(
        default=None, description="Supports of a contact wire without messenger wire."
    )
    bridle: Bridle | None = Field(
        default=None, description="Bridles between these supports and the contact wire."
    )
    stitch_wire: StitchWire | None = Field(
        default=None, description="Stitch wires at the inner supports of a stitched line."
    )
    auxiliary_wire: AuxiliaryWire | None = Field(
        default=None, description="Auxiliary wire of a compound line."
    )
    hanger: DropperType | None = Field(
        default=None, description="Hangers of a compound line; without it, as the droppers."
    )
    twin_contact_wires: TwinContactWires | None = Field(
        default=None, description="A second contact wire parallel to the first and equal to it."
    )
    midpoint_anchor: MidpointAnchor | None = Field(
        default=None, description="Holds the wires along the track; both their ends then move."
    )
    point_masses: Annotated[tuple[LumpedMass, ...], Field(max_length=MAX_PARTS)] = Field(
        default=(), description="Masses on wires."
    )
    inserts: Annotated[tuple[Insert, ...], Field(max_length=MAX_PARTS)] = Field(
        default=(), description="Pieces of a wire made of something else, as section insulators."
    )
    geometry: Geometry = Field(description="Heights and staggers.")
    span_types: dict[str, SpanType] = Field(
        description="Span types by name.", min_length=1, max_length=MAX_SPANS
    )
    spans: tuple[SpanRun, ...] = Field(
        description="Spans from the start of the line to its end.",
        min_length=1,
        max_length=MAX_SPANS,
    )
    tension_lengths: Annotated[tuple[TensionLength, ...], Field(min_length=1)] | None = Field(
        default=None,
        description="Spans of each tension length; neighbours share those of their overlap."
        " Without it, one over all spans.",
    )
    overlap: Overlap | None = Field(
        default=None, description="Overlaps; needed where there are several tension lengths."
    )
    track: Track = Field(default_factory=Track, description="Curves; straight without them.")
    design: DesignSpace = Field(default_factory=DesignSpace, description="Values for assessment.")

    def wires(self) -> Iterator[tuple[str, TensionedWire]]:
        """Yield the wires of the line by the names of their fields."""
        for name in WIRES:
            wire = getattr(self, name)
            if wire is not None:
                yield name, wire

    @property
    def hanging_mass(self) -> float:
        """Mass in kg/m of the messenger wire and of the wires that hang on it."""
        below = 1 if self.twin_contact_wires is None else 2
        own = (self.messenger_wire, self.auxiliary_wire)
        return below * self.contact_wire.mass + sum(wire.mass for wire in own if wire is not None)

    def span_list(self) -> list[SpanType]:
        """Return the span types in order, one entry per span."""
        return [self.span_types[run.type] for run in self.spans for _ in range(run.count)]

    def support_positions(self) -> list[float]:
        """Return the positions of the supports in m, one more than there are spans."""
        return list(accumulate((span.length for span in self.span_list()), initial=0.0))

    def contact_wire_heights(self) -> list[float]:
        """Return the nominal heights of the contact wire at the supports in m."""
        own = self.geometry
        return heights_at(own.contact_wire_height, own.height_changes, self.support_positions())

    def tension_length_list(self) -> list[TensionLength]:
        """Return the tension lengths in order; one over all spans where none are given."""
        if self.tension_lengths is not None:
            return list(self.tension_lengths)
        # Asked for with every dropper that is named; there is nothing to check.
        return [TensionLength.model_construct(from_span=1, to_span=len(self.span_list()))]

    def tension_lengths_over(self, first: float, last: float) -> list[int]:
        """Return the numbers, from 1, of the tension lengths whose wires cover a stretch in m."""
        supports = self.support_positions()
        return [
            number
            for number, one in enumerate(self.tension_length_list(), start=1)
            if supports[one.from_span - 1] - POSITION_TOLERANCE <= first
            and last <= supports[one.to_span] + POSITION_TOLERANCE
        ]

    def tension_length_of(self, part: LumpedMass | Insert, first: float, last: float) -> int:
        """Return the number of the tension length that a part on a wire belongs to."""
        return part.tension_length or self.tension_lengths_over(first, last)[0]

    @property
    def total_length(self) -> float:
        """Length of the line in m."""
        return self.support_positions()[-1]

    @property
    def has_overlaps(self) -> bool:
        """True when there are several tension lengths."""
        return len(self.tension_length_list()) > 1

    @property
    def has_paired_droppers(self) -> bool:
        """True when two droppers hang from each position, one on either contact wire."""
        twin = self.twin_contact_wires
        return twin is not None and twin.droppers == "paired" and self.auxiliary_wire is None

    @property
    def holds_stagger(self) -> bool:
        """True when something holds the contact wire across the track at the supports."""
        held = self.contact_support is not None and self.bridle is None
        return held or self.steady_arm.kind != "none"

    @property
    def is_spatial(self) -> bool:
        """True when stagger, curves or a steady arm make the line three-dimensional."""
        geometry = self.geometry
        staggers = geometry.stagger_contact_wire + geometry.stagger_messenger_wire
        staggers += geometry.stagger_auxiliary_wire or ()
        if self.overlap is not None:
            lists = (self.overlap.stagger_in, self.overlap.stagger_out)
            staggers += (self.overlap.apart, *(side for sides in lists for side in sides or ()))
        is_bent = self.steady_arm.kind == "arm" or bool(self.track.curves)
        return is_bent or any(stagger != 0 for stagger in staggers)

    @property
    def wave_speed(self) -> float | None:
        """Wave speed of the contact wire, √(tension / mass per metre), in m/s; None without it.

        Waves of a beam have no speed of their own: short ones run faster than long ones.
        """
        if self.contact_wire.tension == 0:
            return None
        return sqrt(self.contact_wire.tension / self.contact_wire.mass)
