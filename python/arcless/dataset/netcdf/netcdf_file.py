"""The NetCDF file of a dataset, written whole or in pieces, without xarray.

NetCDF 4 is HDF5 with conventions: each dimension is a dimension scale, here always its coordinate,
which is attached to every variable that has it, and numbers are attributes of one entry. Written
here because h5netcdf, which looks every variable up by its path a dozen times, takes three times as
long.

Source: NetCDF-4 File Format Specification, Unidata.
"""

from collections.abc import Collection, Mapping
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from arcless.dataset.build import Entry
    from arcless.dataset.netcdf.error_keeping_file import ErrorKeepingFile
    from arcless.dataset.plain_dataset import Plain

# Levels of compression, with byte shuffling. Of a whole file level 2 gains nearly all that level 9
# does, at a fifth of its time; series in pieces are as small by level 1, in two thirds of its time.
WHOLE, IN_PIECES = 2, 1
# A part of compression at most this large: HDF5 keeps it in memory whole. In numbers.
LARGEST_PART = 1 << 20
# Variables that a whole file has as they are: packing them takes more than half of the time of a
# whole file, and their digits are noise, which shrinks by a fifth. A long run is packed meanwhile.
AS_THEY_ARE = frozenset({"dropper_force"})
# Variables that any file has as they are. To pack the motion of a run takes longer than the run
# itself and gains a fifth; of 50 km, half, at a third of the time of the run.
NEVER_PACKED = frozenset({"motion_up", "motion_across", "motion_dropper_force"})


class NetcdfFile:
    """A file that is being written.

    Parameters
    ----------
    file
        Empty, open for writing and reading.
    level
        Of compression, `WHOLE` or `IN_PIECES`.
    """

    def __init__(self, file: "BytesIO | ErrorKeepingFile", level: int) -> None:
        import h5py

        self._level = level
        self._unpacked = NEVER_PACKED | (AS_THEY_ARE if level == WHOLE else frozenset())
        self._h5 = h5py.File(file, "w", track_order=True)
        # Looking a variable up in the file reads all of its attributes.
        self._made: dict[str, Any] = {}
        self._dims: dict[str, tuple[str, ...]] = {}

    @property
    def names(self) -> Collection[str]:
        """Names of the variables and coordinates that it has."""
        return self._made.keys()

    def add(self, name: str, entry: "Entry", rows: int | None = None) -> None:
        """Add a variable or coordinate with its values.

        With `rows` it has room for so many along its first dimension, and no values yet.
        """
        import h5py

        dims, given, meaning = entry
        # Words of one length, as a result that was opened has them, HDF5 does not take.
        values = given.astype(object) if given.dtype.kind == "U" else given
        options: dict[str, Any] = {"dtype": values.dtype, "track_order": True}
        if values.dtype.kind == "O":
            options["dtype"] = h5py.string_dtype()
        elif name not in self._unpacked:
            options |= {"chunks": _parts(values.shape), "shuffle": True}
            options |= {"compression": "gzip", "compression_opts": self._level}
        if rows is None:
            options["data"] = values
        else:
            options["shape"] = (rows, *values.shape[1:])
        self._made[name] = self._h5.create_dataset(name, **options)
        self._made[name].attrs.update(meaning)
        self._dims[name] = dims

    def fill(self, name: str, first: int, values: NDArray[Any]) -> None:
        """Write rows of a variable from a row on."""
        self._made[name][first : first + len(values)] = values

    def finish(self, attributes: Mapping[str, Any]) -> None:
        """Tie the dimensions to their variables, write the attributes of the whole, and close."""
        coordinates = [name for name, dims in self._dims.items() if dims == (name,)]
        numbers = {dim: number for number, dim in enumerate(coordinates)}
        for dim in numbers:
            self._made[dim].make_scale(dim)
        for name, variable in self._made.items():
            dims = self._dims[name]
            own = np.array([numbers[dim] for dim in dims], dtype=np.int32)
            variable.attrs["_Netcdf4Coordinates"] = own
            variable.attrs["_Netcdf4Dimid"] = own[0]
            for axis, dim in enumerate(dims if name not in numbers else ()):
                variable.dims[axis].attach_scale(self._made[dim])
        for name, value in attributes.items():
            self._h5.attrs[name] = value if isinstance(value, str) else np.atleast_1d(value)
        self.close()

    def close(self) -> None:
        """Let HDF5 end its work, whatever is still to come of the file."""
        self._h5.close()


def netcdf(dataset: "Plain") -> memoryview:
    """Return a whole file: the variables and attributes that xarray writes, value for value."""
    buffer = BytesIO()
    file = NetcdfFile(buffer, WHOLE)
    for name, entry in dataset.variables.items():
        file.add(name, entry)
    file.finish(dataset.attrs)
    return buffer.getbuffer()


def _parts(shape: tuple[int, ...]) -> tuple[int, ...]:
    """Return the shape of the parts in which an array of a shape, or its first rows, is packed."""
    rows = max(1, LARGEST_PART // int(np.prod(shape[1:])))
    return (min(shape[0], rows), *shape[1:])
