"""Contacts of the core brought to channels of the pantographs."""

import numpy as np
import pytest

from arcless.dataset.plain_dataset import dataset_from
from arcless.errors import ResultFormatError
from arcless.simulate.recording import contacts

# Two pantographs: the first on two wires, the second on one of them with its only strip.
RAW = {
    "contacts": [[0, 0, 0], [0, 0, 1], [1, 0, 0]],
    "force": np.array([[100.0, 0.0, 7.0], [40.0, 60.0, 0.0], [0.0, 0.0, 8.0]]),
    "gap": np.array([[0.0, np.inf, 0.0], [0.0, 0.0, 0.01], [0.03, 0.02, 0.0]]),
    "height": np.array([[5.0, np.nan, 5.2], [5.01, 5.02, 5.2], [5.03, 5.04, 5.2]]),
    "lateral": np.array([[0.1, np.nan, 0.2], [0.11, -0.1, 0.2], [0.12, -0.2, 0.2]]),
}
FLAT = {name: np.ravel(values) if name != "contacts" else values for name, values in RAW.items()}


def test_several_contacts_become_one_value() -> None:
    found = contacts.channels(FLAT, 2)
    assert found["contact_force"].tolist() == [[100.0, 7.0], [100.0, 0.0], [0.0, 8.0]]
    # No gap as soon as one is closed; the smallest when all are open.
    assert found["contact_gap"].tolist() == [[0.0, 0.0], [0.0, 0.01], [0.02, 0.0]]
    # At the largest force; in the last row, where all are open, at the smallest gap.
    assert found["contact_height"].tolist() == [[5.0, 5.2], [5.02, 5.2], [5.04, 5.2]]
    assert found["contact_lateral"].tolist() == [[0.1, 0.2], [-0.1, 0.2], [-0.2, 0.2]]


def test_each_contact_is_kept_where_there_are_several() -> None:
    found = contacts.channels(FLAT, 2)
    np.testing.assert_array_equal(found["wire_contact_force"], RAW["force"])
    assert np.isnan(found["wire_contact_gap"][0, 1])
    assert np.isnan(found["wire_contact_lateral"][0, 1])
    assert contacts.labels(FLAT, ["P1", "P2"]) == [
        "P1 strip 1 wire 1",
        "P1 strip 1 wire 2",
        "P2 strip 1 wire 1",
    ]


def test_single_contacts_are_not_listed() -> None:
    raw = {name: values[:, ::2].ravel() for name, values in RAW.items() if name != "contacts"}
    raw["contacts"] = [[0, 0, 0], [1, 0, 0]]
    found = contacts.channels(raw, 2)
    assert sorted(found) == [f"contact_{name}" for name in ("force", "gap", "height", "lateral")]
    np.testing.assert_array_equal(found["contact_force"], RAW["force"][:, ::2])
    assert contacts.labels(raw, ["P1", "P2"]) == []


def built(gap: float) -> None:
    time = np.arange(2.0)
    channel = np.zeros((2, 1))
    required = ("contact_force", "contact_gap", "contact_height", "position")
    record = {name: channel for name in required}
    record |= {"speed": np.ones(2), "wire_contact_gap": np.array([[0.0, 0.0], [0.0, gap]])}
    names = {"time": time, "pantograph": ["P1"], "contact": ["a", "b"]}
    dataset_from(record, names, {}, {})


def test_only_nan_may_stand_for_a_missing_wire() -> None:
    with pytest.raises(ResultFormatError, match=r"wire_contact_gap at time 1\.0, contact b"):
        built(np.inf)
    # With NaN it gets as far as the attributes, of which there are none here.
    with pytest.raises(ResultFormatError, match="attributes"):
        built(np.nan)
