"""Run → Readings: what the sensors of an instrumented pantograph would have written down."""
# ruff: noqa: N815 - the names carry their units

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import sample_rate_Hz
from arcless.errors import ModelError
from arcless.results.instrument.head import checked_mass, head_acceleration
from arcless.results.instrument.instrument import ORDER, Instrument
from arcless.storage.csv_files import Column, write_csv

if TYPE_CHECKING:
    from arcless.model import Scenario

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Readings:
    """Channels of a test run at equal time steps.

    Attributes
    ----------
    pantograph
        Name of the pantograph where the run has several, which columns begin with; else empty.
    instrument
        The sensors.
    mass_above_kg
        Mass above the force sensors in kg.
    time_s, position_m, speed_m_s
        Time in s, what the odometer shows in m, and the speed in m/s.
    force_N
        Sum of the force sensors in N: not the contact force, as the inertia above is missing.
    acceleration_m_s2
        Vertical acceleration of the strips in m/s², upwards positive.
    height_m
        Height of the strips above rail in m.
    clipped
        Samples of the force that are beyond the range of the sensors.
    delay_s
        What the amplifier delays force, acceleration and height by, in s: they belong to where the
        train was so long before.
    """

    pantograph: str
    instrument: Instrument
    mass_above_kg: float
    time_s: Floats
    position_m: Floats
    speed_m_s: Floats
    force_N: Floats
    acceleration_m_s2: Floats
    height_m: Floats
    clipped: int
    delay_s: float

    def columns(self) -> list[Column]:
        """Return the channels as columns with units, such as ``P2.sensor_force [N]``."""
        of = f"{self.pantograph}." if self.pantograph else ""
        return [
            Column("time", "s", self.time_s),
            Column(f"{of}position", "m", self.position_m),
            Column("speed", "m/s", self.speed_m_s),
            Column(f"{of}sensor_force", "N", self.force_N),
            Column(f"{of}acceleration", "m/s2", self.acceleration_m_s2),
            Column(f"{of}contact_height", "m", self.height_m),
        ]

    def save(self, path: str | Path) -> None:
        """Write the channels as a CSV file; one that exists is replaced.

        Raises
        ------
        OutputError
            The file cannot be written.
        """
        write_csv(path, self.columns())


def read_off(
    dataset: Any, scenario: "Scenario", instrument: Instrument, pantograph: str | None = None
) -> Readings:
    """Return a run as an instrumented pantograph would have measured it.

    Parameters
    ----------
    dataset
        Of the run.
    scenario
        That was run.
    instrument
        The sensors.
    pantograph
        Name of the pantograph; the first in the direction of travel without.

    Raises
    ------
    ModelError
        There is no such pantograph, or the instrument does not fit it or the record.
    ResultFormatError
        The displacements of the masses were not recorded.
    """
    place = _place(dataset, pantograph)
    model = scenario.pantographs[place].model
    mass = checked_mass(instrument.mass_above_kg, model)
    time = dataset["time"].values
    rate = sample_rate_Hz(time)
    _check_rates(instrument, rate)
    at = _sample_times(time, instrument.rate_Hz)

    def sampled(values: Floats) -> Floats:
        return np.interp(at, time, values)

    acceleration = head_acceleration(dataset, place, model)
    force = dataset["contact_force"].values[:, place] + mass * acceleration - instrument.lift_N
    # The strips hang below the wire by the gap where contact is lost.
    height = dataset["contact_height"].values[:, place] - dataset["contact_gap"].values[:, place]
    slow = [
        sampled(_amplified(values, rate, instrument.cutoff_Hz))
        for values in (force, acceleration, height)
    ]
    noise = np.random.default_rng(int(instrument.seed))
    spreads = (
        instrument.force_noise_N, instrument.acceleration_noise_m_s2, instrument.height_noise_m,
    )  # fmt: skip
    noisy = [
        values + spread * noise.standard_normal(at.size)
        for values, spread in zip(slow, spreads, strict=True)
    ]
    digits, clipped = _digitised(noisy[0], instrument)
    true = sampled(dataset["position"].values[:, place])
    shown = true + instrument.position_offset_m + instrument.odometer_drift * (true - true[0])
    names = [str(name) for name in dataset["pantograph"].values]
    name = names[place] if len(names) > 1 else ""
    return Readings(
        name, instrument, mass, at, shown, sampled(dataset["speed"].values), digits, noisy[1],
        noisy[2], clipped, instrument.delay_s(rate),
    )  # fmt: skip


def _place(dataset: Any, pantograph: str | None) -> int:
    names = [str(name) for name in dataset["pantograph"].values]
    if pantograph is None:
        return 0
    if pantograph not in names:
        expected = f"one of {', '.join(names)}"
        raise ModelError("no such pantograph", got=f'"{pantograph}"', expected=expected)
    return names.index(pantograph)


def _check_rates(instrument: Instrument, rate_Hz: float) -> None:
    """Refuse an instrument that is faster than the record it reads from."""
    hint = "record contact channels more often: output.contact_every"
    if instrument.rate_Hz > rate_Hz * (1.0 + 1e-9):  # rounding of the record's times
        expected = f"at most the recording rate of {rate_Hz:g} Hz"
        raise ModelError("rate_Hz", got=f"{instrument.rate_Hz:g} Hz", expected=expected, hint=hint)
    if not instrument.cutoff_Hz < 0.5 * rate_Hz:
        got, expected = f"{instrument.cutoff_Hz:g} Hz", f"below half the rate of {rate_Hz:g} Hz"
        raise ModelError("low_pass_Hz", got=got, expected=expected, hint=hint)


def _sample_times(time: Floats, rate_Hz: float) -> Floats:
    """Return times from the first of the record on, not beyond its last."""
    steps = int(np.floor((time[-1] - time[0]) * rate_Hz * (1.0 + 1e-12)))
    found: Floats = np.minimum(time[0] + np.arange(steps + 1) / rate_Hz, time[-1])
    return found


def _amplified(values: Floats, rate_Hz: float, cutoff_Hz: float) -> Floats:
    """Return a channel behind the amplifier, which was at rest at the first value."""
    from scipy.signal import butter, sosfilt, sosfilt_zi

    cascade = butter(ORDER, cutoff_Hz, fs=rate_Hz, output="sos")
    found, _ = sosfilt(cascade, values, zi=sosfilt_zi(cascade) * values[0])
    return np.asarray(found, dtype=np.float64)


def _digitised(force: Floats, instrument: Instrument) -> tuple[Floats, int]:
    """Return the force cut to the range and rounded to the resolution, and how many were cut."""
    inside = np.clip(force, instrument.force_min_N, instrument.force_max_N)
    clipped = int(np.count_nonzero(inside != force))
    if instrument.force_resolution_N > 0.0:
        inside = instrument.force_resolution_N * np.round(inside / instrument.force_resolution_N)
    return inside, clipped
