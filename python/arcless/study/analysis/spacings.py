"""Rows of a study over the distance of two pantographs, as curves with a worst and a best one."""

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.study.definition.quantities import WORST, is_number, owner_of_key
from arcless.study.definition.study import Study
from arcless.study.journal.row import Row
from arcless.study.variables.variables import Axis

Floats = NDArray[np.float64]
DEVIATION = "std_force_N"
# Fewer distances have no curve.
LEAST = 3


@dataclass(frozen=True)
class SpacingCurve:
    """Standard deviation of a pantograph's force over its distance to the one before it.

    Attributes
    ----------
    output
        Name of the output.
    others
        Values of the study's other variables in SI, the same along the curve.
    spacings
        In m, ascending.
    values
        In N.
    leading
        Of the leading pantograph in N; None where it is no output.
    """

    output: str
    others: dict[str, Any]
    spacings: Floats
    values: Floats
    leading: Floats | None

    def to_dict(self) -> dict[str, Any]:
        """Return the worst and the best spacing as plain values."""
        found: dict[str, Any] = {"output": self.output, "others": self.others}
        for name, place in (("worst", self.worst), ("best", self.best)):
            found[f"{name}_spacing_m"] = float(self.spacings[place])
            found[f"{name}_std_force_N"] = float(self.values[place])
        return found

    @property
    def worst(self) -> int:
        """Place of the highest value."""
        return int(np.argmax(self.values))

    @property
    def best(self) -> int:
        """Place of the lowest value."""
        return int(np.argmin(self.values))


def spacing_axis(study: Study) -> Axis | None:
    """Return the variable that is the distance of the second pantograph; None without one."""
    for axis in study.axes:
        levels = axis.levels or ()
        if re.fullmatch(r"pantographs\.1\.distance", axis.field) and all(map(is_number, levels)):
            return axis
    return None


def spacing_curves(study: Study, rows: Iterable[Row]) -> list[SpacingCurve]:
    """Return a curve over the distance for each combination of the other variables' values.

    Parameters
    ----------
    study
        A study; one that varies no distance of the second pantograph, or has no standard deviation
        of a pantograph that is not the leading one alone, has no curves.
    rows
        Its rows.
    """
    axis, names = spacing_axis(study), _outputs(study)
    if axis is None or names is None:
        return []
    behind, leading = names
    groups: dict[str, list[tuple[float, float, float]]] = {}
    others: dict[str, dict[str, Any]] = {}
    for row in rows:
        value = row.outputs.get(behind) if row.status == "done" else None
        if value is None:
            continue
        rest = {name: given for name, given in row.values.items() if name != axis.name}
        key = json.dumps(rest, sort_keys=True, default=str)
        others[key] = rest
        first = row.outputs.get(leading) if leading is not None else None
        point = float(row.values[axis.name]), value, np.nan if first is None else first
        groups.setdefault(key, []).append(point)
    made = []
    for key, points in groups.items():
        spacings, values, first_values = np.array(sorted(points)).T
        if len(np.unique(spacings)) < max(LEAST, len(spacings)):
            continue
        known = bool(np.isfinite(first_values).all())
        made.append(
            SpacingCurve(behind, others[key], spacings, values, first_values if known else None)
        )
    return made


def _outputs(study: Study) -> tuple[str, str | None] | None:
    """Return the outputs of the trailing, or the worst, and of the leading pantograph, by name."""
    owners: dict[Any, str] = {}
    for name, output in study.outputs.items():
        key = output.expression.strip()
        if key.rpartition(".")[2] == DEVIATION:
            owners.setdefault(owner_of_key(key, study.base), name)
    behind = owners.get(1, owners.get(WORST))
    return None if behind is None else (behind, owners.get(0))
