"""Errors over the length of elements: a line for each error instead of one for each length."""

import re

import numpy as np
from validation.runs import escaped, table

from arcless.validate.evidence import INSIDE, Measurement

SIZED = re.compile(r"(?P<what>.*), (?P<family>chain|cubic) of (?P<size>[\d.]+) m")
LEAST = 3
HEAD = """Errors over the length of elements, each with what is allowed behind it. *Order* is the
slope of log (error) over log (length), by least squares; it is less where an error comes to that of
the time step."""
NAMES = {"chain": "chains of point masses", "cubic": "cubic elements"}

# What is measured, the family, and the unit.
Key = tuple[str, str, str]


def split(rows: list[Measurement]) -> tuple[dict[Key, list[Measurement]], list[Measurement]]:
    """Return errors that are known at three lengths or more, and all other rows."""
    known: dict[Key, list[Measurement]] = {}
    for row in rows:
        match = SIZED.fullmatch(row.what)
        if match and row.reference is None and row.low is None:
            known.setdefault((match["what"], match["family"], row.unit), []).append(row)
    known = {key: own for key, own in known.items() if len(own) >= LEAST}
    taken = {row.what for own in known.values() for row in own}
    return known, [row for row in rows if row.what not in taken]


def tables(known: dict[Key, list[Measurement]]) -> str:
    """Return the tables of both families, and the reasons of their tolerances."""
    if not known:
        return ""
    parts = [HEAD]
    for family, name in NAMES.items():
        own = {key: rows for key, rows in known.items() if key[1] == family}
        if not own:
            continue
        sizes = sorted({_size(row) for rows in own.values() for row in rows}, reverse=True)
        head = [f"error, {name}", *(f"{size:g} m" for size in sizes), "order", "verdict"]
        parts.append(table(head, [_line(key, rows, sizes) for key, rows in own.items()]))
        parts.append(_reasons(own))
    return "\n\n".join(parts)


def _size(row: Measurement) -> float:
    match = SIZED.fullmatch(row.what)
    assert match
    return float(match["size"])


def _line(key: Key, rows: list[Measurement], sizes: list[float]) -> list[str]:
    what, _, unit = key
    found = {_size(row): row for row in rows}
    cells = [f"{found[s].value:.2g} ≤ {found[s].high:.2g}" if s in found else "" for s in sizes]
    values = [row.value for row in found.values()]
    order = ""
    if min(values) > 0.0:
        order = f"{np.polyfit(np.log(list(found)), np.log(values), 1)[0]:.1f}"
    name = what + ("" if unit == "1" else f", {unit}") + (" †" if rows[0].slow else "")
    outside = [row.verdict for row in rows if row.verdict != INSIDE]
    return [escaped(name), *cells, order, f"**{outside[0]}**" if outside else INSIDE]


def _reasons(own: dict[Key, list[Measurement]]) -> str:
    """Return each reason once, after what it is the reason of."""
    known: dict[str, list[str]] = {}
    for (what, _, _), rows in own.items():
        for reason in dict.fromkeys(row.reason for row in rows):
            known.setdefault(reason, []).append(what.split(",")[0])
    lines = [
        f"- {escaped(', '.join(dict.fromkeys(what)))}: {escaped(reason)}"
        for reason, what in known.items()
    ]
    return "Why these tolerances:\n\n" + "\n".join(lines)
