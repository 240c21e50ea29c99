"""Writing a file: whole or absent, and left-overs of killed writers."""

import os
import threading
from pathlib import Path

import pytest

from arcless.errors import OutputError
from arcless.results import unfinished
from arcless.results.files import check_writable, write_bytes


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
    at_work = tmp_path / unfinished.new_name()
    lock = unfinished.create_folder(at_work)
    left = tmp_path / unfinished.new_name()
    (left / "inside").mkdir(parents=True)
    (tmp_path / unfinished.new_name()).write_bytes(b"half")
    others = [tmp_path / ".arcless-notes", tmp_path / "result.nc"]
    for other in others:
        other.write_bytes(b"of the user")
    unfinished.sweep(tmp_path)
    assert sorted(tmp_path.iterdir()) == sorted([at_work, *others])
    os.close(lock)
    unfinished.sweep(tmp_path)
    assert sorted(tmp_path.iterdir()) == sorted(others)


def test_a_link_is_never_swept_through(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / unfinished.new_name()).symlink_to(tmp_path / "mine")
    unfinished.sweep(tmp_path)
    assert (tmp_path / "mine").is_dir()


def test_a_writer_that_was_swept_before_its_lock_begins_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    flock, name = unfinished.fcntl.flock, tmp_path / unfinished.new_name()

    def late(descriptor: int, operation: int) -> None:
        monkeypatch.setattr(unfinished.fcntl, "flock", flock)
        name.unlink()  # what a sweeper does that came between creating and locking
        flock(descriptor, operation)

    monkeypatch.setattr(unfinished.fcntl, "flock", late)
    with unfinished.create(name) as file:
        file.write(b"content")
    assert name.read_bytes() == b"content"


@pytest.mark.parametrize(
    ("place", "said"), [("none/x", "no folder"), ("folder", "a folder"), ("file/x", "no folder")]
)
def test_places_are_refused_before_computing(tmp_path: Path, place: str, said: str) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputError, match=said):
        check_writable(tmp_path / place)
