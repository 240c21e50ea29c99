"""Recorded motion of a result → each contact wire with its own nodes."""

from pathlib import Path

import numpy as np
import xarray

import arcless
from arcless.figures.wires.wire_motion import contact_wires
from tests.support.synthetic import synthetic_dataset


def recorded(wires: dict[str, int], rows: int = 4) -> xarray.Dataset:
    """A result with motion: wire → columns; values tell row and column."""
    dataset = synthetic_dataset(duration_s=1.0)
    columns = sum(wires.values())
    up = np.arange(rows * columns, dtype=np.float32).reshape(rows, columns)
    first = np.arange(rows)[:, None] + 10 * np.arange(len(wires))
    dataset = dataset.assign_coords(motion_time=0.01 * np.arange(rows), motion_wire=[*wires])
    dataset["motion_up"] = (("motion_time", "motion_node"), up)
    dataset["motion_first"] = (("motion_time", "motion_wire"), first)
    dataset["motion_count"] = (("motion_wire",), [*wires.values()])
    return dataset


def test_without_recorded_motion_there_is_none() -> None:
    assert contact_wires(synthetic_dataset(duration_s=1.0)) == []


def test_contact_wires_alone_are_taken_with_their_own_columns() -> None:
    dataset = recorded({"contact_wire 1": 3, "messenger_wire 1": 2, "contact_wire 2": 4})
    nodes = dataset.sizes["contact_wire_node"]
    number = np.where(np.arange(nodes) < 20, 1, 2)
    dataset["contact_wire_node_wire"] = (("contact_wire_node",), number)
    dataset["contact_wire_node_lane"] = (("contact_wire_node",), number)
    one, two = contact_wires(dataset)
    np.testing.assert_array_equal(one.up[1], [9.0, 10.0, 11.0])
    np.testing.assert_array_equal(two.up[1], [14.0, 15.0, 16.0, 17.0])
    np.testing.assert_array_equal(two.first, [20, 21, 22, 23])
    x = dataset["contact_wire_node_x"].values
    np.testing.assert_array_equal(one.x, x[:20])
    np.testing.assert_array_equal(two.x, x[20:])
    np.testing.assert_array_equal(one.times, [0.0, 0.01, 0.02, 0.03])


def test_wires_that_share_a_lane_are_told_apart() -> None:
    """Wires 1 and 3 are one behind the other, wire 2 next to both."""
    dataset = recorded({"contact_wire 1": 3, "contact_wire 2": 2})
    nodes = dataset.sizes["contact_wire_node"]
    number = np.where(np.arange(nodes) < 5, 1, np.where(np.arange(nodes) < 12, 2, 3))
    dataset["contact_wire_node_wire"] = (("contact_wire_node",), number)
    dataset["contact_wire_node_lane"] = (("contact_wire_node",), np.where(number == 2, 2, 1))
    # The window of the first lane: wire 1 alone, both twice, wire 3 alone.
    dataset["motion_first"][:, 0] = [2, 3, 4, 5]
    dataset["motion_first"][:, 1] = [0, 1, 2, 3]
    one, three, two = contact_wires(dataset)
    x = dataset["contact_wire_node_x"].values
    for wire, own in ((one, x[:5]), (two, x[5:12]), (three, x[12:])):
        np.testing.assert_array_equal(wire.x, own)
    # Nodes 3 and 4 of wire 1 in its second row, then the first one of wire 3.
    np.testing.assert_array_equal(one.first, [2, 3, 4, 5])
    np.testing.assert_array_equal(one.up[1], [5.0, 6.0, np.nan])
    np.testing.assert_array_equal(three.times, [0.0, 0.01, 0.02, 0.03])
    np.testing.assert_array_equal(three.first, [-3, -2, -1, 0])
    np.testing.assert_array_equal(three.up[1], [np.nan, np.nan, 7.0])
    np.testing.assert_array_equal(three.up[3], [15.0, 16.0, 17.0])
    np.testing.assert_array_equal(two.up[3], [18.0, 19.0])


def test_a_single_contact_wire_has_all_nodes() -> None:
    dataset = recorded({"contact_wire 1": 3, "messenger_wire 1": 2})
    (one,) = contact_wires(dataset)
    assert one.x.size == dataset.sizes["contact_wire_node"]


def test_of_a_file_the_columns_of_other_wires_are_not_read(tmp_path: Path) -> None:
    short = {"travel.end": "200 m", "analysis.spans": [2, 3], "output.motion": True}
    run = arcless.run(arcless.load("en50318-ac-simple-320-planar").with_(**short))
    run.save(tmp_path / "result.nc")
    opened = arcless.open(tmp_path / "result.nc").recorded
    (found,), (known,) = contact_wires(opened), contact_wires(run.recorded)
    np.testing.assert_array_equal(found.up, known.up)
    # Of the contact wire alone: neither it nor the messenger wire is kept by the file.
    assert opened.read_bytes < found.up.nbytes < run.recorded["motion_up"].values.nbytes
