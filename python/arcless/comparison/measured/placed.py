"""A measurement on the line of a run: placed, and as arrays that figures take."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess import Assessment
from arcless.assess.section import ForceRecord
from arcless.assess.signals.gapped import stretches
from arcless.assess.statistics import ForceBands
from arcless.comparison.alignment import Alignment
from arcless.comparison.measured.signal import Signal, settled
from arcless.dataset.plain_dataset import Plain
from arcless.figures.comparison.measured_run import MeasuredRun
from arcless.measurements import MeasuredPantograph, Measurement
from arcless.measurements.samples.settled import bands

Floats = NDArray[np.float64]
# Channels of a record that are known between two pieces; all others are not.
ALONG = ("time", "position")


@dataclass(frozen=True, eq=False)
class Placed:
    """A measurement whose positions are those of a line.

    Attributes
    ----------
    measurement
        With positions on the line.
    alignments
        Of each pantograph.
    """

    measurement: Measurement
    alignments: tuple[Alignment, ...]

    @classmethod
    def of(cls, measurement: Measurement, alignments: Sequence[Alignment]) -> "Placed":
        """Return a measurement with its positions put on the line."""
        moved = tuple(
            _moved(one, by) for one, by in zip(measurement.pantographs, alignments, strict=True)
        )
        return cls(replace(measurement, pantographs=moved), tuple(alignments))

    def reach_m(self, margin_s: float) -> tuple[float, float]:
        """Return from and to in m where samples of all pantographs count.

        Parameters
        ----------
        margin_s
            Time at the ends of a piece at which samples do not count.
        """
        ends = []
        for one in self.measurement.pantographs:
            counted = one.position[settled(one.force.size, one.pieces, one.rate_Hz, margin_s)]
            if counted.size == 0:
                return np.inf, -np.inf
            ends.append((float(counted[0]), float(counted[-1])))
        return max(begin for begin, _ in ends), min(end for _, end in ends)

    def signal(self, pantograph: int, section_m: tuple[float, float], margin_s: float) -> Signal:
        """Return the force of a pantograph whose samples count inside a section."""
        one = self.measurement.pantographs[pantograph]
        counted = settled(one.force.size, one.pieces, one.rate_Hz, margin_s)
        counted &= (one.position >= section_m[0]) & (one.position <= section_m[1])
        speed = float(one.speed[counted].mean()) if counted.any() else float(one.speed.mean())
        return Signal(one.position, one.force, one.rate_Hz, one.pieces, counted, speed)

    def drawn(
        self,
        assessment: Assessment,
        supports_m: Floats,
        margin_s: float,
        reach_m: tuple[float, float],
    ) -> MeasuredRun:
        """Return the measurement as figures take it.

        Parameters
        ----------
        assessment
            Its assessment over the section that is shown.
        supports_m
            Supports of the line in m.
        margin_s
            Time at the ends of a piece at which samples do not count.
        reach_m
            From and to in m: what was measured beyond is not drawn.
        """
        begin, end = assessment.section_m
        parts = []
        for place, one in enumerate(self.measurement.pantographs):
            filtered = bands(one, assessment.low_pass_Hz, assessment.band_split_Hz)
            counted = self.signal(place, (begin, end), margin_s).counted
            near_end = ~settled(one.force.size, one.pieces, one.rate_Hz, margin_s)
            shown = [
                np.where(near_end, np.nan, band)
                for band in (filtered.total, filtered.low, filtered.high)
            ]
            height = np.full(one.force.size, np.nan) if one.height is None else one.height
            channels = (one.time, one.position, one.force, *shown, counted.astype(np.float64),
                        height)  # fmt: skip
            near = (one.position >= reach_m[0]) & (one.position <= reach_m[1])
            parts.append(_apart(channels, stretches(near, one.pieces)))
        columns = [
            _beside([part[number] for part in parts], held=number < len(ALONG))
            for number in range(len(parts[0]))
        ]
        time, position, force, total, low, high, counts, height = columns
        record = ForceRecord(
            self.measurement.pantographs[0].rate_Hz, force, ForceBands(total, low, high),
            counts == 1.0,
        )  # fmt: skip
        both = ("time", "pantograph")
        channels_of: dict[str, Any] = {
            "position": (both, position, {}), "contact_height": (both, height, {}),
            "support_x": (("support",), supports_m, {}),
        }  # fmt: skip
        names = np.array([one.name for one in self.measurement.pantographs], dtype=object)
        dataset = Plain(channels_of, {"pantograph": (("pantograph",), names, {})}, {})
        return MeasuredRun(dataset, assessment, record, time)


def _moved(one: MeasuredPantograph, by: Alignment) -> MeasuredPantograph:
    places = by.on_line(one.position)
    first, last = (float(end) for end in by.on_line(np.array([one.first_m, one.last_m])))
    return replace(one, position=places, first_m=first, last_m=last)


def _apart(channels: Sequence[Floats], pieces: Sequence[slice]) -> list[Floats]:
    """Return channels with a sample between pieces: NaN, but time and position half-way."""
    found = []
    for number, values in enumerate(channels):
        parts: list[Floats] = []
        for before, piece in zip([None, *pieces[:-1]], pieces, strict=True):
            if before is not None:
                middle = 0.5 * (values[before.stop - 1] + values[piece.start])
                parts.append(np.array([middle if number < len(ALONG) else np.nan]))
            parts.append(values[piece])
        found.append(np.concatenate(parts))
    return found


def _beside(columns: Sequence[Floats], *, held: bool) -> Floats:
    """Return columns as one array, (time, pantograph).

    Shorter ones keep their last value where they are held, and have no values where not.
    """
    longest = max(column.size for column in columns)
    filled = [
        np.concatenate([
            column, np.full(longest - column.size, column[-1] if held else np.nan)
        ])
        for column in columns
    ]  # fmt: skip
    return np.stack(filled, axis=1)
