"""A result in pieces: the whole dataset, or an error that says why."""

import errno
import io
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
import pytest

from arcless.dataset.netcdf.error_keeping_file import ErrorKeepingFile
from arcless.dataset.netcdf.stream_writer import Writer
from arcless.errors import OutputError, ResultFormatError
from arcless.results import open_dataset
from arcless.storage.whole_files import replacing
from tests.support.synthetic import synthetic_dataset

ROWS = 400


@pytest.fixture(scope="module")
def dataset() -> Any:
    return synthetic_dataset(
        duration_s=2.0,
        speed_m_s=50.0,
        section=(20.0, 80.0),
        pantographs=("P1",),
        distance_m=10.0,
        force=lambda t: 100.0 + 30.0 * np.sin(7.0 * t) / 3.0,
    )


def pieces(dataset: Any, ends: list[int]) -> Any:
    """Yield the series of a dataset between rows; those of the line begin with the second piece."""
    names = [n for n in dataset.data_vars if dataset[n].dims[0] == "time"]
    for first, last in zip([0, *ends[:-1]], ends, strict=True):
        rows = slice(first, last)
        series = {name: dataset[name].values[rows] for name in names}
        yield series, {"time": dataset["time"].values[rows]}


def write(file: BinaryIO, dataset: Any, ends: list[int], rows: int) -> None:
    kept = [n for n in dataset.data_vars if dataset[n].dims[0] not in ("time", "line_time")]
    names = {d: dataset[d].values for d in dataset.dims if d not in ("time", "line_time")}
    with Writer(file, {"time": rows}, names) as writer:
        for series, labels in pieces(dataset, ends):
            writer.append(series, labels)
        static = {name: dataset[name].values for name in kept}
        writer.finish(static, {n: v for n, v in dataset.attrs.items() if n != "format"})


@pytest.mark.parametrize("ends", [[-1], [1, -1], [100, 101, 200, -1]])
def test_pieces_of_any_length(dataset: Any, ends: list[int], tmp_path: Path) -> None:
    rows = dataset.sizes["time"]
    with replacing(tmp_path / "x.nc") as file:
        write(file, dataset, [end if end > 0 else rows for end in ends], rows)
    again = open_dataset(tmp_path / "x.nc")
    for name in again.variables:
        assert (
            again[name].values.tobytes() == dataset[name].values.astype(again[name].dtype).tobytes()
        )
        assert again[name].attrs == dataset[name].attrs
    assert again.attrs == dataset.attrs


@pytest.mark.parametrize(
    ("ends", "rows", "said"),
    [([200], ROWS, "incomplete"), ([200, 300], 250, "too many rows")],
)
def test_rows_must_be_as_many_as_were_told(
    dataset: Any, ends: list[int], rows: int, said: str, tmp_path: Path
) -> None:
    with pytest.raises(ResultFormatError, match=said), replacing(tmp_path / "x.nc") as file:
        write(file, dataset, ends, rows)
    assert list(tmp_path.iterdir()) == []


def test_times_must_go_on(dataset: Any, tmp_path: Path) -> None:
    series, labels = next(pieces(dataset, [100]))
    with (
        pytest.raises(ResultFormatError, match="does not increase"),
        replacing(tmp_path / "x.nc") as file,
        Writer(file, {"time": ROWS}, {"pantograph": ["P1"]}) as writer,
    ):
        writer.append(series, labels)
        writer.append(series, labels)


class Full(io.BytesIO):
    """A disk that has room for so many bytes."""

    room = 20_000

    def write(self, content: Any) -> int:
        if self.tell() + len(content) > self.room:
            raise OSError(errno.ENOSPC, "No space left on device")
        return super().write(content)


def test_a_full_disk_is_told_by_the_disk(dataset: Any, tmp_path: Path) -> None:
    with pytest.raises(OSError, match="No space left"):
        write(Full(), dataset, [200, 400], ROWS)
    with pytest.raises(OutputError, match="No space left"), replacing(tmp_path / "x.nc"):
        write(Full(), dataset, [200, 400], ROWS)
    assert list(tmp_path.iterdir()) == []


def test_a_disk_that_has_failed_goes_on_as_if_nothing_were() -> None:
    file = Full(b"abc")
    disk = ErrorKeepingFile(file)
    assert disk.write(memoryview(b"0" * 30_000)) == 30_000
    assert disk.tell() == 30_000
    file.close()
    disk.seek(0)
    assert disk.read(4) == b"\0" * 4
    assert disk.truncate(10) == 10
    assert disk.seek(-2, io.SEEK_END) == 8
    with pytest.raises(OSError, match="No space left"):
        disk.check()
