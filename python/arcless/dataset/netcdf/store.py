"""Datasets as NetCDF files: saved atomically, checked when opened."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.dataset.build import missing_variables
from arcless.dataset.metadata import metadata
from arcless.dataset.netcdf import checksum, lazy_reader
from arcless.dataset.netcdf.form_checks import check_attributes, check_entry
from arcless.dataset.netcdf.motion_checks import check_motion
from arcless.dataset.netcdf.netcdf_file import WHOLE, netcdf
from arcless.dataset.plain_dataset import Plain
from arcless.dataset.schema import ATTRIBUTES, RESULT_FORMAT
from arcless.errors import ResultFormatError
from arcless.storage.whole_files import write_bytes

if TYPE_CHECKING:
    import xarray

    from arcless.dataset.build import Entry
    from arcless.dataset.plain_dataset import Dataset

COMPRESSION = {"zlib": True, "complevel": WHOLE, "shuffle": True, "_FillValue": None}


# The first bytes of every HDF5 file without a user block, as h5py writes them.
HDF5 = b"\x89HDF\r\n\x1a\n"
# Exceptions of the library for files that are no results. `RuntimeError` has `RecursionError`.
UNREADABLE = (
    OSError, ValueError, KeyError, RuntimeError, TypeError, IndexError, AttributeError, MemoryError,
    OverflowError,
)  # fmt: skip


def save(dataset: "Dataset", path: str | Path) -> None:
    """Save a dataset as NetCDF4: the file is there whole or not at all.

    Parameters
    ----------
    dataset
        As built by `arcless.dataset.plain_dataset.dataset_from`, or the same as `Plain`.
    path
        The file to write, usually ending in ``.nc``; the folder must exist.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    # Through memory: HDF5 ends the whole process when a disk is full, a plain write raises.
    write_bytes(path, checksum.sealed(_content(dataset)))


def _content(dataset: "Dataset") -> bytes | memoryview:
    if isinstance(dataset, Plain):
        return netcdf(dataset)
    # Somebody may have put into it whatever xarray writes.
    encoding: dict[str, dict[str, Any]] = {
        str(name): COMPRESSION if variable.dtype.kind in "fiu" else {}
        for name, variable in dataset.variables.items()
    }
    content: memoryview = dataset.to_netcdf(engine="h5netcdf", encoding=encoding)
    return content


def open_dataset(path: str | Path) -> "xarray.Dataset":
    """Read a saved dataset wholly into memory and check that it is one of ours.

    Parameters
    ----------
    path
        A file written by `save`.

    Raises
    ------
    ResultFormatError
        The file is missing, damaged, no NetCDF file, of another format version, or lacks variables.
    """
    return open_plain(path).dataset()


def open_plain(path: str | Path) -> Plain:
    """Open a saved dataset and check that it is one of ours.

    A file that carries its checksum is read variable by variable, when somebody asks for one; any
    other at once, since damage shows only when it is read.

    Raises
    ------
    ResultFormatError
        As `open_dataset`.
    """
    file = Path(path)
    if not file.is_file():
        raise ResultFormatError(
            "no such result file", where=str(file), expected="a file written by `arcless run`"
        )
    with _reading(file):
        is_sealed = checksum.check(file)
        _check_kind(file)
        dataset = _opened(file)
    _check(dataset, file)
    if not is_sealed:
        _ = dataset.variables
    return dataset


def _opened(file: Path) -> Plain:
    import h5py

    def read(variable: h5py.Dataset) -> "Entry":
        with _reading(file):
            entry = lazy_reader.entry(variable)
        name = variable.name.rpartition("/")[2]
        check_entry(name, entry, sizes, file)
        return entry

    # Closed when nothing refers to its variables any more.
    opened = h5py.File(file, "r")
    data, coords = lazy_reader.split(opened)
    sizes = {name: variable.shape[0] for name, variable in coords.items()}
    return Plain(
        lazy_reader.LazyVariables(data, read),
        lazy_reader.LazyVariables(coords, read),
        lazy_reader.attributes(opened),
    )


def _check_kind(file: Path) -> None:
    """Refuse a file that does not begin as NetCDF-4, which is HDF5, does."""
    with file.open("rb") as opened:
        first = opened.read(len(HDF5))
    if first == HDF5:
        return
    zipped = first.startswith(b"PK")
    kind = "an Excel workbook or another ZIP file" if zipped else "a file of another kind"
    raise ResultFormatError(
        "cannot read the result file", where=str(file), got=kind if first else "an empty file",
        expected="a NetCDF file written by `arcless run`",
        hint="a measured run is a CSV file, whose name ends in .csv",
    )  # fmt: skip


@contextmanager
def _reading(file: Path) -> Iterator[None]:
    """Say in our words that a file cannot be read."""
    try:
        yield
    except ResultFormatError:
        raise
    except UNREADABLE as error:
        raise ResultFormatError(
            "cannot read the result file",
            where=str(file),
            got=str(error).partition("\n")[0],
            expected="a whole NetCDF4 file written by `arcless run`",
        ) from error


def _check(dataset: Plain, file: Path) -> None:
    found = str(dataset.attrs.get("format", "no format mark"))
    if found != RESULT_FORMAT:
        raise ResultFormatError(
            "not a result file that this version can read",
            where=str(file),
            got=found,
            expected=RESULT_FORMAT,
            hint="run the scenario again, or open the file with the version that wrote it",
        )
    missing = missing_variables(dataset)
    missing += [n for n, entry in ATTRIBUTES.items() if entry.required and n not in dataset.attrs]
    if missing:
        raise ResultFormatError(
            "the result file is incomplete", where=str(file), expected=", ".join(missing)
        )
    try:
        check_attributes(metadata(dataset))
    except (ValueError, TypeError, OverflowError, RecursionError) as error:
        raise ResultFormatError(
            "an attribute of the result file is damaged", where=str(file), got=str(error)
        ) from error
    check_motion(dataset, file)
