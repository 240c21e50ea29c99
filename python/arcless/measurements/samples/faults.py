"""Samples that a sensor or a recorder spoilt: codes, clipped, frozen, held between samples."""

import re

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Samples at the largest or smallest value of a record that count as clipped. Fewer would take
# chance for it; more would leave short overloads in.
CLIPPED_SAMPLES = 4
# So many times as often as the value next to it an end of the range is seen. The top of a wave,
# flattened by a recorder's resolution, has 1/(√2 − 1) = 2.4; more leaves mild overloads in.
CLIPPED_RATIO = 4.0
# Time in s after which a value that does not change counts as frozen: a force that is measured
# has noise. Less would take resolution for it; more lets a dead sensor lower the deviation.
FROZEN_S = 0.1
# Share of equal stretches of one length above which a value is held between samples, as a recorder
# that is faster than its sensor does. Less would see it in resolution.
HELD_SHARE = 0.8

# Numbers that recorders write for no value: 999, 9999 and so on in any power of ten, any sign.
_CODE = re.compile(r"0*9{3,}0*")
# Ranges of the other values that a code is away from them at least. Fewer would take a real peak of
# 999 for a code; more lets 999 N pass for a force among those of 100 to 300 N.
CODE_RANGES = 2.0


def codes(values: Floats) -> Mask:
    """Return which samples are a usual code for no value, far outside the others."""
    finite = np.isfinite(values)
    levels = [level for level in np.unique(values[finite]) if _is_code(level)]
    is_code = np.isin(values, levels)
    others = values[finite & ~is_code]
    if not levels or not others.size:
        return np.zeros(values.shape, bool)
    low, high = float(others.min()), float(others.max())
    away = np.maximum(low - values, values - high)
    return is_code & (away > CODE_RANGES * (high - low)) & (away > 0.0)


def _is_code(value: float) -> bool:
    digits = f"{abs(value):.9g}"
    return "e" not in digits and _CODE.fullmatch(digits.replace(".", "")) is not None


def stretches(values: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return begin and length of stretches of equal values; each NaN is one of its own."""
    begins = np.concatenate([[0], np.flatnonzero(values[1:] != values[:-1]) + 1])
    return begins, np.diff(begins, append=values.size)


def held(values: Floats) -> int:
    """Return over how many samples a recorder holds each value; 1 where it does not.

    Values of a stretch at zero (loss of contact) do not count.
    """
    begins, lengths = stretches(values)
    lengths = lengths[np.isfinite(values[begins]) & (values[begins] != 0.0)]
    if not lengths.size:
        return 1
    usual = int(np.median(lengths))
    return usual if np.mean(lengths == usual) >= HELD_SHARE else 1


def clipped(values: Floats, at_least: int = CLIPPED_SAMPLES) -> tuple[Mask, Mask]:
    """Return which samples are at the lower, and which at the upper end of the sensor's range.

    That is the smallest or largest value of a record, where it is seen much more often than the
    value next to it.

    Parameters
    ----------
    values
        One sensor; NaN where there is no sample.
    at_least
        Samples that tell an end of the range.

    Notes
    -----
    Zero is no end of a range: a contact force is zero while there is no contact.
    """
    levels, counts = np.unique(values[np.isfinite(values)], return_counts=True)
    ends = [(levels[:1], counts[:1], counts[1:2]), (levels[-1:], counts[-1:], counts[-2:-1])]
    lower, upper = (
        np.isin(values, level[level != 0.0])
        & (count.sum() >= max(at_least, CLIPPED_RATIO * nearest.sum()))
        for level, count, nearest in ends
    )
    return lower, upper


def frozen(values: Floats, step_s: float) -> Mask:
    """Return which samples lie in a stretch of equal values, other than zero, of `FROZEN_S`."""
    begins, lengths = stretches(values)
    long = (lengths - 1) * step_s > FROZEN_S
    return _spread(long & (values[begins] != 0.0) & (lengths > CLIPPED_SAMPLES), lengths)


def _spread(chosen: Mask, lengths: NDArray[np.intp]) -> Mask:
    """Return for each sample what holds for its stretch."""
    return np.repeat(chosen, lengths)
