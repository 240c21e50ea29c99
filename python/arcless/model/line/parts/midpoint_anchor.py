"""The midpoint anchor of a tension length whose two ends are tensioned."""

from typing import TYPE_CHECKING, Annotated

from pydantic import Field

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.part import Part, Unit

if TYPE_CHECKING:
    from arcless.model.line.line import Line


class MidpointAnchor(Part):
    """What keeps the wires in place along the track when a device tensions them at either end."""

    stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] = Field(
        description="Along the track, of what holds each wire there."
    )
    support: Annotated[int, Field(ge=1, strict=True)] | None = Field(
        default=None,
        description="Number of its support; without it, the middle one of each tension length.",
    )


def check_midpoint(line: "Line") -> None:
    """Raise `ModelError` for the first thing that does not fit."""
    anchor = line.midpoint_anchor
    if anchor is None:
        return
    lengths = line.tension_length_list()
    for name in ("contact_wire", "messenger_wire", "auxiliary_wire"):
        wire = getattr(line, name)
        if wire is not None and wire.is_anchored:
            raise ModelError(
                "midpoint anchor between fixed ends",
                got="ends: fixed" if wire.ends else "no ends, which are fixed then",
                expected="ends: weights, constant_force or spring, or no midpoint_anchor",
                hint="the anchor lets both ends of a wire move",
                field=(name, "ends"),
            )
    for index, one in enumerate(lengths):
        if one.to_span == one.from_span:
            raise ModelError(
                "no support for a midpoint anchor",
                got="a tension length of one span",
                expected="at least two spans",
                field=("tension_lengths", index) if line.tension_lengths else ("midpoint_anchor",),
            )
    if anchor.support is not None:
        _check_support(anchor.support, len(lengths), lengths[0].to_span)


def _check_support(support: int, lengths: int, spans: int) -> None:
    field = ("midpoint_anchor", "support")
    if lengths > 1:
        raise ModelError(
            "one support for several tension lengths",
            got=f"support {support} for {lengths} of them",
            expected="no support: the middle one of each tension length is taken",
            field=field,
        )
    if not 1 < support <= spans:
        raise ModelError(
            "midpoint anchor at an end of the line",
            got=f"support {support}",
            expected=f"a support between 2 and {spans}",
            field=field,
        )
