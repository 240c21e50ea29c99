"""The checksum at the end of a result file."""

from pathlib import Path

import h5py
import pytest

import arcless
from arcless.dataset.netcdf import checksum
from arcless.dataset.netcdf.store import save
from arcless.errors import ResultFormatError
from tests.support.synthetic import synthetic_dataset


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "result.nc"
    save(synthetic_dataset(), path)
    return path


def test_a_sound_file_is_read_by_us_and_by_others(file: Path) -> None:
    assert file.read_bytes()[-checksum.SIZE :].startswith(checksum.MARK)
    assert arcless.open(file).dataset.sizes["time"] > 0
    with h5py.File(file) as opened:
        assert "contact_force" in opened


@pytest.mark.parametrize("where", [0, 100, 0.5, -checksum.SIZE - 1, -1])
def test_one_wrong_bit_anywhere_is_noticed(file: Path, where: float) -> None:
    data = bytearray(file.read_bytes())
    at = int(where * len(data)) if isinstance(where, float) else where
    data[at] ^= 1
    file.write_bytes(data)
    with pytest.raises(ResultFormatError, match="damaged"):
        arcless.open(file)


def test_zeros_in_the_middle_are_noticed(file: Path) -> None:
    data = bytearray(file.read_bytes())
    middle = len(data) // 2
    data[middle : middle + 4000] = bytes(4000)
    file.write_bytes(data)
    with pytest.raises(ResultFormatError, match="damaged"):
        arcless.open(file)


def test_a_file_without_the_line_is_read_as_it_is(file: Path) -> None:
    file.write_bytes(file.read_bytes()[: -checksum.SIZE])
    assert arcless.open(file).dataset.sizes["time"] > 0


def test_a_file_that_is_cut_short_is_refused(file: Path) -> None:
    data = file.read_bytes()
    for size in (0, 10, checksum.SIZE, len(data) // 2, len(data) - checksum.SIZE - 1):
        file.write_bytes(data[:size])
        with pytest.raises(ResultFormatError, match="cannot read"):
            arcless.open(file)
