"""Masses, inserts, midpoint anchors and tensioning springs in lines that run."""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless.mesh.division.systems import wire_systems
from arcless.mesh.division.wires import stations
from arcless.model import load
from arcless.model.line.places.wire_places import SAME_PLACE, shortest_distances
from arcless.simulate import StaticsResult
from tests.support.line_types import STITCH, compound_data, scenario_data, stitched_data
from tests.support.overlaps import overlap_data
from tests.support.simple_lines import bridle_data, rail_data, trolley_data

GRAVITY = 9.81
MASS = {"name": "feeder clamp", "wire": "contact_wire", "position": 131.3, "mass": 3.0}
INSERT = {
    "name": "section insulator",
    "position": 150.0,
    "length": 1.6,
    "mass": 12.0,
    "axial_stiffness": 2e7,
    "bending_stiffness": 3e3,
}


def at_rest(line: dict[str, Any], **changes: Any) -> StaticsResult:
    return arcless.statics(load(scenario_data(line, **changes)))


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_a_line_with_all_of_them_runs(model: str) -> None:
    line = compound_data(
        point_masses=[
            {"name": "feeder clamp", "wire": wire, "position": 131.3, "mass": 3.0}
            for wire in ("contact_wire", "messenger_wire", "auxiliary_wire")
        ],
        inserts=[
            {
                "name": "section insulator",
                "position": 150.0,
                "length": 1.6,
                "mass": 12.0,
                "axial_stiffness": 2e7,
                "bending_stiffness": 3e3,
            }
        ],
    )
    # Masses make `auto` take shorter elements: the same for both lines.
    same = {"solver__contact_wire_element": 0.3, "solver__messenger_wire_element": 0.3}
    same |= {"solver__wire_model": model, "solver__time_step": "0.5 ms"}
    result = arcless.run(load(scenario_data(line, **same)))
    plain = arcless.run(load(scenario_data(compound_data(), **same)))
    time, x = result.dataset["time"].values, result.dataset["position"].values[:, 0]
    passed = (x > 148.0) & (x < 154.0)
    forces = [r.dataset["contact_force"].values[passed, 0] for r in (result, plain)]
    # 7.5 kg/m in place of 1.1 kg/m: the head hits it.
    assert np.abs(forces[0] - forces[1]).max() > 30.0
    assert time.size == plain.dataset["time"].size
    before = x < 110.0
    forces = [r.dataset["contact_force"].values[before, 0] for r in (result, plain)]
    # 20 m ahead of the masses, only waves reach here: 0.2 s at 117 m/s.
    np.testing.assert_allclose(*forces, atol=3.0)


HELD = {"midpoint_anchor": {"stiffness": 1e7}}


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_wires_move_away_from_their_midpoint_anchor(model: str) -> None:
    """By α Δθ x to both sides, while tension and heights stay."""
    both = {f"{wire}__ends": "constant_force" for wire in ("contact_wire", "messenger_wire")}
    line = stitched_data(stitch_wire=None, **both, **HELD)
    cold, warm = (
        at_rest(line, solver__wire_model=model, as_built__temperature_difference=d)
        for d in (0.0, 40.0)
    )
    for wire in ("contact_nodes", "messenger_nodes"):
        nodes = getattr(warm.equilibrium.mesh, wire)
        here, there = (r.equilibrium.positions[nodes] for r in (cold, warm))
        moved, x = there[:, 0] - here[:, 0], here[:, 0] - 180.0
        # Along the wire, which the sag makes longer than the track by 1e-3; droppers lean.
        np.testing.assert_allclose(moved, 17e-6 * 40.0 * x, atol=3e-4)
        # To rounding the same on both sides: the solver stops at 1e-5 N of EA.
        np.testing.assert_allclose(moved, -moved[::-1], atol=1e-9)
        assert abs(moved[len(moved) // 2]) < 1e-9
    assert warm.as_built is not None
    tensions = [warm.as_built[f"{wire}_wire_tension_N"] for wire in ("contact", "messenger")]
    np.testing.assert_allclose(tensions, 15e3, rtol=2e-3)


def test_a_spring_without_change_is_a_constant_force() -> None:
    springs = {"contact_wire__ends": "spring", "contact_wire__end_stiffness": 5e3}
    one, other = at_rest(trolley_data()), at_rest(trolley_data(**springs))
    heights = [r.equilibrium.positions[:, 2] for r in (one, other)]
    # The design hands both the same lengths; the equilibrium stops at 1e-5 N.
    np.testing.assert_allclose(*heights, atol=1e-8)


@pytest.mark.parametrize("data", [trolley_data, rail_data], ids=["trolley", "rail"])
def test_a_pantograph_runs_below_an_anchored_line(data: Any) -> None:
    result = arcless.run(load(scenario_data(data(**HELD), speed=20.0)))
    # The masses of the pantograph move freely: the mean is the static force but for the base.
    assert result.dataset["contact_force"].values.mean() == pytest.approx(120.0, rel=0.05)


@pytest.mark.parametrize(
    "line",
    [
        compound_data(point_masses=[MASS], inserts=[INSERT]),
        stitched_data(),
        overlap_data(stitch_wire=STITCH),
        rail_data(),
        bridle_data(),
    ],
    ids=["compound", "stitched", "overlap of stitched", "rail", "bridle"],
)
def test_nodes_stand_where_the_element_length_expects_them(line: dict[str, Any]) -> None:
    """Compare the shortest distance of places that the mesh makes nodes of with that of the model.

    The model knows it before there is a mesh; the element length and the step depend on it. A
    contact wire that supports hold has nodes beside them that nothing is attached to: trolley
    wires are not compared.
    """
    known = load(scenario_data(line)).line
    expected = shortest_distances(known)
    found: dict[str, list[float]] = {}
    for system in wire_systems(known, {}):
        places = stations(known, system)
        above = ("messenger wire", "auxiliary wire", "stitch wire", "bridle")
        for wire in (*system.contact_wires, *above):
            key = "contact_wire" if wire in system.contact_wires else wire.replace(" ", "_")
            steps = np.diff(places.along(wire))
            found.setdefault(key, []).extend(steps[steps > SAME_PLACE])
    for key, gaps in expected.items():
        # Both are rounded to 1 µm.
        assert min(gaps) == pytest.approx(min(found[key]), abs=2e-6), key
