"""Two pantographs, one behind the other, over their spacing: runs, tables and the figure.

The leading pantograph leaves the line vibrating. The trailing one comes d/v later; whether it adds
to that vibration or takes from it depends on the phase f d/v. So σ of the trailing pantograph goes
up and down with a period v/f, where f lies in the first band of natural frequencies of the line (as
many frequencies as spans, each span swinging as one half wave).
"""

from dataclasses import dataclass
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from validation.runs import run, table

import arcless
from arcless.simulate.resonance import spacing_period

IMAGES = Path(__file__).parents[1] / "images"
Floats = NDArray[np.float64]

SPACINGS = tuple(range(60, 221, 5))
SHOWN = (60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160, 170, 180, 190, 200, 210, 220)
# Spans before and within the section that both pantographs are assessed over.
BEFORE, ASSESSED = 6, 10


@dataclass(frozen=True)
class Case:
    """A line with one kind of pantograph at one speed."""

    title: str
    scenario: str
    speed_km_h: float
    static_force: float  # of both, in N: about the mean force aimed at


CASES = (
    Case("AC simple, 275 km/h", "en50318-ac-simple-275-planar", 275.0, 160.0),
    Case("Beijing-Yizhuang, 300 km/h", "china-beijing-yizhuang-300", 300.0, 157.3),
    Case("Beijing-Yizhuang, 350 km/h", "china-beijing-yizhuang-300", 350.0, 188.8),
)


def deviations(case: Case, spacing: float | None) -> list[float]:
    """Standard deviations in N of the pantographs, each over the same ten spans of the line."""
    base = arcless.load(case.scenario)
    length = base.line.span_list()[0].length
    behind = ceil((spacing or 0.0) / length)
    one: dict[str, Any] = base.to_dict()["pantographs"][0]
    one |= {"mean_force": None, "static_force": case.static_force}
    place = [one] if spacing is None else [one, {**one, "name": "P2", "distance": spacing}]
    start = (behind + 1) * length
    first = behind + BEFORE
    changes = {
        "speed": f"{case.speed_km_h} km/h",
        "line.spans": [{"type": "standard", "count": 2 * behind + BEFORE + ASSESSED + 2}],
        "pantographs": place,
        "travel": {"start": start, "end": (first + ASSESSED + behind + 1) * length},
        "analysis": {"from": first * length, "to": (first + ASSESSED) * length},
        "output": {"line_every": 1000, "droppers": False},
    }
    return [p.std_force_N for p in run(case.scenario, changes).assessment.pantographs]


def sweep(case: Case) -> tuple[Floats, Floats, float]:
    """Spacings in m, σ of the trailing pantograph in N, and σ of a single one."""
    trailing = [deviations(case, float(spacing))[1] for spacing in SPACINGS]
    return np.array(SPACINGS, dtype=float), np.array(trailing), deviations(case, None)[0]


def first_band(case: Case) -> tuple[float, float]:
    """Lowest and highest frequency in Hz of the band with one half wave in each span."""
    base = arcless.load(case.scenario)
    frequencies = arcless.statics(base).natural_frequencies_Hz
    spans = min(len(base.line.span_list()), len(frequencies))
    return frequencies[0], frequencies[spans - 1]


def period(spacings: Floats, trailing: Floats) -> float:
    """Period in m of the cosine that fits the variance over the spacing best."""
    found = spacing_period(spacings, trailing)
    assert found is not None
    return found.length


def spacing_table() -> str:
    found = {case.title: dict(zip(*sweep(case)[:2], strict=True)) for case in CASES}
    alone = [f"{deviations(case, None)[0]:.1f}" for case in CASES]
    rows = [("a single one", *alone)]
    rows += [
        (f"{spacing} m", *(f"{found[case.title][float(spacing)]:.1f}" for case in CASES))
        for spacing in SHOWN
    ]
    return table(("spacing", *(f"{case.title}, N" for case in CASES)), rows)


def leading_table() -> str:
    rows = []
    for case in CASES:
        alone = deviations(case, None)[0]
        leading = [deviations(case, float(spacing))[0] for spacing in SPACINGS]
        _, trailing, _ = sweep(case)
        larger = sum(b > a for a, b in zip(leading, trailing, strict=True))
        rows.append(
            (
                case.title,
                f"{alone:.1f}",
                f"{min(leading):.1f} to {max(leading):.1f}",
                f"{trailing.min():.1f} to {trailing.max():.1f}",
                f"{larger} of {len(SPACINGS)}",
            )
        )
    head = ("case", "single N", "leading N", "trailing N", "trailing larger at")
    return table(head, rows)


def period_table() -> str:
    rows = []
    for case in CASES:
        spacings, trailing, _ = sweep(case)
        found, speed = period(spacings, trailing), case.speed_km_h / 3.6
        low, high = first_band(case)
        best, worst = spacings[np.argmin(trailing)], spacings[np.argmax(trailing)]
        line = arcless.load(case.scenario).line
        span = line.span_list()[0].length
        rows.append(
            (
                case.title,
                f"{found:.1f}",
                f"{speed / found:.2f}",
                f"{low:.2f} to {high:.2f}",
                f"{span:g}",
                f"{span * (1 + speed / line.wave_speed):.0f}",
                f"{best:.0f}",
                f"{worst:.0f}",
            )
        )
    head = (
        "case",
        "period of σ² m",
        "v / period Hz",
        "first band Hz",
        "span L m",
        "L (1 + v/c) m",
        "best m",
        "worst m",
    )
    return table(head, rows)


def figure() -> str:
    """Draw σ of both over the spacing, with odd multiples of half a period."""
    import matplotlib as mpl
    import matplotlib.pyplot as plt

    mpl.rcParams.update({"svg.hashsalt": "arcless", "svg.fonttype": "none", "font.size": 9})
    drawn, all_axes = plt.subplots(
        len(CASES), 1, figsize=(8.0, 6.4), sharex=True, layout="constrained"
    )
    for axes, case in zip(all_axes, CASES, strict=True):
        spacings, trailing, alone = sweep(case)
        leading = [deviations(case, float(spacing))[0] for spacing in SPACINGS]
        half = 0.5 * case.speed_km_h / 3.6 / np.mean(first_band(case))
        for odd in np.arange(1, 12, 2) * half:
            if spacings[0] <= odd <= spacings[-1]:
                axes.axvline(odd, color="0.5", lw=0.6, ls=":")
        axes.axhline(alone, color="0.45", lw=0.8, ls="--", label="single")
        axes.plot(spacings, leading, color="0.45", lw=1.2, label="leading")
        axes.plot(spacings, trailing, color="#d0652a", lw=1.4, marker=".", label="trailing")
        axes.set(ylabel="σ, N", ylim=(0, 95), xlim=(spacings[0], spacings[-1]))
        axes.set_title(f"{case.title}; dotted: (n + ½) v/f", loc="left", fontsize=9)
    all_axes[0].legend(ncols=3, frameon=False, loc="upper right")
    all_axes[-1].set_xlabel("spacing of the two pantographs, m")
    drawn.savefig(IMAGES / "spacing.svg", metadata={"Date": None})
    plt.close(drawn)
    return "![σ over the spacing](../images/spacing.svg)"


TABLES = {
    "leading": leading_table,
    "spacing": spacing_table,
    "spacing-figure": figure,
    "period": period_table,
}
