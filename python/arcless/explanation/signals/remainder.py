"""Spectral lines of what does not repeat: bands of pantograph modes, and what chance gives.

Of n samples r_i over the time T, with the discrete Fourier transform R_q, the lines

    p_q = 2 |R_q|²/n²   at   f_q = q/T,      Σ_q p_q = Σ_i r_i²/n   (Parseval)

add up to the variance. A line belongs to the mode whose band it lies in, of two bands to that whose
middle is nearer; a band reaches from the natural frequency at the largest elasticity of the line to
that at the least, and further by the half-power width ζ f on either side. Of a random force lines
vary independently of one another, each as much as its mean: a sum of them varies by √Σ p_q².

Sources: A. V. Oppenheim & R. W. Schafer, Discrete-Time Signal Processing, chapter 8 (Parseval);
J. S. Bendat & A. G. Piersol, Random Data, 8.5; both from memory (C).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.pantograph.natural_modes import Band, PantographMode

Floats = NDArray[np.float64]

# Least number of lines that orders must have left about them: with none, nothing is left to tell
# chance by; a section that is no whole number of spans has one more or less.
LEAST_FREE = 1.0


@dataclass(frozen=True)
class Lines:
    """Spectral lines: frequencies in Hz, and the variance of each in N²."""

    frequency: Floats
    variance: Floats

    @classmethod
    def of(cls, remainder: Floats, rate_Hz: float) -> "Lines":
        """Return the lines of a signal at equal time steps."""
        count = remainder.size
        variance = 2.0 * np.abs(np.fft.rfft(remainder)) ** 2 / count**2
        variance[0] /= 2.0
        if count % 2 == 0:
            variance[-1] /= 2.0
        frequency: Floats = np.fft.rfftfreq(count, 1.0 / rate_Hz).astype(np.float64)
        return cls(frequency, variance)

    @property
    def spacing_Hz(self) -> float:  # noqa: N802 - unit in the name
        """Distance of two lines in Hz, one over the time of the section."""
        return float(self.frequency[1])


def band(mode: PantographMode) -> Band:
    """Return the band of frequencies in Hz that a mode answers in."""
    found, zeta = mode.frequency, mode.damping_ratio
    return Band(found.low * max(0.0, 1.0 - zeta), found.middle, found.high * (1.0 + zeta))


def mode_at(frequency: Floats, bands: list[Band]) -> NDArray[np.intp]:
    """Return the number of the mode that frequencies belong to, from 0; -1 for none."""
    found = np.full(frequency.size, -1)
    distance = np.full(frequency.size, np.inf)
    for number, one in enumerate(bands):
        away = np.abs(frequency - one.middle)
        inside = (frequency >= one.low) & (frequency <= one.high) & (away < distance)
        found[inside], distance[inside] = number, away[inside]
    return found


def chance(lines: Lines, at: Floats, columns: NDArray[np.intp], width_Hz: float) -> Floats:
    """Return the variance b in N² that a free line has about each order.

    Parameters
    ----------
    lines
        Of the remainder.
    at
        Frequency of each order in Hz.
    columns
        Number of columns that each order took: two of them take a line.
    width_Hz
        Width of the surroundings that are averaged: the distance of two orders.

    Returns
    -------
    numpy.ndarray
        NaN where the orders took all lines: the section is too short to tell.
    """
    found = np.full(at.size, np.nan)
    for place, frequency in enumerate(at):
        near = np.abs(lines.frequency - frequency) <= width_Hz / 2.0
        taken = columns[np.abs(at - frequency) <= width_Hz / 2.0].sum() / 2.0
        free = np.count_nonzero(near) - taken
        if free >= LEAST_FREE:
            found[place] = lines.variance[near].sum() / free
    return found
