"""Many frequencies at once, and what a linear system answers at each."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]


def phases(omega: Floats) -> Floats:
    """Phases that keep the sum from peaking, always the same."""
    return np.random.default_rng(5).uniform(0.0, 2.0 * np.pi, len(omega))


def waves(omega: Floats, t: Floats) -> Floats:
    """All angular frequencies in 1/s with amplitude one, at instants t in s."""
    return np.asarray(np.sin(np.outer(t, omega) + phases(omega)).sum(axis=1))


def rates(omega: Floats, t: Floats) -> Floats:
    """Their rates in 1/s."""
    return np.asarray(np.cos(np.outer(t, omega) + phases(omega)) @ omega)


def coefficients(omega: Floats, values: Floats, t: Floats) -> Complex:
    """Fourier coefficients of values over a common period of all frequencies."""
    return np.asarray(2.0 / len(t) * np.exp(-1j * np.outer(omega, t)) @ values)
