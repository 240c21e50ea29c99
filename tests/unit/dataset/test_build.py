"""Building the dataset: the table decides names, dimensions, units and finiteness."""

import json

import numpy as np
import pytest

from arcless.dataset.schema import ATTRIBUTES, DIMENSIONS, RESULT_FORMAT, VARIABLES
from arcless.errors import ResultFormatError
from arcless.results import dataset_from, metadata
from tests.support.synthetic import synthetic_dataset

TIMES, PANTOGRAPHS = 4, 2


def minimal() -> tuple[dict, dict, dict, dict]:
    """The smallest record that is complete, to be spoiled one piece at a time."""
    column = np.ones((TIMES, PANTOGRAPHS))
    record = {
        "contact_force": 100.0 * column,
        "contact_gap": 0.0 * column,
        "contact_height": 5.3 * column,
        "position": np.arange(TIMES)[:, None] + 0.0 * column,
        "speed": np.ones(TIMES),
    }
    names = {"time": np.arange(TIMES) * 1e-3, "pantograph": ["P1", "P2"]}
    attrs = {
        "arcless_version": "0",
        "scenario": {"name": "x"},
        "scenario_name": "x",
        "section_m": [0.0, 1.0],
        "steps": np.int64(4),
        "simulated_time_s": 1,
        "wall_time_s": 0.1,
        "real_time_factor": 10.0,
        "setup_time_s": None,
    }
    return record, names, {}, attrs


def test_every_variable_carries_unit_and_meaning() -> None:
    dataset = synthetic_dataset(duration_s=5.0, section=(20.0, 80.0))
    for name, variable in dataset.variables.items():
        entry = VARIABLES.get(name) or DIMENSIONS[name]
        assert variable.attrs == {"units": entry.units, "long_name": entry.long_name}


def test_every_variable_has_known_dimensions_and_an_ascii_name() -> None:
    for name, variable in VARIABLES.items():
        assert set(variable.dims) <= set(DIMENSIONS)
        assert name.isascii()
        assert name.isidentifier()


def test_values_are_kept_as_given() -> None:
    record, names, static, attrs = minimal()
    record["contact_force"][2, 1] = 123.456
    dataset = dataset_from(record, names, static, attrs)
    assert dataset["contact_force"].sel(pantograph="P2").values[2] == 123.456
    assert dataset["contact_force"].dims == ("time", "pantograph")


def test_counting_dimensions_are_numbered_from_one() -> None:
    record, names, static, attrs = minimal()
    record["mass_displacement"] = np.zeros((TIMES, PANTOGRAPHS, 3))
    dataset = dataset_from(record, names, static, attrs)
    assert dataset["mass"].values.tolist() == [1, 2, 3]


def test_empty_dimensions_are_left_out() -> None:
    record, names, static, attrs = minimal()
    record["point_uplift"] = np.zeros((2, 0))
    names |= {"line_time": [0.0, 1.0], "point": []}
    dataset = dataset_from(record, names, static, attrs)
    assert "point_uplift" not in dataset
    assert "point" not in dataset.coords


def test_attributes_come_back_as_python_values() -> None:
    facts = metadata(dataset_from(*minimal()))
    assert facts["format"] == RESULT_FORMAT
    assert facts["scenario"] == {"name": "x"}
    assert facts["section_m"] == [0.0, 1.0]
    assert type(facts["steps"]) is int
    assert type(facts["simulated_time_s"]) is float
    assert facts["setup_time_s"] is None
    assert set(facts) == set(ATTRIBUTES)


def test_motion_of_points_and_pivots_per_step_are_kept() -> None:
    record, names, static, attrs = minimal()
    record |= {"point_uplift": [[0.0], [0.02]], "point_along": [[0.0], [-1e-3]]}
    names |= {"line_time": [0.0, 1.0], "point": ["20 m"]}
    attrs |= {"lcp_pivots_per_step": [3, 0, 1], "lcp_pivots_mean": 0.5}
    dataset = dataset_from(record, names, static, attrs)
    assert dataset["point_along"].sel(point="20 m").values.tolist() == [0.0, -1e-3]
    assert dataset["point_along"].dims == dataset["point_uplift"].dims
    facts = metadata(dataset)
    assert facts["lcp_pivots_per_step"] == [3, 0, 1]
    assert facts["lcp_pivots_mean"] == 0.5


def test_scenario_attribute_is_json_text() -> None:
    assert json.loads(dataset_from(*minimal()).attrs["scenario"]) == {"name": "x"}


def spoil_nan(record, names, static, attrs):
    record["contact_force"][3, 1] = np.nan


def spoil_infinity(record, names, static, attrs):
    record["speed"][0] = np.inf


def spoil_shape(record, names, static, attrs):
    record["position"] = record["position"][:, :1]


def spoil_variable_name(record, names, static, attrs):
    record["contact_forse"] = record.pop("contact_force")


def spoil_missing(record, names, static, attrs):
    del record["contact_gap"]


def spoil_dimension_name(record, names, static, attrs):
    names["pantagraph"] = names["pantograph"]


def spoil_labels(record, names, static, attrs):
    del names["pantograph"]


def spoil_time(record, names, static, attrs):
    names["time"] = [0.0, 1.0, 1.0, 2.0]


def spoil_attribute_name(record, names, static, attrs):
    attrs["wall_tme_s"] = 1.0


def spoil_attribute_missing(record, names, static, attrs):
    del attrs["section_m"]


def spoil_attribute_nan(record, names, static, attrs):
    attrs["real_time_factor"] = float("nan")


def spoil_attribute_json(record, names, static, attrs):
    attrs["section_m"] = [0.0, float("nan")]


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (spoil_nan, ["contact_force", "time 0.003", "pantograph P2", "nan"]),
        (spoil_infinity, ["speed", "time 0.0", "inf"]),
        (spoil_shape, ["position", "(4, 1)", "(4, 2)"]),
        (spoil_variable_name, ["contact_forse", "did you mean contact_force?"]),
        (spoil_missing, ["contact_gap"]),
        (spoil_dimension_name, ["pantagraph", "did you mean pantograph?"]),
        (spoil_labels, ["pantograph"]),
        (spoil_time, ["time"]),
        (spoil_attribute_name, ["wall_tme_s", "did you mean wall_time_s?"]),
        (spoil_attribute_missing, ["section_m"]),
        (spoil_attribute_nan, ["real_time_factor", "nan"]),
        (spoil_attribute_json, ["section_m"]),
    ],
)
def test_one_spoiled_piece_is_refused_and_named(spoil, said: list[str]) -> None:
    pieces = minimal()
    spoil(*pieces)
    with pytest.raises(ResultFormatError) as caught:
        dataset_from(*pieces)
    for word in said:
        assert word in str(caught.value)


def test_padding_of_a_shorter_pantograph_is_no_fault() -> None:
    record, names, static, attrs = minimal()
    displacement = np.zeros((TIMES, PANTOGRAPHS, 3))
    displacement[:, 1, 2] = np.nan
    record["mass_displacement"] = displacement
    assert np.isnan(dataset_from(record, names, static, attrs)["mass_displacement"]).any()


def test_a_single_nan_in_a_padded_variable_is_a_fault() -> None:
    record, names, static, attrs = minimal()
    displacement = np.zeros((TIMES, PANTOGRAPHS, 3))
    displacement[1, 1, 2] = np.nan
    record["mass_displacement"] = displacement
    with pytest.raises(ResultFormatError, match=r"mass_displacement at time 0\.001"):
        dataset_from(record, names, static, attrs)
