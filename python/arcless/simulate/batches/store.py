"""Members of a batch on disk: a file for each, there whole or not at all.

A member's file has the fingerprint of the member for a name. So a batch that is run again
into the same folder finds the finished members, in whatever order; a changed member is another one.

```
members.csv                  index, name, file and changed fields of each member begun
ab/cdef….json                assessment of the member with the fingerprint abcdef…
ab/cdef….nc                  its result, where results are kept
```
"""

import csv
import io
import json
from collections.abc import Iterable
from pathlib import Path

from arcless.assess import Assessment
from arcless.errors import OutputError
from arcless.results import Result
from arcless.simulate.runs.outcome import Keep
from arcless.storage.whole_files import check_writable, write_bytes

FORMAT = "arcless-member/1"
LIST = "members.csv"
# Digits of the fingerprint in names: by chance two of 10⁸ members meet once in 10²².
DIGITS = 32
# Index, name, key and changed fields of a member.
Listed = tuple[int, str, str, str]


class Folder:
    """A folder with the members of a batch.

    Raises
    ------
    OutputError
        It cannot be made or written.
    """

    def __init__(self, path: str | Path, keep: Keep) -> None:
        self._path, self._keep = Path(path), keep
        try:
            self._path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            what = "the folder of the batch cannot be made"
            raise OutputError.of(error, what, path) from error
        check_writable(self._path / LIST)

    def file(self, key: str, ending: str | None = None) -> Path:
        """Return the file of a member: that of what is kept, or with another ending."""
        ending = ending or ("nc" if self._keep == "result" else "json")
        return self._path / key[:2] / f"{key[2:DIGITS]}.{ending}"

    def read(self, key: str) -> tuple[Assessment, float] | None:
        """Return assessment and wall time in s of a member; None where it is missing or damaged."""
        if not self.file(key).is_file():
            return None
        try:
            stored = json.loads(self.file(key, "json").read_bytes())
            if (stored["format"], stored["member"]) != (FORMAT, key):
                return None
            return Assessment.from_dict(stored["assessment"]), float(stored["wall_time_s"])
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def write(self, key: str, done: Assessment | Result, wall_time_s: float) -> Path:
        """Write what is kept of a member; returns its file.

        Raises
        ------
        OutputError
            It cannot be written.
        """
        assessment = done.assessment if isinstance(done, Result) else done
        stored = {
            "format": FORMAT,
            "member": key,
            "wall_time_s": wall_time_s,
            "assessment": assessment.to_dict(),
        }
        text = json.dumps(stored, indent=1, ensure_ascii=False, allow_nan=False)
        target = self.file(key)
        try:
            target.parent.mkdir(exist_ok=True)
        except OSError as error:
            what = "a folder of the batch cannot be made"
            raise OutputError.of(error, what, target.parent) from error
        if isinstance(done, Result):
            done.save(target)
        write_bytes(self.file(key, "json"), text.encode())
        return target

    def write_list(self, members: Iterable[Listed]) -> None:
        """Write which file is whose."""
        text = io.StringIO()
        rows = csv.writer(text, lineterminator="\n")
        rows.writerow(["index", "name", "file", "changes"])
        for index, name, key, changes in members:
            rows.writerow([index, name, self.file(key).relative_to(self._path), changes])
        write_bytes(self._path / LIST, text.getvalue().encode())
