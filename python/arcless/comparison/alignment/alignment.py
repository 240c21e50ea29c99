"""Where a measurement lies on the line of a run: offset and scale of its positions.

    x_line = x_0 + offset + scale · |x − x_0|,    x the odometer, x_0 its first value

Positions that fall along the run are taken as the distance run: the line of a model begins where
the train enters it. Offset and scale are those at which the filtered channels correlate best: the
scale on a grid that is refined about its best one, the offset by a parabola between its steps.

Two maxima of the correlation are told apart by Fisher's transform: atanh r of n independent samples
has the standard deviation 1/√(n − 3), so that the best is told from the next one where

    (atanh r_1 − atanh r_2) √((n − 3)/2) > 1.645,     n = 2 · overlap / shortest wave

(one in twenty by chance; two samples for each wave of the band: Nyquist). On a line whose spans
are alike the correlation has a maximum at each span, and nearly equal ones are said to be
ambiguous. This counts noise only: where the line was modelled wrongly, r is lower than it says.

Source: Fisher, Metron 1 (1921) 3 (mark C: from memory).
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.comparison.alignment.correlation import correlations, spectrum_of, vertex
from arcless.comparison.alignment.place import POOR_CORRELATION, Alignment, Search
from arcless.comparison.alignment.trace import Trace
from arcless.errors import ComparisonError

Floats = NDArray[np.float64]
# Steps of the grid in the shortest wave: a parabola through three of them finds a maximum within a
# hundredth of that wave. Fewer miss maxima, more take longer.
STEPS_A_WAVE = 8.0
# Of the shorter record at least this part must overlap: a few spans fit anywhere.
LEAST_OVERLAP = 0.5
# Waves that must overlap for a correlation to say anything.
FEWEST_WAVES = 10.0
# First steps of the scale move an end of the overlap by this part of the shortest wave; they are
# then halved about the best one, down to a hundredth of a wave. Longer ones miss the maximum.
SCALE_STEP, HALVINGS = 0.25, 5
# Of a normal distribution, one in twenty is above.
ONE_IN_TWENTY = 1.645
# A correlation of 1 has no transform; channels that are the same to rounding come this near.
NEAREST_ONE = 1.0 - 1e-12


@dataclass(frozen=True, eq=False)
class _Maxima:
    """Correlation over the offset, at one scale."""

    offsets: Floats
    r: Floats
    step: float

    def tops(self) -> NDArray[np.intp]:
        """Return the local maxima that are known, the highest first."""
        r = np.where(np.isnan(self.r), -np.inf, self.r)
        inner = np.flatnonzero((r[1:-1] >= r[:-2]) & (r[1:-1] > r[2:]) & (r[1:-1] > -np.inf)) + 1
        return inner[np.argsort(r[inner])[::-1]]

    def refined(self, top: int) -> tuple[float, float]:
        """Return offset in m and correlation of a maximum, between the steps."""
        around = self.r[top - 1 : top + 2]
        if np.isnan(around).any():
            return float(self.offsets[top]), float(self.r[top])
        place, height = vertex(*(float(one) for one in around))
        return float(self.offsets[top]) + place * self.step, min(height, 1.0)


def aligned(line: Trace, measured: Trace, search: Search, method: str = "correlation") -> Alignment:
    """Return where a measurement lies on a line.

    Parameters
    ----------
    line
        Channel of the run over its position.
    measured
        The same channel over the distance run, which begins at the measurement's first position.
    search
        Limits of offset and scale.
    method
        Name of the method, for the record.

    Raises
    ------
    ComparisonError
        A channel is constant, or too short, or nothing overlaps within the limits.
    """
    shortest = max(line.shortest_m, measured.shortest_m)
    step = shortest / STEPS_A_WAVE
    least = max(LEAST_OVERLAP * min(line.known_m, measured.known_m), FEWEST_WAVES * shortest)
    _check(line, measured, least)
    scales, each = _scales(search, shortest, min(line.length_m, measured.length_m))

    def at(scale: float) -> tuple[float, _Maxima]:
        found = _over_offsets(line, measured, scale, step, least)
        top = _best_inside(found, search)
        return (-math.inf if top is None else found.refined(top)[1]), found

    tried = {scale: at(scale) for scale in scales}
    if not any(math.isfinite(height) for height, _ in tried.values()):
        raise ComparisonError(
            "no maximum of the correlation within the search",
            got=f"offsets {search.low_m:g} to {search.high_m:g} m",
            expected=f"an overlap of at least {least:.0f} m there",
            hint="widen the search (--search), or give the offset by hand (--offset)",
        )
    for _ in range(HALVINGS if len(scales) > 1 else 0):
        best, each = max(tried, key=lambda one: tried[one][0]), 0.5 * each
        near = (best - each, best + each)
        tried |= {one: at(one) for one in near if abs(one - 1.0) <= search.scale_within}
    scale = max(tried, key=lambda one: tried[one][0])
    return _described(tried[scale][1], scale, line, measured, search, method=method)


def _check(line: Trace, measured: Trace, least_m: float) -> None:
    for name, one in (("run", line), ("measurement", measured)):
        values = one.values[one.valid]
        if one.known_m < least_m:
            raise ComparisonError(
                f"the {name} is too short to be aligned",
                got=f"{one.known_m:.0f} m that count",
                expected=f"at least {least_m:.0f} m, {FEWEST_WAVES:g} of the shortest waves",
                hint="give the offset by hand: --offset",
            )
        if not np.ptp(values) > 1e-9 * max(1.0, float(np.abs(values).max())):  # rounding
            raise ComparisonError(
                f"the channel of the {name} is constant: nothing to align by",
                got=f"{values[0]:g} at all samples",
                hint="give the offset by hand: --offset",
            )


def _scales(search: Search, shortest_m: float, length_m: float) -> tuple[list[float], float]:
    """Return the scales to try first, 1 in the middle of an odd number, and their distance."""
    if search.scale_within <= 0.0:
        return [1.0], 0.0
    each = 2.0 * SCALE_STEP * shortest_m / length_m
    count = max(1, math.ceil(search.scale_within / each))
    each = search.scale_within / count
    return [1.0 + each * number for number in range(-count, count + 1)], each


def _over_offsets(
    line: Trace, measured: Trace, scale: float, step_m: float, least_m: float
) -> _Maxima:
    """Return the correlation over the offset, NaN where too little overlaps."""
    begin, origin = float(line.position_m[0]), float(measured.position_m[0])
    a, known_a = line.on_grid(begin, step_m)
    b, known_b = measured.on_grid(origin, step_m, scale)
    length = 1 << (a.size + b.size - 1).bit_length()
    waves = spectrum_of(a, known_a, length), spectrum_of(b, known_b, length)
    shifts, r, count = correlations(*waves, length)
    r = np.where(count * step_m >= least_m, r, np.nan)
    offsets: Floats = begin - origin + step_m * shifts.astype(np.float64)
    return _Maxima(offsets, r, step_m)


def _best_inside(maxima: _Maxima, search: Search) -> int | None:
    """Return the highest maximum within the limits; None where there is none."""
    for top in maxima.tops():
        if search.low_m <= maxima.offsets[top] <= search.high_m:
            return int(top)
    return None


def _described(
    shown: _Maxima, scale: float, line: Trace, measured: Trace, search: Search, *, method: str
) -> Alignment:
    """Return the best maximum with its neighbours."""
    best = _best_inside(shown, search)
    assert best is not None, "the scale was chosen by it"
    offset, r = shown.refined(best)
    origin = float(measured.position_m[0])
    low = max(float(line.position_m[0]), origin + offset)
    high = min(float(line.position_m[-1]), origin + offset + scale * measured.length_m)
    independent = 2.0 * (high - low) / (shown.step * STEPS_A_WAVE)
    inside = [top for top in shown.tops()
              if top != best and search.low_m <= shown.offsets[top] <= search.high_m]  # fmt: skip
    following = shown.refined(int(inside[0])) if inside else None
    first = int(shown.tops()[0])
    beyond = shown.refined(first)
    # Noise decides among spans that are alike; a poor place is doubtful without it.
    doubtful = r < POOR_CORRELATION or told_apart(beyond[1], r, independent)
    is_beyond = first != best and beyond[1] > r and doubtful
    return Alignment(
        method, origin, False, offset, scale, r,
        None if following is None else following[0],
        None if following is None else following[1],
        following is not None and not told_apart(r, following[1], independent),
        beyond[0] if is_beyond else None,
        beyond[1] if is_beyond else None,
        (low, high),
    )  # fmt: skip


def told_apart(better: float, worse: float, independent: float) -> bool:
    """Say whether noise makes this difference of two correlations less than once in twenty times.

    Parameters
    ----------
    better, worse
        Correlation coefficients.
    independent
        Independent samples of each.
    """
    if independent <= 3.0:  # noqa: PLR2004 - the transform has no deviation below
        return False
    one, other = (math.atanh(max(-NEAREST_ONE, min(NEAREST_ONE, r))) for r in (better, worse))
    return (one - other) * math.sqrt((independent - 3.0) / 2.0) > ONE_IN_TWENTY
