"""Tables of the guide to damping: what shipped lines have, and what damping changes.

The latter by two pantographs at the spacing of their speed, with the mean forces of the shipped
scenario, on lines long enough for both, with explicit steps.
"""

from math import ceil, pi
from typing import Any

from validation.runs import table

import arcless
from arcless.model import Line, load_line
from arcless.model.pantograph.spacing import tsi_spacing
from arcless.model.shipped.library import shipped

LINES = ("germany-re-330-300", "france-lgv-est-320", "spain-ca-220-220")
# Share of critical damping at the frequency at which a line was measured, Hz; and β of all lines.
MEASURED, BETA = 1.4, 1e-4
SHARES = (0.0012, 0.01, 0.02, 0.05)
BETAS = (1e-5, 1e-4, 3e-4)
# Spans run before and assessed, by both pantographs alike.
BEFORE, ASSESSED = 6, 10
VALUES = ("leading σ N", "min N", "trailing σ N", "min N", "uplift mm")
# Frequencies in Hz that shares are told at.
AT = (1.0, MEASURED, 5.0, 20.0)
REFERENCES = ("ac-simple", "en50318", "praks", "conductor-rail")
KINDS = {
    "real lines": ((), "assumed: the least of what lines were measured at; β as in public studies"),
    "AC simple": ("ac-simple", "as remembered for the published model (C)"),
    "EN 50318:2002": (
        "en50318",
        "assumed; [left open by the description](../validation/en50318-2002.md)",
    ),
    "PRAKS": ("praks", "not in the paper"),
    "conductor rails": ("conductor-rail", "read with them (A)"),
}
ALL_WIRES = ("contact_wire", "messenger_wire", "auxiliary_wire", "stitch_wire", "bridle")
WIRES = ("contact_wire", "messenger_wire", "stitch_wire")
STEPS = {
    "solver.scheme": "central-difference",
    "solver.contact_wire_element": "auto",
    "solver.messenger_wire_element": "auto",
}


def share(alpha: float, beta: float, frequency: float) -> float:
    """Return the share of critical damping at a frequency in Hz: α/2ω + βω/2."""
    omega = 2 * pi * frequency
    return alpha / (2 * omega) + beta * omega / 2


def alpha_of(damping: float, beta: float = BETA) -> float:
    """Return the α in 1/s that damps by a share of critical at the frequency of the measurement."""
    omega = 2 * pi * MEASURED
    return 2 * omega * (damping - beta * omega / 2)


def spacing(name: str) -> float:
    """Return the distance in m of two pantographs at the speed of a scenario."""
    return tsi_spacing(arcless.load(name).top_speed)


def pair(name: str, alpha: float, beta: float) -> list[float]:
    """Return σ and minimum of leading and trailing pantograph in N, and the uplift in mm."""
    base = arcless.load(name)
    one: dict[str, Any] = base.to_dict()["pantographs"][0]
    two = base.with_(pantographs=[one, {**one, "name": "P2", "distance": "tsi"}])
    length = base.line.span_list()[0].length
    behind = ceil(two.pantographs[1].distance / length)
    first = behind + BEFORE
    kind = base.line.spans[0].type
    changes = {
        "line.spans": [{"type": kind, "count": 2 * behind + BEFORE + ASSESSED + 2}],
        "travel": {"start": (behind + 1) * length, "end": (first + ASSESSED + behind + 1) * length},
        "analysis": {"from": first * length, "to": (first + ASSESSED) * length},
        **STEPS,
    }
    for wire in WIRES:
        if getattr(base.line, wire) is not None:
            changes[f"line.{wire}.damping"] = {"alpha": alpha, "beta": beta}
    found = arcless.run(two.with_(**changes)).assessment.to_dict()
    forces = [(p["std_force_N"], p["min_force_N"]) for p in found["pantographs"]]
    return [value for both in forces for value in both] + [found["max_uplift_at_support_mm"]]


def lines_table() -> str:
    """Return the damping of the shipped lines, kind by kind, as their files have it."""
    rows = []
    for kind, (begins, why) in KINDS.items():
        names = [name for name in shipped("line") if begins and name.startswith(begins)]
        if not begins:
            names = [name for name in shipped("line") if not name.startswith(REFERENCES)]
        ((alpha, beta),) = {pair for name in names for pair in _of_wires(load_line(name))}
        shares = ", ".join(f"{100 * share(alpha, beta, f):.2g}" for f in AT)
        rows.append((kind, f"{alpha:g}", f"{1e3 * beta:g}", shares if alpha else "0", why))
    at = ", ".join(f"{f:g}" for f in AT)
    return table(("lines", "α 1/s", "β ms", f"ζ at {at} Hz, %", "why"), rows)


def _of_wires(line: Line) -> set[tuple[float, float]]:
    wires = [getattr(line, name) for name in ALL_WIRES]
    return {(wire.damping.alpha, wire.damping.beta) for wire in wires if wire is not None}


def alpha_table() -> str:
    """Return runs with damping by α, so that low frequencies differ most."""
    return table(
        ("scenario, spacing", "ζ at 1.4 Hz %", "α 1/s", *VALUES),
        (
            (f"{name}, {spacing(name):g} m", f"{100 * damping:.2g}", f"{alpha_of(damping):.3f}",
             *_row(name, alpha_of(damping), BETA))
            for name in LINES
            for damping in SHARES
        ),
    )  # fmt: skip


def beta_table() -> str:
    """Return runs with the same damping where lines were measured, and another β."""
    rows = []
    for name in LINES:
        for beta in BETAS:
            alpha = alpha_of(SHARES[1], beta)
            at_20_hz = f"{100 * share(alpha, beta, 20.0):.2g}"
            cells = [f"{name}, {spacing(name):g} m", f"{beta:.0e}", at_20_hz]
            rows.append((*cells, *_row(name, alpha, beta)))
    return table(("scenario, spacing", "β s", "ζ at 20 Hz %", *VALUES), rows)


def _row(name: str, alpha: float, beta: float) -> list[str]:
    return [f"{value:.1f}" for value in pair(name, alpha, beta)]


QUICK = {"lines": lines_table}
SLOW = {"alpha": alpha_table, "beta": beta_table}
