"""Motion across the track, of members of a batch, and of wires that are put to rest."""

from pathlib import Path

import numpy as np
import pytest

import arcless
from arcless.model import load
from tests.support.line_types import scenario_data
from tests.support.overlaps import overlap_data

SHORT = {"travel.end": "200 m", "analysis.spans": [2, 3], "output.motion": True}


@pytest.fixture(scope="module")
def spatial() -> arcless.Result:
    return arcless.run(arcless.load("en50318-ac-simple-320").with_(**SHORT))


def test_the_wire_at_the_strip_moves_across_as_the_contact_does(spatial: arcless.Result) -> None:
    found = spatial.dataset
    x, y = found["contact_wire_node_x"].values, found["contact_wire_node_y"].values
    first, count = found["motion_first"].values[:, 0], int(found["motion_count"].values[0])
    across = found["motion_across"].values[:, :count]
    rows = np.searchsorted(found["time"].values, found["motion_time"].values - 1e-9)
    place, lateral = (found[name].values[rows, 0] for name in ("position", "contact_lateral"))
    there = np.array(
        [
            np.interp(place[row], x[nodes], y[nodes] + across[row])
            for row, nodes in enumerate(slice(begin, begin + count) for begin in first)
        ]
    )
    bare = np.interp(place, x, y)
    # Nodes 0.45 m apart, a wire that turns by less than 1 mrad at each: chords are off by 0.1 mm.
    assert np.abs(there - lateral)[20:].max() < 1e-4
    # Without what is recorded it would be seen: wires swing by some millimetres.
    assert np.abs(bare - lateral)[20:].max() > 5e-4


def test_a_member_of_a_batch_has_the_motion_of_the_run(
    spatial: arcless.Result, tmp_path: Path
) -> None:
    kept, stored = (
        arcless.batch([spatial.scenario], keep="result", folder=folder, workers=1)
        for folder in (None, tmp_path)
    )
    assert kept[0].result is not None
    assert stored[0].path is not None
    for result in (kept[0].result, arcless.open(stored[0].path)):
        moved = [name for name in spatial.dataset.variables if str(name).startswith("motion")]
        assert "motion_across" in moved
        for name in moved:
            np.testing.assert_array_equal(result.dataset[name].values, spatial.dataset[name].values)


def test_wires_ahead_and_around_move_as_if_none_was_at_rest() -> None:
    """Tension lengths left behind are put to rest by `output.around`; no row near shows it."""
    short = {"travel__start": 70.0, "travel__end": 560.0, "output__motion": {"around": "40 m"}}
    line = overlap_data(3, ends=(5, 8), spans=11)
    whole, near = (
        arcless.run(load(scenario_data(line, **short, **around))).dataset
        for around in ({}, {"output__around": "40 m"})
    )
    np.testing.assert_array_equal(whole["motion_first"].values, near["motion_first"].values)
    rows = np.searchsorted(near["time"].values, near["motion_time"].values - 1e-9)
    behind = near["position"].values[rows, 0] - 40.0
    ends, lanes = np.cumsum(near["motion_count"].values), near["motion_wire"].values
    seen = 0
    for k, (kind, number) in enumerate(str(lane).split(" ") for lane in lanes):
        of_lane = near[f"{kind}_node_lane"].values == int(number)
        x = near[f"{kind}_node_x"].values[of_lane]
        columns = slice(ends[k] - near["motion_count"].values[k], ends[k])
        nodes = near["motion_first"].values[:, [k]] + np.arange(near["motion_count"].values[k])
        around = x[nodes] > behind[:, None]
        moved = [dataset["motion_up"].values[:, columns] for dataset in (whole, near)]
        np.testing.assert_array_equal(moved[0][around], moved[1][around])
        seen += int((np.abs(moved[1][around]) > 1e-3).sum())
    assert seen > 1000
    # The tension length that was left first stands still in one of them.
    left = near["motion_time"].values > 0.9 * near["motion_time"].values[-1]
    assert (whole["motion_up"].values[left] != near["motion_up"].values[left]).any()
