"""Saving and opening: bit-exact, whole or absent, and nothing else is taken for a result."""

import json
import subprocess
import sys
from pathlib import Path

import h5netcdf
import numpy as np
import pytest

from arcless import results
from arcless.errors import OutputError, ResultFormatError
from arcless.model import load
from arcless.results import Result, open_dataset, save
from arcless.storage import whole_files
from tests.support.synthetic import scenario_data, synthetic_dataset

REPOSITORY = Path(__file__).parents[4]


@pytest.fixture(scope="module")
def dataset():
    # Irrational values everywhere: rounding in the file would show.
    return synthetic_dataset(
        duration_s=2.0,
        speed_m_s=50.0,
        section=(20.0, 80.0),
        pantographs=("P1", "Stromabnehmer hinten é"),
        distance_m=10.0,
        force=lambda t: 100.0 + 30.0 * np.sin(7.0 * t) / 3.0,
    )


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "an empty file"),
        (b"PK\3\4" + bytes(100), "an Excel workbook or another ZIP file"),
        (b"time [s],contact_force [N]\n0,100\n", "a file of another kind"),
    ],
)
def test_a_file_of_another_kind_is_named(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "x.xlsx"
    path.write_bytes(content)
    with pytest.raises(ResultFormatError, match=f"got {words}, expected a NetCDF file") as raised:
        open_dataset(path)
    assert "CSV" in str(raised.value.hint)


def test_round_trip_keeps_every_bit(dataset, tmp_path: Path) -> None:
    save(dataset, tmp_path / "x.nc")
    again = open_dataset(tmp_path / "x.nc")
    assert list(again.variables) == list(dataset.variables)
    for name, variable in dataset.variables.items():
        assert again[name].dims == variable.dims
        assert again[name].attrs == variable.attrs
        if variable.dtype.kind == "f":
            assert again[name].values.tobytes() == variable.values.tobytes(), name
        else:
            assert again[name].values.tolist() == variable.values.tolist(), name
    assert results.metadata(again) == results.metadata(dataset)


def test_saving_twice_gives_the_same_dataset_and_one_file(dataset, tmp_path: Path) -> None:
    path = tmp_path / "x.nc"
    save(dataset, path)
    save(open_dataset(path), path)
    assert open_dataset(path).identical(open_dataset(path))
    assert [p.name for p in tmp_path.iterdir()] == ["x.nc"]


def test_result_opens_with_its_scenario(dataset, tmp_path: Path) -> None:
    scenario = load(json.loads(dataset.attrs["scenario"]))
    Result(dataset, scenario).save(tmp_path / "x.nc")
    again = results.open(tmp_path / "x.nc")
    assert again.scenario == scenario
    assert again.assessment.to_dict() == Result(dataset, scenario).assessment.to_dict()
    assert "synthetic" in repr(again)


def test_an_opened_result_is_saved_again(dataset, tmp_path: Path) -> None:
    save(dataset, tmp_path / "x.nc")
    results.open(tmp_path / "x.nc").save(tmp_path / "again.nc")
    assert open_dataset(tmp_path / "again.nc").identical(open_dataset(tmp_path / "x.nc"))


def test_other_programs_can_read_the_file(dataset, tmp_path: Path) -> None:
    save(dataset, tmp_path / "x.nc")
    with h5netcdf.File(tmp_path / "x.nc") as file:
        force = file.variables["contact_force"]
        assert force.dimensions == ("time", "pantograph")
        assert force.attrs["units"] == "N"
        assert "_FillValue" not in force.attrs


class Interrupted(KeyboardInterrupt):
    pass


@pytest.mark.parametrize("error", [Interrupted, OSError, MemoryError])
@pytest.mark.parametrize("before", [None, b"older"])
def test_interrupted_save_leaves_the_folder_as_it_was(
    dataset, tmp_path: Path, monkeypatch, error, before
) -> None:
    path = tmp_path / "x.nc"
    if before is not None:
        path.write_bytes(before)

    def stop(_: int) -> None:
        raise error

    monkeypatch.setattr(whole_files.os, "fsync", stop)
    with pytest.raises((error, OutputError)):
        save(dataset, path)
    left = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    assert left == ({} if before is None else {"x.nc": before})


# Root may write into read-only folders, so the places here are impossible for anyone.
def test_places_that_cannot_be_written(dataset, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    for place in ("missing/x.nc", "file/x.nc", "."):
        with pytest.raises(OutputError) as caught:
            save(dataset, tmp_path / place)
        assert str(tmp_path) in str(caught.value)
        assert caught.value.exit_code == 2
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


FULL_DISK = """
import resource, sys
from arcless.errors import OutputError
from arcless.results import save
from tests.support.synthetic import synthetic_dataset
dataset = synthetic_dataset(duration_s=2.0, section=(10.0, 30.0))
resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
try:
    save(dataset, sys.argv[1])
except OutputError as error:
    print("refused:", error)
"""


# HDF5 crashes the process when its own writes fail; a limit on file size stands for the full disk.
def test_full_disk_is_an_error_and_not_a_crash(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", FULL_DISK, str(tmp_path / "x.nc")],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("refused:")
    assert done.stderr == ""
    assert list(tmp_path.iterdir()) == []


def write_other_netcdf(path: Path) -> None:
    with h5netcdf.File(path, "w") as file:
        file.dimensions["x"] = 1
        file.create_variable("y", ("x",), float)


def write_newer_format(path: Path) -> None:
    newer = synthetic_dataset(duration_s=1.0, section=(5.0, 15.0))
    save(newer.assign_attrs(format="arcless-result/2"), path)


def write_without_force(path: Path) -> None:
    save(synthetic_dataset(duration_s=1.0, section=(5.0, 15.0)).drop_vars("contact_force"), path)


def write_damaged_attribute(path: Path) -> None:
    damaged = synthetic_dataset(duration_s=1.0, section=(5.0, 15.0))
    save(damaged.assign_attrs(scenario="{half"), path)


def write_half(path: Path) -> None:
    save(synthetic_dataset(duration_s=1.0, section=(5.0, 15.0)), path)
    path.write_bytes(path.read_bytes()[:5000])


@pytest.mark.parametrize(
    ("write", "said"),
    [
        (lambda path: None, "no such result file"),
        (lambda path: path.mkdir(), "no run in this folder"),
        (lambda path: path.write_bytes(b""), "cannot read"),
        (lambda path: path.write_text("speed: 300 km/h"), "cannot read"),
        (lambda path: path.write_bytes(bytes(range(256)) * 50), "cannot read"),
        (write_half, "cannot read"),
        (write_other_netcdf, "arcless-result/1"),
        (write_newer_format, "got arcless-result/2"),
        (write_without_force, "contact_force"),
        (write_damaged_attribute, "damaged"),
    ],
)
def test_what_is_no_result_is_refused_in_one_message(tmp_path: Path, write, said: str) -> None:
    path = tmp_path / "x.nc"
    write(path)
    with pytest.raises(ResultFormatError) as caught:
        results.open(path)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
    assert str(path) in str(caught.value)


def test_scenario_survives_with_its_provenance(tmp_path: Path) -> None:
    scenario = scenario_data()
    save(synthetic_dataset(duration_s=1.0, section=(5.0, 15.0), scenario=scenario), tmp_path / "x")
    stored = results.open(tmp_path / "x").scenario.line.provenance
    assert stored["contact_wire.tension"].source == "S1"
