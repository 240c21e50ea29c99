"""Spans: their length, and the droppers in them."""

from itertools import pairwise
from typing import Annotated

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields.list_checks import check_count
from arcless.model.fields.part import Lengths, Part, Unit
from arcless.model.fields.rule_errors import both_given
from arcless.units import DECIMAL_POINT, WRONG_VALUE

MAX_SPANS = 5000
MAX_DROPPERS_PER_SPAN = 200
Places = Annotated[Lengths, Field(max_length=MAX_DROPPERS_PER_SPAN)]
# A dropper nearer to a support than this stands at the support. In m.
AT_SUPPORT = 1e-6
# A position below, behind a greater one, is perhaps what stands behind a decimal comma. In m.
LEAST_PLACE = 10


class SpanDroppers(Part):
    """Droppers (hangers) of a span: design by pre-sag, or as built by lengths."""

    positions: Places = Field(
        description="Distance of each dropper from the left support of the span."
    )
    presag: Places | None = Field(
        default=None,
        description="The wire held, below its nominal height at each dropper; zeros without it.",
    )
    lengths: Places | None = Field(
        default=None,
        description="Unstretched length of each dropper between its clamps, without the stretch"
        " under its force: the clamps at rest are farther apart.",
    )

    @property
    def design_presag(self) -> tuple[float, ...]:
        """Pre-sag at each dropper in m; zeros when neither presag nor lengths is given."""
        return self.presag if self.presag is not None else (0.0,) * len(self.positions)

    @model_validator(mode="after")
    def _check_lists(self) -> "SpanDroppers":
        if self.presag is not None and self.lengths is not None:
            raise both_given("presag", "lengths", expected="presag (design) or lengths (as built)")
        # Before they are counted: a decimal comma makes two positions of one.
        for index, (left, right) in enumerate(pairwise(self.positions), start=1):
            if right <= left:
                is_rest = right.is_integer() and left.is_integer() and right < LEAST_PLACE
                point = f"{DECIMAL_POINT}: {left:g}.{right:g}"
                raise ModelError(
                    "droppers out of order",
                    got=f"{right:g} m after {left:g} m",
                    expected="positions that increase along the span",
                    hint=point if is_rest else None,
                    field=("positions", index),
                )
        for name in ("presag", "lengths"):
            check_count(getattr(self, name), len(self.positions), "positions", (name,))
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
    droppers: SpanDroppers = Field(
        default_factory=lambda: SpanDroppers(positions=()), description="Droppers of the span."
    )
    hangers: SpanDroppers | None = Field(
        default=None, description="From the auxiliary to the contact wire; only with that wire."
    )

    @property
    def holders(self) -> SpanDroppers:
        """Parts that the contact wire hangs on: hangers where there is an auxiliary wire."""
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
                    "dropper at a support",
                    got=f"{x:g} m, the place of the {side} support",
                    expected=f"a position between the supports at 0 and {self.length:g} m",
                    hint="leave it out: the support holds the messenger wire there",
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
