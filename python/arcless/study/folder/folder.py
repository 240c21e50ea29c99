"""The folder of a study: what was asked, the journal, the table, and results that are kept."""

import json
import re
import shlex
from collections.abc import Iterator
from datetime import UTC, datetime
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any
from uuid import uuid4

from arcless.errors import OutputError, StudyError
from arcless.platforms.file_names import refused_by_windows
from arcless.platforms.moving import move
from arcless.storage.whole_files import write_bytes
from arcless.study.definition.load import contents, differences, digest, meaning
from arcless.study.definition.study import Study
from arcless.study.evaluation.version import code_version
from arcless.study.folder import journal_version_1
from arcless.study.journal import journal
from arcless.study.journal.journal import Journal
from arcless.study.journal.row import Row
from arcless.study.journal.salvage import Damage, add
from arcless.study.optimisation.search import Search

if TYPE_CHECKING:
    import pandas

STATE, _COPY, _JOURNAL, _RESULTS = "study.json", "study.yaml", "journal.db", "results"
TABLE = "table.parquet"
# The journal as it was before it was a database, and its name when its rows are in one.
_LINES, _FORMER = "journal.jsonl", "journal-former.jsonl"
# Files that a study may be named by, as its folder may.
NAMES = {STATE, _COPY, _JOURNAL, TABLE, _LINES, "report.html"}


def read_state(folder: Path) -> dict[str, Any] | None:
    """Return the settings with which the study of a folder was begun; None where none was.

    Raises
    ------
    StudyError
        It cannot be read.
    """
    file = folder / STATE
    if not file.exists():
        return None
    try:
        state: dict[str, Any] = json.loads(file.read_text("utf-8"))
        known = isinstance(state["study"], dict) and isinstance(state["arcless_version"], str)
        if not (known and isinstance(state["hash"], str)):
            raise TypeError
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        raise unreadable(file) from None
    return state


def unreadable(file: Path) -> StudyError:
    """Return the error of a state that is damaged."""
    return StudyError(
        "the state of the study cannot be read",
        where=str(file),
        expected="the file as `arcless study run` wrote it",
        hint="copy it again, or choose another folder with `--out`",
    )


class StudyFolder:
    """The state of a study on the disk.

    Parameters
    ----------
    study
        The study.
    path
        The folder; ``runs/studies/NAME`` without.

    Attributes
    ----------
    damage
        Rows of the journal that readers of this object left out.
    """

    def __init__(self, study: Study, path: Path | None = None) -> None:
        plain = re.sub(r"[^\w.-]+", "-", study.name).strip("-.") or "study"
        own = f"_{plain}" if refused_by_windows(plain) else plain
        self._usual = Path("runs") / "studies" / own
        self.study = study
        self.path = self._usual if path is None else path
        self.damage = Damage()

    @cached_property
    def hash(self) -> str:
        """Hash of the study's contents, with which every row is sealed."""
        return digest(meaning(contents(self.study)))

    def command(self, word: str) -> str:
        """Return `arcless study WORD` as it is called for this folder."""
        own = [] if self.path == self._usual else ["--out", str(self.path)]
        return shlex.join(["arcless", "study", word, self.study.file or "FILE", *own])

    @property
    def is_of_this_study(self) -> bool:
        """True when the study that was begun here has the same contents."""
        state = self.state()
        return state is not None and state["hash"] == self.hash

    @property
    def journal(self) -> Path:
        """The journal."""
        return self.path / _JOURNAL

    @property
    def table(self) -> Path:
        """The table."""
        return self.path / TABLE

    @property
    def results(self) -> Path:
        """The folder of the results that are kept."""
        return self.path / _RESULTS

    def make(self) -> None:
        """Make the folder, where there is none."""
        try:
            self.path.mkdir(parents=True, exist_ok=True)
            if self.study.keep == "results":
                self.results.mkdir(exist_ok=True)
        except OSError as error:
            what, hint = "the folder of the study cannot be made", "choose another one with `--out`"
            raise OutputError.of(error, what, self.path, hint) from error

    def write_state(self, mode: str) -> None:
        """Write the study with all that it names, and a copy of its file, into the folder.

        `mode` says how the journal is kept whole.
        """
        state = {
            "format": "arcless-study-state/2",
            "name": self.study.name,
            "id": uuid4().hex,
            "hash": self.hash,
            "arcless_version": code_version(),
            "begun": datetime.now(UTC).isoformat(timespec="seconds"),
            "journal": mode,
            "study": contents(self.study),
        }
        if self.study.file is not None and Path(self.study.file).is_file():
            write_bytes(self.path / _COPY, Path(self.study.file).read_bytes())
        self._write(state)

    def note_mode(self, mode: str) -> None:
        """Write down how the journal is kept whole, if that has changed."""
        state = self.check_same()
        if state.get("journal") != mode:
            self._write(state | {"journal": mode})

    def _write(self, state: dict[str, Any]) -> None:
        write_bytes(self.path / STATE, json.dumps(state, indent=1, ensure_ascii=False).encode())

    def state(self) -> dict[str, Any] | None:
        """Return the settings with which the study was begun; None where none was.

        Raises
        ------
        StudyError
            It cannot be read.
        """
        return read_state(self.path)

    def check_same(self) -> dict[str, Any]:
        """Return the state; refuse a study that is not the one that was begun here.

        Raises
        ------
        StudyError
            No study was begun here, or another one; the message has the fields that differ.
        """
        state = self.state()
        if state is None:
            raise StudyError(
                "no study was begun here",
                where=str(self.path),
                hint="begin it with `arcless study run`, or name its folder with `--out`",
            )
        if state["hash"] != self.hash:
            fields = differences(meaning(state["study"]), meaning(contents(self.study)))
            raise StudyError(
                "the study is another one than when it was begun",
                where=self.study.file or str(self.path),
                got="other values, listed below",
                expected=f"the study as it is in {self.path / _COPY}",
                hint="take the changes back, or restart in another folder with `--out`\n  "
                + "\n  ".join(fields),
            )
        return state

    def open_journal(self) -> Journal:
        """Return the journal, to be entered by the computing process; make the folder for it."""
        self.make()
        return Journal(self.journal, self.hash)

    def take_former(self) -> str | None:
        """Take the rows of a journal of version 1, and rename it; say so. None without one.

        Only for who has the journal open.
        """
        former = self.path / _LINES
        if not former.exists():
            return None
        damage = Damage()
        there = {row.variant: row for row in journal_version_1.rows(former, self.study, damage)}
        if damage.rows and not there:
            raise StudyError(
                "the rows are of another study, or all of them are damaged",
                where=str(former),
                expected="lines with the values that the design gives to their variants",
                hint="restart in another folder with `--out`",
            )
        add(self.journal, there, self.hash)
        aside = self.path / _FORMER
        move(former, aside)
        left = f", lines left out as damaged: {len(damage.rows)}" if damage.rows else ""
        return (
            f"the journal is a database now: {len(there)} rows were taken over from that of an"
            f" older version{left}; it is {aside} now, and may be deleted, as `optuna.db` may"
        )

    def rows(self, first: int = 1, last: int | None = None) -> Iterator[Row]:
        """Yield the rows that are there, in the order of the variants.

        Parameters
        ----------
        first, last
            Numbers of the variants that are wanted; to the end without `last`.
        """
        end = self.study.plan.count if last is None else last
        found = journal.rows(self.journal, self.hash, self.damage, first=first, last=end)
        former = self.path / _LINES
        if former.exists():  # the study was not resumed since
            both = {
                row.variant: row for row in journal_version_1.rows(former, self.study, self.damage)
            }
            both |= {row.variant: row for row in found}
            found = (both[number] for number in sorted(both) if first <= number <= end)
        yield from found

    def to_dataframe(self) -> "pandas.DataFrame":
        """Return the rows that are there as a data frame, by variant, with units in the columns.

        Raises
        ------
        StudyError
            The package pyarrow is not installed.
        """
        from arcless.study.folder import table

        return table.data_frame(self.study, self.rows())

    def export(self, path: str | Path) -> None:
        """Write the rows that are there for other programs; a file that exists is replaced.

        Parameters
        ----------
        path
            A name that ends in .csv or .xlsx; columns are those of `to_dataframe`.

        Raises
        ------
        OutputError
            Another ending, more rows than a sheet takes, or the file cannot be written.
        StudyError
            The package pyarrow is not installed.
        """
        from arcless.study.folder.export import export

        export(self.study, self.rows(), Path(path))

    def __repr__(self) -> str:
        return f"<StudyFolder {self.study.name}: {self.path}>"

    def recall(self) -> None:
        """Let an optimisation know the values of the variants that have rows."""
        if isinstance(self.study.plan, Search):
            self.study.plan.recall(self.rows())
