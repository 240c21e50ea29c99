"""The folder of a study: what was asked, the journal, the table, and results that are kept."""

import json
import re
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any
from uuid import uuid4

from arcless.errors import OutputError, StudyError
from arcless.results.files import write_bytes
from arcless.study import journal
from arcless.study.database import secrets
from arcless.study.load import differences, digest, meaning
from arcless.study.model import Study
from arcless.study.rows import Row
from arcless.study.search import Search
from arcless.study.version import code_version

_STATE, _COPY, _JOURNAL, _RESULTS = "study.json", "study.yaml", "journal.jsonl", "results"
TABLE = "table.parquet"


class StudyFolder:
    """The state of a study on the disk.

    Parameters
    ----------
    study
        The study.
    path
        The folder; ``runs/studies/NAME`` without.
    """

    def __init__(self, study: Study, path: Path | None = None) -> None:
        plain = re.sub(r"[^\w.-]+", "-", study.name).strip("-.") or "study"
        self.study = study
        self.path = path if path is not None else Path("runs") / "studies" / plain

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

    def write_state(self) -> None:
        """Write down what is asked: the study with all that it names, and a copy of the file."""
        asked = meaning(self.study)
        state = {
            "format": "arcless-study-state/1",
            "name": self.study.name,
            "id": uuid4().hex,
            "hash": digest(asked),
            "arcless_version": code_version(),
            "begun": datetime.now(UTC).isoformat(timespec="seconds"),
            "study": asked,
        }
        if self.study.file is not None:
            copy = Path(self.study.file).read_bytes()
            for secret in self._secrets():
                copy = copy.replace(secret.encode(), b"***")
            write_bytes(self.path / _COPY, copy)
        write_bytes(self.path / _STATE, json.dumps(state, indent=1, ensure_ascii=False).encode())

    def _secrets(self) -> set[str]:
        """Return the passwords in the study file."""
        url = getattr(self.study.design, "storage", None)
        return set() if url is None else secrets(url)

    def state(self) -> dict[str, Any] | None:
        """Return what was asked when the study was begun; None where none was.

        Raises
        ------
        StudyError
            It cannot be read.
        """
        file = self.path / _STATE
        if not file.exists():
            return None
        try:
            state: dict[str, Any] = json.loads(file.read_text("utf-8"))
            _ = state["study"], state["hash"], state["arcless_version"]
        except (OSError, ValueError, KeyError, TypeError):
            raise StudyError(
                "the state of the study cannot be read",
                where=str(file),
                expected="the file as `arcless study run` wrote it",
                hint="copy it again, or choose another folder with `--out`",
            ) from None
        return state

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
        asked = meaning(self.study)
        if state["hash"] != digest(asked):
            lines = differences(state["study"], json.loads(json.dumps(asked)))
            raise StudyError(
                "the study is another one than when it was begun",
                where=self.study.file or str(self.path),
                got="other values, listed below",
                expected=f"the study as it stands in {self.path / _COPY}",
                hint="take the changes back, or begin anew in another folder with `--out`\n  "
                + "\n  ".join(lines),
            )
        return state

    def rows(self) -> Iterator[Row]:
        """Yield the rows that are there, in the order of the variants."""
        return journal.rows(self.journal)

    def recall(self) -> None:
        """Let an optimisation know the values of the variants that have rows."""
        if isinstance(self.study.plan, Search):
            self.study.plan.recall(self.rows())
