"""A dataset as the bytes of a NetCDF file, without xarray.

NetCDF 4 is HDF5 with conventions: each dimension is a dimension scale, here always its coordinate,
which is attached to every variable that has it, and numbers are attributes of one entry. Written
here because h5netcdf, which looks every variable up by its path a dozen times, takes three times as
long.

Source: NetCDF-4 File Format Specification, Unidata.
"""

from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.plain_dataset import Plain

# Level 2 with byte shuffling gains nearly all that level 9 does, at a fifth of its time.
COMPRESSION = {"compression": "gzip", "compression_opts": 2, "shuffle": True}
# A part of compression at most this large: HDF5 keeps it in memory whole. In numbers.
LARGEST_PART = 1 << 20
# Variables that are written as they are: packing them takes more than half of the time of a whole
# file, and their digits are noise, which shrinks by a fifth.
AS_THEY_ARE = frozenset({"dropper_force"})


def netcdf(dataset: Plain) -> memoryview:
    """Return the file: the same variables and attributes as xarray writes, value for value."""
    import h5py

    buffer = BytesIO()
    with h5py.File(buffer, "w", track_order=True) as file:
        made = {}
        for name, (_, given, meaning) in dataset.variables.items():
            # Words of one length, as a result that was opened has them, HDF5 does not take.
            values = given.astype(object) if given.dtype.kind == "U" else given
            options = {"track_order": True, **_options(name, values)}
            made[name] = file.create_dataset(name, data=values, **options)
            made[name].attrs.update(meaning)
        numbers = {dim: number for number, dim in enumerate(dataset.dims)}
        for dim in numbers:
            made[dim].make_scale(dim)
        for name, variable in made.items():
            dims = dataset[name].dims
            own = np.array([numbers[dim] for dim in dims], dtype=np.int32)
            variable.attrs["_Netcdf4Coordinates"] = own
            variable.attrs["_Netcdf4Dimid"] = own[0]
            for axis, dim in enumerate(dims if name not in numbers else ()):
                variable.dims[axis].attach_scale(made[dim])
        for name, value in dataset.attrs.items():
            file.attrs[name] = value if isinstance(value, str) else np.atleast_1d(value)
    return buffer.getbuffer()


def _options(name: str, values: NDArray[Any]) -> dict[str, Any]:
    import h5py

    if values.dtype.kind == "O":
        return {"dtype": h5py.string_dtype()}
    if name in AS_THEY_ARE:
        return {"dtype": values.dtype}
    return {"dtype": values.dtype, "chunks": parts(values.shape), **COMPRESSION}


def parts(shape: tuple[int, ...]) -> tuple[int, ...]:
    """Return the shape of the parts in which an array of a shape, or its first rows, is packed."""
    rows = max(1, LARGEST_PART // int(np.prod(shape[1:])))
    return (min(shape[0], rows), *shape[1:])
