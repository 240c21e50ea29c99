"""Figures of these pages as SVG; the same runs give the same files."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np

from arcless.results import Result

IMAGES = Path(__file__).parents[1] / "images"
STYLE = {"svg.hashsalt": "arcless", "svg.fonttype": "none", "font.size": 9}
BLUE = "#1f5fa8"


def draw_forces(results: Sequence[Result]) -> None:
    with mpl.rc_context(STYLE):
        figure, axes = plt.subplots(2, 2, figsize=(8.0, 4.6), layout="constrained")
        for ax, result in zip(axes.flat, results, strict=True):
            force = result.dataset["contact_force"].values[:, 0]
            p = result.assessment.pantographs[0]
            low, high = p.unfiltered_min_force_N, p.unfiltered_max_force_N
            _draw(ax, result, force, f"{low:.0f} to {high:.0f} N")
            ax.set_ylabel("F, N")
        _save(figure, "praks-force.svg")


def draw_gaps(results: Sequence[Result]) -> None:
    with mpl.rc_context(STYLE):
        figure, axes = plt.subplots(1, 2, figsize=(8.0, 2.3), layout="constrained")
        for ax, result in zip(axes.flat, results, strict=True):
            gap = 1e3 * result.dataset["contact_gap"].values[:, 0]
            largest = result.assessment.pantographs[0].max_gap_mm
            _draw(ax, result, gap, f"up to {largest:.2f} mm")
            ax.set_ylabel("d, mm")
        _save(figure, "praks-gap.svg")


def _draw(ax: Any, result: Result, values: Any, text: str) -> None:
    data = result.dataset
    time, x = data["time"].values, data["position"].values[:, 0]
    ax.plot(time, values, color=BLUE, lw=0.8)
    ax.axvspan(*np.interp(result.assessment.section_m, x, time), color=BLUE, alpha=0.06, lw=0)
    joints = data["dropper_x"].values
    passed = np.interp(joints[(joints >= x[0]) & (joints <= x[-1])], x, time)
    ax.vlines(passed, 0.0, 0.04, color="0.4", lw=0.8, transform=ax.get_xaxis_transform())
    ax.set(xlim=(0.0, time[-1]), ylim=(0.0, 1.08 * values.max()), xlabel="t, s")
    ax.set_title(f"{3.6 * result.assessment.speed_m_s:.0f} km/h: {text}", loc="left", fontsize=9)
    ax.spines[["top", "right"]].set_visible(False)


def _save(figure: Any, name: str) -> None:
    figure.savefig(IMAGES / name, metadata={"Date": None})
    plt.close(figure)
