"""The line under the pantographs of several runs: uplift at supports, ranges of dropper forces."""

from typing import Literal

import numpy as np

from arcless.figures.comparison.overlaid import Overlaid
from arcless.figures.description import Axis, Figure, Layer, Points, Rules, Segments, Tip
from arcless.figures.description.thinning import every
from arcless.figures.measured import MeasuredData
from arcless.figures.run.track import MARKS

# Marks of the runs, which tell them apart without colour as well.
SHAPES: tuple[Literal["circle", "triangle", "diamond", "down", "cross", "tick"], ...] = (
    "circle", "triangle", "diamond", "down", "cross", "tick",
)  # fmt: skip
# Distance in m between the ranges of one dropper: less than there is between droppers.
BESIDE_M = 0.5


def uplift(many: Overlaid) -> list[Figure]:
    """Return the maximum uplift at each support, a mark for each run."""
    layers: list[Layer] = many.ground()
    alt = []
    top = 0.0
    for k, run in reversed(list(enumerate(many.runs))):
        if not run.has("support_x", "support_uplift_max"):
            continue
        kept = every(run.values("support_x").size, MARKS)
        x, peak = run.values("support_x")[kept], 1e3 * run.values("support_uplift_max")[kept]
        names = [str(name) for name in run.values("support")[kept]]
        tips = (Tip("", [many.names[k]] * x.size, form=""), Tip("", names, form=""),
                Tip("maximum uplift", "y", "mm"), Tip("position", "x", "m"))  # fmt: skip
        layers.append(
            Points(x, peak, colour=many.colour(k), name=many.names[k], size=8.0, shape=SHAPES[k],
                   tips=tips)
        )  # fmt: skip
        top = max(top, float(peak.max(initial=0.0)))
        most = run.assessment.max_uplift_at_support_mm
        alt.append(f"{many.names[k]}: {'not known' if most is None else f'{most:.1f} mm'}")
    if not alt:
        return []
    spaces = {run.limit("uplift_space") for run in many.runs}
    space = spaces.pop() if len(spaces) == 1 else None
    if space is not None:
        top = max(top, 0.5 * space)
        layers.append(
            Rules(axis="y", at=np.array([0.5 * space]), colour="limit", dash="dashed", width=1.6,
                  name=f"half of the space for uplift: {0.5 * space:g} mm")
        )  # fmt: skip
    return [
        Figure(
            "uplift", "Uplift of the contact wire at supports", many.axis(),
            Axis("maximum uplift", "mm", 0.0, 1.12 * top or 1.0), layers,
            caption=many.remark.strip(),
            alt="Maximum uplift at supports, in the analysis section at most:"
            f" {'; '.join(reversed(alt))}.",
        )
    ]  # fmt: skip


def droppers(many: Overlaid) -> list[Figure]:
    """Return the range of each dropper's force, those of the runs next to each other."""
    needed = ("dropper_x", "dropper_force_min", "dropper_force_max")
    shown = [k for k, run in enumerate(many.runs) if run.has_droppers and run.has(*needed)]
    if not shown:
        return []
    layers: list[Layer] = many.ground()
    alt = []
    for order, k in reversed(list(enumerate(shown))):
        run = many.runs[k]
        kept = every(run.values("dropper_x").size, MARKS)
        x, low, high = (run.values(name)[kept] for name in needed)
        names = [str(name) for name in run.values("dropper")[kept]]
        drawn = x + BESIDE_M * (order - 0.5 * (len(shown) - 1))
        tips = (Tip("", [many.names[k]] * x.size, form=""), Tip("", names, form=""),
                Tip("minimum", low, "N"), Tip("maximum", high, "N"),
                Tip("position", x, "m"))  # fmt: skip
        colour = many.colour(k)
        layers += [
            Segments(drawn, low, drawn, high, colour=colour, name=many.names[k], width=2.4,
                     alpha=0.7),
            Points(drawn, high, colour=colour, size=4.0, tips=tips),
        ]  # fmt: skip
        alt.append(f"{many.names[k]}: {low.min():.1f} to {high.max():.1f} N")
    without = [many.names[k] for k, run in enumerate(many.runs)
               if k not in shown and not isinstance(run, MeasuredData)]  # fmt: skip
    said = f" Without droppers: {', '.join(without)}." if without else ""
    return [
        Figure(
            "droppers", "Range of the dropper forces", many.axis(), Axis("dropper force", "N"),
            layers, caption=f"From minimum to maximum during the passage; runs stand {BESIDE_M:g} m"
            f" apart.{said}{many.remark}",
            alt=f"Ranges of the dropper forces. {'; '.join(reversed(alt))}.",
        )
    ]  # fmt: skip
