"""Locks between processes: held by one, seen by others, gone with their holder."""

import subprocess
import sys
from pathlib import Path, PurePath, PurePosixPath, PureWindowsPath
from urllib.parse import unquote, urlsplit

import pytest

from arcless.storage.lock import Lock, database_address, is_held

HOLDER = (
    "import sys, pathlib; from arcless.storage.lock import Lock\n"
    "print(Lock(pathlib.Path(sys.argv[1])).take(), flush=True); sys.stdin.read()\n"
)


def test_one_holds_it_at_a_time(tmp_path: Path) -> None:
    file = tmp_path / "a %b#.lock"
    one, other = Lock(file), Lock(file)
    assert not is_held(file)
    assert one.take()
    assert is_held(file)
    assert not other.take(0.05)
    one.close()
    assert not is_held(file)
    assert other.take()
    other.close()
    assert (file.read_bytes(), [path.name for path in tmp_path.iterdir()]) == (b"", [file.name])


def test_it_is_gone_with_its_holder(tmp_path: Path) -> None:
    file = tmp_path / "lock"
    with subprocess.Popen(
        [sys.executable, "-c", HOLDER, str(file)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"True\n"
        assert is_held(file)
        assert not Lock(file).take()
        holder.kill()
    assert not is_held(file)
    assert Lock(file).take()


@pytest.mark.parametrize(
    ("path", "address"),
    [
        (PurePosixPath("/lines/a b?#%.lock"), "file:///lines/a%20b%3F%23%25.lock?mode=ro"),
        (PureWindowsPath("C:\\lines\\a b.lock"), "file:///C:/lines/a%20b.lock?mode=ro"),
        (PureWindowsPath("\\\\server\\share\\a.lock"), "file:////server/share/a.lock?mode=ro"),
    ],
)
def test_addresses_of_databases(path: PurePath, address: str) -> None:
    found = database_address(path, "ro")
    assert found == address
    assert urlsplit(found).netloc == ""  # SQLite refuses a host
    assert unquote(urlsplit(found).path).lstrip("/") == path.as_posix().lstrip("/")


def test_what_is_no_lock(tmp_path: Path) -> None:
    assert not is_held(tmp_path / "none")
    with pytest.raises(FileNotFoundError):
        Lock(tmp_path / "none" / "lock")
    (tmp_path / "text").write_bytes(b"words of somebody " * 100)
    with pytest.raises(OSError, match="no lock: file is not a database"):
        Lock(tmp_path / "text").take()
    assert not is_held(tmp_path / "text")
