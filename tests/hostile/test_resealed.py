"""Result files that somebody changed and sealed again: an error of ours, and never a guess."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

import arcless
from arcless.dataset.netcdf import checksum
from arcless.errors import ResultFormatError

SHORT = Path(__file__).parents[1] / "interface" / "data" / "short.yaml"
Change = Callable[[Any], None]


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    file = tmp_path_factory.mktemp("sound") / "result.nc"
    arcless.run(arcless.load(SHORT)).save(file)
    return file.read_bytes()


@pytest.fixture
def resealed(sound: bytes, tmp_path: Path) -> Callable[[Change], Path]:
    def make(change: Change) -> Path:
        path = tmp_path / "result.nc"
        path.write_bytes(sound)
        with h5py.File(path, "r+") as file:
            change(file)
        with path.open("r+b") as opened:
            checksum.put(opened)
        return path

    return make


def attribute(name: str, value: Any) -> Change:
    def change(file: Any) -> None:
        file.attrs[name] = value

    return change


def group(file: Any) -> None:
    del file["contact_force"]
    file.create_group("contact_force")


def text(file: Any) -> None:
    dims = [scale[0] for scale in file["contact_force"].dims]
    shape = file["contact_force"].shape
    del file["contact_force"]
    made = file.create_dataset("contact_force", data=np.full(shape, b"x"))
    for number, scale in enumerate(dims):
        made.dims[number].attach_scale(scale)


def turned(file: Any) -> None:
    force = file["contact_force"]
    values, dims = force[()].T, [scale[0] for scale in force.dims][::-1]
    del file["contact_force"]
    made = file.create_dataset("contact_force", data=values)
    for number, scale in enumerate(dims):
        made.dims[number].attach_scale(scale)


def loose(file: Any) -> None:
    values = file["contact_force"][()]
    del file["contact_force"]
    file.create_dataset("contact_force", data=values)


def spoilt_number(value: float) -> Change:
    def change(file: Any) -> None:
        file["contact_force"][7, 0] = value

    return change


CHANGES = {
    "brackets": attribute("section_m", "[" * 100_000),
    "three numbers": attribute("section_m", "[1, 2, 3]"),
    "words": attribute("section_m", '["a", "b"]'),
    "infinite": attribute("section_m", "[0, 1e999]"),
    "warnings are no list": attribute("warnings", "5"),
    "warnings are no texts": attribute("warnings", "[5]"),
    "forces are no numbers": attribute("static_force_found", '{"a": []}'),
    "scenario is a list": attribute("scenario", "[]"),
    "scenario is deep": attribute("scenario", '{"a":' * 50_000 + "1" + "}" * 50_000),
    "steps are a text": attribute("steps", "many"),
    "time is not a number": attribute("wall_time_s", float("nan")),
    "a group": group,
    "texts": text,
    "turned": turned,
    "without dimensions": loose,
    "no number": spoilt_number(float("nan")),
    "infinite force": spoilt_number(float("inf")),
}


@pytest.mark.parametrize("kind", CHANGES)
def test_it_is_refused(resealed: Callable[[Change], Path], kind: str, tmp_path: Path) -> None:
    path = resealed(CHANGES[kind])
    with pytest.raises((ResultFormatError, arcless.errors.ModelError)) as caught:
        result = arcless.open(path)
        json.loads(result.assessment.to_json())
        result.write_report(tmp_path / "report.html")
    assert "Traceback" not in str(caught.value)
    assert len(str(caught.value)) < 1000


def test_sealing_anew_alone_is_no_harm(resealed: Callable[[Change], Path], tmp_path: Path) -> None:
    result = arcless.open(resealed(lambda _file: None))
    assert "NaN" not in result.assessment.to_json()
    result.write_report(tmp_path / "report.html")
