"""A result file written piece by piece during the run.

The file has its final sizes from the first piece on; each piece fills the next rows of the series.
It is the dataset that `save` writes, value for value; only how it is compressed differs.
"""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from types import TracebackType
from typing import Any, BinaryIO, Self

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.build import Described, attributes, check_complete, variables
from arcless.dataset.netcdf import checksum
from arcless.dataset.netcdf.error_keeping_file import ErrorKeepingFile
from arcless.dataset.netcdf.netcdf_file import IN_PIECES, NetcdfFile
from arcless.errors import ResultFormatError


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
        self._disk = ErrorKeepingFile(file)
        self._rows, self._names = dict(rows), dict(names)
        self._done = dict.fromkeys(rows, 0)
        self._last = dict.fromkeys(rows, -np.inf)
        self._netcdf = NetcdfFile(self._disk, IN_PIECES)

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
            for name, entry in {**series, **data}.items():
                (dim, *_), values, _ = entry
                if name not in self._netcdf.names:
                    self._netcdf.add(name, entry, self._rows[dim])
                self._netcdf.fill(name, self._done[dim], values)
        for dim, (_, times, _) in series.items():
            self._done[dim] += len(times)

    def finish(self, static: Mapping[str, Any], attrs: Mapping[str, Any]) -> None:
        """Write the variables that are no series, and the attributes; append the checksum.

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
        check_complete({*static, *self._netcdf.names})
        data, coords = variables(static, self._names)
        texts = attributes(attrs)
        with self._on_disk():
            self._whole({**data, **coords})
            self._netcdf.finish(texts)
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
            self._netcdf.close()

    @contextmanager
    def _on_disk(self) -> Iterator[None]:
        """Raise the error of the disk before the one that HDF5 makes of it."""
        try:
            yield
        finally:
            self._disk.check()

    def _whole(self, described: Described) -> None:
        """Write the variables that are no series, if they are not there yet."""
        for name, entry in described.items():
            if name not in self._netcdf.names:
                self._netcdf.add(name, entry)

    def _follow(self, dim: str, times: NDArray[Any]) -> None:
        """Take note of the labels of the next rows, which must lie after those before."""
        if self._done[dim] + len(times) > self._rows[dim]:
            raise ResultFormatError("the record of the run has too many rows", where=dim)
        if len(times) and not times[0] > self._last[dim]:
            raise ResultFormatError("a coordinate does not increase", where=dim)
        self._last[dim] = float(times[-1]) if len(times) else self._last[dim]
