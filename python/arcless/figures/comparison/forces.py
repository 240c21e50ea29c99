"""Contact forces of runs laid over each other: along the track, over the span, by span."""

from collections.abc import Sequence

import numpy as np

from arcless.figures.comparison.overlaid import Overlaid
from arcless.figures.description import Axis, Bars, Curve, Figure, Layer, Tip
from arcless.figures.run.spans import (
    FEWEST,
    PLACES,
    by_place,
    deviations_by_span,
    whole_spans,
)
from arcless.figures.run.track import SAME_LENGTH, filtered

# A pantograph of the comparison: its number in each run, None for a run without it.
Places = Sequence[int | None]
TALL = 340


def force(many: Overlaid, places: Places, key: str, title: str) -> list[Figure]:
    """Return the filtered force of a pantograph over its position, a curve for each run."""
    layers: list[Layer] = many.ground()
    alt = []
    for k, place in reversed(list(enumerate(places))):
        if place is None:
            continue
        run = many.runs[k]
        look = {"colour": many.colour(k), "name": many.names[k], "width": 1.4, "alpha": 0.9}
        total = run.record.bands.total[:, place]
        curve = filtered(run, place, total, "contact force N 0.0", **look)
        layers.append(curve)
        alt.append(many.mean_of(k, place))
    passes = {f"{one.assessment.low_pass_Hz:g} Hz" for one in many.runs}
    filters = f"the {passes.pop()} low-pass" if len(passes) == 1 else "the low-pass of each run"
    return [
        Figure(
            key, title, many.axis(), Axis("contact force", "N"), layers,
            caption=f"After {filters}.{many.remark}",
            alt=f"Contact force along the track. {'; '.join(reversed(alt))}.", height=TALL,
        )
    ]  # fmt: skip


def folded(many: Overlaid, places: Places, key: str, title: str) -> list[Figure]:
    """Return the force over the place in the span, the mean of the spans of each run."""
    chosen = [whole_spans(run) for run in many.runs]
    shown = [k for k, place in enumerate(places) if place is not None and len(chosen[k]) >= FEWEST]
    if not shown:
        return []
    lengths = np.concatenate([[right - left for _, left, right in chosen[k]] for k in shown])
    equal = bool(np.ptp(lengths) <= SAME_LENGTH * lengths.mean())
    along = np.linspace(0.0, 1.0, PLACES)
    x = along * float(lengths.mean()) if equal else 100.0 * along
    unit = "m" if equal else "% of the span"
    layers: list[Layer] = []
    alt = []
    for k in reversed(shown):
        place = places[k]
        assert place is not None, "only runs with this pantograph are shown"
        forces = by_place(many.runs[k], place, chosen[k], along)
        # A span with a gap of the measurement is not whole.
        forces = forces[~np.isnan(forces).any(axis=1)]
        if len(forces) < FEWEST:
            continue
        mean = forces.mean(axis=0)
        tips = (Tip("", [many.names[k]] * x.size, form=""), Tip("mean", "y", "N"),
                Tip("deviation", forces.std(axis=0), "N"),
                Tip("distance from the support", "x", unit))  # fmt: skip
        layers.append(
            Curve(x, mean, colour=many.colour(k), name=many.names[k], width=2.2, tips=tips)
        )
        alt.append(f"{many.names[k]}: from {mean.min():.0f} to {mean.max():.0f} N")
    if not layers:
        return []
    return [
        Figure(
            key, title, Axis("distance from the support", unit, 0.0, float(x[-1])),
            Axis("contact force", "N"), layers,
            caption="Mean of the whole spans of the analysis section, after the low-pass.",
            alt=f"Mean contact force over the span. {'; '.join(reversed(alt))}.",
        )
    ]  # fmt: skip


def by_span(many: Overlaid, places: Places, key: str, title: str) -> list[Figure]:
    """Return the standard deviation of the force in each span, bars of the runs side by side."""
    chosen = [whole_spans(run) for run in many.runs]
    shown = [k for k, place in enumerate(places) if place is not None and len(chosen[k]) >= FEWEST]
    if not shown:
        return []
    width = 0.84 / len(shown)
    layers: list[Layer] = []
    alt = []
    ends: list[float] = []
    for order, k in reversed(list(enumerate(shown))):
        place = places[k]
        assert place is not None, "only runs with this pantograph are shown"
        high = deviations_by_span(many.runs[k], place, chosen[k])
        numbers = np.array([number for number, _, _ in chosen[k]], dtype=float)
        known = ~np.isnan(high)
        high, numbers = high[known], numbers[known]
        if not high.size:
            continue
        left = numbers - 0.42 + width * order
        tips = (Tip("", [many.names[k]] * high.size, form=""),
                Tip("standard deviation", high, "N"), Tip("span", numbers, "", "0"))  # fmt: skip
        layers.append(
            Bars(left, left + width, np.zeros_like(high), high, colour=many.colour(k),
                 name=many.names[k], alpha=0.85, tips=tips)
        )  # fmt: skip
        worst = int(high.argmax())
        alt.append(f"{many.names[k]}: largest in span {numbers[worst]:.0f}, {high[worst]:.1f} N")
        ends += [float(numbers[0]), float(numbers[-1])]
    if not layers:
        return []
    remark = "" if many.same_supports else " The lines differ: a number is not the same span."
    return [
        Figure(
            key, title, Axis("span", "", min(ends) - 0.6, max(ends) + 0.6, form="0"),
            Axis("standard deviation σ", "N", 0.0), layers,
            caption=f"Whole spans of the analysis section, after the low-pass.{remark}",
            alt="Standard deviation of the contact force in each span."
            f" {'; '.join(reversed(alt))}.",
        )
    ]  # fmt: skip
