"""A dataset without xarray is the same dataset, in memory and in the file."""

from pathlib import Path

import h5py
import numpy as np
import pytest

from arcless.dataset.plain_dataset import Plain
from arcless.results import Result, open_dataset, save
from tests.support.synthetic import synthetic_dataset


@pytest.fixture(scope="module")
def dataset():
    return synthetic_dataset(
        duration_s=2.0,
        speed_m_s=50.0,
        section=(20.0, 80.0),
        pantographs=("P1", "Stromabnehmer hinten é"),
        distance_m=10.0,
        force=lambda t: 100.0 + 30.0 * np.sin(7.0 * t) / 3.0,
    )


@pytest.fixture(scope="module")
def plain(dataset):
    def described(variables):
        return {
            str(name): (variable.dims, variable.values, dict(variable.attrs))
            for name, variable in variables.items()
        }

    return Plain(described(dataset.data_vars), described(dataset.coords), dict(dataset.attrs))


def test_it_becomes_the_same_dataset(dataset, plain) -> None:
    assert plain.dataset().identical(dataset)
    assert set(plain.variables) == {str(name) for name in dataset.variables}
    assert "time" in plain
    assert "contact_force" in plain
    assert "nothing" not in plain


def test_the_file_is_that_of_xarray(dataset, plain, tmp_path: Path) -> None:
    save(plain, tmp_path / "plain.nc")
    save(dataset, tmp_path / "xarray.nc")
    one, other = open_dataset(tmp_path / "plain.nc"), open_dataset(tmp_path / "xarray.nc")
    assert one.identical(other)
    for name in other.variables:
        assert one[name].dtype == other[name].dtype, name
    for name, value in other.attrs.items():
        assert type(one.attrs[name]) is type(value), name


def test_the_file_keeps_the_conventions_of_netcdf(plain, tmp_path: Path) -> None:
    save(plain, tmp_path / "x.nc")
    with h5py.File(tmp_path / "x.nc") as file:
        assert file["time"].is_scale
        force = file["contact_force"]
        assert [dim[0].name for dim in force.dims] == ["/time", "/pantograph"]
        numbers = [file[dim].attrs["_Netcdf4Dimid"] for dim in ("time", "pantograph")]
        assert force.attrs["_Netcdf4Coordinates"].tolist() == numbers
        assert file.attrs["steps"].shape == (1,)


def test_a_result_is_assessed_and_saved_without_a_dataset(dataset, plain, tmp_path: Path) -> None:
    result, other = Result(plain, None), Result(dataset, None)  # type: ignore[arg-type]
    assert result.assessment.to_dict() == other.assessment.to_dict()
    assert result.metadata == other.metadata
    result.save(tmp_path / "x.nc")
    assert "dataset" not in result.__dict__
    # Once there is a dataset, what is changed in it is saved.
    result.dataset.attrs["command"] = "changed"
    result.save(tmp_path / "x.nc")
    assert open_dataset(tmp_path / "x.nc").attrs["command"] == "changed"
