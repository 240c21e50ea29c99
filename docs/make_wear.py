"""Draw wear over uplift force, and print its minima for the guide.

`python docs/make_wear.py TABLE FILE.svg`, where TABLE is that of
`arcless study run uplift-force-and-wear`.
"""

import sys
from typing import Any

import matplotlib.pyplot as plt
import pyarrow.parquet
from drawing import BLUE, GREEN, GREY, ORANGE, PURPLE, save, set_up

COLOURS = (BLUE, GREEN, ORANGE, PURPLE)
PARTS = {"wear_mechanical_mm3_km": "--", "wear_arc_mm3_km": ":"}
# Below this a part is not worth its line, in mm³/km.
LOWEST = 0.3


def by_speed(rows: list[dict[str, Any]]) -> dict[float, list[dict[str, Any]]]:
    """Return the rows of each speed in km/h, by rising force."""
    done = [row for row in rows if row["wear_total_mm3_km"] is not None]
    speeds = sorted({row["speed"] for row in done})
    return {
        round(3.6 * speed, 6): sorted(
            (row for row in done if row["speed"] == speed), key=lambda row: row["uplift_force"]
        )
        for speed in speeds
    }


def least(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the row of the least wear."""
    return min(rows, key=lambda row: row["wear_total_mm3_km"])


def minima(rows: list[dict[str, Any]]) -> str:
    """Return the force of least wear at each speed, and what wears there, as Markdown."""
    lines = ["| speed, km/h | force of least wear, N | wear, mm³/km | by friction | by current "
             "| by arcs | loss of contact, % |", "|" + "---|" * 7]  # fmt: skip
    for speed, group in by_speed(rows).items():
        at = least(group)
        parts = " | ".join(
            f"{at[f'wear_{part}_mm3_km']:.2f}" for part in ("total", "mechanical", "joule", "arc")
        )
        loss = f"{at['contact_loss_percent']:.2f}"
        lines.append(f"| {speed:g} | {at['uplift_force']:.0f} | {parts} | {loss} |")
    return "\n".join(lines)


def draw(rows: list[dict[str, Any]], file: str) -> None:
    """Draw the sum, its two branches, and the force of least wear at each speed."""
    set_up()
    figure, axes = plt.subplots(figsize=(8.0, 4.2), layout="constrained")
    for colour, (speed, group) in zip(COLOURS, by_speed(rows).items(), strict=True):
        force = [row["uplift_force"] for row in group]
        total = [row["wear_total_mm3_km"] for row in group]
        axes.plot(force, total, color=colour, lw=1.8, label=f"{speed:g} km/h")
        for part, style in PARTS.items():
            values = [row[part] if row[part] > LOWEST / 10 else float("nan") for row in group]
            axes.plot(force, values, color=colour, lw=0.9, ls=style)
        at = least(group)
        axes.plot(at["uplift_force"], at["wear_total_mm3_km"], "o", color=colour, ms=6)
    axes.plot([], [], color=GREY, lw=0.9, ls="--", label="friction")
    axes.plot([], [], color=GREY, lw=0.9, ls=":", label="arcs")
    axes.plot([], [], "o", color=GREY, ms=6, label="least wear")
    axes.set(yscale="log", ylim=(LOWEST, None), xlabel="uplift force, N", ylabel="wear, mm³/km")
    axes.set_title("AC simple; illustrative coefficients of wear, not measured", loc="left")
    axes.legend(loc="upper right", ncols=2, frameon=False)
    save(figure, file)


if __name__ == "__main__":
    found = pyarrow.parquet.read_table(sys.argv[1]).to_pylist()
    draw(found, sys.argv[2])
    sys.stdout.write(minima(found) + "\n")
