"""The rule e = l/(k ΣT) for the elasticity in mid-span, on the shipped lines.

k = 4.0 without and 3.5 with a stitch wire (S55). With k = 4 it is the middle of one string of the
tension ΣT between two supports: many stiff droppers that make one string of all wires, and all
wires held at the supports. What a line has of neither can be put in: droppers a metre apart, and
arms that do not yield.
"""

from functools import cache
from typing import Any

import numpy as np
from validation.runs import table

import arcless
from arcless.equilibrium import equilibrium
from arcless.model import Line, load_line
from arcless.model.shipped.library import shipped

PLAIN, STITCHED = 4.0, 3.5
ALLOWED = 0.15  # a line farther from the rule is explained by what is computed
DENSE, RIGID = 1.0, 1e7  # distance in m; N/m
# The published method's own line, whose pantograph and droppers are no line's.
LEFT_OUT = {"praks"}


def lines() -> list[str]:
    """Return the shipped lines that the rule is about."""
    names = [name for name in shipped("line") if name not in LEFT_OUT]
    return [name for name in names if load_line(name).messenger_wire is not None]


def rule(line: Line) -> float:
    """Elasticity in mid-span by the rule, mm/N."""
    assert line.messenger_wire is not None
    total = line.messenger_wire.tension
    total += line.contact_wire.tension * (1 if line.twin_contact_wires is None else 2)
    total += 0.0 if line.auxiliary_wire is None else line.auxiliary_wire.tension
    k = PLAIN if line.stitch_wire is None else STITCHED
    return 1e3 * line.span_list()[0].length / (k * total)


def closer(line: Line) -> dict[str, Any]:
    """Changes that hang all wires on droppers a metre apart, as heavy by metre as those it has."""
    name, changes = line.spans[0].type, dict[str, Any]()
    outer = line.span_types[name].holders.positions  # of a compound line its hangers
    count = round((outer[-1] - outer[0]) / DENSE) // 2 * 2 + 1  # one of them in mid-span
    places = np.linspace(outer[0], outer[-1], count)
    for kind, part in (("droppers", "dropper"), ("hangers", "hanger")):
        own = getattr(line.span_types[name], kind)
        if own is None:
            continue
        presag = np.interp(places, own.positions, own.design_presag)
        changes[f"span_types.{name}.{kind}"] = {
            "positions": places.tolist(), "presag": presag.tolist()
        }  # fmt: skip
        if getattr(line, part) is not None:
            lighter = len(own.positions) / count
            for mass in ("mass", "clamp_mass_contact_wire", "clamp_mass_messenger_wire"):
                changes[f"{part}.{mass}"] = lighter * getattr(getattr(line, part), mass)
    return changes


HELD = {"steady_arm": {"kind": "spring", "vertical_stiffness": RIGID}}
VARIANTS = ("as shipped", "droppers 1 m apart", "arms that do not yield", "both", "no stitch wire")


@cache
def mid_span(name: str, variant: str = "as shipped") -> float:
    """Elasticity in the middle of the middle span, mm/N."""
    line = load_line(name)
    changes: dict[str, Any] = {}
    if variant in ("droppers 1 m apart", "both", "no stitch wire"):
        changes |= closer(line)
    if variant in ("arms that do not yield", "both", "no stitch wire"):
        changes |= HELD
    if variant == "no stitch wire":
        changes["stitch_wire"] = None
    base = arcless.load("norway-s25-250").with_(line=name)
    found = equilibrium.find(base.with_(**{f"line.{path}": v for path, v in changes.items()}))
    left, right = found.middle_span()
    return 1e3 * float(found.elasticity(np.array([(left + right) / 2.0]))[0])


def one_string(line: Line) -> float:
    """Elasticity in mid-span of one string of all tensions between two supports, mm/N."""
    return rule(line) * (1.0 if line.stitch_wire is None else STITCHED / PLAIN)


def as_one_string(line: Line) -> str:
    """Return the variant that leaves nothing but that string."""
    return VARIANTS[-2] if line.stitch_wire is None else VARIANTS[-1]


def _share(value: float, of: float) -> str:
    return f"{100 * (value / of - 1):+.0f}"


def rule_table() -> str:
    rows = []
    for name in lines():
        line, found = load_line(name), mid_span(name)
        by_rule = rule(line)
        k = (PLAIN if line.stitch_wire is None else STITCHED) * by_rule / found
        rows.append((
            name, f"{by_rule:.3f}", f"{found:.3f}", _share(found, by_rule), f"{k:.2f}",
            len(line.span_list()[0].holders.positions),
        ))  # fmt: skip
    head = ("line", "rule mm/N", "product mm/N", "product over rule %", "k")
    return table((*head, "droppers in a span"), rows)


def far() -> list[str]:
    """Return the lines beyond what is allowed."""
    return [n for n in lines() if abs(mid_span(n) / rule(load_line(n)) - 1.0) > ALLOWED]


def far_table() -> str:
    rows = []
    for name in far():
        line = load_line(name)
        plain = one_string(line)
        variants = VARIANTS if line.stitch_wire is not None else VARIANTS[:-1]
        cells = [
            f"{mid_span(name, v):.3f} ({_share(mid_span(name, v), plain)} %)" for v in variants
        ]
        rows.append((name, f"{plain:.3f}", *cells, *["–"] * (len(VARIANTS) - len(variants))))
    return table(("line", "l/(4 ΣT) mm/N", *VARIANTS), rows)


TABLES = {"mid-span": rule_table, "mid-span-far": far_table}
