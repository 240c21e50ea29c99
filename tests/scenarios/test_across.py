"""Motion across the track only: what it leaves out, and what it leaves alone."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from arcless.equilibrium import equilibrium
from arcless.errors import ModelError
from arcless.model import Scenario
from arcless.results import Result

Short = Callable[..., Scenario]
Run = Callable[..., Result]
ACROSS = {"solver.motion": "across"}
EXPLICIT = {"solver.scheme": "central-difference"}
FINE = {"solver.contact_wire_element": 0.5, "solver.messenger_wire_element": 1.0}
FAMILIES = pytest.mark.parametrize("family", [{}, EXPLICIT], ids=["matrix", "explicit"])
BOTH = ("contact_wire", "messenger_wire")


def force(result: Result) -> Any:
    return result.dataset["contact_force"].values[:, 0]


@FAMILIES
def test_nothing_that_acts_along_the_track_matters(run: Run, family: dict[str, Any]) -> None:
    plain = force(run(**family, **ACROSS))
    free = {f"line.{wire}.ends": "constant_force" for wire in BOTH}
    for changes in (free, {"line.support.longitudinal_stiffness": 1e5}):
        other = force(run(**family, **ACROSS, **changes))
        # The same equilibrium but for rounding of its iterations, 1e-9 m, on springs of 50 kN/m.
        np.testing.assert_allclose(other, plain, rtol=0, atol=1e-2)
        full = force(run(**family, **changes))
        assert np.abs(full - force(run(**family))).max() > 0.1, "with motion along it does"


def test_statics_are_the_same(short: Short) -> None:
    full, across = (equilibrium.find(short(**changes)) for changes in ({}, ACROSS))
    for name in ("positions", "link_rest_length", "wire_tension"):
        np.testing.assert_array_equal(full.arrays[name], across.arrays[name])
    places = full.elasticity_positions()
    assert (full.elasticity(places) != across.elasticity(places)).any()


def test_both_families_agree(run: Run) -> None:
    matrix = run(**FINE, **ACROSS, **{"solver.residual_flexibility": True}).assessment.pantographs[
        0
    ]
    steps = run(**FINE, **EXPLICIT, **ACROSS).assessment.pantographs[0]
    # Elements of 0.5 m, and two schemes.
    assert steps.std_force_N == pytest.approx(matrix.std_force_N, rel=0.02)
    assert steps.contact_point_range_mm == pytest.approx(matrix.contact_point_range_mm, rel=0.02)


def test_in_space_nothing_moves_along_either(run: Run) -> None:
    arm = {"line.steady_arm": {"kind": "arm", "length": 1.2, "slope": "8 deg"}}
    stagger = {f"line.geometry.stagger_{wire}": [0.2, -0.2] for wire in BOTH}
    found = [
        run(**arm, **stagger, **ACROSS, **family, **FINE).assessment.pantographs[0].std_force_N
        for family in ({"solver.residual_flexibility": True}, EXPLICIT)
    ]
    # Two families of elements.
    assert found[0] == pytest.approx(found[1], rel=0.03)


def test_not_with_updated_kinematics(short: Short) -> None:
    with pytest.raises(ModelError, match=r"solver\.kinematics: not together with motion: across"):
        short(**ACROSS, **{"solver.kinematics": "updated"})
