"""Rules for a line with a messenger wire, and for one without."""

from arcless.errors import ModelError
from arcless.model.fields.rule_errors import missing
from arcless.model.line.line_data import LineData
from arcless.model.line.parts.contact_supports import Bridle

# Fields that need a messenger wire, and what they are.
ABOVE = {
    "dropper": "droppers",
    "support": "messenger supports",
    "stitch_wire": "stitch wires",
    "auxiliary_wire": "an auxiliary wire",
    "hanger": "hangers",
    "twin_contact_wires": "twin contact wires",
}
EXAMPLES = {
    "dropper": "{stiffness: 100 kN/m}",
    "support": "{vertical_stiffness: 500 kN/m}",
    "steady_arm": "{kind: spring, vertical_stiffness: 250 N/m}",
}
STANDARD_GRAVITY = 9.81
TROLLEY = "without a messenger wire the contact wire hangs on contact_support alone"


def check_suspension(line: LineData) -> None:
    """Raise `ModelError` for the first thing that does not fit."""
    if line.messenger_wire is not None:
        _check_hung(line)
    else:
        _check_trolley(line)
    if line.bridle is not None:
        _check_bridle(line, line.bridle)


def _check_hung(line: LineData) -> None:
    """Refuse a messenger wire without all that hangs the contact wire on it."""
    for name in ("contact_support", "bridle"):
        if getattr(line, name) is not None:
            raise ModelError(
                f"{name.replace('_', ' ')} with a messenger wire",
                expected=f"messenger_wire, or {name}",
                hint="droppers hold a contact wire below a messenger wire",
                field=(name,),
            )
    if line.contact_wire.kind == "conductor_rail":
        raise ModelError(
            "conductor rail below a messenger wire",
            expected="a contact wire of kind wire, or no messenger_wire",
            hint=TROLLEY,
            field=("contact_wire", "kind"),
        )
    for name in ("dropper", "support", "steady_arm"):
        is_absent = name == "steady_arm" and name not in line.model_fields_set
        if is_absent or getattr(line, name) is None:
            raise missing(
                name,
                expected=f"{name}, which a line with a messenger wire has",
                hint=f"for instance {name}: {EXAMPLES[name]}",
            )
    if line.geometry.encumbrance is None:
        expected = line.geometry._expected("encumbrance")
        raise missing("geometry", "encumbrance", expected=expected)
    for name, span in line.span_types.items():
        if "droppers" not in span.model_fields_set:
            field = ("span_types", name, "droppers")
            raise missing(
                *field,
                expected="droppers, which the contact wire hangs on",
                hint="for instance droppers: {positions: [10 m, 20 m, 30 m]}; a span without any"
                " has droppers: {positions: []}",
            )


def _check_trolley(line: LineData) -> None:
    given = [name for name in ABOVE if getattr(line, name) is not None]
    if line.contact_support is None and not given and line.geometry.encumbrance is None:
        raise missing(
            "messenger_wire",
            expected="messenger_wire, or contact_support for a contact wire without one",
        )
    for name in given:
        raise _without_messenger(ABOVE[name], name, (name,))
    if line.geometry.encumbrance is not None:
        raise _without_messenger("encumbrance", "encumbrance", ("geometry", "encumbrance"))
    if any(line.geometry.stagger_messenger_wire):
        name = "stagger_messenger_wire"
        raise _without_messenger("stagger of a messenger wire", name, ("geometry", name))
    for name, span in line.span_types.items():
        for what in ("droppers", "hangers"):
            own = getattr(span, what)
            if own is not None and own.positions:
                raise _without_messenger(what, what, ("span_types", name, what))
    if line.contact_support is None:
        raise missing(
            "contact_support",
            expected="contact_support: what holds the contact wire, or its bridle, at each mast",
        )
    if line.bridle is None and line.steady_arm.kind != "none":
        raise ModelError(
            "two things hold the contact wire at each mast",
            got=f"contact_support and a steady arm of kind {line.steady_arm.kind}",
            expected="contact_support alone, or a bridle that it holds",
            field=("steady_arm", "kind"),
        )


def _without_messenger(what: str, name: str, field: tuple[str, ...]) -> ModelError:
    return ModelError(
        f"{what} without a messenger wire",
        expected=f"messenger_wire, or no {name}",
        hint=TROLLEY,
        field=field,
    )


def _check_bridle(line: LineData, bridle: Bridle) -> None:
    tension, spans = line.contact_wire.tension, line.span_list()
    if line.contact_wire.kind == "conductor_rail":
        raise ModelError(
            "bridle of a conductor rail",
            expected="a contact wire of kind wire, or no bridle",
            field=("bridle",),
        )
    if bridle.tension >= tension:
        raise ModelError(
            "bridle with all of the contact wire's tension",
            got=f"{bridle.tension:g} N",
            expected=f"less than {tension:g} N, the tension of the contact wire",
            hint="between the clamps the contact wire keeps the difference",
            field=("bridle", "tension"),
        )
    _check_steepness(line, bridle)
    if len(spans) == 1:
        raise ModelError(
            "no support for a bridle",
            got="a line of one span",
            expected="at least two spans",
            hint="bridles hang at the supports between two spans",
            field=("bridle",),
        )
    shortest = min(span.length for span in spans)
    if bridle.length >= shortest:
        raise ModelError(
            "bridle longer than a span",
            got=f"{bridle.length:g} m",
            expected=f"less than {shortest:g} m, the shortest span",
            hint="half of it reaches into each span, where that of the next support begins",
            field=("bridle", "length"),
        )


def _check_steepness(line: LineData, bridle: Bridle) -> None:
    """Refuse a bridle steeper than 1 in 2: R/T_b, with half of the longest span on each clamp."""
    longest = max(span.length for span in line.span_list())
    weight = STANDARD_GRAVITY * 0.5 * line.contact_wire.mass * longest
    if bridle.tension < 2 * weight:
        raise ModelError(
            "bridle too loose",
            got=f"{bridle.tension:g} N, with {weight:.3g} N of contact wire on each clamp",
            expected=f"at least {2 * weight:.3g} N",
            hint="with less it rises by more than one metre in two from its clamps",
            field=("bridle", "tension"),
        )
