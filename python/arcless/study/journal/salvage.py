"""Repair of a damaged journal: all rows that still fit their seals go into a new one.

Whatever was hit, a row that fits its seal is what was written. So rows are looked for where SQLite
finds them, and where it finds none any more in the plain bytes of the file.
"""

import mmap
import re
import shutil
import sqlite3
from contextlib import closing, suppress
from dataclasses import dataclass, field
from pathlib import Path

from arcless.errors import StudyError
from arcless.platforms.moving import move
from arcless.storage.whole_files import sync_folder
from arcless.study.journal.database import BESIDE, ERRORS, connect, is_damage, tables
from arcless.study.journal.row import Row
from arcless.study.journal.sealed_rows import FORMAT, SEAL_LETTERS, opened, seal, written

MAKE = (
    "CREATE TABLE about (text TEXT NOT NULL, seal TEXT NOT NULL)",
    "CREATE TABLE rows (variant INTEGER PRIMARY KEY, row TEXT NOT NULL, seal TEXT NOT NULL)",
)
PUT = "INSERT OR REPLACE INTO rows (variant, row, seal) VALUES (?, ?, ?)"
_WHAT = "SELECT row, seal FROM rows"
_ROW = "SELECT variant, row, seal FROM rows ORDER BY variant"
# In the bytes of a file a row is in one piece if it fits a page.
_BEGINS, _ENDS = re.compile(rb'\{"variant":'), re.compile(rb"\}[0-9a-f]{%d}" % SEAL_LETTERS)
_PAGE = 4096


@dataclass
class Damage:
    """Damage that a reader found: numbers of rows that were left out, and state of the file."""

    rows: set[int] = field(default_factory=set)
    file: bool = False

    @property
    def found(self) -> bool:
        """True when there is damage."""
        return self.file or bool(self.rows)


def make(path: Path, study: str) -> None:
    """Make a journal without rows, in one transaction; one that is there stays as it is."""
    with closing(connect(path)) as base:
        base.execute("BEGIN IMMEDIATE")
        if not tables(base):
            for statement in MAKE:
                base.execute(statement)
            _put_about(base, study)
        base.execute("COMMIT")


def _about(study: str) -> bytes:
    """Return what a journal says of itself."""
    return f'{{"format":"{FORMAT}","study":"{study}"}}'.encode()


def _put_about(base: sqlite3.Connection, study: str) -> None:
    text = _about(study)
    base.execute("DELETE FROM about")
    about = (text.decode(), seal(text, "").decode())
    base.execute("INSERT INTO about (text, seal) VALUES (?, ?)", about)


def repair(path: Path, study: str) -> str | None:
    """Put a journal in order that nobody writes or reads; say what was wrong with it, if anything.

    Parameters
    ----------
    path
        The journal.
    study
        Hash of what the study asks.

    Raises
    ------
    StudyError
        It is that of another study.
    OSError, sqlite3.Error
        The system refuses something.
    """
    spare = scanned(Path(f"{path}-wal"), study)  # before SQLite looks: it drops what is damaged
    try:
        if _is_whole(path, study):
            add(path, spare, study)
            return None
    except ERRORS as error:
        if not is_damage(error, path):
            raise
    return _rebuilt(path, spare, study)


def salvaged(path: Path, study: str) -> dict[int, Row]:
    """Return all rows of a damaged journal that fit their seals."""
    found: dict[int, Row] = {}
    for order in ("", " DESC"):  # up to the damage from both sides
        try:
            with closing(connect(path, "ro")) as base:
                for number, text, mark in base.execute(_ROW + order):
                    _keep(found, opened(text, mark, study, number))
        except ERRORS:
            pass
    for file in (path, Path(f"{path}-wal")):
        for row in scanned(file, study).values():
            _keep(found, row)
    return found


def scanned(path: Path, study: str) -> dict[int, Row]:
    """Return the rows that stand in the bytes of a file, and fit their seals."""
    found: dict[int, Row] = {}
    if not path.exists() or not path.stat().st_size:
        return found
    with (
        path.open("rb") as file,
        closing(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)) as content,
    ):
        for start in _BEGINS.finditer(content):
            piece = content[start.start() : start.start() + _PAGE]
            end = _ENDS.search(piece)
            if end is not None:
                cut = end.start() + 1
                _keep(found, opened(piece[:cut], piece[cut : end.end()], study))
    return found


def _keep(found: dict[int, Row], row: Row | None) -> None:
    """Keep a row; of several of one variant one that did not fail, as only those are replaced."""
    if row is not None and found.get(row.variant, row).status in (row.status, "failed"):
        found[row.variant] = row


def _is_whole(path: Path, study: str) -> bool:
    """Return whether a journal has its tables, its structure, and rows that all fit their seals."""
    with closing(connect(path, "rw")) as base:
        base.execute("BEGIN IMMEDIATE")  # puts in order what a killed process left
        base.execute("ROLLBACK")
        if [sql for _, sql in tables(base)] != [statement.encode() for statement in MAKE]:
            return False
        if base.execute("PRAGMA integrity_check(1)").fetchall() != [(b"ok",)]:
            return False
        ((text, mark),) = base.execute("SELECT text, seal FROM about").fetchall() or ((None, None),)
        if not isinstance(text, bytes) or mark != seal(text, ""):
            return False
        if text != _about(study):
            if base.execute("SELECT 1 FROM rows LIMIT 1").fetchone() is not None:
                raise _another(path)
            _put_about(base, study)  # one that was begun and never had a row
        return all(opened(row, mark, study, number) for number, row, mark in base.execute(_ROW))


def _another(path: Path) -> StudyError:
    return StudyError(
        "the rows are of another study, or of another version of the journal",
        where=str(path),
        expected="the journal that was begun in this folder",
        hint="put it back, or restart in another folder with `--out`",
    )


def add(path: Path, rows: dict[int, Row], study: str) -> None:
    """Put rows into a journal that it does not have, in one transaction."""
    with closing(connect(path, "rw")) as base:
        base.execute("BEGIN IMMEDIATE")
        for number, row in rows.items():
            there: dict[int, Row] = {}
            for text, mark in base.execute(f"{_WHAT} WHERE variant = ?", (number,)):
                _keep(there, opened(text, mark, study, number))
            _keep(there, row)
            text, mark = written(there[number], study)
            base.execute(PUT, (number, text.decode(), mark.decode()))
        base.execute("COMMIT")


def _rebuilt(path: Path, spare: dict[int, Row], study: str) -> str:
    """Make a new journal of what can be read, and rename the damaged one, whole until then."""
    rows = salvaged(path, study)
    for row in spare.values():
        _keep(rows, row)
    fresh = path.with_name(f"{path.stem}-new{path.suffix}")
    for end in ("", *BESIDE):
        Path(f"{fresh}{end}").unlink(missing_ok=True)
    try:
        make(fresh, study)
        add(fresh, rows, study)
        aside = _aside(path)
    except BaseException:
        for end in ("", *BESIDE):
            with suppress(OSError):
                Path(f"{fresh}{end}").unlink(missing_ok=True)
        raise
    for end in BESIDE:  # before the new one has its name, which would take them for its own
        Path(f"{path}{end}").unlink(missing_ok=True)
    move(fresh, path)
    sync_folder(path.parent)
    return (
        f"the journal was damaged: {len(rows)} rows of it could be read and are kept, all others "
        f"are computed again; it was put aside as {aside}"
    )


def _aside(path: Path) -> Path:
    """Copy a damaged journal, and what belongs to it, to a name that is free."""
    number = 1
    while (aside := path.with_name(f"{path.stem}-damaged-{number}{path.suffix}")).exists():
        number += 1
    for end in ("-wal", "-journal", ""):
        with suppress(FileNotFoundError):
            shutil.copyfile(f"{path}{end}", f"{aside}{end}")
    return aside
