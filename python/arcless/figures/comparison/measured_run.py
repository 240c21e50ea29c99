"""Measured forces, ready to be drawn together with those of runs.

Between two pieces of a record stands a sample without a value, so that curves have a gap there.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from arcless.assess.section import ForceRecord
from arcless.figures.run import RunData
from arcless.figures.run.run_data import MOST_SAMPLES, SAMPLES_A_PERIOD, Floats, Sampled


@dataclass(frozen=True)
class MeasuredRun(RunData):
    """Samples and assessment of a measurement.

    Attributes
    ----------
    measured
        Its forces, (time, pantograph), NaN between pieces.
    times
        Time of each sample in s, (time, pantograph).
    """

    measured: ForceRecord
    times: Floats

    @cached_property
    def record(self) -> ForceRecord:
        """Filtered forces of the whole record."""
        return self.measured

    @cached_property
    def sampled(self) -> list[Sampled] | None:
        """Samples of each pantograph, and all places between pieces."""
        count = self.times.shape[0]
        most = MOST_SAMPLES // max(2, len(self.pantographs))
        per_period = self.record.rate_Hz / self.assessment.low_pass_Hz
        stride = max(1, int(per_period / SAMPLES_A_PERIOD), -(-count // most))
        found = []
        for i in range(len(self.pantographs)):
            apart = np.flatnonzero(np.isnan(self.record.force[:, i]))
            rows = np.union1d(np.arange(0, count, stride), apart)
            found.append(Sampled(rows, self.position[rows, i], self.times[rows, i]))
        return found
