"""Tables of parts: their shapes, and what a model's parts become."""

from collections.abc import Callable
from math import cos, radians, sin

import numpy as np
import pytest

from arcless.errors import MeshError
from arcless.mesh import Mesh
from arcless.mesh.tables.parts import COLUMNS, GIVEN, HELD, UNLOADED

Make = Callable[..., Mesh]
ARM = {"kind": "arm", "length": 1.2, "slope": radians(10), "mass": 0.7, "axial_stiffness": 17e6}
STAGGER = {"contact_wire_height": 5.3, "encumbrance": 1.2, "stagger_contact_wire": [0.2, -0.2]}


@pytest.mark.parametrize("wire_model", ["hermite", "lumped"])
@pytest.mark.parametrize("spatial", [False, True])
def test_every_table_has_its_columns(mesh: Make, spatial: bool, wire_model: str) -> None:
    changes = {"geometry": STAGGER, "steady_arm": ARM} if spatial else {}
    made = mesh({"wire_model": wire_model}, **changes)
    assert made.dimension == (3 if spatial else 2)
    assert set(made.parts) == set(COLUMNS)
    for kind, (integers, floats) in made.parts.items():
        assert integers.shape[1:] == (COLUMNS[kind][0],)
        assert floats.shape[1:] == (COLUMNS[kind][1],)
        assert len(integers) == len(floats)
        assert (integers.dtype, floats.dtype) == (np.int64, np.float64)
        assert np.all(np.isfinite(floats))
    assert made.positions.shape == made.slopes.shape == (len(made.positions), 3)


def test_planar_coordinates_are_along_and_up(mesh: Make) -> None:
    made = mesh()
    np.testing.assert_array_equal(made.positions[:, 2], 0.0)
    np.testing.assert_allclose(made.positions[made.contact_nodes, 1], 5.3)
    assert made.positions[made.messenger_nodes[0], 1] == pytest.approx(6.5)


def test_spatial_coordinates_hold_the_stagger(mesh: Make) -> None:
    made = mesh(geometry=STAGGER)
    y = [made.positions[s.contact_node, 1] for s in made.supports]
    np.testing.assert_allclose(y, [0.2, -0.2, 0.2, -0.2, 0.2])
    np.testing.assert_allclose(made.positions[made.contact_nodes, 2], 5.3)
    # An arm known only by a spring holds the stagger: two ends in all three, three arms across.
    fixed, _ = made.parts["fixed"]
    assert len(fixed) == 2 * 2 * 3 + 3


def test_arms_pull_outwards(mesh: Make) -> None:
    made = mesh(geometry=STAGGER, steady_arm=ARM)
    integers, floats = made.parts["struts"]
    assert [made.positions[node, 0] for node in integers[:, 0]] == [50.0, 100.0, 150.0]
    np.testing.assert_allclose(floats[:, 1], np.array([-1, 1, -1]) * cos(radians(10)))
    np.testing.assert_allclose(floats[:, 2], sin(radians(10)))
    np.testing.assert_allclose(floats[:, 6], 1.2)
    np.testing.assert_allclose(floats[:, 7], 17e6 / 1.2)
    # A bar turning about its hinge: a third of it moves, half of it hangs.
    np.testing.assert_allclose(floats[:, 8:], [[0.7 * 1.2 / 3, 0.7 * 1.2 / 2]] * 3)
    assert [s.steady_arm for s in made.supports] == [None, 0, 1, 2, None]


def test_design_leaves_lengths_open_and_as_built_gives_them(mesh: Make) -> None:
    design, _ = mesh().parts["links"]
    assert np.all(design[:, 3] == 1)
    lengths = [1.1, 0.9, 0.8, 0.9, 1.1]
    span = {"length": 50.0, "droppers": {"positions": [5, 15, 25, 35, 45], "lengths": lengths}}
    built, floats = mesh(span_types={"span": span}).parts["links"]
    assert np.all(built[:, 3] == 0)
    np.testing.assert_allclose(floats[:, 0], lengths * 4)
    np.testing.assert_allclose(floats[:, 1], 2e5)


def test_droppers_that_cannot_slacken(mesh: Make) -> None:
    stiff = {"stiffness": 2e5, "slackens": False}
    integers, _ = mesh(dropper=stiff).parts["links"]
    assert np.all(integers[:, 2] == 0)
    assert np.all(mesh().parts["links"][0][:, 2] == 1)


def test_presag_lowers_the_first_guess(mesh: Make) -> None:
    span = {"length": 50.0, "droppers": {"positions": [10, 25, 40], "presag": [0.02, 0.05, 0.02]}}
    made = mesh(span_types={"span": span})
    links, _ = made.parts["links"]
    heights = made.positions[links[:3, 1], 1]
    np.testing.assert_allclose(heights, [5.28, 5.25, 5.28])


def test_springs_say_how_they_rest(mesh: Make) -> None:
    integers, floats = mesh().parts["springs"]
    held, unloaded = integers[integers[:, 2] == HELD], integers[integers[:, 2] == UNLOADED]
    assert len(held) == len(unloaded) == 3  # messenger supports and steady arms
    assert set(floats[:, 0]) == {5e5, 300.0}
    assert not np.any(integers[:, 2] == GIVEN)
    along = {"vertical_stiffness": 5e5, "longitudinal_stiffness": 1e6}
    more, _ = mesh(support=along).parts["springs"]
    assert np.sum(more[:, 1] == 0) == 3


def test_masses_appear_only_where_there_is_mass(mesh: Make) -> None:
    assert len(mesh().parts["masses"][0]) == 0
    dropper = {"stiffness": 2e5, "clamp_mass_contact_wire": 0.165, "clamp_mass_messenger_wire": 0.2}
    arm = {"kind": "spring", "vertical_stiffness": 300.0, "mass": 1.0}
    _, floats = mesh(dropper=dropper, steady_arm=arm).parts["masses"]
    assert sorted(set(floats[:, 0])) == [0.165, 0.2, 1.0]
    assert len(floats) == 2 * 20 + 3


@pytest.mark.parametrize(("ends", "free"), [("fixed", 0), ("constant_force", 1)])
def test_ends(mesh: Make, ends: str, free: int) -> None:
    wire = {"mass": 1.35, "axial_stiffness": 15e6, "bending_stiffness": 180.0, "tension": 22e3}
    made = mesh(contact_wire={**wire, "ends": ends})
    integers, floats = made.parts["ends"]
    assert dict(zip(integers[:, 0].tolist(), floats[:, 0].tolist(), strict=True)) == {
        made.contact_nodes[-1]: 22e3,
        made.messenger_nodes[-1]: 16e3,
    }
    released = dict(zip(integers[:, 0].tolist(), integers[:, 1].tolist(), strict=True))
    assert released == {made.contact_nodes[-1]: free, made.messenger_nodes[-1]: 0}


@pytest.mark.parametrize("change", [{"geometry": STAGGER}, {"steady_arm": ARM}])
def test_planar_calculation_of_a_spatial_line_is_refused(mesh: Make, change: dict) -> None:
    with pytest.raises(MeshError, match=r"solver\.dimension: got planar, expected auto"):
        mesh({"dimension": "planar"}, **change)


def test_spatial_calculation_of_a_planar_line_is_allowed(mesh: Make) -> None:
    assert mesh({"dimension": "spatial"}).dimension == 3
