"""Hidden files of writers that are interrupted: nothing stays, wherever Ctrl-C is pressed."""

import dis
import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

from arcless.storage import hidden_files, lock

HERE = {hidden_files.__file__, lock.__file__}
# After these instructions CPython answers signals: a call, the start of a function, a loop.
ANSWERING = ("CALL", "RESUME", "JUMP_BACKWARD")


def test_a_temporary_folder_goes_with_its_block(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with hidden_files.temporary_folder() as folder:
        (folder / "file").write_bytes(b"content")
        hidden_files.sweep_temporary()  # somebody is at work there
        assert (folder / "file").exists()
    assert list(tmp_path.iterdir()) == []


def interrupted(work: Callable[[], Any], place: int) -> bool:
    """Work, and be interrupted at a place in these modules; return whether there was one."""
    seen = 0
    last: dict[FrameType, str] = {}

    def trace(frame: FrameType, event: str, _argument: Any) -> Any:
        nonlocal seen
        if frame.f_code.co_filename not in HERE or seen > place:
            return None
        frame.f_trace_opcodes = True
        if event == "opcode":
            seen += last.get(frame, "").startswith(ANSWERING)
            last[frame] = dis.opname[frame.f_code.co_code[frame.f_lasti]]
            if seen > place:
                raise KeyboardInterrupt
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        work()
    except KeyboardInterrupt:
        return True
    finally:
        sys.settrace(before)
    return False


def claim_file(folder: Path) -> None:
    with hidden_files.claimed(folder / hidden_files.new_name()):
        pass


def claim_folder(folder: Path) -> None:
    path = folder / hidden_files.new_name()
    claim = hidden_files.create_folder(path)
    path.rmdir()
    claim.close()


def write_alone(folder: Path) -> None:
    lock = hidden_files.claim_folder(folder)
    assert lock is not None
    hidden_files.release(lock)


@pytest.mark.parametrize("work", [claim_file, claim_folder, write_alone])
def test_interrupted_at_each_place(
    tmp_path: Path, work: Callable[[Path], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    # The cleaning up is not interrupted: a second signal within a second is none.
    cleaning = [(hidden_files, name) for name in ("_remove_file", "release")]
    for module, name in (*cleaning, (hidden_files.Claim, "close")):
        monkeypatch.setattr(module, name, untraced(getattr(module, name)))
    stopped = 0
    while interrupted(lambda: work(tmp_path), stopped):
        assert list(tmp_path.iterdir()) == [], f"place {stopped}"
        stopped += 1
    assert stopped > 10
    assert list(tmp_path.iterdir()) == []


def untraced(work: Callable[..., Any]) -> Callable[..., Any]:
    def call(*arguments: Any) -> Any:
        trace = sys.gettrace()
        sys.settrace(None)
        try:
            return work(*arguments)
        finally:
            sys.settrace(trace)

    return call


def test_a_folder_has_one_writer(tmp_path: Path) -> None:
    first = hidden_files.claim_folder(tmp_path)
    assert first is not None
    hidden_files.sweep(tmp_path)  # which leaves what is in use
    assert hidden_files.claim_folder(tmp_path) is None
    hidden_files.release(first)
    assert list(tmp_path.iterdir()) == []
    again = hidden_files.claim_folder(tmp_path)
    assert again is not None
    hidden_files.release(again)


def test_a_writer_that_was_killed_keeps_nobody_out(tmp_path: Path) -> None:
    (tmp_path / f"{hidden_files.PREFIX}writer.lock").touch()
    lock = hidden_files.claim_folder(tmp_path)
    assert lock is not None
    hidden_files.release(lock)
    assert list(tmp_path.iterdir()) == []
