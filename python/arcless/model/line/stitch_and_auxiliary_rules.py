"""Rules for a line with stitch wires or an auxiliary wire."""

from arcless.errors import ModelError
from arcless.model.fields.rule_errors import missing
from arcless.model.line.line_data import LineData
from arcless.model.line.parts.components import AuxiliaryWire, StitchWire


def check_wires(line: LineData) -> None:
    """Raise `ModelError` for the first thing that does not fit."""
    if line.stitch_wire is not None:
        _check_stitch(line, line.stitch_wire)
    if line.auxiliary_wire is not None:
        _check_auxiliary(line, line.auxiliary_wire)
    _check_hangers(line)


def _check_stitch(line: LineData, stitch: StitchWire) -> None:
    assert line.messenger_wire is not None
    messenger, spans = line.messenger_wire.tension, line.span_list()
    if stitch.tension >= messenger:
        raise ModelError(
            "stitch wire with all of the messenger wire's tension",
            got=f"{stitch.tension:g} N",
            expected=f"less than {messenger:g} N, the tension of the messenger wire",
            hint="between the clamps the messenger wire keeps the difference",
            field=("stitch_wire", "tension"),
        )
    if len(spans) == 1:
        raise ModelError(
            "no support for a stitch wire",
            got="a line of one span",
            expected="at least two spans",
            hint="stitch wires hang at the supports between two spans",
            field=("stitch_wire",),
        )
    shortest = min(spans, key=lambda span: span.length)
    if stitch.length >= shortest.length:
        raise ModelError(
            "stitch wire longer than a span",
            got=f"{stitch.length:g} m",
            expected=f"less than {shortest.length:g} m, the shortest span",
            hint="half of it reaches into each span, where that of the next support begins",
            field=("stitch_wire", "length"),
        )
    _check_stitch_droppers(line, stitch)


def _check_stitch_droppers(line: LineData, stitch: StitchWire) -> None:
    nearest = min(
        (min(x, span.length - x) for span in line.span_list() for x in span.droppers.positions),
        default=None,
    )
    if nearest is None or nearest >= 0.5 * stitch.length:
        got = "no dropper" if nearest is None else f"the nearest one {nearest:g} m from a support"
        raise ModelError(
            "no dropper on the stitch wire",
            got=got,
            expected=f"one less than {0.5 * stitch.length:g} m, half of the stitch wire, from it",
            hint=_reach(nearest),
            field=("stitch_wire", "length"),
        )


def _reach(nearest: float | None) -> str:
    if nearest is None:
        return "give the spans next to the supports droppers"
    return f"a stitch wire of more than {2 * nearest:g} m, or a dropper nearer to each support"


def _check_auxiliary(line: LineData, wire: AuxiliaryWire) -> None:
    encumbrance = line.geometry.encumbrance
    assert encumbrance is not None
    if wire.height >= encumbrance:
        raise ModelError(
            "auxiliary wire not between contact and messenger wire",
            got=f"{wire.height:g} m above the contact wire",
            expected=f"less than the encumbrance, {encumbrance:g} m",
            field=("auxiliary_wire", "height"),
        )
    for name, span in line.span_types.items():
        for index, presag in enumerate(span.droppers.presag or ()):
            if not 0 < wire.height - presag < encumbrance:
                raise ModelError(
                    "auxiliary wire not between contact and messenger wire",
                    got=f"{wire.height - presag:g} m above the contact wire: auxiliary_wire.height,"
                    f" {wire.height:g} m, less a pre-sag of {presag:g} m",
                    expected=f"a height between 0 and {encumbrance:g} m above it",
                    hint="droppers hold the auxiliary wire: their pre-sag is that of this wire;"
                    " that of the contact wire belongs to hangers",
                    field=("span_types", name, "droppers", "presag", index),
                )


def _check_hangers(line: LineData) -> None:
    wire = line.auxiliary_wire
    if wire is None and line.hanger is not None:
        raise ModelError(
            "hangers without an auxiliary wire",
            expected="auxiliary_wire, or no hanger",
            hint="without that wire the contact wire hangs on droppers",
            field=("hanger",),
        )
    for name, span in line.span_types.items():
        field = ("span_types", name, "hangers")
        if wire is None and span.hangers is not None:
            raise ModelError(
                "hangers without an auxiliary wire",
                expected="auxiliary_wire, or droppers alone",
                hint="hangers hold the contact wire below an auxiliary wire",
                field=field,
            )
        if wire is not None and span.hangers is None:
            raise missing(
                *field,
                expected="hangers: what the contact wire hangs on below the auxiliary wire",
                hint="for instance hangers: {positions: [10 m, 20 m, 30 m, 40 m]}",
            )
        for index, presag in enumerate((span.hangers and span.hangers.presag) or ()):
            if wire is not None and -presag >= wire.height:
                raise ModelError(
                    "contact wire above the auxiliary wire",
                    got=f"{-presag:g} m above its nominal height",
                    expected=f"less than {wire.height:g} m",
                    hint="pre-sag is positive downwards",
                    field=(*field, "presag", index),
                )
