"""A journal that is damaged: the table is that of an undamaged one, whatever was hit."""

import random
import shutil
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ArclessError
from arcless.study import Study, StudyFolder, run, status
from arcless.study.executors.threads import Threads
from tests.support.studies import data, filled, made_up, rows, study

COUNT = 240  # some levels of the tree that the database keeps rows in
FORCE = {"field": "pantographs.0.static_force", "range": ["60 N", "120 N"], "count": COUNT // 2}
LARGE = {"variables": {**data()["variables"], "force": FORCE}}
FLIPS = [*range(40), *(pytest.param(n, marks=pytest.mark.evidence) for n in range(40, 300))]
CUTS = [*range(8), *(pytest.param(n, marks=pytest.mark.evidence) for n in range(8, 60))]


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let rows be made up where they would be computed."""

    def compute(
        _self: Threads, _task: Any, variants: Any, _count: int, take: Any, _stop: Any
    ) -> None:
        for one in variants:
            take(made_up(large(), one.number))

    monkeypatch.setattr(Threads, "compute", compute)


@cache
def large() -> Study:
    return study(**LARGE)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a study of many made-up rows, at rest."""
    folder = tmp_path_factory.mktemp("whole") / "study"
    place = StudyFolder(large(), folder)
    numbers = list(range(1, COUNT + 1))
    random.Random(1).shuffle(numbers)
    with place.open_journal() as kept:
        place.write_state(kept.mode)
        for number in numbers:
            kept.append(made_up(place.study, number))
    run(place.study, folder, resume=True)
    return folder


def flipped(content: bytes, seed: int) -> bytes:
    place = random.Random(seed).randrange(8 * len(content))
    spoilt = bytearray(content)
    spoilt[place // 8] ^= 1 << place % 8
    return bytes(spoilt)


def check_mended(folder: Path, expected: Path) -> None:
    """Resume, and see that the table is that of an undamaged study, or an error of ours."""
    made = large()
    status(made, folder)
    try:
        run(made, folder, resume=True)
    except ArclessError as error:
        assert error.hint, error
    else:
        assert rows(folder / "table.parquet") == rows(expected / "table.parquet")
        assert list(StudyFolder(made, folder).rows()) == list(StudyFolder(made, expected).rows())


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("seed", FLIPS)
def test_a_flipped_bit(whole: Path, tmp_path: Path, seed: int) -> None:
    shutil.copytree(whole, tmp_path / "study")
    file = tmp_path / "study" / "journal.db"
    file.write_bytes(flipped(file.read_bytes(), seed))
    check_mended(tmp_path / "study", whole)


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("seed", CUTS)
def test_a_file_cut_short(whole: Path, tmp_path: Path, seed: int) -> None:
    shutil.copytree(whole, tmp_path / "study")
    file = tmp_path / "study" / "journal.db"
    size = file.stat().st_size
    length = random.Random(seed).randrange(size) if seed % 2 else 4096 * (seed % (size // 4096))
    file.write_bytes(file.read_bytes()[:length])
    check_mended(tmp_path / "study", whole)


@pytest.fixture(scope="module")
def killed(whole: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of that study as a process left it that was killed: rows are in the log."""
    folder = tmp_path_factory.mktemp("killed") / "study"
    shutil.copytree(whole, folder)
    (folder / "journal.db").unlink()
    place = StudyFolder(large(), folder)
    with place.open_journal() as kept:
        for number in range(1, COUNT + 1):
            kept.append(made_up(place.study, number))
        for end in ("", "-wal"):
            shutil.copyfile(f"{kept.path}{end}", f"{kept.path}{end}.kept")
    for end in ("", "-wal"):
        Path(f"{kept.path}{end}.kept").replace(f"{kept.path}{end}")
    assert Path(f"{kept.path}-wal").stat().st_size > 100_000
    return folder


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("seed", FLIPS)
def test_a_flipped_bit_of_the_log(killed: Path, whole: Path, tmp_path: Path, seed: int) -> None:
    shutil.copytree(killed, tmp_path / "study")
    log = tmp_path / "study" / "journal.db-wal"
    log.write_bytes(flipped(log.read_bytes(), seed))
    computed = []
    place = StudyFolder(large(), tmp_path / "study")
    done = run(place.study, place.path, resume=True, tell=lambda now: computed.append(now.computed))
    # All rows stand in the log, and at most one of them is hit; long ones only SQLite finds.
    assert done.computed <= 1 + sum(number % 50 == 0 for number in range(1, COUNT + 1))
    assert rows(place.table) == rows(whole / "table.parquet")


@pytest.mark.usefixtures("quick")
def test_damage_is_told_and_put_aside(whole: Path, tmp_path: Path) -> None:
    shutil.copytree(whole, tmp_path / "study")
    file = tmp_path / "study" / "journal.db"
    spoilt = file.read_bytes().replace(b'"variant":17,', b'"variant":18,')
    file.write_bytes(spoilt)
    place = StudyFolder(large(), tmp_path / "study")
    found = status(place.study, place.path)
    assert (found.damaged, found.missing) == (1, 1)
    told: list[str] = []
    assert run(place.study, place.path, resume=True, note=told.append).computed == 1
    assert f"{COUNT - 1} rows of it could be read" in told[0]
    assert str(place.path / "journal-damaged-1.db") in told[0]
    assert (place.path / "journal-damaged-1.db").read_bytes() == spoilt
    found = status(place.study, place.path)
    assert (found.damaged, found.missing) == (0, 0)
    assert rows(place.table) == rows(whole / "table.parquet")


def test_a_file_that_is_none(tmp_path: Path) -> None:
    made = filled(tmp_path, of=2)
    for content in (b"no database " * 500, b"\0" * 9000, b"SQLite format 3\0" + b"\xff" * 5000):
        (tmp_path / "journal.db").write_bytes(content)
        assert status(made, tmp_path).damaged is None
        assert list(StudyFolder(made, tmp_path).rows()) == []
        with StudyFolder(made, tmp_path).open_journal() as kept:
            assert kept.damage is not None
    assert len(list(tmp_path.glob("journal-damaged-*.db"))) == 3
