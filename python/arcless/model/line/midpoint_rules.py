"""Rules for the midpoint anchor: wires that it may hold, and supports that it may stand at."""

from arcless.errors import ModelError
from arcless.model.line.line_data import LineData


def check_midpoint(line: LineData) -> None:
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
