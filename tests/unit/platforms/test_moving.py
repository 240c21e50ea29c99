"""Files moved to their place while another program has them open, as on Windows."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from arcless.platforms import moving
from arcless.platforms.moving import move


@pytest.fixture
def files(tmp_path: Path) -> tuple[Path, Path]:
    source, target = tmp_path / "new", tmp_path / "old"
    source.write_bytes(b"new")
    target.write_bytes(b"old")
    return source, target


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return the time of a clock that only waiting moves."""
    now = [0.0]

    def sleep(time_s: float) -> None:
        now[0] += time_s

    monkeypatch.setattr(moving, "time", SimpleNamespace(monotonic=lambda: now[0], sleep=sleep))
    return now


def held(monkeypatch: pytest.MonkeyPatch, refusals: int) -> list[int]:
    """Refuse to move so many times, as Windows does while a program has the file open."""
    left, replace = [refusals], Path.replace

    def refusing(source: Path, target: Path) -> Path:
        left[0] -= 1
        if left[0] >= 0:
            raise PermissionError(13, "Access is denied", str(target))
        return replace(source, target)

    monkeypatch.setattr(Path, "replace", refusing)
    return left


def test_it_is_tried_until_nobody_has_the_file(
    files: tuple[Path, Path], clock: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    held(monkeypatch, 5)
    move(*files, patience_s=1.0)
    assert files[1].read_bytes() == b"new"
    assert not files[0].exists()
    assert 0.0 < clock[0] < 1.0


def test_it_gives_up_and_leaves_both(
    files: tuple[Path, Path], clock: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    held(monkeypatch, 1000)
    with pytest.raises(PermissionError):
        move(*files, patience_s=1.0)
    assert (files[0].read_bytes(), files[1].read_bytes()) == (b"new", b"old")
    assert clock[0] == pytest.approx(1.0, abs=0.1)


def test_on_posix_a_refusal_is_final(
    files: tuple[Path, Path], clock: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(moving, "sys", SimpleNamespace(platform="linux"))
    left = held(monkeypatch, 1000)
    with pytest.raises(PermissionError):
        move(*files)
    assert (left[0], clock[0]) == (999, 0.0)


def test_on_windows_it_waits_for_seconds(
    files: tuple[Path, Path], clock: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(moving, "sys", SimpleNamespace(platform="win32"))
    held(monkeypatch, 10)
    move(*files)
    assert files[1].read_bytes() == b"new"
