"""Watching of a run whose server goes while it is watched."""

import threading

import pytest

from arcless.model import Scenario
from arcless.studio.motion.watching import Watching


class Gone:
    """A spool whose server is not there any more."""

    full = False

    def finish(self) -> None:
        raise BrokenPipeError


def test_a_server_that_is_gone_ends_the_run_and_says_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    said: list[object] = []
    monkeypatch.setattr(threading, "excepthook", said.append)
    watching = Watching(Scenario.__new__(Scenario), lambda *_, **__: Gone())  # type: ignore[arg-type,return-value]
    watching._spool = Gone()  # type: ignore[assignment]
    with pytest.raises(BrokenPipeError), watching:
        pass
    # What ended the run first is told, and not what followed from it.
    watching = Watching(Scenario.__new__(Scenario), lambda *_, **__: Gone())  # type: ignore[arg-type,return-value]
    watching._spool = Gone()  # type: ignore[assignment]
    with pytest.raises(KeyboardInterrupt), watching:
        raise KeyboardInterrupt
    assert said == []
