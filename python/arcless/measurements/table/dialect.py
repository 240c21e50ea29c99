"""Head of a CSV file → its delimiter, its decimal sign, and the names of its columns."""

import csv
import re
from dataclasses import dataclass
from pathlib import Path

from arcless.errors import MeasurementError
from arcless.units import show

# A file is read whole, as numbers of about its size; filters take ten times that. In bytes.
LARGEST_FILE = 512 * 2**20
# The header and first rows stand within so many bytes.
HEAD_BYTES = 2**20
# Rows by which the decimal sign is told.
TRIED_ROWS = 20

EXPECTED = "a CSV file with units in its header, such as `time [s],speed [km/h],contact_force [N]`"
_AS_CSV = "save it as CSV in UTF-8"
_BEGINNINGS = {
    b"\xff\xfe": "text in UTF-16",
    b"\xfe\xff": "text in UTF-16",
    b"PK\x03\x04": "a zip archive, as .xlsx is one",
    b"\xd0\xcf\x11\xe0": "an old Office document",
    b"\x89HDF": "an HDF5 or NetCDF file",
}
_DECIMAL_COMMA = re.compile(r"\s*[+-]?\d+,\d+([eE][+-]?\d+)?\s*")
# Line in front of the header by which Excel is told the delimiter.
_OF_EXCEL = re.compile(r"sep=.", re.IGNORECASE)
_NAMES = {",": "comma", ";": "semicolon", "\t": "tab"}


@dataclass(frozen=True)
class Dialect:
    """Form of a CSV file.

    Attributes
    ----------
    delimiter, decimal
        What stands between cells, and before decimals.
    header
        Cells of the header.
    header_line
        Its line, from 1.
    """

    delimiter: str
    decimal: str
    header: tuple[str, ...]
    header_line: int

    @property
    def words(self) -> str:
        """The form in words."""
        sign = "comma" if self.decimal == "," else "point"
        return f"columns separated by {_NAMES[self.delimiter]}, decimal {sign}"


def examine(path: Path, *, largest_bytes: int = LARGEST_FILE) -> Dialect:
    """Read the head of a file, and refuse what is no CSV file before reading all of it.

    Raises
    ------
    MeasurementError
        There is no such file, it is too large, empty, binary, not UTF-8, or has one column only.
    """
    label = str(path)
    lines = _text(_head(path, largest_bytes), label).split("\n")
    content = [(n, line) for n, line in enumerate(lines, 1) if is_content(line)]
    if content and _OF_EXCEL.fullmatch(content[0][1].strip()):
        del content[0]
    if not content:
        raise MeasurementError("empty file", where=label, got="no header", expected=EXPECTED)
    number, header = content[0]
    header = header.rstrip("\r")
    if "\r" in header or "\0" in header:
        raise lone_return(f"{label}:{number}")
    rows = [line for _, line in content[1 : TRIED_ROWS + 1]]
    delimiter = _delimiter(header, f"{label}:{number}")
    names = next(csv.reader([header], delimiter=delimiter, skipinitialspace=True))
    if not rows:
        got = "a header without rows"
        raise MeasurementError("empty table", where=label, got=got, expected="rows of samples")
    decimal = "," if delimiter != "," and _has_decimal_comma(rows, delimiter) else "."
    return Dialect(delimiter, decimal, tuple(name.strip() for name in names), number)


def line_too_long(where: str) -> MeasurementError:
    """Return the error of a line that no table has; files without line ends have one."""
    expected = f"lines of at most {HEAD_BYTES / 2**20:g} MiB"
    return MeasurementError("line too long", where=where, expected=expected)


def lone_return(where: str) -> MeasurementError:
    """Return the error of a line end that is not one in a text file of today."""
    got, hint = "a carriage return alone", "save the file with line ends of Unix or Windows"
    return MeasurementError("line end", where=where, got=got, hint=hint)


def is_content(line: str) -> bool:
    """Return whether a line is neither empty nor a comment."""
    stripped = line.strip()
    return bool(stripped) and not stripped.startswith("#")


def _head(path: Path, largest_bytes: int) -> bytes:
    label = str(path)
    try:
        if not path.exists():
            raise MeasurementError("no such file", where=label, expected=EXPECTED)
        if not path.is_file():
            got = "a folder" if path.is_dir() else "a device or a pipe"
            raise MeasurementError("not a file", where=label, got=got, expected=EXPECTED)
        size = path.stat().st_size
        if size > largest_bytes:
            raise MeasurementError(
                "file too large",
                where=label,
                got=f"{size / 2**20:.0f} MiB",
                expected=f"at most {largest_bytes / 2**20:.0f} MiB, for it is held in memory",
                hint="leave out columns that are not used, or split the record by place",
            )
        with path.open("rb") as file:
            return file.read(HEAD_BYTES)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise MeasurementError(
            f"cannot be read ({reason})", where=label, expected=EXPECTED
        ) from None


def _text(raw: bytes, label: str) -> str:
    """Return the head as text, without a line that it cuts off."""
    for beginning, kind in _BEGINNINGS.items():
        if raw.startswith(beginning):
            raise MeasurementError(
                "not a CSV file in UTF-8", where=label, got=kind, expected=EXPECTED, hint=_AS_CSV
            )
    if b"\0" in raw:
        got = "binary data"
        raise MeasurementError("not a text file", where=label, got=got, expected=EXPECTED)
    whole = raw if len(raw) < HEAD_BYTES else raw[: raw.rfind(b"\n") + 1]
    if raw and not whole:
        raise line_too_long(f"{label}:1")
    try:
        return whole.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = whole[: error.start].count(b"\n") + 1
        raise MeasurementError(
            "not a text file in UTF-8",
            where=f"{label}:{line}",
            got=f"byte 0x{whole[error.start]:02x}",
            expected=EXPECTED,
            hint="save it as UTF-8, or write units in plain letters, such as m/s2",
        ) from None


def _delimiter(header: str, where: str) -> str:
    """Return the first of tab, semicolon and comma that a header has outside of quotes."""
    bare = re.sub(r'"[^"]*"', "", header)
    for delimiter in ("\t", ";", ","):
        if delimiter in bare:
            return delimiter
    raise MeasurementError(
        "header with one column",
        where=where,
        got=show(header),
        expected=EXPECTED,
        hint="separate the columns by commas, semicolons or tabs",
    )


def _has_decimal_comma(rows: list[str], delimiter: str) -> bool:
    return any(_DECIMAL_COMMA.fullmatch(cell.strip('"')) for row in rows
               for cell in row.split(delimiter))  # fmt: skip
