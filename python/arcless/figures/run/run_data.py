"""Data that every figure of a run needs, computed once."""

import json
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess import Assessment, Criterion
from arcless.assess.section import ForceRecord, force_record
from arcless.errors import ExplanationError
from arcless.explanation import Explanation, explain
from arcless.model import load

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

Floats = NDArray[np.float64]

# Samples of a filtered channel in a period of the low-pass: straight pieces between them leave out
# 1 - cos(π/16) = 1.9 % of a wave at that frequency. Long runs have fewer, down to the second, which
# the sampling theorem allows; where even these are too many for a file, only extremes are drawn.
SAMPLES_A_PERIOD, LEAST_A_PERIOD = 16.0, 2.5
# Samples of all pantographs together: usual, and most.
USUAL_SAMPLES, MOST_SAMPLES = 14_000, 36_000


@dataclass(frozen=True)
class Sampled:
    """Samples of a run at equal steps of time, as figures draw filtered channels.

    Attributes
    ----------
    rows
        Indices in the record.
    x, t
        Position of the pantograph in m, and time in s.
    """

    rows: NDArray[np.intp]
    x: Floats
    t: Floats


@dataclass(frozen=True)
class RunData:
    """Result and assessment of a run, ready to be drawn.

    Attributes
    ----------
    dataset, assessment
        The run.
    whole
        True for curves of all samples, where the medium thins them to what it shows.
    """

    dataset: "Dataset"
    assessment: Assessment
    whole: bool = False

    @cached_property
    def record(self) -> ForceRecord:
        """Filtered forces of the whole record."""
        a = self.assessment
        begin, end = a.section_m
        return force_record(self.dataset, (begin, end), a.low_pass_Hz, a.band_split_Hz)

    @cached_property
    def explanation(self) -> Explanation | None:
        """Explanation of σ; None where the section is too short for one, or a force constant."""
        scenario = load(json.loads(self.dataset.attrs["scenario"]))
        try:
            return explain(self.dataset, self.assessment, scenario)
        except ExplanationError:
            return None

    @cached_property
    def pantographs(self) -> list[str]:
        """Names of the pantographs."""
        return [str(name) for name in self.dataset["pantograph"].values]

    @cached_property
    def has_droppers(self) -> bool:
        """True when the line has droppers."""
        return self.values("dropper").size > 0

    @cached_property
    def rigid_contact(self) -> bool:
        """True when strip and wire touch without a compliance between them."""
        law: str = json.loads(self.dataset.attrs["scenario"])["contact"]["law"]
        return law == "rigid"

    @cached_property
    def time(self) -> Floats:
        """Times of the record in s."""
        return self.values("time")

    @cached_property
    def position(self) -> Floats:
        """Positions of the pantographs in m, (time, pantograph)."""
        found: Floats = self.dataset["position"].values
        return found

    @cached_property
    def supports(self) -> Floats:
        """Positions of the supports in m, each once."""
        return np.unique(self.values("support_x"))

    @cached_property
    def line_position(self) -> Floats:
        """Position in m of the first pantograph at the times of the line channels."""
        front: Floats = np.interp(self.values("line_time"), self.time, self.position[:, 0])
        return front

    @cached_property
    def sampled(self) -> list[Sampled] | None:
        """Samples of each pantograph, enough for channels that the low-pass has filtered.

        None for a run so long that they are too many for a file.
        """
        per_period = self.record.rate_Hz / self.assessment.low_pass_Hz
        count = self.time.size
        usual, most = (
            whole // max(2, len(self.pantographs)) for whole in (USUAL_SAMPLES, MOST_SAMPLES)
        )
        stride = max(per_period / SAMPLES_A_PERIOD, count / usual)
        rows = np.arange(0, count, max(1, int(min(stride, per_period / LEAST_A_PERIOD))))
        if rows.size > 2 * most and not self.whole:
            return None
        return [
            Sampled(rows, self.position[rows, i], self.time[rows])
            for i in range(len(self.pantographs))
        ]

    def left_out(self, _pantograph: int) -> list[tuple[float, float]]:
        """Return stretches of the section in m that numbers leave out; none of a simulated run."""
        return []

    def stretches(self, pantograph: int) -> list[Floats]:
        """Return the unfiltered force in N inside the section, one for each part without a gap."""
        return [self.record.force[self.record.inside[:, pantograph], pantograph]]

    def has(self, *names: str) -> bool:
        """Say whether the dataset holds all these variables."""
        return all(name in self.dataset for name in names)

    def values(self, name: str) -> NDArray[Any]:
        """Return a variable's values, empty if the dataset does not hold it."""
        values: NDArray[Any] = self.dataset[name].values if self.has(name) else np.empty(0)
        return values

    def inside(self, x: Floats) -> NDArray[np.intp]:
        """Return the indices of the positions inside the section."""
        begin, end = self.assessment.section_m
        return np.flatnonzero((x >= begin) & (x <= end))

    def criterion(self, name: str, pantograph: int | None = None) -> Criterion | None:
        """Return the criterion of this name, of a pantograph or of the run; None for none."""
        wanted = None if pantograph is None else self.pantographs[pantograph]
        for one in self.assessment.criteria:
            if one.name == name and one.pantograph == wanted:
                return one
        return None

    def limit(self, name: str, pantograph: int | None = None) -> float | None:
        """Return the limit of a criterion; None where there is none."""
        found = self.criterion(name, pantograph)
        return None if found is None else found.limit
