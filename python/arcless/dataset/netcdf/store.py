"""Datasets as NetCDF files: saved atomically, checked when opened."""

from collections.abc import Container, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.dataset.build import missing_variables
from arcless.dataset.metadata import decoded, metadata
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
    _check_there(file)
    with _reading(file):
        is_sealed = checksum.check(file)
        _check_kind(file)
        dataset = _opened(file)
    _checked(dataset.attrs, dataset, file)
    check_motion(dataset, file)
    if not is_sealed:
        _ = dataset.variables
    return dataset


def read_facts(path: str | Path) -> dict[str, Any]:
    """Return the attributes of a saved dataset as plain values; see `metadata`.

    None of its variables is opened, which takes most of the time of `open_plain`. The checksum is
    compared all the same: HDF5 must not be let loose on a damaged file. A file without one is
    opened as `open_plain` does, and read wholly.

    Raises
    ------
    ResultFormatError
        As `open_dataset`.
    """
    import h5py

    file = Path(path)
    _check_there(file)
    with _reading(file):
        if checksum.check(file):
            with h5py.File(file, "r") as opened:
                attrs = lazy_reader.attributes(opened)
                names = set(opened)
            return _checked(attrs, names, file)
    return metadata(open_plain(file))


def _opened(file: Path) -> Plain:
    import h5py

    def read(variable: h5py.Dataset, columns: slice) -> "Entry":
        with _reading(file):
            entry = lazy_reader.entry(variable, columns)
        name = variable.name.rpartition("/")[2]
        # Of some columns there are fewer than the dimension has labels.
        whole = entry[0] if columns == lazy_reader.ALL else entry[0][:1]
        check_entry(name, entry, {dim: n for dim, n in sizes.items() if dim in whole}, file)
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


def _check_there(file: Path) -> None:
    if not file.is_file():
        raise ResultFormatError(
            "no such result file", where=str(file), expected="a file written by `arcless run`"
        )


def _checked(attrs: dict[str, Any], names: Container[str], file: Path) -> dict[str, Any]:
    """Return the attributes as plain values, given the names of the variables."""
    found = str(attrs.get("format", "no format mark"))
    if found != RESULT_FORMAT:
        raise ResultFormatError(
            "not a result file that this version can read",
            where=str(file),
            got=found,
            expected=RESULT_FORMAT,
            hint="run the scenario again, or open the file with the version that wrote it",
        )
    missing = missing_variables(names)
    missing += [n for n, entry in ATTRIBUTES.items() if entry.required and n not in attrs]
    if missing:
        raise ResultFormatError(
            "the result file is incomplete", where=str(file), expected=", ".join(missing)
        )
    try:
        facts = decoded(attrs)
        check_attributes(facts)
    except (ValueError, TypeError, OverflowError, RecursionError) as error:
        raise ResultFormatError(
            "an attribute of the result file is damaged", where=str(file), got=str(error)
        ) from error
    return facts
