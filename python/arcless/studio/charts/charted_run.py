"""A run on the disk as charts need it: its figures with all samples, its series, their pyramids."""

from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ModelError
from arcless.figures.description import Figure
from arcless.figures.run import figures
from arcless.figures.run.run_data import RunData
from arcless.figures.wires.wire_motion import contact_wires
from arcless.figures.wires.wire_velocity import WireMotion
from arcless.results import open as open_result
from arcless.studio.charts.plain.charted import Charted
from arcless.units import show

if TYPE_CHECKING:
    from arcless.explanation import Explanation
    from arcless.results import Result


# Name of the contact force after the low-pass, which no result stores.
FILTERED = "filtered_contact_force"


class ChartedRun(Charted):
    """A run whose series and figures are asked for piece by piece.

    Parameters
    ----------
    file
        Folder of the run, or its file.
    """

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.file = file
        self.result: Result = open_result(file)
        self._series: dict[tuple[str, int], NDArray[np.float64]] = {}

    @cached_property
    def data(self) -> RunData:
        """Data that its figures are made of."""
        return RunData(self.result.recorded, self.result.assessment, whole=True)

    @cached_property
    def figures(self) -> dict[str, list[Figure]]:
        """Its figures by their keys, curves with all samples."""
        return figures(self.data)

    @cached_property
    def motions(self) -> list[WireMotion]:
        """Recorded motion of the contact wires; empty where it was not recorded."""
        return contact_wires(self.data.dataset)

    @cached_property
    def explanation(self) -> "Explanation":
        """Explanation of σ.

        Raises
        ------
        ExplanationError
            The section is too short for one, or a force is constant.
        """
        # That of the figures; where they have none, the error says why.
        return self.data.explanation or self.result.explain()

    def series(self, name: str, column: int) -> NDArray[np.float64]:
        """Return a column of what was recorded over time.

        Raises
        ------
        ModelError
            There is no such series, or no such column.
        """
        with self.lock:
            if (name, column) not in self._series:
                force = self.data.record.bands.total if name == FILTERED else None
                self._series[name, column] = _column(self.result, self.stored(name), column, force)
            return self._series[name, column]

    def places(self, name: str, column: int, x: str) -> NDArray[np.float64]:
        """Return where or when the samples of a series are: position in m, or time in s.

        The position is that of the pantograph of the column, or of the first one for series that
        are of no pantograph.
        """
        dims = self.result.recorded[self.stored(name)].dims
        if x == "time":
            return self.series(str(dims[0]), 0)
        if dims[0] == "line_time":
            with self.lock:
                return self.data.line_position
        return self.series("position", column if "pantograph" in dims else 0)

    def stored(self, name: str) -> str:
        """Return the name in the result of what a series is computed from, mostly its own."""
        return "contact_force" if name == FILTERED else name

    @property
    def bytes(self) -> int:
        """Memory of what was read, of series, curves of figures and pyramids in bytes."""
        arrays = {id(one): one.nbytes for one in list(self._series.values())}
        for group in list(self.__dict__.get("figures", {}).values()):
            for figure in group:
                for layer in figure.layers:
                    arrays |= {id(one): one.nbytes for one in vars(layer).values()
                               if isinstance(one, np.ndarray)}  # fmt: skip
        arrays |= {id(one): one.up.nbytes for one in self.__dict__.get("motions", [])}
        known = getattr(self.result.recorded, "read_bytes", 0)
        return known + sum(arrays.values()) + self.pyramid_bytes


def _column(
    result: "Result", name: str, column: int, instead: NDArray[np.float64] | None = None
) -> NDArray[np.float64]:
    recorded = result.recorded
    dims = recorded[name].dims if name in recorded else ()
    if not dims or dims[0] not in ("time", "line_time"):
        raise ModelError("no series of this run", got=show(name), expected="a recorded channel")
    given = recorded[name].values if instead is None else instead
    values = np.asarray(given, dtype=np.float64)
    table = values.reshape(len(values), -1)
    if not 0 <= column < table.shape[1]:
        raise ModelError(
            f"no such column of {name}", got=str(column), expected=f"0 to {table.shape[1] - 1}"
        )
    return np.ascontiguousarray(table[:, column])
