"""Writing a file: whole or absent, and left-overs of killed writers."""

import errno
import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from arcless.errors import OutputError
from arcless.storage import hidden_files
from arcless.storage.lock import Lock
from arcless.storage.whole_files import check_writable, write_bytes


def test_a_pipe_is_written_and_not_replaced(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    read: list[bytes] = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_bytes()), daemon=True)
    reader.start()
    write_bytes(pipe, b"content")
    reader.join(timeout=10)
    assert read == [b"content"]
    assert pipe.is_fifo()
    assert list(tmp_path.iterdir()) == [pipe]
    check_writable(pipe)


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "file")
    write_bytes(tmp_path / "link", b"new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "file").read_bytes() == b"new"


def test_links_in_a_circle_are_refused(tmp_path: Path) -> None:
    (tmp_path / "a").symlink_to(tmp_path / "b")
    (tmp_path / "b").symlink_to(tmp_path / "a")
    with pytest.raises(OutputError, match="no folder"):
        check_writable(tmp_path / "a" / "x.nc")
    with pytest.raises(OutputError, match="symbolic links"):
        write_bytes(tmp_path / "a" / "x.nc", b"new")


def test_only_what_nobody_holds_is_swept(tmp_path: Path) -> None:
    at_work = tmp_path / hidden_files.new_name()
    claim = hidden_files.create_folder(at_work)
    left = tmp_path / hidden_files.new_name()
    (left / "inside").mkdir(parents=True)
    (tmp_path / hidden_files.new_name()).write_bytes(b"half")
    others = [tmp_path / ".arcless-notes", tmp_path / "result.nc"]
    for other in others:
        other.write_bytes(b"of the user")
    hidden_files.sweep(tmp_path)
    beside = at_work.with_name(at_work.name + ".lock")
    assert sorted(tmp_path.iterdir()) == sorted([at_work, beside, *others])
    claim.close()
    at_work.rmdir()
    (tmp_path / f"{hidden_files.new_name()}.lock").touch()  # killed before it had a file
    hidden_files.sweep(tmp_path)
    assert sorted(tmp_path.iterdir()) == sorted(others)


def test_what_another_process_holds_is_not_swept(tmp_path: Path) -> None:
    script = (
        "import sys, pathlib; from arcless.storage import hidden_files\n"
        "with hidden_files.claimed(pathlib.Path(sys.argv[1])):\n"
        "    pathlib.Path(sys.argv[1]).touch(); print('held', flush=True); sys.stdin.read()\n"
    )
    name = tmp_path / hidden_files.new_name()
    with subprocess.Popen(
        [sys.executable, "-c", script, str(name)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as other:
        assert other.stdout is not None
        assert other.stdout.readline() == b"held\n"
        hidden_files.sweep(tmp_path)
        assert name.exists()
        other.kill()
    hidden_files.sweep(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_where_there_are_no_locks_nothing_is_swept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def none(_lock: Lock, _wait_s: float = 0.0) -> bool:
        raise OSError(errno.ENOLCK, "no locks")

    monkeypatch.setattr(Lock, "take", none)
    write_bytes(tmp_path / "file", b"content")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]
    left = tmp_path / hidden_files.new_name()
    left.touch()
    hidden_files.sweep(tmp_path)
    assert left.exists()


def test_a_link_is_never_swept_through(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / hidden_files.new_name()).symlink_to(tmp_path / "mine")
    hidden_files.sweep(tmp_path)
    assert (tmp_path / "mine").is_dir()


def test_a_writer_that_was_swept_before_its_lock_begins_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    take, name = Lock.take, tmp_path / hidden_files.new_name()

    def late(lock: Lock, wait_s: float) -> bool:
        monkeypatch.setattr(Lock, "take", take)
        lock.path.unlink()  # what a sweeper does that came between making and taking
        return take(lock, wait_s)

    monkeypatch.setattr(Lock, "take", late)
    with hidden_files.claimed(name):
        name.write_bytes(b"content")
        hidden_files.sweep(tmp_path)
        assert name.read_bytes() == b"content"


@pytest.mark.parametrize(
    ("place", "said"), [("none/x", "no folder"), ("folder", "a folder"), ("file/x", "no folder")]
)
def test_places_are_refused_before_computing(tmp_path: Path, place: str, said: str) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputError, match=said):
        check_writable(tmp_path / place)
