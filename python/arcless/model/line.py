"""An overhead line as engineers describe it: geometry, spans, and their components."""

from itertools import accumulate, pairwise
from math import sqrt
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.catalogue import with_catalogue
from arcless.model.components import (
    AuxiliaryWire,
    DropperType,
    MessengerSupport,
    SteadyArm,
    StitchWire,
    Wire,
)
from arcless.model.documents import Document
from arcless.model.fields import Lengths, Part, Unit, nearest
from arcless.model.heights import HeightChange, check_heights, heights_at
from arcless.model.line_checks import check_wires
from arcless.model.track import Track
from arcless.model.track_checks import check_track
from arcless.units import WRONG_VALUE, show

MAX_SPANS = 5000
MAX_DROPPERS_PER_SPAN = 200
MAX_PATTERN = 1000
# Positions typed with few digits may lie this far outside the line's exact length. In m.
POSITION_TOLERANCE = 1e-6
# A dropper nearer to a support than this stands at the support. In m.
AT_SUPPORT = 1e-6


Staggers = Annotated[
    tuple[Annotated[float, Unit("m", minimum=-1, maximum=1)], ...],
    Field(min_length=1, max_length=MAX_PATTERN),
]


class Geometry(Part):
    """Heights and staggers at the supports."""

    contact_wire_height: Annotated[float, Unit("m", above=0, maximum=20)] = Field(
        description="Height of the contact wire above rail at the supports, from the first one on."
    )
    height_changes: tuple[HeightChange, ...] = Field(
        default=(),
        description="Stretches on which that height changes, and all wires with it.",
        max_length=MAX_PATTERN,
    )
    encumbrance: Annotated[float, Unit("m", above=0, maximum=10)] = Field(
        description="Messenger wire above contact wire at the supports (system height)."
    )
    stagger_contact_wire: Staggers = Field(
        default=(0.0,), description="Stagger at successive supports; the pattern repeats."
    )
    stagger_messenger_wire: Staggers = Field(
        default=(0.0,), description="Lateral position of the messenger wire; the pattern repeats."
    )
    stagger_auxiliary_wire: Staggers | None = Field(
        default=None, description="Of the auxiliary wire; without it, as the contact wire."
    )


class SpanDroppers(Part):
    """Droppers (hangers) of a span: design by pre-sag, or as built by lengths."""

    positions: Annotated[Lengths, Field(max_length=MAX_DROPPERS_PER_SPAN)] = Field(
        description="Distance of each dropper from the left support of the span."
    )
    presag: Lengths | None = Field(
        default=None,
        description="The wire held, below its nominal height at each dropper; zeros without it.",
    )
    lengths: Lengths | None = Field(
        default=None, description="Unstretched distance between the clamps of each dropper."
    )

    @property
    def design_presag(self) -> tuple[float, ...]:
        """Pre-sag at each dropper in m; zeros when neither presag nor lengths is given."""
        return self.presag if self.presag is not None else (0.0,) * len(self.positions)

    @model_validator(mode="after")
    def _check_lists(self) -> "SpanDroppers":
        if self.presag is not None and self.lengths is not None:
            raise ModelError(
                "both presag and lengths given",
                expected="presag (design) or lengths (as built)",
                field=("lengths",),
            )
        count = len(self.positions)
        for name in ("presag", "lengths"):
            values = getattr(self, name)
            if values is not None and len(values) != count:
                raise ModelError(
                    "wrong number of values",
                    got=f"{len(values)} values",
                    expected=f"{count}, one for each of positions",
                    field=(name,),
                )
        for index, (left, right) in enumerate(pairwise(self.positions), start=1):
            if right <= left:
                raise ModelError(
                    "droppers out of order",
                    got=f"{right:g} m after {left:g} m",
                    expected="positions that increase along the span",
                    field=("positions", index),
                )
        for index, length in enumerate(self.lengths or ()):
            if length <= 0:
                raise ModelError(
                    WRONG_VALUE,
                    got=f"{length:g} m",
                    expected="a dropper length above 0 m",
                    field=("lengths", index),
                )
        return self


class SpanType(Part):
    """A span: its length and its droppers."""

    length: Annotated[float, Unit("m", above=0, maximum=500)] = Field(
        description="Distance between the two supports."
    )
    droppers: SpanDroppers = Field(description="Droppers of the span.")
    hangers: SpanDroppers | None = Field(
        default=None, description="From the auxiliary to the contact wire; only with that wire."
    )

    @property
    def holders(self) -> SpanDroppers:
        """What the contact wire hangs on: hangers where there is an auxiliary wire."""
        return self.hangers or self.droppers

    @model_validator(mode="after")
    def _check_inside(self) -> "SpanType":
        self._check_positions("droppers", self.droppers)
        if self.hangers is not None:
            self._check_positions("hangers", self.hangers)
        return self

    def _check_positions(self, name: str, droppers: SpanDroppers) -> None:
        for index, x in enumerate(droppers.positions):
            field = (name, "positions", index)
            if min(abs(x), abs(x - self.length)) < AT_SUPPORT and name == "droppers":
                side = "left" if abs(x) < AT_SUPPORT else "right"
                raise ModelError(
                    "dropper (hanger) at a support",
                    got=f"{x:g} m, the place of the {side} support",
                    expected=f"a position between the supports at 0 and {self.length:g} m",
                    hint="at a support the messenger wire is held, a dropper has no part there",
                    field=field,
                )
            if not 0 < x < self.length:
                raise ModelError(
                    f"{name[:-1]} outside its span",
                    got=f"{x:g} m",
                    expected=f"a position between 0 and {self.length:g} m, the span's length",
                    hint="positions count from the left support of the span",
                    field=field,
                )


class SpanRun(Part):
    """A number of equal spans in a row."""

    type: str = Field(description="Name of a span type.")
    count: int = Field(
        default=1, ge=1, le=MAX_SPANS, strict=True, description="Number of such spans in a row."
    )


class DesignSpace(Part):
    """What the line was designed for; used by the assessment only."""

    uplift_space: Annotated[float, Unit("m", above=0, maximum=2)] | None = Field(
        default=None, description="Free space above the steady arm at rest."
    )
    uplift_limited: bool = Field(
        default=False,
        strict=True,
        description="True when a stop limits the steady arm's uplift.",
    )
    supply: Literal["AC 25 kV", "AC 15 kV", "DC 3 kV", "DC 1.5 kV"] = Field(
        default="AC 25 kV", description="Electrical supply; selects the force limits."
    )


class Line(Document):
    """An overhead line: one tension length made of spans."""

    format: Literal["arcless-line/1"] = Field(
        default="arcless-line/1", description="Format, version."
    )
    contact_wire: Wire = Field(description="Contact wire.")
    messenger_wire: Wire = Field(description="Messenger wire.")
    dropper: DropperType = Field(description="Droppers.")
    support: MessengerSupport = Field(description="Supports of the messenger wire.")
    steady_arm: SteadyArm = Field(description="Steady arm: kind spring, arm or none.")
    stitch_wire: StitchWire | None = Field(
        default=None, description="Stitch wires at the inner supports of a stitched line."
    )
    auxiliary_wire: AuxiliaryWire | None = Field(
        default=None, description="Auxiliary wire of a compound line."
    )
    hanger: DropperType | None = Field(
        default=None, description="Hangers of a compound line; without it, as the droppers."
    )
    geometry: Geometry = Field(description="Heights and staggers.")
    span_types: dict[str, SpanType] = Field(description="Span types by name.", min_length=1)
    spans: tuple[SpanRun, ...] = Field(
        description="Spans from the start of the line to its end.", min_length=1
    )
    track: Track = Field(default_factory=Track, description="Curves; straight without them.")
    design: DesignSpace = Field(default_factory=DesignSpace, description="Values for assessment.")

    @classmethod
    def prepare(cls, data: dict[str, Any]) -> dict[str, Any]:
        """Return the data with the wires that are named instead of written out."""
        return with_catalogue(cls, data)

    @model_validator(mode="after")
    def _check_spans(self) -> "Line":
        for index, run in enumerate(self.spans):
            if run.type not in self.span_types:
                raise ModelError(
                    "unknown span type",
                    got=show(run.type),
                    expected="a name from span_types",
                    hint=nearest(run.type, list(self.span_types)),
                    field=("spans", index, "type"),
                )
        for name, span in self.span_types.items():
            self._check_presag(name, span)
        self._check_stagger()
        total = sum(run.count for run in self.spans)
        if total > MAX_SPANS:
            raise ModelError(
                "too many spans",
                got=str(total),
                expected=f"at most {MAX_SPANS} in all",
                field=("spans",),
            )
        check_wires(self)
        check_heights(self)
        check_track(self)
        return self

    def _check_presag(self, name: str, span: SpanType) -> None:
        holders = "droppers" if span.hangers is None else "hangers"
        for index, presag in enumerate(span.holders.presag or ()):
            if not abs(presag) < self.geometry.encumbrance:
                raise ModelError(
                    WRONG_VALUE,
                    got=f"{presag:g} m",
                    expected=f"less than the encumbrance, {self.geometry.encumbrance:g} m",
                    hint="pre-sag is positive downwards; mind mm and m",
                    field=("span_types", name, holders, "presag", index),
                )

    def _check_stagger(self) -> None:
        for index, stagger in enumerate(self.geometry.stagger_contact_wire):
            if self.steady_arm.kind == "none" and stagger != 0:
                raise ModelError(
                    "nothing holds the stagger",
                    got=f"{stagger:g} m with a steady arm of kind none",
                    expected="0 m, or a steady arm of kind spring or arm",
                    field=("geometry", "stagger_contact_wire", index),
                )

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

    @property
    def total_length(self) -> float:
        """Length of the line in m."""
        return self.support_positions()[-1]

    @property
    def is_spatial(self) -> bool:
        """True when stagger, curves or a steady arm make the line three-dimensional."""
        geometry = self.geometry
        staggers = geometry.stagger_contact_wire + geometry.stagger_messenger_wire
        staggers += geometry.stagger_auxiliary_wire or ()
        is_bent = self.steady_arm.kind == "arm" or bool(self.track.curves)
        return is_bent or any(stagger != 0 for stagger in staggers)

    @property
    def wave_speed(self) -> float:
        """Wave speed of the contact wire, √(tension / mass per metre), in m/s."""
        return sqrt(self.contact_wire.tension / self.contact_wire.mass)
