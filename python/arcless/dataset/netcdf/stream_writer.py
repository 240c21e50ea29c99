"""A result file written piece by piece while the run goes on.

The file has its final sizes from the first piece on; each piece fills the next rows of the series.
It is the same dataset as `save` writes, value for value; only the parts of compression differ.
"""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from types import TracebackType
from typing import Any, BinaryIO, Self

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.build import Described, attributes, check_complete, variables
from arcless.dataset.netcdf import checksum
from arcless.dataset.netcdf.error_keeping_file import Disk
from arcless.dataset.netcdf.writer import parts
from arcless.errors import ResultFormatError

# Level 1: of series in pieces as small as level 2 makes them, in two thirds of its time.
COMPRESSION = {"compression": "gzip", "compression_opts": 1, "shuffle": True}


class Writer:
    """Writes series piece by piece, and everything else at the end.

    Parameters
    ----------
    file
        Empty, open for writing and reading; see `arcless.storage.whole_files.replacing`.
    rows
        Dimension → number of rows that all pieces have together.
    names
        Dimension → labels, of those that are not counted, except the dimensions in `rows`.
    """

    def __init__(self, file: BinaryIO, rows: Mapping[str, int], names: Mapping[str, Any]) -> None:
        import h5netcdf

        self._disk = Disk(file)
        self._rows, self._names = dict(rows), dict(names)
        self._done = dict.fromkeys(rows, 0)
        self._last = dict.fromkeys(rows, -np.inf)
        self._h5 = h5netcdf.File(self._disk, "w")
        # Looking a variable up in the file reads all of its attributes.
        self._made: dict[str, Any] = {}

    def append(self, piece: Mapping[str, Any], labels: Mapping[str, Any]) -> None:
        """Write the next rows.

        Parameters
        ----------
        piece
            Series name → array of the next rows, SI units; the same names in each piece.
        labels
            Labels of these rows: times in s, for each dimension of the series.

        Raises
        ------
        ResultFormatError
            As `dataset_from`; or more rows than there is room for.
        OSError
            The file cannot be written.
        """
        data, coords = variables(piece, {**self._names, **labels})
        series = {dim: coords.pop(dim) for dim in self._rows if dim in coords}
        for dim, (_, times, _) in series.items():
            self._follow(dim, times)
        with self._on_disk():
            self._whole(coords)
            for name, (dims, values, meaning) in {**series, **data}.items():
                if name not in self._made:
                    self._create(name, dims, values, meaning)
                first = self._done[dims[0]]
                self._made[name][first : first + len(values)] = values
        for dim, (_, times, _) in series.items():
            self._done[dim] += len(times)

    def finish(self, static: Mapping[str, Any], attrs: Mapping[str, Any]) -> None:
        """Write what is no series, and the attributes; put the checksum behind the file.

        Parameters
        ----------
        static, attrs
            Variables and attributes; see `dataset_from`.

        Raises
        ------
        ResultFormatError
            As `dataset_from`; or rows are missing.
        OSError
            The file cannot be written.
        """
        if self._done != self._rows:
            raise ResultFormatError(
                "the record of the run is incomplete",
                got=f"{self._done} rows",
                expected=f"{self._rows}",
            )
        check_complete({*static, *self._made})
        data, coords = variables(static, self._names)
        texts = attributes(attrs)
        with self._on_disk():
            self._whole({**data, **coords})
            for name, value in texts.items():
                self._h5.attrs[name] = value
            self._h5.close()
        checksum.put(self._disk.file)

    def __enter__(self) -> Self:
        """Begin; there is nothing to do."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Let HDF5 end its work, whatever is still to come of the file."""
        with suppress(OSError, RuntimeError):
            self._h5.close()

    @contextmanager
    def _on_disk(self) -> Iterator[None]:
        """Raise what the disk says before what HDF5 makes of it."""
        try:
            yield
        finally:
            self._disk.check()

    def _whole(self, described: Described) -> None:
        """Write what is no series, if it is not there yet."""
        for name, (dims, values, meaning) in described.items():
            if name not in self._made:
                self._create(name, dims, values, meaning)
                self._made[name][...] = values

    def _follow(self, dim: str, times: NDArray[Any]) -> None:
        """Take note of the labels of the next rows, which must lie after those before."""
        if self._done[dim] + len(times) > self._rows[dim]:
            raise ResultFormatError("the record of the run has too many rows", where=dim)
        if len(times) and not times[0] > self._last[dim]:
            raise ResultFormatError("a coordinate does not increase", where=dim)
        self._last[dim] = float(times[-1]) if len(times) else self._last[dim]

    def _create(
        self, name: str, dims: tuple[str, ...], values: NDArray[Any], meaning: dict[str, str]
    ) -> None:
        import h5py

        shape = tuple(self._rows.get(dim, n) for dim, n in zip(dims, values.shape, strict=True))
        for dim, size in zip(dims, shape, strict=True):
            if dim not in self._h5.dimensions:
                self._h5.dimensions[dim] = size
        options: dict[str, Any] = {"dtype": h5py.string_dtype()}
        if values.dtype.kind != "O":
            options = {"dtype": values.dtype, "chunks": parts(values.shape), **COMPRESSION}
        made = self._h5.create_variable(name, dims, **options)
        made.attrs.update(meaning)
        self._made[name] = made
