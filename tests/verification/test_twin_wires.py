"""Two contact wires side by side against one of twice everything."""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import load
from arcless.results import Result
from tests.support.line_types import scenario_data
from tests.support.overlaps import plain_data

SPANS = 10
# As much of each as two wires of tests.support.line_types have together, and two droppers.
DOUBLE = {"mass": 2.2, "axial_stiffness": 28e6, "bending_stiffness": 260.0, "tension": 30e3}
DAMPING = {"alpha": 0.0125, "beta": 1e-4}


def pair(droppers: str = "paired", separation: float = 0.04) -> dict[str, Any]:
    twin = {"separation": separation, "droppers": droppers}
    return plain_data(SPANS, twin_contact_wires=twin, contact_wire__damping=DAMPING)


def single() -> dict[str, Any]:
    line = plain_data(SPANS, contact_wire={**DOUBLE, "damping": DAMPING})
    line["dropper"] = {"stiffness": 2e5, "mass": 0.2}
    line["steady_arm"] = {"kind": "spring", "vertical_stiffness": 600.0}
    return line


def ride(line: dict[str, Any], contact: float, **changes: Any) -> Result:
    data = scenario_data(
        line,
        speed="250 km/h",
        travel={"start": 130.0, "end": 480.0},
        contact={"stiffness": contact},
        **changes,
    )
    return arcless.run(load(data))


@pytest.mark.parametrize("kinematics", ["linearised", "updated"])
def test_a_pair_moves_like_one_wire_of_twice_everything(kinematics: str) -> None:
    # Planar, where two wires side by side are in one place; each has its own contact, 25 + 25 kN/m.
    settings = {"solver__kinematics": kinematics, "output__energy": "never"}
    two = ride(pair(), 25e3, **settings).dataset
    one = ride(single(), 50e3, **settings).dataset
    force = one["contact_force"].values
    # All numbers are summed in another order: rounding, which contacts and droppers that open and
    # close pass on but do not multiply without bound.
    np.testing.assert_allclose(two["contact_force"], force, atol=1e-5 * np.abs(force).max())
    half = two["wire_contact_force"].values
    np.testing.assert_allclose(half[:, 0], half[:, 1], atol=1e-5 * np.abs(force).max())
    np.testing.assert_allclose(half.sum(axis=1), force[:, 0], atol=1e-5 * np.abs(force).max())
    uplift = one["support_uplift_max"].values
    np.testing.assert_allclose(two["support_uplift_max"][::2], uplift, atol=1e-8)
    np.testing.assert_allclose(two["support_uplift_max"][1::2], uplift, atol=1e-8)
    assert force.std() > 5.0  # it did move
