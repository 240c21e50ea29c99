"""Measured records with known content, written as a recorder writes them."""

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

SPEED = 70.0  # m/s
RATE = 500.0  # Hz


def times(seconds: float = 10.0, rate: float = RATE) -> Floats:
    return np.arange(round(seconds * rate)) / rate


def wave(frequency: float, amplitude: float) -> Callable[[Floats], Floats]:
    return lambda t: amplitude * np.sin(2.0 * np.pi * frequency * t)


def force(time: Floats) -> Floats:
    """Return a force in N of waves at 1.3, 7 and 40 Hz, whose phases repeat in no sample."""
    parts = [wave(1.3, 30.0), wave(7.1, 12.0), wave(40.3, 9.0)]
    return 130.0 + sum(part(time) for part in parts)


def write(
    path: Path,
    columns: Mapping[str, Floats],
    *,
    delimiter: str = ",",
    decimal: str = ".",
    ends: tuple[str, str] = ("utf-8", "\n"),
) -> Path:
    """Write columns with their headers, every bit; what is no number is an empty cell.

    `ends` is the encoding, and what ends a line.
    """
    encoding, newline = ends
    lines = [delimiter.join(columns)]
    for row in zip(*columns.values(), strict=True):
        cells = ["" if np.isnan(value) else repr(float(value)) for value in row]
        lines.append(delimiter.join(cell.replace(".", decimal) for cell in cells))
    path.write_bytes((newline.join(lines) + newline).encode(encoding))
    return path


def record(**changed: Floats) -> dict[str, Floats]:
    """Return a record of 10 s at 500 Hz and 70 m/s, with some columns changed."""
    time = times()
    columns = {"time": time, "position": SPEED * time, "contact_force": force(time)} | changed
    units = {"time": "s", "position": "m", "speed": "m/s", "contact_force": "N",
             "contact_height": "m", "uplift": "m", "sensor_force_1": "N", "sensor_force_2": "N",
             "acceleration_1": "m/s2", "acceleration_2": "m/s2"}  # fmt: skip
    return {f"{name} [{units[name]}]": values for name, values in columns.items()}
