"""A dataset without xarray, whose import takes longer than a run.

What `arcless run` does with a record, assessing and saving, needs its arrays by name. It becomes an
xarray dataset when somebody asks for one.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from arcless.results.build import Described

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

    def __init__(self, data: Described, coords: Described, attrs: dict[str, Any]) -> None:
        self._data, self._coords, self.attrs = data, coords, attrs

    def __contains__(self, name: object) -> bool:
        return name in self._data or name in self._coords

    def __getitem__(self, name: str) -> Column:
        """Return a variable or a coordinate."""
        return Column(*(self._data if name in self._data else self._coords)[name])

    @property
    def variables(self) -> Described:
        """Variables and coordinates: dimensions, values, units and meaning."""
        return {**self._data, **self._coords}

    def dataset(self) -> "xarray.Dataset":
        """Return the same as an xarray dataset; arrays are shared."""
        import xarray

        return xarray.Dataset(self._data, self._coords, self.attrs)
