"""The journal: what it keeps, who may look into it, what damage costs, and journals of old."""

import json
import sqlite3
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import OutputError, StudyError
from arcless.study import Study, StudyFolder, run, status
from arcless.study.executors.threads import Threads
from arcless.study.journal import filesystem, journal
from arcless.study.journal.row import Row, row_of
from arcless.study.journal.sealed_rows import opened, written
from tests.support.studies import data, filled, load, made_up, rows, study

HASH = "0123456789abcdef"


def test_a_row_and_its_seal() -> None:
    row = Row(3, "k", {"a": 0.1, "b": "ü"}, "done", {"x": 1e-300, "y": None}, "", 0.5, "v")
    text, mark = written(row, HASH)
    assert opened(text, mark, HASH, 3) == row
    assert opened(text, mark, HASH, 4) is None
    assert opened(text, mark, HASH[::-1], 3) is None
    assert opened(text.replace(b"0.1", b"0.2"), mark, HASH, 3) is None
    assert opened(text, None, HASH) is opened(None, mark, HASH) is opened(5, 5.0, HASH) is None


WHOLE_ROW = Row(1, "k", {"a": 1.0}, "done", {"x": 1.0}, "", 0.5, "v", {"x": [1.0, None]}, 5, 5, 1.0)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("variant", 0), ("variant", 1.0), ("variant", True), ("variant", [1]), ("variant", "1"),
        ("variant", 1 << 63), ("key", 5), ("values", [1.0]), ("values", None), ("status", "fine"),
        ("status", ["done"]), ("outputs", "x"), ("outputs", 5), ("outputs", [1.0]),
        ("outputs", {"x": "1"}), ("outputs", {"x": float("nan")}), ("outputs", {"x": 10**400}),
        ("outputs", {"x": True}), ("error", None), ("error", 5), ("wall_time_s", None),
        ("wall_time_s", {"s": 1}), ("wall_time_s", float("inf")), ("wall_time_s", -1.0),
        ("arcless_version", 1), ("so_far", {"x": 1.0}), ("so_far", [1]), ("steps", 1.5),
        ("steps", 1 << 70), ("stopped_at_m", "here"), ("more", 1),
    ],
)  # fmt: skip
def test_what_is_no_row(name: str, value: Any) -> None:
    plain = WHOLE_ROW.to_dict()
    assert row_of(plain) == WHOLE_ROW
    assert row_of(plain | {name: value}) is None
    if name in ("variant", "key", "values", "status", "outputs", "error", "wall_time_s"):
        assert row_of({key: one for key, one in plain.items() if key != name}) is None


def test_readers_look_on(tmp_path: Path) -> None:
    made = filled(tmp_path, of=3)
    place = StudyFolder(made, tmp_path)
    with place.open_journal() as kept:
        assert kept.mode == "write-ahead log"
        reading = place.rows()
        first = next(reading)
        kept.append(replace(first, variant=4, error="later"))
        assert [row.variant for row in reading] == [2, 3, 4]  # what comes while somebody reads
        assert [row.variant for row in place.rows(2, 3)] == [2, 3]
    assert sorted(path.name for path in tmp_path.glob("journal*")) == ["journal.db", "journal.lock"]


@pytest.mark.parametrize("mode", ["write-ahead log", "rollback journal"])
def test_the_mode_follows_the_folder_and_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, mode: str
) -> None:
    monkeypatch.setattr(journal, "carries_wal", lambda _folder: mode == "write-ahead log")
    run(study(), tmp_path)
    assert json.loads((tmp_path / "study.json").read_text())["journal"] == mode
    assert status(study(), tmp_path).journal == mode
    monkeypatch.setattr(journal, "carries_wal", lambda _folder: False)
    run(study(), tmp_path, resume=True)
    assert status(study(), tmp_path).journal == "rollback journal"
    assert json.loads((tmp_path / "study.json").read_text())["hash"] == StudyFolder(study()).hash


MOUNTS = """\
21 1 8:1 / / rw - ext4 /dev/a rw
22 21 0:5 / /home rw,relatime shared:5 - nfs4 server:/home rw
23 22 0:6 / /home/my\\040disk rw - xfs /dev/b rw
24 21 0:7 / /mnt rw - fuse.sshfs there rw
25 21 0:8 / /mnt rw - ext4 /dev/c rw
26 21 0:9 / /scratch rw - lustre there rw
27 21 0:9 / /new rw - nobodyknowsfs there rw
"""


@pytest.mark.parametrize(
    ("place", "expected"),
    [
        ("/", True), ("/homes", True), ("/home/me/study", False), ("/home/my disk/x", True),
        ("/mnt/x", True), ("/scratch/x", False), ("/new/x", False),
    ],
)  # fmt: skip
def test_folders_on_a_network(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str, expected: bool
) -> None:
    (tmp_path / "mounts").write_text(MOUNTS)
    monkeypatch.setattr(filesystem, "_MOUNTS", tmp_path / "mounts")
    assert filesystem.is_local(Path(place)) is expected
    monkeypatch.setattr(filesystem, "_MOUNTS", tmp_path / "none")
    assert filesystem.is_local(Path(place))


def test_a_folder_without_shared_memory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(path: Path, mode: str = "rwc") -> sqlite3.Connection:
        raise sqlite3.OperationalError("locking protocol")

    assert filesystem.carries_wal(tmp_path)
    monkeypatch.setattr(filesystem, "connect", broken)
    assert not filesystem.carries_wal(tmp_path)
    assert list(tmp_path.iterdir()) == []
    assert not filesystem.carries_wal(tmp_path / "none")


def test_what_the_system_refuses_is_no_damage(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = filled(tmp_path, of=2)
    place = StudyFolder(made, tmp_path)
    monkeypatch.setattr("arcless.study.journal.database._PATIENCE_S", 0.05)
    with closing(sqlite3.connect(place.journal, isolation_level=None)) as other:
        other.execute("BEGIN EXCLUSIVE")
        with pytest.raises(StudyError, match=r"cannot be read: got database is locked"):
            list(place.rows())
        with pytest.raises(OutputError, match=r"cannot be written: got database is locked"):
            place.open_journal().__enter__()
    assert len(list(place.rows())) == 2
    assert not list(tmp_path.glob("journal-damaged*"))


def test_a_folder_without_locks(tmp_path: Path) -> None:
    made = filled(tmp_path, of=2)
    (tmp_path / "journal.lock").write_bytes(b"words of somebody " * 100)
    with pytest.raises(OutputError, match=r"cannot be locked: got no lock.*that has locks"):
        StudyFolder(made, tmp_path).open_journal().__enter__()
    assert status(made, tmp_path).done == 2


APPENDS = """
import sys
from pathlib import Path
from arcless.study.journal.journal import Journal
from arcless.study.journal.row import Row
with Journal(Path(sys.argv[1]), sys.argv[2]) as journal:
    print(journal.mode, flush=True)
    for number in range(1, 100_000):
        journal.append(Row(number, "k", {"a": 0.1}, "done", {"x": number / 7}, "", 0.1, "v"))
        print(number, flush=True)
"""


MANY = [pytest.param(after, marks=pytest.mark.evidence) for after in (60, 2500)]


@pytest.mark.parametrize("after", [1, 700, *MANY])
@pytest.mark.parametrize("mode", ["write-ahead log", "rollback journal"])
def test_a_killed_writer_loses_no_row(tmp_path: Path, after: int, mode: str) -> None:
    script = APPENDS
    if mode == "rollback journal":
        after //= 10
        script = script.replace(
            "with Journal",
            "import arcless.study.journal.journal as j; j.carries_wal = lambda _: 0\nwith Journal",
        )
    path = tmp_path / "journal.db"
    with subprocess.Popen(
        [sys.executable, "-c", script, str(path), HASH], stdout=subprocess.PIPE, text=True
    ) as writer:
        assert writer.stdout is not None
        assert writer.stdout.readline().strip() == mode
        while int(writer.stdout.readline()) < after:
            pass
        writer.kill()
        told = [int(line) for line in writer.stdout if line.strip()] or [after]
    damage = journal.Damage()
    found = [row.variant for row in journal.rows(path, HASH, damage)]
    assert found == list(range(1, len(found) + 1))
    assert max(told) <= len(found) <= max(told) + 1
    assert not damage.found and not journal.is_locked(path)
    with journal.Journal(path, HASH) as again:
        assert again.damage is None


def former(folder: Path, made: Study, *, spoilt: Callable[[list[Any]], list[Any]] = list) -> Path:
    """Write a study as it was kept before its journal was a database."""
    place = StudyFolder(made, folder)
    place.make()
    place.write_state("")
    state = json.loads((folder / "study.json").read_text())
    del state["journal"]
    (folder / "study.json").write_text(json.dumps(state | {"format": "arcless-study-state/1"}))
    lines: list[Any] = [made_up(made, number).to_dict() for number in range(1, 7)]
    texts = [one if isinstance(one, str) else json.dumps(one) for one in spoilt(lines)]
    (folder / "journal.jsonl").write_text("\n".join(texts) + "\n")
    (folder / "optuna.db").write_bytes(b"as it was")
    return folder / "journal.jsonl"


@pytest.fixture
def made_up_all(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    def compute(
        _self: Threads, _task: Any, variants: Any, _count: int, take: Any, _stop: Any
    ) -> None:
        for one in variants:
            take(made_up(study(), one.number))

    monkeypatch.setattr(Threads, "compute", compute)
    return iter(())


@pytest.mark.usefixtures("made_up_all")
def test_a_study_of_old_is_read_and_taken_over(tmp_path: Path) -> None:
    old = former(tmp_path, study(), spoilt=lambda lines: lines[1:5])
    before = old.read_bytes()
    found = status(study(), tmp_path)
    assert (found.done, found.missing, found.journal, found.damaged) == (4, 2, None, 0)
    assert not (tmp_path / "journal.db").exists()
    with pytest.raises(StudyError, match="begun here already: got 4 of 6 variants"):
        run(study(), tmp_path)
    told: list[str] = []
    assert run(study(), tmp_path, resume=True, note=told.append).computed == 2
    assert "4 rows were taken over" in told[0] and "journal-former.jsonl now" in told[0]
    assert (tmp_path / "journal-former.jsonl").read_bytes() == before
    assert [row["variant"] for row in rows(tmp_path / "table.parquet")] == [1, 2, 3, 4, 5, 6]
    told.clear()
    assert run(study(), tmp_path, resume=True, note=told.append).computed == 0
    assert told == []


def changed(name: str, value: Any, lines: list[Any]) -> list[Any]:
    return [lines[0] | {name: value}, *lines[1:]]


DAMAGED_LINES: list[Callable[[list[Any]], list[Any]]] = [
    *(
        partial(changed, name, value)
        for name, value in [
            ("variant", []), ("variant", 7), ("variant", 2), ("variant", "x"), ("status", "fine"),
            ("values", 5), ("values", {"tension": 18000.0, "gorce": 70.0}),
            ("values", {"tension": 18001.0, "force": 70.0}), ("key", "0" * 16), ("outputs", [1]),
            ("outputs", {"sigmo": 1.0}), ("error", 5), ("wall_time_s", None),
            ("arcless_version", {}), ("unknown", 1),
        ]
    ),
    lambda lines: ["[" * 100_000, *lines[1:]],
    lambda lines: [json.dumps(lines[0]).replace("0.25", "NaN"), *lines[1:]],
    lambda lines: ["\0" * 50, *lines[1:]],
    lambda lines: ["null", *lines[1:]],
    lambda lines: ["9" * 5000, *lines[1:]],
]  # fmt: skip


@pytest.mark.usefixtures("made_up_all")
@pytest.mark.parametrize("spoilt", DAMAGED_LINES)
def test_damaged_lines_of_old_are_left_out(tmp_path: Path, spoilt: Any) -> None:
    former(tmp_path, study(), spoilt=spoilt)
    found = status(study(), tmp_path)
    assert (found.done, found.damaged) == (5, 1)
    told: list[str] = []
    assert run(study(), tmp_path, resume=True, note=told.append).computed == 1
    assert "lines left out as damaged: 1" in told[0]
    assert list(StudyFolder(study(), tmp_path).rows()) == [
        made_up(study(), number) for number in range(1, 7)
    ]


def test_lines_of_another_study_are_refused(tmp_path: Path) -> None:
    old = former(tmp_path, study(), spoilt=lambda all_: [one | {"key": "x"} for one in all_])
    with pytest.raises(StudyError, match="of another study, or all of them are damaged"):
        run(study(), tmp_path, resume=True)
    assert old.exists()


def test_state_files_that_are_damaged(tmp_path: Path) -> None:
    made = filled(tmp_path, of=2)
    state = json.loads((tmp_path / "study.json").read_text())
    for spoilt in (
        "[" * 100_000, "[]", "5", json.dumps(state | {"study": 5}),
        json.dumps(state | {"arcless_version": None}), json.dumps(state | {"hash": 1}),
    ):  # fmt: skip
        (tmp_path / "study.json").write_text(spoilt)
        with pytest.raises(StudyError, match="state of the study cannot be read"):
            status(made, tmp_path)
    assert load(data())
