"""Places with the largest deviations of the force, each with what is nearest on the line."""

from math import log, sqrt

import numpy as np
from numpy.typing import NDArray

from arcless.explanation.landmarks import Landmarks, beside
from arcless.explanation.parts import Place

Floats = NDArray[np.float64]

# Places that are listed.
WORST, IRREGULAR = 10, 5
# Chance at which a random section has a place that stands out. Larger, quiet runs name places;
# smaller, a single wrong dropper of a loud line stays unnamed.
RISK = 0.01
# Distance in mean spans within which one irregular place stands for all: further on, it is another
# half wave of the span.
APART = 0.5
# Distance in mean spans within which a part that is not as designed is told. Larger, parts are told
# that have nothing to do with the place; smaller, not those whose waves come some droppers later.
REACH = 0.25


def excursions(deviation: Floats) -> NDArray[np.intp]:
    """Return the sample of the largest deviation between each two crossings of zero."""
    sign = np.signbit(deviation)
    cuts = np.flatnonzero(sign[1:] != sign[:-1]) + 1
    ends = zip([0, *cuts], [*cuts, deviation.size], strict=True)
    size = np.abs(deviation)
    return np.array([first + int(size[first:last].argmax()) for first, last in ends])


def worst(marks: Landmarks, x: Floats, force: Floats, mean_span: float) -> tuple[Place, ...]:
    """Return the excursions of the force furthest from its mean, the largest first.

    Parameters
    ----------
    marks
        Parts of the line.
    x, force
        Position in m and filtered force in N at each sample.
    mean_span
        Mean length of a span in m.
    """
    deviation = force - force.mean()
    rows = excursions(deviation)
    chosen = rows[np.argsort(-np.abs(deviation[rows]), kind="stable")][:WORST]
    reach = REACH * mean_span
    return tuple(_place(marks, x[r], force[r], deviation[r], reach) for r in chosen)


def irregular(
    marks: Landmarks, x: Floats, force: Floats, remainder: Floats, mean_span: float
) -> tuple[Place, ...]:
    """Return the places at which the force differs most from what repeats, half a span apart.

    One stands out if less than one of a hundred random sections has such a deviation anywhere: of n
    excursions with the Rayleigh distribution of a narrow-band Gaussian signal,

        n exp(−z²/2) = 0.01,    z = |r|/σ_r

    Source: S. O. Rice, Bell Syst. Tech. J. 23 (1944), 24 (1945), from memory (C).
    """
    rows = excursions(remainder)
    least = sqrt(2.0 * log(rows.size / RISK)) * float(remainder.std())
    chosen: list[int] = []
    for row in rows[np.argsort(-np.abs(remainder[rows]), kind="stable")]:
        if all(abs(x[row] - x[other]) >= APART * mean_span for other in chosen):
            chosen.append(int(row))
        if len(chosen) == IRREGULAR:
            break
    reach = REACH * mean_span
    return tuple(
        _place(marks, x[r], force[r], remainder[r], reach, stands_out=abs(remainder[r]) > least)
        for r in chosen
    )


def _place(
    marks: Landmarks,
    x: float,
    force: float,
    deviation: float,
    reach: float,
    *,
    stands_out: bool | None = None,
) -> Place:
    part, change, span = marks.nearest(x), marks.change_near(x, reach), marks.span_at(x)
    name = part.name
    if part.span is not None and part.span != span:
        name = f"{name} of span {part.span}"
    within = "".join(f", in the {text}" for text in marks.stretches_at(x))
    return Place(
        position_m=float(x),
        span=span,
        force_N=float(force),
        deviation_N=float(deviation),
        nearest=part.name if part.span is None else f"span {part.span} {part.name}",
        distance_m=float(x - part.x),
        where=beside(x - part.x, name) + within,
        as_built=None if change is None else _change(x - change.x, change.name),
        stands_out=None if stands_out is None else bool(stands_out),
    )


def _change(distance: float, name: str) -> str:
    """Return a part that is not as designed, with where it stands: the other way round."""
    if abs(distance) < 1.0:
        return f"{name}, here"
    return f"{name}, {abs(distance):.1f} m {'before' if distance > 0.0 else 'after'} it"
