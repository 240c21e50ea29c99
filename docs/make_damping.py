"""Print the tables of docs/guide/damping.md: `python docs/make_damping.py`, about a minute.

Two pantographs at the spacing of their speed, with the mean forces of the shipped scenario, on
lines long enough for both, with explicit steps.
"""

from math import ceil, pi
from typing import Any

import arcless
from arcless.model.pantograph.spacing import tsi_spacing

LINES = ("germany-re-330-300", "france-lgv-est-320", "spain-ca-220-220")
# Share of critical damping at the frequency at which a line was measured, Hz; and β of all lines.
MEASURED, BETA = 1.4, 1e-4
SHARES = (0.0012, 0.01, 0.02, 0.05)
BETAS = (1e-5, 1e-4, 3e-4)
# Spans run before and assessed, by both pantographs alike.
BEFORE, ASSESSED = 6, 10
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


def row(cells: list[str], values: list[float]) -> None:
    print(f"| {' | '.join(cells)} | {' | '.join(f'{value:.1f}' for value in values)} |")


def main() -> None:
    """Print both tables."""
    for name in LINES:
        for damping in SHARES:
            alpha = alpha_of(damping)
            cells = [f"{name}, {spacing(name):g} m", f"{100 * damping:.2g}", f"{alpha:.3f}"]
            row(cells, pair(name, alpha, BETA))
    for name in LINES:
        for beta in BETAS:
            alpha = alpha_of(SHARES[1], beta)
            at_20_hz = f"{100 * share(alpha, beta, 20.0):.2g}"
            cells = [f"{name}, {spacing(name):g} m", f"{beta:.0e}", at_20_hz]
            row(cells, pair(name, alpha, beta))


if __name__ == "__main__":
    main()
