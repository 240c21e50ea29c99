"""Samples of one pantograph that count."""
# ruff: noqa: N815 - the names carry their units

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.measurements.samples.left_out import LeftOut

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class MeasuredPantograph:
    """Good samples of one pantograph, piece behind piece, all at one time step.

    Between two pieces there is a gap: what was measured there is not known, or wrong. Nothing is
    filled in.

    Attributes
    ----------
    name
        Name of the pantograph; ``P1`` where the columns name none.
    time, position, speed
        In s, m and m/s, for each sample. Times rise; positions rise or fall.
    force
        Contact force in N, unfiltered.
    is_contact_force
        False where it is the sum of sensors below the strips, without the inertia of what is above.
    height, uplift
        Height of the contact point and uplift of the contact wire in m, NaN where a value is
        missing; None where the file has no such column.
    pieces
        Samples of each piece.
    rate_Hz
        Samples in a second, in every piece.
    held
        Samples over which the recorder holds each value; 1 where it does not.
    interpolated
        True where a piece was not equally spaced in time, and was interpolated.
    rounded_s
        Last decimal of the times in the file, where steps differ by it alone; they are then taken
        as equally spaced. 0 where that is not so.
    clock
        Column that samples were taken by: ``time`` or ``position``.
    first_s, last_s, first_m, last_m
        Time and position of the first and the last sample of the file, good or not.
    left_out
        Stretches that were left out, and why.
    """

    name: str
    time: Floats
    position: Floats
    speed: Floats
    force: Floats
    is_contact_force: bool
    height: Floats | None
    uplift: Floats | None
    pieces: tuple[slice, ...]
    rate_Hz: float
    held: int
    interpolated: bool
    rounded_s: float
    clock: str
    first_s: float
    last_s: float
    first_m: float
    last_m: float
    left_out: tuple[LeftOut, ...]

    def __repr__(self) -> str:
        return (
            f"<MeasuredPantograph {self.name}: {self.force.size} samples at {self.rate_Hz:g} Hz,"
            f" {len(self.pieces)} piece{'s' * (len(self.pieces) > 1)}>"
        )

    @property
    def step_s(self) -> float:
        """Time between two samples of a piece, in s."""
        return 1.0 / self.rate_Hz

    @property
    def true_rate_Hz(self) -> float:  # noqa: N802 - the unit is part of the name
        """Rate at which values change, in Hz: lower than `rate_Hz` where each is held."""
        return self.rate_Hz / self.held

    @property
    def spacing_m(self) -> float:
        """Mean distance of two samples along the track, in m."""
        return float(np.mean(self.speed)) * self.held / self.rate_Hz
