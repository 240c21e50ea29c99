"""Reading and writing at places of one file from many threads, in the way of Windows too."""

import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from arcless.platforms.positioned import read_at, seek_and_read, seek_and_write, write_at

WAYS = [
    pytest.param(read_at, write_at, id="own"),
    pytest.param(seek_and_read, seek_and_write, id="windows"),
]
SIZE, PIECES = 64, 500


@pytest.mark.parametrize(("read", "write"), WAYS)
def test_threads_do_not_disturb_each_other(tmp_path: Path, read: Any, write: Any) -> None:
    def content(number: int) -> bytes:
        return f"{number:>{SIZE}}".encode()

    with (tmp_path / "file").open("w+b", buffering=0) as file, ThreadPoolExecutor(8) as threads:
        descriptor = file.fileno()

        def put(number: int) -> int:
            return int(write(descriptor, memoryview(content(number)), number * SIZE))

        assert set(threads.map(put, reversed(range(PIECES)))) == {SIZE}
        found = list(threads.map(lambda n: read(descriptor, SIZE, n * SIZE), range(PIECES)))
        assert found == [content(number) for number in range(PIECES)]
        assert read(descriptor, SIZE, PIECES * SIZE) == b""
        assert os.fstat(descriptor).st_size == PIECES * SIZE
