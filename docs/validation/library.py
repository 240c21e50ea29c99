"""Tables of the page library: every shipped line and pantograph at a glance."""

from collections import Counter
from typing import Any

import numpy as np
from validation.runs import table
from validation.shipped import at_rest

from arcless.model import Line, Pantograph, load_line, load_pantograph
from arcless.model.shipped.library import shipped

MARKS = (("A", "A'", "D"), ("B",), ("C", "C*"), ("assumed",))
KNOWN = ("read", "second-hand", "memory", "assumed")


def kind_of(line: Line) -> str:
    """Say in a word or two what the fields of a line make of it."""
    if line.messenger_wire is None:
        rail = getattr(line.contact_wire, "kind", "wire") == "conductor_rail"
        return "conductor rail" if rail else "trolley wire"
    parts = [
        "stitched" if line.stitch_wire else "",
        "compound" if line.auxiliary_wire else "",
        "twin" if line.twin_contact_wires else "",
        "overlap" if line.tension_lengths else "",
    ]
    return " ".join(filter(None, parts)) or "simple"


def marks_of(model: Line | Pantograph) -> list[str]:
    """Count the values by how they are known."""
    count = Counter(entry.mark for entry in model.provenance.values())
    return [str(sum(count[mark] for mark in group)) for group in MARKS]


def _tension(wire: Any) -> str:
    tension = getattr(wire, "tension", None)
    return f"{1e-3 * tension:.4g}" if tension else "–"


def lines_table() -> str:
    rows = []
    for name in shipped("line"):
        line = load_line(name)
        found = at_rest(name)
        e = 1e3 * np.array(found.elasticity_m_per_N)
        rows.append(
            (
                name,
                kind_of(line),
                f"{max(span.length for span in line.span_list()):g}",
                _tension(line.contact_wire),
                _tension(line.messenger_wire),
                "–" if found.wave_speed is None else f"{3.6 * found.wave_speed:.0f}",
                f"{e[0]:.3g}",
                f"{e[len(e) // 2]:.3g}",
                *marks_of(line),
            )
        )
    own = ("line", "type", "span m", "contact kN", "messenger kN", "wave km/h")
    return table((*own, "support mm/N", "mid-span mm/N", *KNOWN), rows)


def pantographs_table() -> str:
    rows = []
    for name in shipped("pantograph"):
        model = load_pantograph(name)
        masses = ", ".join(f"{mass.mass:g}" for mass in model.masses or ())
        stiffness = ", ".join(f"{mass.stiffness:g}" for mass in model.masses or ())
        force = "–" if model.static_force is None else f"{model.static_force:g}"
        rows.append((name, masses, stiffness, force, *marks_of(model)))
    return table(("pantograph", "masses kg", "springs N/m", "static N", *KNOWN), rows)


QUICK = {"pantographs": pantographs_table}
SLOW = {"lines": lines_table}
