"""Runs that many tests look at, answered once for all processes of one pytest session."""

import fcntl
import hashlib
from collections.abc import Callable
from pathlib import Path

import pytest

import arcless
from arcless.results import Result


class RunsOnce:
    """Results by key; the first process that asks computes, the others read its file.

    A result file keeps every bit (tests/unit/dataset/netcdf/test_store.py), so it does not
    matter which test runs where.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._known: dict[str, Result] = {}

    def answer(self, key: str, compute: Callable[[], Result]) -> Result:
        """Return the result of a key, computed where nobody has done so yet."""
        if key not in self._known:
            file = self._folder / f"run-{hashlib.sha256(key.encode()).hexdigest()[:16]}.nc"
            with file.with_suffix(".lock").open("w") as lock:
                fcntl.flock(lock, fcntl.LOCK_EX)  # whoever waits here finds the file afterwards
                if not file.exists():
                    compute().save(file)
            self._known[key] = arcless.open(file)
        return self._known[key]


def folder_of_session(factory: pytest.TempPathFactory) -> Path:
    """Return the temporary folder that all processes of this pytest session share."""
    own = factory.getbasetemp()
    # Not by the environment: a pytest that a worker starts inherits that, and is another session.
    return own.parent if own.name.startswith("popen-") else own
