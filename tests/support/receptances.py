"""Receptances of pantographs by a dense solve, and measurements of them with noise."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.model import Pantograph, load_pantograph
from arcless.pantograph.equation_of_motion import matrices, raising_the_strips
from arcless.pantograph.receptance import MeasuredReceptance, of_arrays

Floats = NDArray[np.float64]
Complex = NDArray[np.complexfloating[Any, Any]]

# A test bench's: each tenth of a hertz from 0.2 to 25 Hz.
FREQUENCIES = np.arange(2, 251) / 10.0


def receptance(pantograph: Pantograph | str, frequency: Floats = FREQUENCIES) -> Complex:
    """Return H in m/N of a pantograph at its strip: eᵀ (K + iωC − ω²M)⁻¹ e."""
    model = load_pantograph(pantograph) if isinstance(pantograph, str) else pantograph
    parts, strip = matrices(model), raising_the_strips(model)
    s = 2j * np.pi * frequency[:, None, None]
    return np.einsum("i,fij,j->f", strip, np.linalg.inv(
        parts.stiffness + s * parts.damping + s**2 * parts.mass), strip)  # fmt: skip


def noisy(values: Complex, noise: float, seed: int) -> Complex:
    """Return values with a relative error of a normal distribution, in both parts alike."""
    draw = np.random.default_rng(seed).standard_normal((2, values.size))
    return values * (1.0 + noise * (draw[0] + 1j * draw[1]))


def measured(
    pantograph: Pantograph | str, noise: float = 0.0, seed: int = 1,
    frequency: Floats = FREQUENCIES,
) -> MeasuredReceptance:  # fmt: skip
    """Return the receptance of a pantograph as a bench with noise would measure it."""
    values = noisy(receptance(pantograph, frequency), noise, seed)
    return of_arrays(frequency, values, name="bench")


def table(data: MeasuredReceptance, quantity: str = "receptance", unit: str = "m/N") -> str:
    """Return a table of the amplitudes, in SI of another quantity, and of phases in degrees."""
    s = 2j * np.pi * data.frequency
    values = {
        "receptance": data.values, "mobility": s * data.values, "accelerance": s**2 * data.values,
        "dynamic_stiffness": 1 / data.values, "impedance": 1 / (s * data.values),
        "apparent_mass": 1 / (s**2 * data.values),
    }[quantity]  # fmt: skip
    rows = [
        f"{f:.12g}, {abs(value):.12g}, {np.degrees(np.angle(value)):.12g}"
        for f, value in zip(data.frequency, values, strict=True)
    ]
    return "\n".join([f"frequency [Hz], {quantity} [{unit}], phase [deg]", *rows]) + "\n"
