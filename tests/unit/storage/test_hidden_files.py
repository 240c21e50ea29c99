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


@pytest.mark.parametrize("work", [claim_file, claim_folder])
def test_interrupted_at_each_place(
    tmp_path: Path, work: Callable[[Path], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    # The cleaning up is not interrupted: a second signal within a second is none.
    for module, name in ((hidden_files, "_remove_file"), (hidden_files.Claim, "close")):
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
