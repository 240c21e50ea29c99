"""Data that every figure needs, computed once."""

import json
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess import Assessment
from arcless.assess.section import ForceRecord, force_record
from arcless.report.drawing.bokeh_objects import Model

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset


@dataclass(frozen=True)
class RunData:
    """Result and assessment of a run, ready to be drawn."""

    dataset: "Dataset"
    assessment: Assessment

    @cached_property
    def record(self) -> ForceRecord:
        """Filtered forces of the whole record."""
        a = self.assessment
        begin, end = a.section_m
        return force_record(self.dataset, (begin, end), a.low_pass_Hz, a.band_split_Hz)

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
    def track(self) -> Any:
        """The position axis that the figures along the track share."""
        position = self.dataset["position"].values
        begin, end = float(position[0].min()), float(position[-1].max())
        margin = 0.01 * (end - begin)
        line = self.values("support_x")
        bounds = (
            min(begin, *(line[:1])) - margin if line.size else begin - margin,
            max(end, *(line[-1:])) + margin if line.size else end + margin,
        )
        return Model("Range1d", start=begin - margin, end=end + margin, bounds=bounds)

    @cached_property
    def line_position(self) -> NDArray[np.float64]:
        """Position in m of the first pantograph at the times of the line channels."""
        front: NDArray[np.float64] = np.interp(
            self.values("line_time"),
            self.values("time"),
            self.dataset["position"].values[:, 0],
        )
        return front

    def has(self, *names: str) -> bool:
        """Say whether the dataset holds all these variables."""
        return all(name in self.dataset for name in names)

    def values(self, name: str) -> NDArray[Any]:
        """Return a variable's values, empty if the dataset does not hold it."""
        values: NDArray[Any] = self.dataset[name].values if self.has(name) else np.empty(0)
        return values

    def inside(self, x: NDArray[np.float64]) -> NDArray[np.intp]:
        """Return the indices of the positions inside the section."""
        begin, end = self.assessment.section_m
        return np.flatnonzero((x >= begin) & (x <= end))
