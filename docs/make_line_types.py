"""Draw the figures of the line types: `python docs/make_line_types.py docs/images`.

Each is the initial configuration of a shipped line over two of its spans, from the side, and its
elasticity beside that of the same line without its stitch wires.
"""

import sys
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from drawing import BLUE, GREY, SUPPORT, save, set_up

import arcless
from arcless.figures.description.tokens import colour
from arcless.simulate import StaticsResult, statics

STITCHED, COMPOUND = "norway-s25-250", "shinkansen-compound-240"


def side_view(axes: Any, found: StaticsResult) -> None:
    """Draw the middle span and half of its neighbours, heights larger than lengths."""
    mesh, points = found.equilibrium.mesh, found.equilibrium.positions
    left, right = found.equilibrium.middle_span()
    begin, end = left - 0.5 * (right - left), right + 0.5 * (right - left)
    wires = [
        ("contact wire", colour("contact_wire"), [mesh.contact_nodes]),
        ("messenger wire", colour("messenger_wire"), [mesh.messenger_nodes]),
        ("auxiliary wire", colour("auxiliary_wire"), [mesh.auxiliary_nodes]),
        ("stitch wire", colour("stitch_wire"), [stitch.nodes for stitch in mesh.stitches]),
    ]
    for label, shade, pieces in wires:
        drawn = [points[nodes] for nodes in pieces if nodes]
        for index, p in enumerate(drawn):
            axes.plot(p[:, 0], p[:, 2], color=shade, lw=1.3, label=None if index else label)
    for dropper in mesh.droppers:
        ends = points[list(dropper.nodes)]
        axes.plot(ends[:, 0], ends[:, 2], color=colour("dropper"), lw=0.7, zorder=1)
    for support in mesh.supports:
        axes.axvline(support.x, color=SUPPORT, lw=0.7, ls=":")
    height = points[mesh.contact_nodes, 2].mean()
    top = points[mesh.messenger_nodes, 2].max()
    axes.set(xlim=(begin, end), ylim=(height - 0.15, top + 0.15), ylabel="height above rail, m")
    axes.legend(loc="upper center", ncols=4, frameon=False, bbox_to_anchor=(0.5, 1.18))


def elasticity(axes: Any, found: StaticsResult, label: str, **style: Any) -> None:
    """Draw the elasticity of the middle span, and of its neighbours as if they were the same."""
    x, e = np.array(found.elasticity_x_m), 1e3 * np.array(found.elasticity_m_per_N)
    length = x[-1] - x[0]
    around = [(x - length, e), (x, e), (x + length, e)]
    name = f"{label}: non-uniformity {100 * found.elasticity_nonuniformity:.0f} %"
    axes.plot(*(np.concatenate(parts) for parts in zip(*around, strict=True)), label=name, **style)


def draw(scenario: str, rivals: list[tuple[str, dict[str, Any]]], label: str, file: Path) -> None:
    """Draw one figure: the line at rest above, its elasticity below."""
    found = statics(arcless.load(scenario))
    figure, (above, below) = plt.subplots(
        2, 1, figsize=(8.0, 4.4), sharex=True, layout="constrained", height_ratios=(3, 2)
    )
    side_view(above, found)
    elasticity(below, found, label, color=BLUE, lw=1.3)
    for name, changes in rivals:
        other = statics(arcless.load(scenario).with_(**changes))
        elasticity(below, other, name, color=GREY, lw=0.9, ls="--")
    below.set(xlabel="position along the track, m", ylabel="elasticity, mm/N")
    below.set_ylim(0.0, 1.45 * below.get_ylim()[1])
    below.legend(loc="upper center", ncols=2, frameon=False)
    save(figure, file)


def main(folder: str) -> None:
    set_up()
    plain = [("without stitch wires", {"line.stitch_wire": None})]
    draw(STITCHED, plain, "stitched", Path(folder) / "line-stitched.svg")
    draw(COMPOUND, [], "compound", Path(folder) / "line-compound.svg")


if __name__ == "__main__":
    main(*sys.argv[1:])
