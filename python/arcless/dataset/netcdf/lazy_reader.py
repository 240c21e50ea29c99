"""A result file as arrays by name, each read when it is first asked for.

An assessment or a report needs a tenth of what a long run has written. Read here because xarray
takes a second to import, and looks every variable up by its path.

Source: NetCDF-4 File Format Specification, Unidata (dimension scales and their names).
"""

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import h5py

    from arcless.dataset.build import Entry

# All columns of a variable.
ALL = slice(None)
# Attributes that HDF5 and NetCDF keep on a variable for themselves.
OWN = frozenset({"CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST", "_FillValue"})
# Name of the scale of a dimension that has no coordinate.
NO_VARIABLE = "This is a netCDF dimension but not a netCDF variable"


class LazyVariables(Mapping[str, "Entry"]):
    """Dimensions, values and attributes of variables by name; an array stays once it was read.

    Parameters
    ----------
    variables
        Name → the variable in a file that is open as long as this lives.
    guard
        Called to read columns of a variable; raises what the caller wants of the library's errors.
    """

    def __init__(
        self,
        variables: Mapping[str, "h5py.Dataset"],
        guard: "Callable[[h5py.Dataset, slice], Entry]",
    ) -> None:
        self._variables, self._guard = dict(variables), guard
        self._known: dict[str, Entry] = {}

    def __getitem__(self, name: str) -> "Entry":
        if name not in self._known:
            self._known[name] = self._guard(self._variables[name], ALL)
        return self._known[name]

    def columns(self, name: str, which: slice) -> NDArray[Any]:
        """Return some columns of a variable of two dimensions; they are not kept."""
        if name in self._known:
            return self._known[name][1][:, which]
        return self._guard(self._variables[name], which)[1]

    def __contains__(self, name: object) -> bool:
        return name in self._variables

    def __iter__(self) -> Iterator[str]:
        return iter(self._variables)

    def __len__(self) -> int:
        return len(self._variables)

    @property
    def read_bytes(self) -> int:
        """Memory in bytes of the arrays that were read so far."""
        return sum(values.nbytes for _, values, _ in list(self._known.values()))

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the content of the file: an open file cannot travel."""
        return dict, (dict(self),)


def split(file: "h5py.File") -> tuple[dict[str, "h5py.Dataset"], dict[str, "h5py.Dataset"]]:
    """Return the variables of a file, and its coordinates."""
    found = {str(name): file[name] for name in file}
    coords = {
        name: variable
        for name, variable in found.items()
        if variable.attrs.get("CLASS") == b"DIMENSION_SCALE"
    }
    data = {name: variable for name, variable in found.items() if name not in coords}
    with_values = {
        name: variable
        for name, variable in coords.items()
        if not _text(variable.attrs.get("NAME", b"")).startswith(NO_VARIABLE)
    }
    return data, with_values


def entry(variable: "h5py.Dataset", columns: slice = ALL) -> "Entry":
    """Read a variable, or some of its columns: its dimensions, values and attributes."""
    import h5py

    name = variable.name.rpartition("/")[2]
    is_scale = variable.attrs.get("CLASS") == b"DIMENSION_SCALE"
    dims = (name,) if is_scale else tuple(_dimension(scales) for scales in variable.dims)
    text = h5py.check_string_dtype(variable.dtype) is not None
    values = variable.asstr()[()].astype(str) if text else _values(variable, columns)
    notes = variable.attrs.items()
    return dims, values, {k: plain(v) for k, v in notes if k not in OWN and not _is_internal(k)}


def _values(variable: "h5py.Dataset", columns: slice) -> NDArray[Any]:
    values: NDArray[Any] = variable[()] if columns == ALL else variable[:, columns]
    return values


def _dimension(scales: Any) -> str:
    name: str = scales[0].name.rpartition("/")[2]
    return name


def _is_internal(name: str) -> bool:
    return name.startswith("_Netcdf4")


def attributes(file: "h5py.File") -> dict[str, Any]:
    """Read the attributes of the whole."""
    return {name: plain(value) for name, value in file.attrs.items() if not name.startswith("_NC")}


def plain(value: Any) -> Any:
    """Return an attribute as text or, where it is one number in a list, as a number."""
    if isinstance(value, bytes):
        return _text(value)
    if isinstance(value, np.ndarray) and value.size == 1:
        return plain(value.reshape(-1)[0])
    return value


def _text(value: Any) -> str:
    return value.decode("utf-8", errors="replace") if isinstance(value, bytes) else str(value)
