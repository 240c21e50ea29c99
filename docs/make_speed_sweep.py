"""Draw the shipped sweep of speed with its resonance speeds, and print its table for the guide.

`python docs/make_speed_sweep.py TABLE FILE.svg`, where TABLE is that of
`arcless study run speed-sweep`. `python docs/make_speed_sweep.py 130 185 …` computes variants of it
at these speeds in km/h, and prints which waves of the span their σ is made of.
"""

import sys
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pyarrow.parquet

import arcless
from arcless.results import Result
from arcless.simulate import ResonanceSpeeds, resonance_speeds
from arcless.study import load

STYLES = {
    "wave speed": ("0.45", "-", "wave speeds"),
    "span of the line": ("#3b8a5a", "--", "span passing, swing of the line"),
    "span and pantograph": ("#8a4f9e", "--", "span passing, pantograph"),
    "droppers and pantograph": ("#a88a1c", ":", "dropper passing, pantograph"),
}
COLUMNS = ("sigma", "sigma_over_mean", "highest", "lowest", "uplift", "loss")
STEP = 20  # km/h between the rows that are printed
WAVES = 13  # shortest waves of the span: 4 m, the dropper spacing is 5.75 m
POINTS = 500  # in a span, for the waves


def sweep(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return the rows that are done by rising speed, with the speed in km/h."""
    done = [{**row, "kmh": 3.6 * row["speed"]} for row in rows if row["status"] == "done"]
    return sorted(done, key=lambda row: row["kmh"])


def peaks(rows: list[dict[str, Any]], name: str = "sigma_over_mean") -> list[float]:
    """Return the speeds in km/h at which a value is larger than at both neighbours."""
    values = [row[name] for row in rows]
    inside = range(1, len(rows) - 1)
    return [round(rows[i]["kmh"], 6) for i in inside if values[i - 1] < values[i] > values[i + 1]]


def waves(result: Result) -> list[float]:
    """Return the part of σ in N with 1, 2, … waves a span, unfiltered, over the assessed spans."""
    start, end = result.scenario.analysis_range()
    spans = round((end - start) / result.scenario.line.span_list()[0].length)
    x = np.linspace(start, end, spans * POINTS, endpoint=False)
    given = result.dataset
    force = np.interp(x, given["position"].values[:, 0], given["contact_force"].values[:, 0])
    series = np.abs(np.fft.rfft(force)) / len(x)
    return [float(np.sqrt(2.0) * series[k * spans]) for k in range(1, WAVES + 1)]


def tell_waves(speeds: list[float]) -> None:
    """Compute variants of the study at speeds in km/h, and print their waves as Markdown."""
    study = load("speed-sweep")
    sys.stdout.write("| km/h | " + " | ".join(str(k + 1) for k in range(WAVES)) + " |\n")
    sys.stdout.write("|" + "---|" * (WAVES + 1) + "\n")
    for number in range(study.plan.count):
        values = study.plan.values(number)
        kmh = round(3.6 * values[0], 6)
        if kmh in speeds:
            result = arcless.run(study.base.with_(**study.changes_of(values)))
            cells = " | ".join(f"{part:.1f}" for part in waves(result))
            sys.stdout.write(f"| {kmh:g} | {cells} |\n")
            sys.stdout.flush()


def printed(rows: list[dict[str, Any]]) -> str:
    """Return the peaks and every fourth row as Markdown."""
    lines = [f"peaks of σ/F_m: {', '.join(f'{v:g}' for v in peaks(rows))} km/h", ""]
    lines += ["| km/h | F_m, N | σ, N | σ/F_m | highest, N | lowest, N | uplift, mm | loss, % |",
              "|" + "---|" * 8]  # fmt: skip
    for row in rows:
        if round(row["kmh"]) % STEP == 0:
            cells = (f"{row['mean']:.1f}", f"{row['sigma']:.1f}", f"{row['sigma_over_mean']:.2f}",
                     f"{row['highest']:.0f}", f"{row['lowest']:.0f}", f"{row['uplift']:.0f}",
                     f"{row['loss']:.2f}")  # fmt: skip
            lines.append(f"| {row['kmh']:.0f} | {' | '.join(cells)} |".replace("-", "−"))
    return "\n".join(lines)


def draw(rows: list[dict[str, Any]], speeds: ResonanceSpeeds, file: str) -> None:
    """Draw σ over the mean force, highest and lowest force, uplift and loss over the speed."""
    mpl.rcParams.update({"svg.hashsalt": "arcless", "svg.fonttype": "none", "font.size": 9})
    figure, axes = plt.subplots(3, 1, figsize=(8.0, 7.4), sharex=True, layout="constrained")
    kmh = [row["kmh"] for row in rows]
    curves = (
        (axes[0], "sigma_over_mean", "#1f5a92", "σ/F_m"),
        (axes[1], "highest", "#c0452a", "highest"),
        (axes[1], "mean", "#2b2f33", "mean"),
        (axes[1], "lowest", "#1f5a92", "lowest"),
        (axes[2], "uplift", "#1f5a92", "uplift at a support, mm"),
    )
    for place, name, colour, label in curves:
        place.plot(kmh, [row[name] for row in rows], ".-", color=colour, lw=1.3, ms=3, label=label)
    axes[0].axhline(0.3, color="0.6", lw=0.8)
    axes[0].annotate("0.3, EN 50367", (kmh[0], 0.3), (0, 2), textcoords="offset points", fontsize=8)
    loss = axes[2].twinx()
    loss.plot(kmh, [row["loss"] for row in rows], ".-", color="#c0452a", lw=1.0, ms=3)
    loss.set_ylabel("loss of contact, %", color="#c0452a")
    _mark(axes, speeds, kmh)
    top = max(row["sigma_over_mean"] for row in rows)
    axes[0].set(ylabel="σ/F_m", ylim=(0.0, 1.2 * top))  # the numbers stand above the curve
    axes[1].set_ylabel("contact force, N")
    axes[1].legend(loc="upper left", frameon=False, ncols=3)
    axes[2].set(xlabel="speed, km/h", ylabel="uplift at a support, mm", xlim=(kmh[0], kmh[-1]))
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=3,
                  frameon=False)  # fmt: skip
    # Without a date and with fixed ids, the same table gives the same file.
    figure.savefig(file, metadata={"Date": None})


def _mark(axes: Any, speeds: ResonanceSpeeds, kmh: list[float]) -> None:
    """Draw the marks in range, numbered by rising speed, one label for each kind."""
    drawn = [one for one in speeds.speeds if kmh[0] <= 3.6 * one.speed.middle <= kmh[-1]]
    for number, one in enumerate(drawn, start=1):
        colour, dashes, label = STYLES[one.kind]
        first = all(other.kind != one.kind for other in drawn[: number - 1])
        for place in axes:
            place.axvline(3.6 * one.speed.middle, color=colour, ls=dashes, lw=1.0,
                          label=label if first and place is axes[0] else None)  # fmt: skip
        axes[0].annotate(str(number), (3.6 * one.speed.middle, 1.0), (2, -9 - 9 * (number % 2)),
                         xycoords=("data", "axes fraction"), textcoords="offset points",
                         fontsize=8, color=colour)  # fmt: skip


if __name__ == "__main__":
    if sys.argv[1].isdigit():
        tell_waves([float(given) for given in sys.argv[1:]])
        sys.exit()
    found = sweep(pyarrow.parquet.read_table(sys.argv[1]).to_pylist())
    told = resonance_speeds(load("speed-sweep").base)
    draw(found, told, sys.argv[2])
    sys.stdout.write(printed(found) + "\n")
