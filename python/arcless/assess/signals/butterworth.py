"""Butterworth low-pass as second-order sections, run forwards and backwards.

Poles of order n on the unit circle of the Laplace plane, scaled to the cut-off that the bilinear
transform s = 4 (z − 1)/(z + 1), at two samples per unit of time, moves to where it is wanted:

    p_m = −exp(iπm/2n),  m = 1 − n, 3 − n, … n − 1,     ω = 4 tan(π f_c / f_s)

Each pair of poles is a section with a double zero at −1; the gain stands in the first section, and
the pair next to the unit circle in the last. Written here because importing it takes 1.5 s;
operation for operation that of SciPy (`butter`, `sosfiltfilt`), with which a test compares.

Source: Oppenheim & Schafer, Discrete-Time Signal Processing, sections 7.1 and 6.3; Gustafsson, IEEE
Trans. Signal Process. 44 (1996) 988 (a start without a transient).
"""

import numpy as np
from numpy.typing import NDArray

from arcless import _core

Floats = NDArray[np.float64]

# Samples per unit of time of the bilinear transform; any would do.
_SAMPLES = 2.0


def sections(order: int, cutoff_Hz: float, rate_Hz: float) -> Floats:
    """Return b₀, b₁, b₂, a₁, a₂ of each section (order/2 × 5).

    Parameters
    ----------
    order
        Even order of the filter.
    cutoff_Hz, rate_Hz
        Where one pass takes 3 dB off a sine, and the recording rate, in Hz.
    """
    warped = 2.0 * _SAMPLES * np.tan(np.pi * (cutoff_Hz / (rate_Hz / 2.0)) / _SAMPLES)
    m = np.arange(1 - order, order, 2, dtype=np.float64)
    poles = warped * -np.exp(1j * np.pi * m / (2 * order))
    twice = 2.0 * _SAMPLES
    gain = warped**order * np.real(1.0 / np.prod(twice - poles))
    poles = (twice + poles) / (twice - poles)
    # One of each conjugate pair, averaged: rounding leaves the two a little different.
    upper = poles[poles.imag > 0]
    lower = poles[poles.imag < 0][::-1]
    pairs = (upper + lower.conj()) / 2.0
    pairs = pairs[np.argsort(np.abs(1.0 - np.abs(pairs)))[::-1]]
    found = np.array([[1.0, 2.0, 1.0, -2.0 * p.real, (p * p.conj()).real] for p in pairs])
    found[0, :3] *= gain
    return found


def both_ways(cascade: Floats, signal: Floats, extension: int) -> Floats:
    """Filter a signal forwards and backwards, extended at both ends by its point reflection.

    Parameters
    ----------
    cascade
        As `sections` returns it.
    signal
        One-dimensional, at equal time steps.
    extension
        Samples added at each end, below the length of the signal.
    """
    first, last, n = signal[:1], signal[-1:], extension
    before, behind = 2.0 * first - signal[n:0:-1], 2.0 * last - signal[-2 : -(n + 2) : -1]
    extended = np.concatenate([before, signal, behind]) if n else signal
    start = steady(cascade)
    forwards = _core.filtered(cascade, start * extended[0], extended)
    backwards = _core.filtered(cascade, start * forwards[-1], forwards[::-1])[::-1]
    return backwards[n:-n] if n else backwards


def steady(cascade: Floats) -> Floats:
    """Return the state of each section (n × 2) under a signal that was always 1.

    Of a section in transposed form II, s₁ = b₁ − a₁ y + s₂ and s₂ = b₂ − a₂ y with y = b₀ + s₁, so
    (1 + a₁ + a₂) s₁ = b₁ + b₂ − (a₁ + a₂) b₀. Solved by hand: a library of linear algebra gives
    other last bits on other processors.
    """
    b0, b1, b2, a1, a2 = cascade.T
    first = (b1 + b2 - (a1 + a2) * b0) / (1.0 + a1 + a2)
    states: Floats = np.stack([first, b2 - a2 * (b0 + first)], axis=-1)
    gains = (b0 + b1 + b2) / (1.0 + a1 + a2)
    scales = np.cumprod(np.concatenate([[1.0], gains[:-1]]))
    return scales[:, None] * states
