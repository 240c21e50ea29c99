"""Figures of the force by span: all spans over each other, and the deviation in each."""

import numpy as np

from arcless.explanation.signals import span_deviations
from arcless.figures.description import Area, Axis, Bars, Curve, Figure, Layer, Rules, Tip
from arcless.figures.description.thinning import every
from arcless.figures.description.tokens import of_pantograph
from arcless.figures.run.run_data import Floats, RunData
from arcless.figures.run.track import SAME_LENGTH, titled

# Places along a span at which spans are compared, the fewest spans that are, and the most curves
# of single spans, of all pantographs together.
PLACES, FEWEST, MOST_DRAWN = 241, 2, 60


def folded(run: RunData) -> list[Figure]:
    """Return the filtered force over the place in the span: each span, their mean and deviation."""
    chosen = whole_spans(run)
    if len(chosen) < FEWEST:
        return []
    lengths = np.array([right - left for _, left, right in chosen])
    equal = bool(np.ptp(lengths) <= SAME_LENGTH * lengths.mean())
    along = np.linspace(0.0, 1.0, PLACES)
    x = along * lengths.mean() if equal else 100.0 * along
    axis = Axis("distance from the support", "m" if equal else "% of the span", 0.0, float(x[-1]))
    forces = [by_place(run, i, chosen, along) for i in range(len(run.pantographs))]
    low, high = (float(end(np.concatenate(forces))) for end in (np.nanmin, np.nanmax))
    margin = 0.06 * (high - low) or 1.0
    found = []
    for i, (name, force) in enumerate(zip(run.pantographs, forces, strict=True)):
        mean, deviation = force.mean(axis=0), force.std(axis=0)
        drawn = force[every(len(force), max(6, MOST_DRAWN // len(forces)))]
        pieces = np.column_stack([drawn, np.full(len(drawn), np.nan)]).ravel()
        places = np.tile(np.append(x, np.nan), len(drawn))
        layers: list[Layer] = [
            *_droppers(run, chosen, equal),
            Curve(places, pieces, colour="raw", name="each span", width=1.0),
            Area(x, mean - deviation, mean + deviation, colour=of_pantograph(i), alpha=0.18,
                 name="mean ± standard deviation of the spans"),
            Curve(x, mean, colour=of_pantograph(i), name="mean of the spans", width=2.2,
                  tips=(Tip("mean", "y", "N"), Tip("deviation", deviation, "N"),
                        Tip("distance from the support", "x", axis.unit))),
        ]  # fmt: skip
        found.append(
            Figure(
                f"folded-{i + 1}", titled(run, "Contact force over the span", i), axis,
                Axis("contact force", "N", low - margin, high + margin), layers,
                caption=f"The {len(chosen)} whole spans of the analysis section, overlaid; after"
                " the low-pass.",
                alt=f"Contact force of {name} over the span: on average from {mean.min():.0f} to"
                f" {mean.max():.0f} N.",
            )
        )  # fmt: skip
    return found


def by_span(run: RunData) -> list[Figure]:
    """Return the standard deviation of the force in each whole span of the section."""
    chosen = whole_spans(run)
    if len(chosen) < FEWEST:
        return []
    deviations = [deviations_by_span(run, i, chosen) for i in range(len(run.pantographs))]
    numbers = np.array([number for number, _, _ in chosen], dtype=float)
    limits = [run.limit("standard_deviation", i) for i in range(len(run.pantographs))]
    known = [limit for limit in limits if limit is not None]
    top = 1.08 * max(*(value for each in deviations for value in each), *known, 1e-9)
    found = []
    for i, assessed in enumerate(run.assessment.pantographs):
        high = deviations[i]
        tips = (Tip("standard deviation", high, "N"), Tip("span", numbers, "", "0"))
        layers: list[Layer] = [
            Bars(numbers - 0.4, numbers + 0.4, np.zeros_like(high), high, colour=of_pantograph(i),
                 alpha=0.75, name="σ in the span", tips=tips),
            Rules(axis="y", at=np.array([assessed.std_force_N]), colour="mean", width=1.2,
                  name=f"σ of the section: {assessed.std_force_N:.1f} N"),
        ]  # fmt: skip
        limit = limits[i]
        if limit is not None:
            layers.append(
                Rules(axis="y", at=np.array([limit]), colour="limit", dash="dashed", width=1.6,
                      name=f"limit of σ: {limit:.1f} N")
            )  # fmt: skip
        worst = int(high.argmax())
        found.append(
            Figure(
                f"by-span-{i + 1}", titled(run, "Standard deviation in each span", i),
                Axis("span", "", numbers[0] - 0.6, numbers[-1] + 0.6, form="0"),
                Axis("standard deviation σ", "N", 0.0, top), layers,
                alt=f"Standard deviation of the force of {assessed.name} in each span, largest in"
                f" span {numbers[worst]:.0f}: {high[worst]:.1f} N.",
            )
        )  # fmt: skip
    return found


def whole_spans(run: RunData) -> list[tuple[int, float, float]]:
    """Return number and ends of the spans that lie inside the section wholly."""
    begin, end = run.assessment.section_m
    ran = (float(run.position[0].max()), float(run.position[-1].min()))
    return span_deviations.whole_spans(run.supports, (begin, end), ran)


def by_place(
    run: RunData, pantograph: int, chosen: list[tuple[int, float, float]], along: Floats
) -> Floats:
    """Return the filtered force at places of each span, (span, place)."""
    x, force = run.position[:, pantograph], run.record.bands.total[:, pantograph]
    left = np.array([begin for _, begin, _ in chosen])
    length = np.array([end - begin for _, begin, end in chosen])
    places = left[:, None] + along * length[:, None]
    values: Floats = np.interp(places.ravel(), x, force).reshape(places.shape)
    return values


def deviations_by_span(
    run: RunData, pantograph: int, chosen: list[tuple[int, float, float]]
) -> Floats:
    """Return the standard deviation of the filtered force in each span, in N."""
    x, force = run.position[:, pantograph], run.record.bands.total[:, pantograph]
    return span_deviations.deviations(x, force, chosen)


def _droppers(run: RunData, chosen: list[tuple[int, float, float]], equal: bool) -> list[Layer]:
    """Return the droppers of the middle span, where all spans have theirs at the same places."""
    if not (equal and run.has_droppers):
        return []
    of, x = run.values("dropper_span"), run.values("dropper_x")
    places = [np.unique(x[of == number]) - left for number, left, _ in chosen]
    first = places[0]
    if not first.size or any(
        one.size != first.size or np.max(np.abs(one - first)) > SAME_LENGTH for one in places
    ):
        return []
    return [Rules(axis="x", at=first, colour="dropper", name="dropper", dash="dotted")]
