"""A dataset without xarray, whose import takes longer than a run.

What `arcless run` does with a record, assessing and saving, needs its arrays by name. It becomes an
xarray dataset when somebody asks for one.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.build import Described, Entry, attributes, check_complete, variables

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Column:
    """One variable or coordinate: its dimensions, values, and `units` and `long_name`."""

    dims: tuple[str, ...]
    values: NDArray[Any]
    attrs: dict[str, str]


class Plain:
    """Variables and coordinates by name, read like those of an xarray dataset.

    Attributes
    ----------
    attrs
        Attributes of the whole, as they are stored.
    """

    def __init__(
        self, data: Mapping[str, Entry], coords: Mapping[str, Entry], attrs: dict[str, Any]
    ) -> None:
        self._data, self._coords, self.attrs = data, coords, attrs

    def __contains__(self, name: object) -> bool:
        return name in self._data or name in self._coords

    def __getitem__(self, name: str) -> Column:
        """Return a variable or a coordinate."""
        return Column(*(self._data if name in self._data else self._coords)[name])

    @classmethod
    def of(
        cls,
        record: Mapping[str, Any],
        names: Mapping[str, Any],
        static: Mapping[str, Any],
        attrs: Mapping[str, Any],
    ) -> "Plain":
        """Build the dataset of a run from what `dataset_from` takes.

        Raises
        ------
        ResultFormatError
            As there.
        """
        described = variables({**static, **record}, names)
        check_complete({**static, **record})
        return cls(*described, attributes(attrs))

    def __iter__(self) -> Iterator[str]:
        """Go through the names of variables and coordinates; none is read."""
        return iter([*self._data, *self._coords])

    def columns(self, name: str, which: slice) -> NDArray[Any]:
        """Return some columns of a variable of two dimensions; of a file no others are read."""
        of_file = getattr(self._data, "columns", None)
        found: NDArray[Any] = (
            self._data[name][1][:, which] if of_file is None else of_file(name, which)
        )
        return found

    @property
    def dims(self) -> list[str]:
        """Names of the dimensions, which are those of the coordinates."""
        return list(self._coords)

    @property
    def variables(self) -> Described:
        """Variables and coordinates: dimensions, values, units and meaning."""
        return {**self._data, **self._coords}

    @property
    def read_bytes(self) -> int:
        """Memory in bytes of arrays, of a file only those that were read so far."""
        found = 0
        for part in (self._data, self._coords):
            known = getattr(part, "read_bytes", None)
            found += sum(one[1].nbytes for one in part.values()) if known is None else known
        return found

    def dataset(self) -> "xarray.Dataset":
        """Return an xarray dataset with the variables and attributes; arrays are shared."""
        import xarray

        return xarray.Dataset(dict(self._data), dict(self._coords), self.attrs)


def dataset_from(
    record: Mapping[str, Any],
    names: Mapping[str, Any],
    static: Mapping[str, Any],
    attrs: Mapping[str, Any],
) -> "xarray.Dataset":
    """Build the dataset of a run.

    Parameters
    ----------
    record
        Variable name → array, the channels of the run and their extremes. SI units.
    names
        Dimension name → its labels (times in s, names, positions in m). Dimensions that only
        count (``mass``, nodes, ``mode``) may be left out: they are numbered from 1.
    static
        Variable name → array, the initial configuration. SI units.
    attrs
        Attributes; lists and dictionaries become JSON text, ``None`` is left out.

    Returns
    -------
    xarray.Dataset
        With ``units`` and ``long_name`` on every variable.

    Raises
    ------
    ResultFormatError
        A name is unknown, a required one missing, a shape does not fit its dimensions, or a
        value is not finite.

    Notes
    -----
    Variables along a dimension of size zero (a line without droppers, no recorded points) are
    left out: NetCDF has no empty dimension that keeps its size.
    """
    return Plain.of(record, names, static, attrs).dataset()


Dataset: TypeAlias = "xarray.Dataset | Plain"


def columns_of(dataset: Dataset, name: str, which: slice) -> NDArray[Any]:
    """Return some columns of a variable of two dimensions."""
    if isinstance(dataset, Plain):
        return dataset.columns(name, which)
    return np.asarray(dataset[name].values[:, which])
