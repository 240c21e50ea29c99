"""Table of a measured frequency response → receptance of the collector head.

Harmonic force F e^{iωt} upwards on the head, displacement X e^{iωt} of the same point upwards. What
was measured may be any of (Ewins: Modal Testing, 2nd ed., Research Studies Press 2000, table 2.1)

    receptance H = X/F,   mobility iωH,   accelerance −ω²H,
    dynamic stiffness 1/H,   impedance 1/(iωH),   apparent mass −1/(ω²H)

Nothing that is driven at one point gives energy back: the power −ω Im H |F|²/2 is not negative, so
that the phase of H lies in −180° to 0. Data outside by more than noise are refused.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from arcless.errors import MeasurementError
from arcless.model.files.csv_tables import Table, read_table
from arcless.storage.digests import short_digest

Floats = NDArray[np.float64]
Complex = NDArray[np.complexfloating[Any, Any]]

# Quantity → its unit, power of iω by which it is divided once it is a response to a force, and
# whether it is a force to a motion.
QUANTITIES: Mapping[str, tuple[str, int, bool]] = {
    "receptance": ("m/N", 0, False),
    "mobility": ("m/s/N", 1, False),
    "accelerance": ("m/s2/N", 2, False),
    "dynamic_stiffness": ("N/m", 0, True),
    "impedance": ("N s/m", 1, True),
    "apparent_mass": ("kg", 2, True),
}
TABLE = Table(
    {
        **{name: unit for name, (unit, _, _) in QUANTITIES.items()},
        "frequency": "Hz",
        "phase": "rad",
        "relative_error": "1",
    },
    either=tuple(QUANTITIES),
    optional=("relative_error",),
)
# Frequencies without which not even one mass, spring and damper would be overdetermined.
FEWEST, MOST = 6, 20_000
# Phases outside of −180° to 0 by so much are no noise: 15° are five standard deviations of 5 %.
NOISE_RAD = np.radians(15.0)
# Phases beyond are none that anybody counts on to, but degrees under the title of radians.
LARGEST_RAD = 8.0 * np.pi
# Largest amplitude over the smallest: more is a slip, as no bench measures twelve powers of ten.
MOST_RATIO = 1e12
# Places that a message names.
NAMED = 5


@dataclass(frozen=True, eq=False)
class MeasuredReceptance:
    """A measured receptance of the collector head.

    Attributes
    ----------
    name
        Of its file, or as it is called.
    frequency
        In Hz, rising.
    values
        H in m/N.
    error
        Relative standard deviation of each value; None where none is given.
    quantity
        What was measured, a key of `QUANTITIES`.
    digest
        Of the file; empty where there is none.
    """

    name: str
    frequency: Floats
    values: Complex
    error: Floats | None = None
    quantity: str = "receptance"
    digest: str = ""

    def __post_init__(self) -> None:
        _check_frequencies(self.frequency, self.name)
        _check_values(self)

    @property
    def outside(self) -> Floats:
        """Phase outside of −180° to 0 at each frequency, in rad; 0 inside."""
        return outside(self.values)


def read(path: str | Path) -> MeasuredReceptance:
    """Read a table of a receptance, or of what follows from it.

    Parameters
    ----------
    path
        A CSV file with the columns `frequency`, `phase` and one of `QUANTITIES`, each with its unit
        in the header; also `relative_error`, the standard deviation of each value over the value.

    Raises
    ------
    ModelError
        A column, a unit or a number is missing or wrong; the message has the line.
    MeasurementError
        Frequencies do not rise, or are too few; an amplitude is zero; the phase of a passive
        pantograph is none of these.
    """
    file, name = Path(path), str(path)
    columns = {key: np.array(column) for key, column in read_table(file, TABLE).items()}
    quantity = next(key for key in QUANTITIES if key in columns)
    amplitude, phase = columns[quantity], columns["phase"]
    if np.any(amplitude <= 0.0):
        row = int(np.flatnonzero(amplitude <= 0.0)[0])
        raise MeasurementError(
            f"column {quantity}", where=f"{name}, row {row + 1}", got=f"{amplitude[row]:g}",
            expected="an amplitude above 0", hint="leave out rows in which nothing was measured",
        )  # fmt: skip
    if np.max(np.abs(phase)) > LARGEST_RAD:
        raise MeasurementError(
            "column phase", where=name, got=f"up to {np.max(np.abs(phase)):g} rad",
            expected=f"at most {LARGEST_RAD:.3g} rad, four turns",
            hint="are they degrees? Then write phase [deg] into the header",
        )  # fmt: skip
    _check_frequencies(columns["frequency"], name)
    measured = amplitude * np.exp(1j * phase)
    values = as_receptance(columns["frequency"], measured, quantity)
    return MeasuredReceptance(
        name, columns["frequency"], values, columns.get("relative_error"), quantity,
        short_digest(file),
    )  # fmt: skip


def of_arrays(
    frequency_Hz: ArrayLike,
    values: ArrayLike,
    *,
    quantity: str = "receptance",
    relative_error: ArrayLike | None = None,
    name: str = "measured",
) -> MeasuredReceptance:
    """Return a measured receptance from arrays.

    Parameters
    ----------
    frequency_Hz
        Frequencies in Hz, rising.
    values
        Complex values of the quantity, SI units.
    quantity
        A key of `QUANTITIES`.
    relative_error
        Standard deviation of each value over the value; None where it is not known.
    name
        What messages and pages call it.

    Raises
    ------
    MeasurementError
        As `read`.
    """
    frequency = np.asarray(frequency_Hz, np.float64)
    if quantity not in QUANTITIES:
        expected = ", ".join(QUANTITIES)
        raise MeasurementError("quantity", where=name, got=f'"{quantity}"', expected=expected)
    _check_frequencies(frequency, name)
    given = np.asarray(values, np.complex128)
    if given.shape != frequency.shape or not np.all(np.isfinite(given)) or not np.all(given):
        raise MeasurementError(
            "values", where=name, got="not a finite number, other than 0, for each frequency",
            expected=f"{frequency.size} complex numbers",
        )  # fmt: skip
    error = None if relative_error is None else np.asarray(relative_error, np.float64)
    return MeasuredReceptance(
        name, frequency, as_receptance(frequency, given, quantity), error, quantity
    )


def as_receptance(frequency: Floats, values: Complex, quantity: str) -> Complex:
    """Return H in m/N from another quantity in SI units, at frequencies in Hz."""
    _, power, inverse = QUANTITIES[quantity]
    response = 1.0 / values if inverse else values
    found: Complex = response / (2j * np.pi * frequency) ** power
    return found


def outside(values: Complex) -> Floats:
    """Return how far the phase of each value lies outside of −180° to 0, in rad."""
    phase = np.angle(values)
    return np.where(phase > 0.0, np.minimum(phase, np.pi - phase), 0.0)


def listed(frequencies: Floats) -> str:
    """Return frequencies in words, the first of them where they are many."""
    shown = ", ".join(f"{one:g}" for one in frequencies[:NAMED])
    more = frequencies.size - NAMED
    return f"{shown} Hz" + (f" and {more} more" if more > 0 else "")


def _check_frequencies(frequency: Floats, name: str) -> None:
    if frequency.ndim != 1 or not np.all(np.isfinite(frequency)):
        raise MeasurementError("frequencies", where=name, got="not a list of finite numbers",
                               expected="numbers in Hz")  # fmt: skip
    if not FEWEST <= frequency.size <= MOST:
        raise MeasurementError(
            "number of frequencies", where=name, got=str(frequency.size),
            expected=f"{FEWEST} to {MOST}",
        )  # fmt: skip
    if frequency[0] <= 0.0:
        raise MeasurementError(
            "column frequency", where=name, got=f"{frequency[0]:g} Hz", expected="above 0",
            hint="leave the row of 0 Hz out: an accelerometer measures nothing there",
        )  # fmt: skip
    falling = np.flatnonzero(np.diff(frequency) <= 0.0)
    if falling.size:
        row = int(falling[0])
        raise MeasurementError(
            "frequencies do not rise", where=f"{name}, row {row + 2}",
            got=f"{frequency[row + 1]:g} Hz after {frequency[row]:g} Hz",
            expected="each frequency once, in rising order", hint="sort the rows",
        )  # fmt: skip


def _check_values(data: MeasuredReceptance) -> None:
    error = data.error
    if error is not None and not (error.shape == data.frequency.shape and np.all(error > 0.0)
                                  and np.all(error < 1.0)):  # fmt: skip
        raise MeasurementError(
            "relative_error", where=data.name, got="values of 0 or below, or of 100 % or more",
            expected="a standard deviation above 0 and below 100 % for each frequency",
        )  # fmt: skip
    size = np.abs(data.values)
    if not np.all(np.isfinite(size)) or size.max() > MOST_RATIO * size.min():
        raise MeasurementError("amplitudes", where=data.name,
                         got=f"{size.min():.3g} to {size.max():.3g} m/N",
                         expected="a receptance within twelve powers of ten")  # fmt: skip
    bad = data.outside > NOISE_RAD
    if np.any(bad):
        raise _not_passive(data, bad)


def _not_passive(data: MeasuredReceptance, bad: NDArray[np.bool_]) -> MeasurementError:
    """Return the refusal of data that give energy, with what may have made them so."""
    turned = outside(-data.values) <= NOISE_RAD
    if np.all(turned):
        hint = (
            "all phases lie in 0 to 180°: count a lag as negative, and force and motion in one"
            " direction"
        )
    elif bad[-1] and not np.any(bad[: bad.size // 2]):
        hint = (
            "phases leave it at high frequencies: a delay between the two channels turns them in"
            " proportion to frequency"
        )
    else:
        hint = (
            "leave out frequencies at which the measurement failed; force and motion must be those"
            " of one point"
        )
    worst = int(np.argmax(data.outside))
    return MeasurementError(
        "not passive: the pantograph would give energy back", where=data.name,
        got=f"phases of the receptance outside of −180° to 0 at {listed(data.frequency[bad])},"
        f" by {np.degrees(data.outside[worst]):.0f}° at {data.frequency[worst]:g} Hz",
        expected=f"phases in −180° to 0, within {np.degrees(NOISE_RAD):.0f}° of noise", hint=hint,
    )  # fmt: skip
