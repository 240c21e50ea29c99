"""Draw the figures of simple lines and line parts: `python docs/make_simple_lines.py docs/images`.

What the two pages print of them and `docs/make_pages.py` does not write is printed.
"""

import sys
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from drawing import BLUE, GREEN, GREY, ORANGE, save, set_up

import arcless
from arcless.simulate import StaticsResult, statics

TROLLEY, RAILS = "trolley-bridles-60", [f"conductor-rail-{number}-120" for number in (1, 2, 3)]
PLAIN = {"line.bridle": None, "line.steady_arm": {"kind": "none"}}
INSULATOR = {
    "name": "section insulator",
    "position": 550.0,
    "length": 1.6,
    "mass": 12.0,
    "axial_stiffness": 20e6,
    "bending_stiffness": 3e3,
}


def middle(found: StaticsResult) -> tuple[float, float]:
    """Return the middle span and half of its neighbours."""
    left, right = found.equilibrium.middle_span()
    return left - 0.5 * (right - left), right + 0.5 * (right - left)


def at_rest(axes: Any, found: StaticsResult, label: str, style: dict[str, Any]) -> None:
    """Draw contact wire and bridles from the side."""
    mesh, points = found.equilibrium.mesh, found.equilibrium.positions
    wire = points[mesh.contact_nodes]
    axes.plot(wire[:, 0], wire[:, 2], label=label, **style)
    for bridle in mesh.bridles:
        p = points[bridle.nodes]
        axes.plot(p[:, 0], p[:, 2], color=ORANGE, lw=1.0)
    axes.set(xlim=middle(found), ylabel="height above rail, m")


def elasticity(axes: Any, found: StaticsResult, label: str, style: dict[str, Any]) -> None:
    """Draw the elasticity of the middle span, and of its neighbours as if they were the same."""
    x, e = np.array(found.elasticity_x_m), 1e3 * np.array(found.elasticity_m_per_N)
    length = x[-1] - x[0]
    xs = np.concatenate([x - length, x, x + length])
    axes.plot(xs, np.tile(e, 3), label=label, **style)
    axes.set(xlabel="position along the track, m", ylabel="elasticity, mm/N")


def compare(cases: list[tuple[str, StaticsResult, dict[str, Any]]], file: Path) -> None:
    """Draw several lines at rest above each other, their elasticity below."""
    figure, (above, below) = plt.subplots(
        2, 1, figsize=(8.0, 4.4), sharex=True, layout="constrained", height_ratios=(3, 2)
    )
    for label, found, style in cases:
        at_rest(above, found, label, style)
        elasticity(below, found, label, style)
    low, high = above.get_ylim()
    above.set_ylim(low, high + 0.2 * (high - low))
    above.legend(loc="upper center", ncols=3, frameon=False)
    below.set_ylim(bottom=0.0)
    save(figure, file)


def bridles(file: Path) -> None:
    """Draw the trolley wire with and without bridles; print how high these hang."""
    scenarios = [arcless.load(TROLLEY).with_(**PLAIN), arcless.load(TROLLEY)]
    found = [statics(scenario) for scenario in scenarios]
    styles = [{"color": GREY, "lw": 0.9, "ls": "--"}, {"color": BLUE, "lw": 1.3}]
    compare(list(zip(["trolley wire", "on bridles"], found, styles, strict=True)), file)
    hang = found[1].bridles[len(found[1].bridles) // 2]["hangs_at_m"]
    print(f"hangs at {hang:.3f} m")


def rails(file: Path) -> None:
    """Draw three conductor rails."""
    found = [statics(arcless.load(name)) for name in RAILS]
    styles = [{"color": c, "lw": 1.2} for c in (BLUE, ORANGE, GREEN)]
    labels = [f"conductor-rail-{number}" for number in (1, 2, 3)]
    figure, (above, below) = plt.subplots(
        2, 1, figsize=(8.0, 4.4), layout="constrained", height_ratios=(1, 1)
    )
    for label, one, style in zip(labels, found, styles, strict=True):
        left, _ = one.equilibrium.middle_span()
        wire = one.equilibrium.positions[one.equilibrium.mesh.contact_nodes]
        above.plot(wire[:, 0] - left, 1e3 * (wire[:, 2] - 4.4), label=label, **style)
        x = np.array(one.elasticity_x_m) - left
        below.plot(x, 1e6 * np.array(one.elasticity_m_per_N), **style)
    above.set(xlim=(-12.0, 20.0), ylim=(-7.0, 1.0), ylabel="below the supports, mm")
    above.legend(loc="lower center", ncols=3, frameon=False, bbox_to_anchor=(0.5, 1.0))
    below.set(xlim=(-12.0, 20.0), xlabel="distance from a support, m", ylabel="elasticity, µm/N")
    save(figure, file)


def insert(file: Path) -> None:
    """Draw the force below a section insulator; print it."""
    plain = arcless.load("en50318-ac-simple-320-planar")
    figure, axes = plt.subplots(figsize=(8.0, 3.0), layout="constrained")
    cases = [("plain wire", {}, GREY), ("section insulator", {"line.inserts": [INSULATOR]}, BLUE)]
    for label, changes, shade in cases:
        result = arcless.run(plain.with_(**changes))
        x = result.dataset["position"].values[:, 0]
        near = (x > 500.0) & (x < 620.0)
        force = result.dataset["contact_force"].values[near, 0]
        axes.plot(x[near], force, color=shade, lw=1.0, label=label)
        around = (x[near] > 545.0) & (x[near] < 560.0)
        print(f"{label}: {force[around].min():.0f} to {force[around].max():.0f} N unfiltered")
    axes.axvspan(549.2, 550.8, color="0.85", lw=0)
    axes.set(xlabel="position along the track, m", ylabel="contact force, N")
    axes.legend(frameon=False)
    save(figure, file)


def ends(file: Path) -> None:
    """Draw how a wire moves with temperature; print the tension for each kind of end."""
    line = {
        "name": "wire",
        "contact_wire": {
            "mass": 1.1, "axial_stiffness": 14e6, "bending_stiffness": 0.0, "tension": 12e3,
        },
        "contact_support": {"vertical_stiffness": 5e5},
        "geometry": {"contact_wire_height": 5.5},
        "span_types": {"span": {"length": 40.0}},
        "spans": [{"type": "span", "count": 10}],
    }  # fmt: skip
    base = arcless.load(
        {
            "name": "warm",
            "line": line,
            "pantographs": [{"model": "dsa-250", "static_force": 80.0}],
            "speed": 20.0,
            "as_built": {"temperature_difference": 30.0},
        }
    )
    weight = {"line.contact_wire.ends": "constant_force"}
    spring = {"line.contact_wire.ends": "spring", "line.contact_wire.end_stiffness": 2e4}
    kinds = [
        ("`fixed`", {}),
        ("`spring`, 20 kN/m", spring),
        ("`constant_force`", weight),
        ("the same, midpoint anchor", {**weight, "line.midpoint_anchor": {"stiffness": 1e7}}),
    ]
    figure, axes = plt.subplots(figsize=(8.0, 3.0), layout="constrained")
    sag = "sag (maximum less minimum height), mm"
    print(f"| ends | tension, N | way of the far end, mm | {sag} |\n|---|---|---|---|")
    for (name, changes), shade in zip(kinds, (GREY, ORANGE, BLUE, GREEN), strict=True):
        found = statics(base.with_(**changes))
        mesh = found.equilibrium.mesh
        here = mesh.positions[mesh.contact_nodes, 0]
        way = found.equilibrium.positions[mesh.contact_nodes, 0] - here
        axes.plot(here, 1e3 * way, color=shade, lw=1.3, label=name.replace("`", ""))
        assert found.as_built is not None
        built = found.as_built
        tension, travel = built["contact_wire_tension_N"], built["contact_wire_end_travel_m"]
        print(f"| {name} | {tension:.0f} | {1e3 * travel:.0f} |"
              f" {1e3 * found.contact_wire_sag_m:.0f} |")  # fmt: skip
    axes.axhline(0.0, color="0.7", lw=0.6)
    axes.set(xlabel="position along the track, m", ylabel="way since the design, mm")
    axes.legend(frameon=False)
    save(figure, file)


def main(folder: str) -> None:
    set_up()
    bridles(Path(folder) / "line-bridles.svg")
    rails(Path(folder) / "line-rail.svg")
    insert(Path(folder) / "line-insert.svg")
    ends(Path(folder) / "line-anchor.svg")


if __name__ == "__main__":
    main(*sys.argv[1:])
