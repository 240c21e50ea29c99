"""Standard deviation of the force band by band, and how alike the bands are along the line.

Bands of the filter are differences of the low-passes at their ends, in each record's own time;
third octaves are those of the power spectral density. The correlation is that of two bands at the
same places of the line: with other speeds, the same frequency is not the same wavelength.
"""
# ruff: noqa: N815 - the names carry their units

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.gapped import (
    THIRD_OCTAVES,
    common_window_s,
    deviation_between,
    third_octave_Hz,
)
from arcless.comparison.alignment import correlation
from arcless.comparison.measured.signal import Signal

Floats = NDArray[np.float64]
Values = tuple[float | None, ...]
# End of the lowest band in Hz: what passes once or twice in a span, at any speed of a main line.
SLOW_HZ = 2.0


@dataclass(frozen=True)
class Band:
    """A band of the contact force of one pantograph.

    Attributes
    ----------
    pantograph
        Its name.
    kind
        ``filtered`` or ``third octave``.
    low_Hz, high_Hz
        Its ends in Hz.
    deviations_N
        Standard deviation of each run in N; None where it has none.
    differences_N, percents
        Less that of the first run, in N and in % of it.
    correlations
        Correlation coefficient with the first run at the same places; None of a third octave.
    """

    pantograph: str
    kind: str
    low_Hz: float
    high_Hz: float
    deviations_N: Values
    differences_N: Values
    percents: Values
    correlations: Values

    @property
    def label(self) -> str:
        """Name of the band."""
        if self.kind == "filtered":
            return f"{self.low_Hz:g}–{self.high_Hz:g} Hz"
        return f"{np.sqrt(self.low_Hz * self.high_Hz):.3g} Hz"


def bands_of(
    pantograph: str, signals: Sequence[Signal | None], low_pass_Hz: float, band_split_Hz: float
) -> list[Band]:
    """Return the bands of one pantograph, those of the filter first.

    Parameters
    ----------
    pantograph
        Its name.
    signals
        Of each run; None of one without it.
    low_pass_Hz, band_split_Hz
        Of the assessment.
    """
    ends = [(0.0, low_pass_Hz), (0.0, min(SLOW_HZ, band_split_Hz)), (0.0, band_split_Hz),
            (band_split_Hz, low_pass_Hz)]  # fmt: skip
    found = []
    for low, high in dict.fromkeys(one for one in ends if one[0] < one[1]):
        parts = [None if one is None else one.band(low, high) for one in signals]
        values = tuple(_deviation(one, part) for one, part in zip(signals, parts, strict=True))
        alike = tuple(
            _correlation(signals[0], parts[0], one, part) if place else None
            for place, (one, part) in enumerate(zip(signals, parts, strict=True))
        )
        found.append(_band(pantograph, "filtered", (low, high), values, alike))
    window_s = common_window_s(one.longest_s for one in signals if one is not None and one.parts)
    densities = [None if one is None else one.density(window_s) for one in signals]
    for low, high in map(third_octave_Hz, THIRD_OCTAVES):
        # A band that the windows do not resolve has the power of its neighbours.
        narrow = high - low < 1.0 / window_s
        values = tuple(
            None if one is None or narrow else deviation_between(*one, low, high)
            for one in densities
        )
        found.append(_band(pantograph, "third octave", (low, high), values, (None,) * len(signals)))
    return found


def _band(
    pantograph: str, kind: str, ends: tuple[float, float], values: Values, alike: Values
) -> Band:
    first = values[0]
    differences = tuple(None if first is None or one is None else one - first for one in values)
    percents = tuple(
        None if one is None or not first else 100.0 * one / first for one in differences
    )
    return Band(pantograph, kind, *ends, values, differences, percents, alike)


def _deviation(signal: Signal | None, values: Floats | None) -> float | None:
    if signal is None or values is None or not signal.counted.any():
        return None
    return float(values[signal.counted].std())


def _correlation(
    first: Signal | None, values: Floats | None, other: Signal | None, others: Floats | None
) -> float | None:
    """Return the correlation of two bands at the places of the first one."""
    if first is None or values is None or other is None or others is None:
        return None
    at, known = other.trace(others, 0.0).at(first.position_m[first.counted])
    pairs = values[first.counted][known], at[known]
    return correlation(*pairs)
