"""The figures of the founding paper, F(t) and d(t) at its speeds, and the verdicts: one page."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from arcless.report.drawing.bokeh_objects import Model
from arcless.report.drawing.figure import Figure
from arcless.report.drawing.style import (
    GREY,
    add_hover,
    add_legend,
    add_section,
    colour,
    figure,
    single,
)
from arcless.report.figures.run_data import RunData
from arcless.report.reported_run import ReportedRun
from arcless.report.tables import number
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

GAPS_ABOVE = 300 / 3.6  # m/s: the paper shows gaps at 340 and 360 km/h only


def write(
    results: Sequence[ReportedRun],
    path: Path,
    *,
    verdicts: Sequence[Mapping[str, Any]],
    source: str,
) -> None:
    """Write the figures and the verdicts: one HTML file that opens without a network.

    Parameters
    ----------
    results
        The runs, by increasing speed.
    path
        The file to write; its folder must exist.
    verdicts
        The conclusions: ``title``, ``holds``, ``checked``, ``assumption``, and ``rows`` with
        ``quantity``, ``note``, ``value``, ``digits``, ``unit``, ``limit``, ``mark``, ``verdict``.
    source
        Where the conclusions are from.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    scenes = [RunData(result.latest, result.assessment) for result in results]
    fast = [scene for scene in scenes if scene.assessment.speed_m_s > GAPS_ABOVE]
    drawn = {f"force {place}": force(scene) for place, scene in enumerate(scenes)}
    drawn |= {f"gap {place}": gap(scene) for place, scene in enumerate(fast)}
    text = render(
        "published.html",
        drawn,
        forces=len(scenes),
        gaps=len(fast),
        verdicts=[_cells(item) for item in verdicts],
        held=sum(bool(item["holds"]) for item in verdicts),
        command=f"arcless validate seed --report {path.name}",
        source=source,
        facts=results[0].metadata,
    )
    write_bytes(path, text.encode())


def _cells(verdict: Mapping[str, Any]) -> dict[str, Any]:
    """Return a conclusion with the numbers of its rows as text."""
    rows = [{**row, "value": number(row["value"], row["digits"])} for row in verdict["rows"]]
    return {**verdict, "rows": rows}


def force(scene: RunData) -> Figure:
    """Draw the unfiltered contact force over time."""
    values = scene.record.force[:, 0]
    seen = values[scene.record.inside[:, 0]]
    title = f"F(t) at {_speed(scene)}: {seen.min():.0f} to {seen.max():.0f} N in the section"
    return _over_time(scene, title, ("contact force", "N"), values, "0.0")


def gap(scene: RunData) -> Figure:
    """Draw the gap between strip and wire over time."""
    values = 1e3 * scene.dataset["contact_gap"].values[:, 0]
    seen = values[scene.record.inside[:, 0]]
    title = f"d(t) at {_speed(scene)}: at most {seen.max():.2f} mm in the section"
    return _over_time(scene, title, ("gap", "mm"), values, "0.000")


def _speed(scene: RunData) -> str:
    return f"{3.6 * scene.assessment.speed_m_s:.0f} km/h"


def _over_time(scene: RunData, title: str, axis: tuple[str, str], values: Any, form: str) -> Figure:
    time, x = scene.values("time"), scene.dataset["position"].values[:, 0]
    name, unit = axis
    fig = figure(title, "time, s", f"{name}, {unit}", height=270)
    begin, end = np.interp(scene.assessment.section_m, x, time)
    add_section(fig, begin, end)
    data = {"t": single(time), "y": single(values), "x": single(x)}
    line = fig.draw("Line", data, "t", "y", color=colour(0), line_width=1.1)
    joints = scene.values("dropper_x")
    passed = np.interp(joints[(joints >= x[0]) & (joints <= x[-1])], x, time)
    feet = {"x": single(passed), "y": np.zeros_like(passed)}
    ticks = fig.draw("Scatter", feet, marker="dash", angle=np.pi / 2, size=9, color=GREY)
    fig.y_range = Model("Range1d", start=0.0, end=1.08 * float(values.max()) or 1.0)
    tips = [("time", "@t{0.0000} s"), ("position", "@x{0.00} m"), (name, f"@y{{{form}}} {unit}")]
    add_hover(fig, [line], tips, mode="vline")
    add_legend(fig, [(name, [line]), ("hanger joint", [ticks])])
    return fig
