"""The instrument of a test run: sensors below the strips, their amplifier, the odometer."""
# ruff: noqa: N815 - the names carry their units

import math
from dataclasses import dataclass, fields

from arcless.errors import ModelError

# Sampling rate where none is given: a sample every 0.20 m at 360 km/h, so that EN 50317's more than
# 200 Hz or every 0.40 m (from memory) is kept at any speed of a train. Lower lets more fold back.
RATE_HZ = 500.0
# Order of the amplifier's low-pass, a Butterworth filter run forwards as real ones are.
ORDER = 4
# Its cut-off as a part of the sampling rate where none is given: at half of the rate a sine is then
# 24 dB down. Higher lets more fold back into the band, lower delays more.
CUTOFF_PART = 0.25
# Delay of that filter at low frequencies times its angular cut-off: the sum of 2 sin θ over its two
# pairs of poles at the angles 22.5° and 67.5°.
DELAY_PART = 2.0 * (math.sin(math.pi / 8.0) + math.sin(3.0 * math.pi / 8.0))
# Numbers that may be zero but not less; the others are above zero, or of any sign.
_NOT_NEGATIVE = (
    "mass_above_kg", "force_noise_N", "force_resolution_N", "acceleration_noise_m_s2",
    "height_noise_m",
)  # fmt: skip
# Part of the path by which an odometer may be wrong: worn wheels and slip are 1 % or so. More lets
# a number that was meant in per cent pass, and the reader of the file refuses positions that are
# further from its speeds.
LARGEST_DRIFT = 0.02
_ANY_SIGN = ("lift_N", "position_offset_m", "odometer_drift", "force_min_N", "force_max_N", "seed")


@dataclass(frozen=True)
class Instrument:
    """Sensors of a test run; without changes they have neither noise nor errors of position.

    Attributes
    ----------
    rate_Hz
        Sampling rate in Hz.
    low_pass_Hz
        Cut-off of the amplifier in Hz, a Butterworth filter of order 4 that delays as it does in
        the train; a quarter of the sampling rate without.
    mass_above_kg
        Mass above the force sensors in kg; without, the whole mass of the strips, or of the last
        mass of a pantograph that has no strips of its own.
    lift_N
        Upward force of the air on what is above the force sensors, in N.
    force_noise_N
        Standard deviation in N of the noise of a sample of the force.
    force_resolution_N
        Step of the force in N; 0 keeps every bit.
    force_min_N, force_max_N
        Ends of the range of the force sensors in N: forces beyond are cut off there.
    acceleration_noise_m_s2
        Standard deviation in m/s² of the noise of a sample of the acceleration.
    height_noise_m
        Standard deviation in m of the noise of a sample of the height.
    position_offset_m
        What the odometer shows too much at the first sample, in m.
    odometer_drift
        What it shows too much for each metre run: 0.001 for a wheel taken for 0.1 % too large.
    seed
        Of the random numbers: the same seed gives the same file.
    """

    rate_Hz: float = RATE_HZ
    low_pass_Hz: float | None = None
    mass_above_kg: float | None = None
    lift_N: float = 0.0
    force_noise_N: float = 0.0
    force_resolution_N: float = 0.0
    force_min_N: float = -math.inf
    force_max_N: float = math.inf
    acceleration_noise_m_s2: float = 0.0
    height_noise_m: float = 0.0
    position_offset_m: float = 0.0
    odometer_drift: float = 0.0
    seed: int = 0

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if value is not None:
                self._check(field.name, float(value))
        if not self.force_min_N < self.force_max_N:
            got = f"{self.force_min_N:g} to {self.force_max_N:g} N"
            raise ModelError("range of the force sensors", got=got, expected="from < to")
        if abs(self.odometer_drift) > LARGEST_DRIFT:
            raise ModelError(
                "odometer_drift", got=f"{self.odometer_drift:g}, that is"
                f" {100.0 * self.odometer_drift:g} %",
                expected=f"from -{100.0 * LARGEST_DRIFT:g} % to {100.0 * LARGEST_DRIFT:g} %",
                hint="a number without a sign is no percentage: write 0.2 %, or 0.002",
            )  # fmt: skip
        if self.seed < 0 or self.seed != int(self.seed):
            raise ModelError("seed", got=f"{self.seed}", expected="a whole number, 0 or more")

    @staticmethod
    def _check(name: str, value: float) -> None:
        infinite = name in ("force_min_N", "force_max_N") and not math.isnan(value)
        if not (math.isfinite(value) or infinite):
            raise ModelError(name, got=f"{value:g}", expected="a finite number")
        if name in _ANY_SIGN:
            return
        if name in _NOT_NEGATIVE and value < 0.0:
            raise ModelError(name, got=f"{value:g}", expected="0 or more")
        if name not in _NOT_NEGATIVE and value <= 0.0:
            raise ModelError(name, got=f"{value:g}", expected="above 0")

    @property
    def cutoff_Hz(self) -> float:  # noqa: N802 - the unit is part of the name
        """Cut-off of the amplifier in Hz, given or not."""
        return CUTOFF_PART * self.rate_Hz if self.low_pass_Hz is None else self.low_pass_Hz

    def delay_s(self, record_rate_Hz: float) -> float:
        """Return the delay in s of the amplifier at frequencies far below its cut-off.

        Parameters
        ----------
        record_rate_Hz
            Rate in Hz of the record that it filters: the bilinear transform moves the poles of the
            digital filter to 2 f_s tan(π f_c/f_s) instead of 2π f_c.
        """
        twice = 2.0 * record_rate_Hz
        return DELAY_PART / (twice * math.tan(math.pi * self.cutoff_Hz / record_rate_Hz))
