"""A measurement on the line of a run: placed, and as arrays that figures take."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess import Assessment
from arcless.assess.signals.gapped import stretches
from arcless.assess.statistics import ForceBands
from arcless.comparison.alignment import Alignment
from arcless.comparison.measured.signal import Signal, settled
from arcless.figures.measured import Kept, MeasuredData
from arcless.measurements import MeasuredPantograph, Measurement
from arcless.measurements.samples.settled import bands

Floats = NDArray[np.float64]


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
    ) -> MeasuredData:
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
        kept = []
        for one in self.measurement.pantographs:
            near = _cut(one, reach_m)
            filtered = bands(near, assessment.low_pass_Hz, assessment.band_split_Hz)
            far = settled(near.force.size, near.pieces, near.rate_Hz, margin_s)
            shown = [np.where(far, band, np.nan) for band in (
                filtered.total, filtered.low, filtered.high
            )]  # fmt: skip
            begin, end = assessment.section_m
            inside = far & (near.position >= begin) & (near.position <= end)
            kept.append(Kept(near, ForceBands(*shown), inside))
        return MeasuredData(kept, assessment, supports_m)


def _moved(one: MeasuredPantograph, by: Alignment) -> MeasuredPantograph:
    places = by.on_line(one.position)
    first, last = (float(end) for end in by.on_line(np.array([one.first_m, one.last_m])))
    return replace(one, position=places, first_m=first, last_m=last)


def _cut(one: MeasuredPantograph, reach_m: tuple[float, float]) -> MeasuredPantograph:
    """Return the samples between two places in m."""
    near = (one.position >= reach_m[0]) & (one.position <= reach_m[1])
    if near.all():
        return one
    parts = stretches(near, one.pieces)
    ends = np.cumsum([0, *(part.stop - part.start for part in parts)])
    names = ("time", "position", "speed", "force", "height", "uplift")
    columns: dict[str, Any] = {
        name: np.concatenate([values[part] for part in parts])
        for name in names
        if (values := getattr(one, name)) is not None
    }
    pieces = tuple(slice(int(begin), int(end)) for begin, end in pairwise(ends))
    return replace(one, pieces=pieces, **columns)
