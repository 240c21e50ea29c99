"""Worst and best distance of two pantographs in a study, with the waves that explain them."""

from typing import TYPE_CHECKING

import numpy as np

from arcless.errors import ArclessError
from arcless.study.analysis.spacings import SpacingCurve, spacing_axis, spacing_curves
from arcless.study.report.data.record import Record

if TYPE_CHECKING:
    from arcless.simulate.resonance import Band, SpacingPeriod

# A cosine that explains less of σ² is no explanation.
LEAST_SHARE = 0.5
# Part of its width, or of its middle where it is narrow, by which f may lie outside of the band of
# a span: the period is found to a few per cent only.
OUTSIDE = 0.1
# Curves that are told; a study over speed and spacing has one for each speed.
MOST = 40
INTRODUCTION = (
    "What the leading pantograph leaves on the line reaches the trailing one at the same place d/v"
    " later. A wave of the frequency f has turned by f d/v periods by then, so that σ² goes up and"
    " down over the spacing d with the period v/f."
)


def spacing_texts(record: Record) -> list[str]:
    """Return a sentence or more for each curve over the spacing; none without such a study."""
    curves = spacing_curves(record.study, record.done)
    if not curves:
        return []
    told = [_curve(record, curve) for curve in curves[:MOST]]
    more = len(curves) - MOST
    return [INTRODUCTION, *told, *([f"{more} more curves are in the table."] if more > 0 else [])]


def _curve(record: Record, curve: SpacingCurve) -> str:
    from arcless.simulate.resonance import spacing_period

    axis = spacing_axis(record.study)
    assert axis is not None, "a curve has a spacing"

    def at(place: int) -> str:
        return f"{axis.shown(curve.spacings[place])} with {curve.values[place]:.1f} N"

    others = [
        f"{one.name} {one.shown(curve.others[one.name])}"
        for one in record.study.axes
        if one.name in curve.others
    ]
    where = f"{', '.join(others)}: " if others else ""
    ratio = ""
    if curve.leading is not None:
        times = curve.values[curve.worst] / curve.leading[curve.worst]
        ratio = f", {times:.1f} times the leading one's"
    text = (
        f"{where}{curve.output} is highest at {at(curve.worst)}{ratio}, and lowest at"
        f" {at(curve.best)}."
    )
    period = spacing_period(curve.spacings, curve.values)
    speed = _speed(record, curve)
    if period is None or speed is None:
        return f"{text} Too few spacings for a period." if period is None else text
    return f"{text} {_why(record, curve, period, speed)}"


def _speed(record: Record, curve: SpacingCurve) -> float | None:
    """Return the speed in m/s that a curve is of; None with a profile."""
    for axis in record.study.axes:
        if axis.field == "speed":
            return float(curve.others[axis.name])
    return record.study.base.speed


def _why(record: Record, curve: SpacingCurve, period: "SpacingPeriod", speed: float) -> str:
    if period.share < LEAST_SHARE:
        return (
            f"No single period explains this: the best, {period.length:.0f} m, has"
            f" {period.share:.0%} of the variance of σ². Look at the figure."
        )
    f = period.frequency(speed)
    worst, best = (float(curve.spacings[one]) for one in (curve.worst, curve.best))
    away = f"{abs(period.phase(worst)):.2f}", f"{abs(period.phase(best)):.2f}"
    crests = np.arange(period.first_worst, float(curve.spacings[-1]) + 0.5, period.length)
    known = [f"{one:.0f}" for one in crests if one >= curve.spacings[0] - 0.5]
    return (
        f"A period of {period.length:.0f} m has {period.share:.0%} of the variance of σ²:"
        f" f = v/period = {f:.2f} Hz, {_which(record, f)}. Its crests are at"
        f" {', '.join(known)} m. The worst spacing is {away[0]} periods from a crest, the best"
        f" one {away[1]}."
    )


def _which(record: Record, frequency: float) -> str:
    """Say whether a span of the line swings at a frequency in Hz, from the line at rest."""
    if any(axis.field.startswith(("line", "as_built")) for axis in record.study.axes):
        return "of a line that is varied, too"
    try:
        band = _swing(record)
    except ArclessError as error:
        return f"of a line that has no equilibrium ({error})"
    margin = OUTSIDE * max(band.high - band.low, band.middle)
    ends = f"{band.low:.2f} to {band.high:.2f} Hz"
    if band.low - margin <= frequency <= band.high + margin:
        return (
            f"and the spans of the line swing as one half wave each at {ends}: the leading"
            " pantograph leaves them swinging, and the trailing one meets that swing"
        )
    return (
        f"but the spans of the line swing as one half wave each at {ends}: another wave than that"
        " is the strongest in the wake"
    )


def _swing(record: Record) -> "Band":
    """Return the frequencies in Hz in which a span swings as one half wave."""
    from arcless.equilibrium.initial_configuration import InitialConfiguration
    from arcless.simulate.resonance.spans import spans

    base = record.study.base
    rest = InitialConfiguration.of(base)
    force = base.pantographs[0].start_force or 0.0
    found = spans(rest.equilibrium, base.line.span_list(), force)
    return found[len(found) // 2].swing
