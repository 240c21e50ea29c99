"""How transverse and longitudinal vibrations of the contact wire depend on its tension.

Run it with ``python examples/tension_coupling.py [FIGURE.svg]``; it takes half a minute. What the
numbers mean stands in ``docs/guide/tension-study.md``.
"""

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import arcless

Floats = NDArray[np.float64]

SPANS, SPAN = 16, 10.0
MIDDLE = SPANS * SPAN / 2  # m, a support; the hanger joints beside it are 5 m away
SPACING = 0.5
POINTS = np.arange(SPACING, SPANS * SPAN, SPACING)
FORCE = 100.0  # static force of the pantograph, N
# 0.6 to 1.4 % of critical from 1 to 15 Hz. Without damping a result depends on how long the run is.
DAMPING = {"alpha": 0.114, "beta": 2.9e-4}
LINE = {
    "line.spans": [{"type": "standard", "count": SPANS}],
    "line.contact_wire.damping": DAMPING,
    "line.messenger_wire.damping": DAMPING,
    "speed": "72 km/h",
    "travel": {"start": 1.5 * SPAN, "end": (SPANS - 1.5) * SPAN},
    "analysis": {},
    "output": {"points": POINTS.tolist(), "line_every": 1, "droppers": False},
}


@dataclass(frozen=True)
class Motion:
    """Motion of the contact wire in mid-line, and what an inextensible wire would do, m."""

    time: Floats
    up: Floats
    along: Floats
    drawn: Floats
    force_range: tuple[float, float]


def run(
    tension: float, kinematics: str = "updated", gravity: float = 0.0, friction: float = 0.0
) -> Motion:
    """Run a pantograph under the PRAKS line with another tension of the contact wire."""
    changes = {
        **LINE,
        "line.contact_wire.tension": tension,
        "contact": {"law": "compliant", "friction_coefficient": friction},
        "solver": {
            "kinematics": kinematics,
            # The same elements for both kinematics.
            "scheme": "generalised-alpha",
            "residual_flexibility": False,
            "gravity": gravity,
            "time_step": "2 ms",
            "contact_wire_element": "1 m",
            "messenger_wire_element": "2.5 m",
        },
    }
    data = arcless.run(arcless.load("praks-360").with_(**changes)).dataset
    up, along = data["point_uplift"].values, data["point_along"].values
    # A wire that does not stretch is drawn towards its fixed end by what its slopes take up:
    # ½ z′² of the motion, and z₀′ z′ where it hangs in a curve already.
    rest = np.interp(POINTS, data["contact_wire_node_x"], data["contact_wire_node_z"])
    slope = np.diff(up, axis=1, prepend=0.0) / SPACING
    taken = slope * np.diff(rest, prepend=rest[0]) / SPACING
    if kinematics == "updated":
        taken += 0.5 * slope**2
    here = int(np.argmin(abs(POINTS - MIDDLE)))
    force = data["contact_force"].values
    return Motion(
        time=data["line_time"].values,
        up=up[:, here],
        along=along[:, here],
        drawn=-SPACING * taken[:, : here + 1].sum(axis=1),
        force_range=(float(force.min()), float(force.max())),
    )


def rms(values: Floats) -> float:
    """Root mean square about the mean."""
    return float(values.std())


def slow(values: Floats) -> Floats:
    """Return the part of a motion below 1 Hz, far below the wire's first longitudinal mode."""
    from arcless.assess.signals.filter import low_pass

    return np.asarray(low_pass(values[:, np.newaxis], 500.0, 1.0)[:, 0])


def elasticity(tension: float) -> float:
    """Uplift in mid-line for one newton at rest, m/N."""
    line = {"line.spans": LINE["line.spans"], "line.contact_wire.tension": tension}
    at_rest = {**line, "solver.gravity": 0.0, "travel": LINE["travel"], "analysis": {}}
    found = arcless.statics(arcless.load("praks-360").with_(**at_rest))
    return float(found.equilibrium.elasticity(np.array([MIDDLE]))[0])


def study(tension: float) -> tuple[dict[str, float], Motion]:
    """Return amplitudes (rms, mm) and coupling for one tension, and the motion without weight."""
    straight, flat = run(tension), run(tension, "linearised")
    assert not flat.along.any(), "a straight wire does not couple at first order"
    heavy, heavy_flat = (run(tension, k, gravity=9.81) for k in ("updated", "linearised"))
    rubbed = run(tension, friction=0.2)
    x, drawn = slow(straight.along), slow(straight.drawn)
    row = {
        "tension": tension / 1e3,
        "force_min": straight.force_range[0],
        "force_max": straight.force_range[1],
        "z_max": 1e3 * float(straight.up.max()),
        "z_static": 1e3 * FORCE * elasticity(tension),
        "z": 1e3 * rms(straight.up),
        "x": 1e3 * rms(straight.along),
        "drawn": 1e3 * rms(straight.drawn),
        "slow": rms(x) / rms(drawn),
        "r": float(np.corrcoef(x, drawn)[0, 1]),
        "coupling": rms(straight.along) / rms(straight.up) ** 2,
        "back": 100 * rms(straight.up - flat.up) / rms(flat.up),
        "x_weight": 1e3 * rms(heavy.along),
        "x_weight_linearised": 1e3 * rms(heavy_flat.along),
        "x_friction": 1e3 * rms(rubbed.along),
    }
    return row, straight


HEAD = (
    "  kN      F N    z max  static  z rms | x rms  ½∫z′²  slow: ratio  r | x/z²  x→z %"
    " | weight: x rms  linearised | friction"
)
ROW = (
    "{tension:4.0f} {force_min:4.0f}–{force_max:3.0f} {z_max:8.2f} {z_static:7.2f} {z:6.2f}"
    " | {x:6.4f} {drawn:6.4f} {slow:7.3f} {r:8.4f} | {coupling:4.2f} {back:6.3f}"
    " | {x_weight:9.4f} {x_weight_linearised:10.4f} | {x_friction:8.4f}"
)


def main(
    tensions: Sequence[float] = (5e3, 7e3, 10e3, 14e3, 20e3, 30e3), figure: str | None = None
) -> dict[str, list[float]]:
    """Print and draw amplitudes and their coupling for several tensions (N)."""
    print(HEAD)
    rows, motions = [], []
    for tension in tensions:
        row, motion = study(tension)
        print(ROW.format(**row))
        rows.append(row)
        motions.append(motion)
    found = {name: [row[name] for row in rows] for name in rows[0]}
    if len(rows) > 1:
        for name, what in (("z", "z rms"), ("drawn", "½∫z′²"), ("x", "x rms"), ("back", "x→z")):
            power = np.polyfit(np.log(found["tension"]), np.log(found[name]), 1)[0]
            print(f"{what} ∝ T^{power:.2f}")
    if figure is not None:
        draw(found, motions[0], figure)
    return found


def draw(found: dict[str, list[float]], first: Motion, file: str) -> None:
    """Draw amplitudes and coupling over tension, and the motion at the lowest tension."""
    import matplotlib as mpl
    import matplotlib.pyplot as plt
    from matplotlib.ticker import (
        FixedLocator,
        NullFormatter,
        NullLocator,
        StrMethodFormatter,
    )

    mpl.rcParams.update({"svg.hashsalt": "arcless", "svg.fonttype": "none", "font.size": 9})
    panels, ((across, along), (coupling, history)) = plt.subplots(
        2, 2, figsize=(9.0, 6.4), layout="constrained"
    )
    T = found["tension"]
    across.plot(T, found["z_max"], "o-", color="#1f5fa8", label="maximum")
    across.plot(T, found["z_static"], "--", color="0.4", label="100 N at rest")
    across.plot(T, found["z"], "s-", color="#7fa8d8", label="rms")
    across.set(title="transverse, mm", yscale="log", ylim=(3, 100))
    along.plot(T, found["x_friction"], "^-", color="0.6", label="with friction 0.2")
    along.plot(T, found["x"], "o-", color="#b03a2e", label="updated")
    along.plot(T, found["drawn"], "--", color="0.4", label="½ ∫ z′² dx")
    along.plot(T, found["x_weight"], "s-", color="#e0a030", label="with weight, updated")
    weight = found["x_weight_linearised"]
    along.plot(T, weight, "x:", color="#e0a030", label="with weight, linearised")
    along.set(title="longitudinal, rms, mm", yscale="log")
    coupling.plot(T, found["coupling"], "o-", color="#3a7d44", label="x/z² (rms), 1/m")
    coupling.plot(T, found["back"], "s--", color="#80b088", label="change of z by x, %")
    coupling.set(title="coupling", yscale="log")
    for axes in (across, along, coupling):
        axes.set(xlabel="tension of the contact wire, kN", xscale="log")
        axes.yaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axes.yaxis.set_minor_formatter(NullFormatter())
        axes.xaxis.set_major_locator(FixedLocator(T))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axes.grid(color="0.9", which="both")
        axes.legend(frameon=False)
    history.plot(first.time, 1e3 * first.along, color="#b03a2e", lw=0.8, label="x, updated")
    history.plot(first.time, 1e3 * first.drawn, color="0.2", lw=0.8, label="−½ ∫ z′² dx")
    history.set(title=f"longitudinal, {T[0]:g} kN, mm", xlabel="time, s")
    history.legend(frameon=False)
    # Without a date and with fixed ids, the same run gives the same file.
    panels.savefig(Path(file), metadata={"Date": None})


if __name__ == "__main__":
    main(figure=sys.argv[1] if len(sys.argv) > 1 else None)
