"""Normalised cross-correlation of two channels of which some samples are missing.

For each shift k, over the n samples that both have there,

    r_k = (Σ a b − Σa Σb / n) / √((Σ a² − (Σa)²/n) (Σ b² − (Σb)²/n))

all six sums by Fast Fourier Transforms of values and masks.

Source: Padfield, Masked object registration in the Fourier domain, IEEE Trans. Image Process. 21
(2012) 2706 (mark C: from memory); a test compares with the sums written out.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
# A piece whose variance is below this part of that of the whole channel is constant: what is left
# of the difference of its sums is rounding.
CONSTANT = 1e-6


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Transforms of a channel, its square and its mask, padded to a length."""

    values: NDArray[np.complex128]
    squares: NDArray[np.complex128]
    mask: NDArray[np.complex128]
    size: int
    variance: float


def spectrum_of(values: Floats, known: Flags, length: int) -> Spectrum:
    """Return the transforms of a channel; values that are not known must not count.

    Parameters
    ----------
    values
        Of the channel.
    known
        Samples that count, at least one.
    length
        That of both channels together, or more, so that nothing wraps round.
    """
    shifted = np.where(known, values - values[known].mean(), 0.0)
    parts = (shifted, shifted**2, known.astype(np.float64))
    waves = [np.fft.rfft(part, length) for part in parts]
    return Spectrum(waves[0], waves[1], waves[2], values.size, float(shifted[known].var()))


def correlations(a: Spectrum, b: Spectrum, length: int) -> tuple[NDArray[np.intp], Floats, Floats]:
    """Return shifts, correlations and how many samples each is of.

    Shift k puts sample 0 of b on sample k of a. The correlation is NaN where a piece is constant.
    """

    def summed(one: NDArray[np.complex128], other: NDArray[np.complex128]) -> Floats:
        full = np.fft.irfft(one * np.conj(other), length)
        # From shift 1 − size of b, at the end of the transform, to size of a − 1.
        return np.concatenate([full[length - b.size + 1 :], full[: a.size]])

    count = np.round(summed(a.mask, b.mask))
    n = np.maximum(count, 1.0)
    of_a, of_b = summed(a.values, b.mask), summed(a.mask, b.values)
    covariance = summed(a.values, b.values) / n - of_a * of_b / n**2
    spread_a = summed(a.squares, b.mask) / n - (of_a / n) ** 2
    spread_b = summed(a.mask, b.squares) / n - (of_b / n) ** 2
    varies = (spread_a > CONSTANT * a.variance) & (spread_b > CONSTANT * b.variance)
    product = np.where(varies, spread_a * spread_b, 1.0)
    found = np.where(varies, covariance / np.sqrt(product), np.nan)
    shifts = np.arange(1 - b.size, a.size)
    return shifts, found, count


def vertex(before: float, top: float, after: float) -> tuple[float, float]:
    """Return where the parabola through three equidistant values is highest, and how high.

    The place is in steps from the middle value; a middle value that is no maximum stays.
    """
    bend = before - 2.0 * top + after
    if not (bend < 0.0 and top >= max(before, after)):
        return 0.0, top
    place = 0.5 * (before - after) / bend
    return place, top - 0.25 * (before - after) * place


def correlation(one: Floats, other: Floats) -> float | None:
    """Return the correlation coefficient of two equally long channels; None where one is constant.

    Parameters
    ----------
    one, other
        The channels.
    """
    if one.size == 0 or np.ptp(one) == 0.0 or np.ptp(other) == 0.0:
        return None
    a, b = one - one.mean(), other - other.mean()
    return float(np.sum(a * b) / np.sqrt(np.sum(a * a) * np.sum(b * b)))
