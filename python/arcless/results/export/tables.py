"""Tables of a result: channels over time, droppers, supports, assessment, criteria."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import low_pass, sample_rate_Hz
from arcless.assess.tables import criterion_columns, quantity_columns
from arcless.dataset.recorded_series import series_of
from arcless.dataset.schema import VARIABLES
from arcless.errors import ModelError
from arcless.storage.csv_files import Column

if TYPE_CHECKING:
    from arcless.assess import Assessment
    from arcless.dataset.plain_dataset import Dataset
    from arcless.model import Scenario


FILTERED = "contact_force_filtered"


class Run(Protocol):
    """Parts of a result that are exported."""

    @property
    def scenario(self) -> "Scenario":
        """The scenario that was run."""

    @property
    def latest(self) -> "Dataset":
        """Everything that was recorded."""

    @property
    def metadata(self) -> dict[str, Any]:
        """Attributes of the record as plain values."""

    @property
    def assessment(self) -> "Assessment":
        """Indicators and criteria over the run's own section."""


def filtered_force(data: "Dataset", scenario: "Scenario") -> NDArray[np.float64]:
    """Return the contact force in N after the low-pass of the scenario, (time, pantograph).

    Raises
    ------
    ModelError
        The low-pass does not fit the record.
    """
    rate = sample_rate_Hz(data["time"].values)
    return low_pass(data["contact_force"].values, rate, scenario.analysis.low_pass)


def contact_channels(result: Run) -> list[Column]:
    """Return time, speed and every channel of each pantograph, such as ``P1.contact_force [N]``.

    Channels of single contacts have the name of the contact, those of masses and strips their
    number. Columns without a number are left out.
    """
    data = result.latest
    columns = [Column("time", "s", data["time"].values)]
    columns += [Column("speed", "m/s", data["speed"].values)] if "speed" in data else []
    filtered = filtered_force(data, result.scenario)
    for index, name in enumerate(data["pantograph"].values):
        columns += _of_pantograph(data, str(name), index, filtered[:, index])
    if "contact" in data:
        for index, name in enumerate(data["contact"].values):
            for key in _keys(data, ("time", "contact")):
                values = data[key].values[:, index]
                columns.append(Column(f"{name}.{key}", VARIABLES[key].units, values))
    return columns


def _of_pantograph(data: Any, name: str, index: int, filtered: Any) -> Iterator[Column]:
    yield Column(f"{name}.position", "m", data["position"].values[:, index])
    yield Column(f"{name}.contact_force", "N", data["contact_force"].values[:, index])
    yield Column(f"{name}.{FILTERED}", "N", filtered)
    for key in _keys(data, ("time", "pantograph")):
        if key not in ("position", "contact_force"):
            yield Column(f"{name}.{key}", VARIABLES[key].units, data[key].values[:, index])
    for inner in ("mass", "strip"):
        for key in _keys(data, ("time", "pantograph", inner)):
            values = data[key].values[:, index]
            for place, number in enumerate(data[inner].values):
                # A pantograph with fewer masses than another has columns without a number.
                if not np.isnan(values[:, place]).all():
                    title = f"{name}.{inner}_{number}.{key.removeprefix(f'{inner}_')}"
                    yield Column(title, VARIABLES[key].units, values[:, place])


def _keys(data: Any, dims: tuple[str, ...]) -> list[str]:
    return [key for key, variable in VARIABLES.items() if variable.dims == dims and key in data]


def places(result: Run, place: str) -> list[Column]:
    """Return what is known of each dropper or support, one in a row.

    Parameters
    ----------
    result
        The run.
    place
        "dropper" or "support".
    """
    data = result.latest
    if place not in data:
        return []
    columns = [Column(place, "", [str(name) for name in data[place].values])]
    for key in _keys(data, (place,)):
        if not key.endswith("_order"):
            unit = VARIABLES[key].units
            columns.append(Column(key, "" if unit == "1" else unit, data[key].values))
    return columns


def support_channels(result: Run) -> list[Column]:
    """Return every channel of each support over time, such as ``support 5.support_force [N]``.

    Supports where nothing holds the wire have no column of that. Nothing of a long line, of which a
    row holds only what is near the pantographs.
    """
    data = result.latest
    keys = [key for key in series_of("support") if key in data]
    if not keys:
        return []
    columns = [Column("line_time", "s", data["line_time"].values)]
    for index, name in enumerate(data["support"].values):
        for key in keys:
            values = data[key].values[:, index]
            if not np.isnan(values).all():
                columns.append(Column(f"{name}.{key}", VARIABLES[key].units, values))
    return columns


def assessment(result: Run) -> list[Column]:
    """Return the assessed quantities, one in a row: key, name, unit, pantographs, whole run.

    A run that stopped before its analysis section has a row that says why there are none.
    """
    try:
        found = result.assessment
    except ModelError as error:
        return [Column("not assessed", "", [str(error)])]
    return quantity_columns(found.to_dict())


def criteria(result: Run) -> list[Column]:
    """Return the criteria, one in a row, with value, limit, verdict, reason, source, mark."""
    try:
        found = result.assessment
    except ModelError as error:
        return [Column("not assessed", "", [str(error)])]
    return criterion_columns(found.to_dict())
