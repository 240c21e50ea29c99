"""Lateral forces on supports, and heights of the messenger wire, against known values."""

from math import cos
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.equilibrium.support_forces import SupportForces
from arcless.simulate.statics import StaticsResult


def at_rest(name: str, **geometry: Any) -> StaticsResult:
    data = arcless.load_line(name).to_dict()
    data["geometry"] |= geometry
    if "curves" in geometry:
        data["track"]["curves"] = data["geometry"].pop("curves")
    return arcless.statics(arcless.load_line(data))


@pytest.mark.parametrize("name", ["ac-simple-55-3d", "spain-ca-160-3kv", "france-lgv-est"])
def test_the_shape_of_the_wire_tells_what_the_bar_carries(name: str) -> None:
    found = arcless.statics(arcless.load_line(name))
    forces = SupportForces(found.equilibrium, found.scenario.line)
    places = [place for place in found.equilibrium.mesh.supports if place.steady_arm is not None]
    assert len(places) > 10
    for place in places:
        # The bend of elements beside the support, which the directions are read beyond.
        assert forces.by_shape(place) == pytest.approx(forces.of_contact_wire(place), rel=2.5e-3)


def test_a_bar_has_its_lateral_part() -> None:
    found = arcless.statics(arcless.load_line("ac-simple-55-3d"))
    slope = found.scenario.line.to_dict()["steady_arm"]["slope"]
    for support in found.supports[1:-1]:
        # The clamp moves some millimetres on an arm of 1 m from where the slope is given.
        lateral = support["steady_arm_force_N"] * cos(slope)
        assert abs(support["contact_wire_lateral_force_N"]) == pytest.approx(lateral, rel=2e-3)


def test_stagger_pulls_to_the_middle() -> None:
    found = arcless.statics(arcless.load_line("germany-re-330"))
    sides = [
        (place, support["contact_wire_lateral_force_N"])
        for place, support in zip(found.equilibrium.mesh.supports, found.supports, strict=True)
    ][1:-1]
    for place, force in sides:
        assert force * found.equilibrium.positions[place.contact_node, 1] < 0.0
    # 2 T 2a/L, and what leaning droppers add: some per cent.
    assert abs(sides[7][1]) == pytest.approx(2 * 27e3 * 0.6 / 65, rel=0.05)


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_curve_pulls_by_tension_times_length_over_radius(side: str) -> None:
    curve = {"from": -1e4, "to": 1e4, "radius": 2000.0, "side": side}
    found = at_rest("germany-re-330", curves=[curve], stagger_contact_wire=[0.0],
                    stagger_messenger_wire=[0.0])  # fmt: skip
    inwards = 1.0 if side == "left" else -1.0
    for support in found.supports[4:-4]:
        # Droppers hand on a share from wire to wire: only the sum is known. The track is tilted
        # by nothing; the shape of the contact wire is read within 0.2 %.
        both = support["contact_wire_lateral_force_N"] + support["messenger_wire_lateral_force_N"]
        assert inwards * both == pytest.approx((27e3 + 21e3) * 65 / 2000, rel=2e-3)


def test_the_wires_pull_the_supports_of_a_trolley_wire_aside() -> None:
    data = arcless.load_line("conductor-rail-1").to_dict()
    data["geometry"]["stagger_contact_wire"] = [0.1, -0.1]
    found = arcless.statics(arcless.load_line(data))
    inner = [support["contact_wire_lateral_force_N"] for support in found.supports[1:-1]]
    signs = np.sign(inner)
    assert np.all(signs[1:] == -signs[:-1])
    assert all(support["messenger_wire_height_m"] is None for support in found.supports)


@pytest.mark.parametrize("name", ["norway-s25", "ac-simple-overlap", "spain-ca-160-3kv"])
def test_the_messenger_wire_has_a_height_at_every_support(name: str) -> None:
    found = arcless.statics(arcless.load_line(name))
    geometry, raised = found.scenario.line.geometry, found.scenario.line.overlap
    drawn = geometry.contact_wire_height + geometry.encumbrance
    heights = [support["messenger_wire_height_m"] for support in found.supports]
    if raised is None:
        # The support yields by its load over its stiffness, as built into the drawing.
        np.testing.assert_allclose(heights, drawn, atol=1e-6)
    else:
        most = max(raised.raise_)
        assert all(drawn - 1e-6 <= height <= drawn + most + 1e-6 for height in heights)
        assert any(height > drawn + 0.01 for height in heights)


def test_in_the_plane_nothing_pulls_aside() -> None:
    found = arcless.statics(arcless.load_line("norway-s25"))
    for support in found.supports:
        assert support["contact_wire_lateral_force_N"] is None
        assert support["messenger_wire_lateral_force_N"] is None


def test_where_elements_are_too_long_the_force_is_not_told() -> None:
    scenario = arcless.load("germany-re-330-300").with_(
        **{"solver.scheme": "generalised-alpha", "solver.contact_wire_element": "2.5 m"}
    )
    found = arcless.statics(scenario)
    assert found.supports[5]["contact_wire_lateral_force_N"] is None
    assert found.supports[5]["messenger_wire_lateral_force_N"] is not None
