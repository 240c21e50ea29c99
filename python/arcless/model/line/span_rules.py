"""Rules for the spans of a line: their types, pre-sag, lengths of droppers, stagger."""

from arcless.errors import ModelError
from arcless.model.fields.part import nearest
from arcless.model.line.line_data import LineData
from arcless.model.line.parts.spans import MAX_SPANS, SpanType
from arcless.units import WRONG_VALUE, show

# Two clamps need more room; less is a number in m that was given as one in mm. In m.
LEAST_ENCUMBRANCE = 0.02


def check_span_types(line: LineData) -> None:
    """Raise `ModelError` for the first run of spans whose type is not there."""
    for index, run in enumerate(line.spans):
        if run.type not in line.span_types:
            raise ModelError(
                "unknown span type",
                got=show(run.type),
                expected="a name from span_types",
                hint=nearest(run.type, list(line.span_types)),
                field=("spans", index, "type"),
            )


def check_spans(line: LineData) -> None:
    """Raise `ModelError` for the first type of span that does not fit, or too many spans."""
    for name, span in line.span_types.items():
        _check_presag(line, name, span)
        _check_lengths(line, name, span)
    _check_stagger(line)
    _check_alternating(line)
    total = sum(run.count for run in line.spans)
    if total > MAX_SPANS:
        raise ModelError(
            "too many spans",
            got=str(total),
            expected=f"at most {MAX_SPANS} in all",
            field=("spans",),
        )


def _check_presag(line: LineData, name: str, span: SpanType) -> None:
    if line.geometry.encumbrance is None:
        return
    if line.geometry.encumbrance < LEAST_ENCUMBRANCE:
        raise ModelError(
            WRONG_VALUE,
            got=f"{line.geometry.encumbrance:g} m",
            expected=f"an encumbrance of at least {LEAST_ENCUMBRANCE:g} m",
            hint="mind mm and m",
            field=("geometry", "encumbrance"),
        )
    holders = "droppers" if span.hangers is None else "hangers"
    for index, presag in enumerate(span.holders.presag or ()):
        if not abs(presag) < line.geometry.encumbrance:
            raise ModelError(
                WRONG_VALUE,
                got=f"{presag:g} m",
                expected=f"less than the encumbrance, {line.geometry.encumbrance:g} m",
                hint="pre-sag is positive downwards; mind mm and m",
                field=("span_types", name, holders, "presag", index),
            )


def _check_lengths(line: LineData, name: str, span: SpanType) -> None:
    """Refuse droppers that reach from the messenger wire to the ground."""
    top = line.geometry.contact_wire_height + (line.geometry.encumbrance or 0.0)
    for index, length in enumerate(span.droppers.lengths or ()):
        if length >= top:
            raise ModelError(
                "a dropper that reaches the ground",
                got=f"{length:g} m",
                expected=f"less than {top:g} m, the height of the messenger wire",
                hint="mind mm and m",
                field=("span_types", name, "droppers", "lengths", index),
            )


def _check_stagger(line: LineData) -> None:
    for index, stagger in enumerate(line.geometry.stagger_contact_wire):
        if not line.holds_stagger and stagger != 0:
            raise ModelError(
                "nothing holds the stagger",
                got=f"{stagger:g} m with a steady arm of kind none",
                expected="0 m, or a steady arm of kind spring or arm",
                field=("geometry", "stagger_contact_wire", index),
            )
    twin = line.twin_contact_wires
    if not line.holds_stagger and twin is not None and twin.separations is not None:
        raise ModelError(
            "nothing holds the wires apart",
            got="separations with a steady arm of kind none",
            expected="one separation, or a steady arm of kind spring or arm",
            field=("twin_contact_wires", "separations"),
        )


def _check_alternating(line: LineData) -> None:
    """Refuse a second contact wire that hangs on nothing: each span begins with the first."""
    twin = line.twin_contact_wires
    if twin is None or twin.droppers == "paired" or line.messenger_wire is None:
        return
    most = max(len(line.span_types[run.type].holders.positions) for run in line.spans)
    if most < 2:  # noqa: PLR2004 - one for either wire
        raise ModelError(
            "the second contact wire hangs on nothing",
            got=f"alternating, and at most {most} dropper in a span",
            expected="two droppers or more in some span, or paired",
            hint="each span begins with the first wire",
            field=("twin_contact_wires", "droppers"),
        )
