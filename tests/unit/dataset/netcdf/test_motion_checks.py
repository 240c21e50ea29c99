"""Recorded motion whose rows are not of its line is refused when a file is opened."""

from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

import arcless
from arcless.dataset.netcdf.netcdf_file import NEVER_PACKED
from arcless.dataset.netcdf.store import open_plain, save
from arcless.errors import ResultFormatError

MOVING = {"travel.end": "200 m", "analysis.spans": [2, 3], "output.motion": True}


@pytest.fixture(scope="module")
def dataset() -> Any:
    return arcless.run(arcless.load("en50318-ac-simple-320").with_(**MOVING)).dataset


def with_value(dataset: Any, name: str, place: tuple[int, ...], value: object) -> Any:
    spoilt = dataset.copy(deep=True)
    values = spoilt[name].values.copy()
    values[place] = value
    if name in spoilt.coords:
        return spoilt.assign_coords({name: values})
    spoilt[name] = (dataset[name].dims, values, dataset[name].attrs)
    return spoilt


def opened(dataset: Any, file: Path) -> None:
    save(dataset, file)
    open_plain(file)


def test_a_whole_record_is_opened(dataset: Any, tmp_path: Path) -> None:
    opened(dataset, tmp_path / "x.nc")


@pytest.mark.parametrize(
    ("name", "place", "value", "words"),
    [
        ("motion_first", (7, 0), -1, "node -1 in row 7"),
        ("motion_first", (7, 1), 10**9, "node 1000000000 in row 7"),
        ("motion_count", (0,), 10**6, "nodes in a row"),
        ("motion_count", (1,), -5, "nodes in a row"),
        ("motion_dropper_first", (3,), 10**6, "place 1000000 in row 3"),
        ("motion_dropper_first", (3,), -1, "place -1 in row 3"),
        ("motion_dropper_order", (0,), 5, "another order"),
        ("motion_wire", (0,), "contact_wire", "got contact_wire"),
        ("motion_wire", (0,), "cloud 1", "got cloud 1"),
        ("motion_wire", (1,), "stitch_wire 1", "got stitch_wire 1"),
    ],
)
def test_rows_that_are_not_of_the_line(
    dataset: Any, tmp_path: Path, *, name: str, place: tuple[int, ...], value: object, words: str
) -> None:
    spoilt = with_value(dataset, name, place, value)
    with pytest.raises(ResultFormatError, match="not of its line") as told:
        opened(spoilt, tmp_path / "x.nc")
    assert words in str(told.value)
    assert f"x.nc: {name}" in str(told.value)


@pytest.mark.parametrize(
    "name", ["motion_first", "motion_count", "motion_dropper_first", "motion_dropper_order"]
)
def test_a_part_that_is_missing(dataset: Any, tmp_path: Path, name: str) -> None:
    with pytest.raises(ResultFormatError, match=f"incomplete.*{name}"):
        opened(dataset.drop_vars(name), tmp_path / "x.nc")


def test_motion_is_not_packed(dataset: Any, tmp_path: Path) -> None:
    """Packing it took longer than the run: of a whole file, and of one written in pieces."""
    motion = arcless.load("en50318-ac-simple-320").with_(**MOVING)
    result = arcless.run(motion)
    result.save(tmp_path / "whole.nc")
    arcless.run(motion, to=tmp_path / "pieces.nc")
    for file in ("whole.nc", "pieces.nc"):
        with h5py.File(tmp_path / file) as found:
            packed = {name for name in found if found[name].compression is not None}
            there = {name for name in found if name in NEVER_PACKED}
            assert there == NEVER_PACKED
            assert not packed & NEVER_PACKED
            assert "contact_force" in packed
            np.testing.assert_array_equal(found["motion_up"][:], dataset["motion_up"].values)
