"""Figures of the founding paper's example: F(t) and d(t) at its speeds, and the force intervals."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from arcless.figures.description import (
    Axis,
    Curve,
    Figure,
    Layer,
    Points,
    Segments,
    Strip,
    Texts,
    Tip,
)
from arcless.figures.run import RunData
from arcless.figures.run.run_data import Floats
from arcless.figures.run.track import place_name

LOW = 210
HEADROOM = 1.08


class Channel(NamedTuple):
    """A channel over time: key of its figures, name, unit, decimals under the pointer."""

    key: str
    name: str
    unit: str
    form: str


def force_over_time(run: RunData) -> Figure:
    """Return the unfiltered contact force over time, F(t), with the hanger joints."""
    values = run.record.force[:, 0]
    inside = values[run.record.inside[:, 0]]
    title = f"F(t) at {_speed(run)}: {inside.min():.1f} to {inside.max():.1f} N"
    return _over_time(run, Channel("force", "contact force", "N", "0.0"), title, values)


def gap_over_time(run: RunData) -> Figure:
    """Return the gap between strip and wire over time, d(t), with the hanger joints."""
    values = 1e3 * run.dataset["contact_gap"].values[:, 0]
    most = float(values[run.record.inside[:, 0]].max())
    title = f"d(t) at {_speed(run)}: " + (f"at most {most:.2f} mm" if most > 0.0 else "no gap")
    return _over_time(run, Channel("gap", "gap", "mm", "0.000"), title, values)


def force_intervals(runs: Sequence[RunData]) -> Figure:
    """Return the interval of the unfiltered contact force in the section, by speed."""
    speeds = np.array([3.6 * run.assessment.speed_m_s for run in runs])
    force = [run.record.force[run.record.inside[:, 0], 0] for run in runs]
    low, high = (np.array([float(end(one)) for one in force]) for end in (np.min, np.max))
    width = high - low
    tips = (
        Tip("speed", "x", "km/h", "0"), Tip("minimum", low, "N"), Tip("maximum", high, "N"),
        Tip("width of the interval", width, "N"),
    )  # fmt: skip
    labels = [f"{one:.0f} N" for one in width]
    layers: list[Layer] = [
        Segments(speeds, low, speeds, high, colour="pantograph_1", width=8.0, alpha=0.45,
                 name="minimum to maximum"),
        Points(speeds, high, colour="pantograph_1", size=7.0, tips=tips),
        Points(speeds, low, colour="pantograph_1", size=7.0, tips=tips),
        Texts(speeds, high + 0.03 * float(high.max()), labels, colour="ink", size=12.0,
              baseline="bottom"),
    ]  # fmt: skip
    words = ", ".join(f"{w:.1f} N at {s:.0f} km/h" for w, s in zip(width, speeds, strict=True))
    margin = 0.12 * float(np.ptp(speeds)) or 10.0
    return Figure(
        "force-intervals", "Interval of the contact force by speed",
        Axis("speed", "km/h", float(speeds.min()) - margin, float(speeds.max()) + margin),
        Axis("contact force", "N", min(0.0, float(low.min())), 1.15 * float(high.max())), layers,
        caption="Unfiltered, in the analysis section; the numbers are the widths.",
        alt=f"Width of the interval of the contact force: {words}.", height=LOW + 50,
    )  # fmt: skip


def _speed(run: RunData) -> str:
    return f"{3.6 * run.assessment.speed_m_s:.0f} km/h"


def _over_time(run: RunData, channel: Channel, title: str, values: Floats) -> Figure:
    time, x = run.time, run.position[:, 0]
    begin, end = (float(one) for one in np.interp(run.assessment.section_m, x, time))
    joints = run.values("dropper_x")
    passed = np.interp(joints[(joints >= x[0]) & (joints <= x[-1])], x, time)
    name = channel.name
    tips = (
        Tip(name, "y", channel.unit, channel.form),
        Tip("time", "x", "s", "0.000"),
        Tip("position", x, "m", "0.00"),
    )
    layers: list[Layer] = [
        Strip(axis="x", low=begin, high=end, colour="section", alpha=0.06, name="analysis section"),
        Points(passed, np.zeros_like(passed), colour="dropper", shape="tick", size=10.0,
               name="hanger joint"),
        Curve(time, values, colour="pantograph_1", width=1.1, name=name, tips=tips),
    ]  # fmt: skip
    top = int(np.argmax(np.where(run.record.inside[:, 0], values, -np.inf)))
    low, high = min(0.0, float(values.min())), HEADROOM * float(values.max()) or 1.0
    where = place_name(run, float(x[top]))
    return Figure(
        f"{channel.key}-{_speed(run).split()[0]}", title,
        Axis("time", "s", float(time[0]), float(time[-1])), Axis(name, channel.unit, low, high),
        layers, alt=f"{title} in the analysis section; the maximum is at {where}.", height=LOW,
    )  # fmt: skip
