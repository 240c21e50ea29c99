"""Temporary files of two processes: given as they are open, or by their name as on Windows."""

import os
import tempfile
from collections.abc import Callable
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

from arcless.platforms.positioned import seek_and_read, seek_and_write
from arcless.platforms.shared_files import (
    new_file,
    receive_file,
    receive_name,
    send_file,
    send_name,
)

CONTENT = b"row" * 1000


def write_there(line: Connection, receive: Callable[[Connection], int]) -> None:
    """Write into the file of the other process."""
    descriptor = receive(line)
    seek_and_write(descriptor, memoryview(CONTENT), 5)
    os.close(descriptor)
    line.send("written")


def test_an_open_file_is_written_by_a_spawned_process() -> None:
    context = get_context("spawn")
    here, there = context.Pipe()
    with new_file() as file:
        writer = context.Process(target=write_there, args=(there, receive_file))
        writer.start()
        assert writer.pid is not None
        send_file(here, file, writer.pid)
        assert here.recv() == "written"
        writer.join()
        assert seek_and_read(file.fileno(), len(CONTENT), 5) == CONTENT


def test_a_file_by_its_name_as_on_windows() -> None:
    context = get_context("spawn")
    here, there = context.Pipe()
    # On Windows this is what `TemporaryFile` gives.
    with tempfile.NamedTemporaryFile("w+b", buffering=0) as file:
        writer = context.Process(target=write_there, args=(there, receive_name))
        writer.start()
        send_name(here, file)  # type: ignore[arg-type]
        assert here.recv() == "written"
        writer.join()
        assert seek_and_read(file.fileno(), len(CONTENT), 5) == CONTENT


def test_a_name_that_is_gone() -> None:
    here, there = get_context("spawn").Pipe()
    here.send("/none/of/these")
    with pytest.raises(FileNotFoundError):
        receive_name(there)


def test_nothing_of_it_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    with new_file() as file:
        file.write(CONTENT)
    assert list(tmp_path.iterdir()) == []
