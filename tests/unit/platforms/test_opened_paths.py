"""Files that are opened where their path says, in the way of Windows, which knows no `openat`."""

import os
import sys
from pathlib import Path

import pytest

from arcless.platforms.opened_paths import open_in_place, plain_path

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="/proc says what is open")


def path_of(descriptor: int) -> str:
    return str(Path(f"/proc/self/fd/{descriptor}").readlink())


def test_a_file_in_its_place(tmp_path: Path) -> None:
    file = tmp_path.resolve() / "a" / "line.yaml"
    file.parent.mkdir()
    file.write_bytes(b"a line")
    descriptor = open_in_place(file, path_of)
    with os.fdopen(descriptor, "rb") as opened:
        assert opened.read() == b"a line"


@pytest.mark.parametrize("swapped", ["the file", "the folder"])
def test_a_link_that_was_put_in(tmp_path: Path, swapped: str) -> None:
    here = tmp_path.resolve()
    (here / "secret").mkdir()
    (here / "secret" / "line.yaml").write_bytes(b"a secret")
    if swapped == "the folder":
        (here / "a").symlink_to(here / "secret")
    else:
        (here / "a").mkdir()
        (here / "a" / "line.yaml").symlink_to(here / "secret" / "line.yaml")
    before = len(os.listdir("/proc/self/fd"))  # noqa: PTH208
    with pytest.raises(OSError, match="a link leads to another file"):
        open_in_place(here / "a" / "line.yaml", path_of)
    assert len(os.listdir("/proc/self/fd")) == before  # noqa: PTH208


def test_a_pipe_does_not_wait(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    os.close(open_in_place(tmp_path.resolve() / "pipe", path_of))


@pytest.mark.parametrize(
    ("extended", "plain"),
    [
        ("\\\\?\\C:\\lines\\a.yaml", "C:\\lines\\a.yaml"),
        ("\\\\?\\UNC\\server\\lines\\a.yaml", "\\\\server\\lines\\a.yaml"),
        ("C:\\lines\\a.yaml", "C:\\lines\\a.yaml"),
    ],
)
def test_long_paths_of_windows(extended: str, plain: str) -> None:
    assert plain_path(extended) == plain
