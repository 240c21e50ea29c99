"""Draw the figures of overlaps and twin wires: `python docs/make_several_wires.py docs/images`.

The overlap is that of a shipped line, at rest from the side and from above, with the force that
each of its wires takes as a pantograph passes. The twin wires are drawn with their elasticity.
"""

import sys
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from drawing import BLUE, GREY, ORANGE, SUPPORT, save, set_up

import arcless
from arcless.simulate import StaticsResult, statics

OVERLAP, TWIN = "ac-simple-overlap-275", "spain-ca-220-3kv-200"
SHADES = (BLUE, ORANGE)


def near(x: Any, limits: tuple[float, float]) -> Any:
    """Tell which positions are drawn."""
    return (x >= limits[0]) & (x <= limits[1])


def wires(axes: Any, found: StaticsResult, component: int, limits: tuple[float, float]) -> None:
    """Draw contact and messenger wires of all tension lengths, one colour for each."""
    mesh, points = found.equilibrium.mesh, found.equilibrium.positions
    for shade, system in zip(SHADES, mesh.systems, strict=True):
        for nodes in (*system.contact.values(), system.messenger):
            drawn = points[nodes][near(points[nodes, 0], limits)]
            main = nodes is not system.messenger
            label = system.label if main else None
            style = {"lw": 1.4 if main else 0.8, "ls": "-" if main else "--"}
            axes.plot(drawn[:, 0], drawn[:, component], color=shade, label=label, **style)
    for place in found.equilibrium.support_places():
        axes.axvline(place, color=SUPPORT, lw=0.7, ls=":")


def overlap(file: Path) -> None:
    """Draw an overlap at rest, and the forces in it."""
    scenario = arcless.load(OVERLAP)
    begin, end = scenario.analysis_range()
    limits = begin - 55.0, end + 55.0
    found = statics(scenario)
    figure, axes = plt.subplots(
        4, 1, figsize=(8.0, 7.4), sharex=True, layout="constrained", height_ratios=(3, 2, 2, 2)
    )
    side, plan, *forces = axes
    wires(side, found, 2, limits)
    wires(plan, found, 1, limits)
    side.set(ylabel="height above rail, m")
    plan.set(ylabel="across, m")
    side.legend(loc="upper center", ncols=2, frameon=False, bbox_to_anchor=(0.5, 1.2))
    for axis, speed in zip(forces, ("60 km/h", "275 km/h"), strict=True):
        data = arcless.run(scenario.with_(speed=speed)).dataset
        drawn = near(data["position"].values[:, 0], limits)
        x = data["position"].values[drawn, 0]
        total = data["contact_force"].values[drawn, 0]
        for shade, force in zip(SHADES, data["wire_contact_force"].values[drawn].T, strict=True):
            axis.plot(x, np.where(force > 0.0, force, np.nan), color=shade, lw=0.8)
        axis.plot(x, total, color=GREY, lw=0.5, label="both together")
        axis.set(ylabel=f"force at {speed}, N", ylim=(0, None))
    forces[0].legend(loc="lower left", frameon=False)
    forces[-1].set(xlabel="position along the track, m", xlim=limits)
    save(figure, file)


def twin(file: Path) -> None:
    """Draw twin wires with alternating droppers, and their elasticity."""
    scenario = arcless.load(TWIN)
    found = statics(scenario)
    mesh, points = found.equilibrium.mesh, found.equilibrium.positions
    left, right = found.equilibrium.middle_span()
    figure, (above, below) = plt.subplots(
        2, 1, figsize=(8.0, 4.4), sharex=True, layout="constrained", height_ratios=(3, 2)
    )
    for dropper in mesh.droppers:
        ends = points[list(dropper.nodes)]
        shade = SHADES[dropper.wires[1] == "contact wire 2"]
        above.plot(ends[:, 0], ends[:, 2], color=shade, lw=0.8)
    for nodes, shade, label in zip(
        (*mesh.contact_wires, mesh.messenger_nodes),
        (*SHADES, GREY),
        ("contact wire 1", "contact wire 2", "messenger wire"),
        strict=True,
    ):
        above.plot(points[nodes, 0], points[nodes, 2], color=shade, lw=1.3, label=label)
    above.set(ylabel="height above rail, m", ylim=(5.2, 6.85))
    above.legend(loc="upper center", ncols=3, frameon=False, bbox_to_anchor=(0.5, 1.2))
    x = found.equilibrium.elasticity_positions()
    below.plot(x, 1e3 * found.equilibrium.elasticity(x), color=GREY, label="both touched")
    for lane, shade, label in zip(mesh.lanes, SHADES, ("wire 1", "wire 2"), strict=True):
        alone = np.array(found.equilibrium.core.elasticity([lane], x.tolist(), 0.0))
        below.plot(x, 1e3 * alone, color=shade, lw=0.9, ls="--", label=f"{label} alone")
    for support in mesh.supports:
        for axis in (above, below):
            axis.axvline(support.x, color=SUPPORT, lw=0.7, ls=":")
    below.set(xlabel="position along the track, m", ylabel="elasticity, mm/N", ylim=(0, None))
    below.set_xlim(left - 5.0, right + 5.0)
    below.legend(loc="lower center", ncols=3, frameon=False)
    save(figure, file)


def main(folder: str) -> None:
    set_up()
    overlap(Path(folder) / "overlap.svg")
    twin(Path(folder) / "twin-wires.svg")


if __name__ == "__main__":
    main(*sys.argv[1:])
