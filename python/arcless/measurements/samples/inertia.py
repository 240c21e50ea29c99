"""Contact force from sensors below the collector strips.

What is above the sensors has the mass m and the upward acceleration a. The sensors push it up with
F_s (zero at rest without contact: its weight is tared away), the air with F_a, and the wire pushes
it down with the contact force F_c. Newton's law of it is m a = ΣF_s + F_a − F_c, so

    F_c = Σ F_s − m a + F_a,        F_a constant, or k v²

EN 50317 asks for this correction, and GB/T 32592, 6.3 and 6.4 (from memory and from its contents
list: mark C). Where it is written with + m a, a is counted downwards.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.errors import MeasurementError, ModelError
from arcless.units import accepted, show, to_si

Floats = NDArray[np.float64]

# A head stays at its height, so its mean acceleration is zero over any record; a sensor that shows
# gravity has 9.81. In m/s²: lower refuses the offset of a sensor, which shifts the mean force by it
# times the mass; higher lets a wrong tare through.
LARGEST_MEAN_ACCELERATION = 1.0


@dataclass(frozen=True)
class Head:
    """Parts of a collector head above the sensors.

    Attributes
    ----------
    mass
        m, in kg.
    lift
        F_a upwards, in N; at any speed.
    lift_per_speed_squared
        k, in N/(m/s)².
    acceleration_down
        True where the channels count the acceleration positive downwards.
    """

    mass: float
    lift: float = 0.0
    lift_per_speed_squared: float = 0.0
    acceleration_down: bool = False

    @classmethod
    def of(
        cls, mass: float | str, lift: float | str | None = None, *, acceleration_down: bool = False
    ) -> "Head":
        """Return a head from amounts with units: its mass, and its lift in N or N/(m/s)².

        Raises
        ------
        ModelError
            An amount is no number, has another unit, or the mass is not above zero.
        """
        kilograms = to_si(mass, "kg")
        if kilograms <= 0.0:
            raise ModelError("mass above the sensors", got=show(mass), expected="more than 0")
        try:
            newton = 0.0 if lift is None else to_si(lift, "N")
            return cls(kilograms, newton, acceleration_down=acceleration_down)
        except ModelError:
            try:
                k = to_si(lift, "N/(m/s)2")
            except ModelError as error:
                error.expected = f"{accepted('N')} or {accepted('N/(m/s)2')}"
                raise
            return cls(kilograms, 0.0, k, acceleration_down)

    @property
    def words(self) -> str:
        """The correction in words."""
        parts = [f"the inertia of {self.mass:g} kg above the sensors is taken off"]
        if self.lift:
            parts.append(f"a lift of {self.lift:g} N is added")
        if self.lift_per_speed_squared:
            parts.append(f"a lift of {self.lift_per_speed_squared:g} N/(m/s)² times v² is added")
        return ", ".join(parts)


def contact_force(
    sensors: Sequence[Floats],
    acceleration: Floats | None = None,
    speed: Floats | float = 0.0,
    head: Head | None = None,
) -> Floats:
    """Return the contact force F_c in N.

    Parameters
    ----------
    sensors
        F_s of each sensor in N, positive when the strips press on it; at least one.
    acceleration
        a in m/s², the mean over the channels; needed with a head.
    speed
        v in m/s.
    head
        What is above the sensors; None returns the sum of the sensors.
    """
    total: Floats = np.sum(np.stack(sensors), axis=0)
    if head is None:
        return total
    assert acceleration is not None
    upwards = -acceleration if head.acceleration_down else acceleration
    lift = head.lift + head.lift_per_speed_squared * np.square(speed)
    return total - head.mass * upwards + lift


def check_mean(acceleration: Floats, where: str) -> None:
    """Refuse an acceleration whose mean is not zero.

    Raises
    ------
    MeasurementError
        Gravity, or a large offset, is in the channel.
    """
    finite = acceleration[np.isfinite(acceleration)]
    mean = float(finite.mean()) if finite.size else 0.0
    if abs(mean) > LARGEST_MEAN_ACCELERATION:
        raise MeasurementError(
            "mean acceleration of the collector head",
            where=where,
            got=f"{mean:.2f} m/s²",
            expected=f"within ± {LARGEST_MEAN_ACCELERATION:g} m/s²",
            hint="take gravity and the sensor's offset off the channel",
        )
