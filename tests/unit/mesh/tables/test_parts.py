"""Tables of parts: their shapes, and what a model's parts become."""

from collections.abc import Callable
from math import cos, radians, sin

import numpy as np
import pytest

from arcless.errors import MeshError
from arcless.mesh import Mesh
from arcless.mesh.tables.columns import COLUMNS, GIVEN, HELD, UNLOADED, Tables
from arcless.mesh.tables.parts import Parts

Make = Callable[..., Mesh]
ARM = {"kind": "arm", "length": 1.2, "slope": radians(10), "mass": 0.7, "axial_stiffness": 17e6}
STAGGER = {"contact_wire_height": 5.3, "encumbrance": 1.2, "stagger_contact_wire": [0.2, -0.2]}


@pytest.mark.parametrize("wire_model", ["hermite", "lumped"])
@pytest.mark.parametrize("spatial", [False, True])
def test_every_table_has_its_columns(mesh: Make, spatial: bool, wire_model: str) -> None:
    changes = {"geometry": STAGGER, "steady_arm": ARM} if spatial else {}
    made = mesh({"wire_model": wire_model}, **changes)
    assert made.dimension == (3 if spatial else 2)
    assert set(made.parts) == set(COLUMNS) == set(Tables.__annotations__)
    for kind, table in made.parts.items():
        assert table.dtype == COLUMNS[kind]
        assert table.ndim == 1
        assert all(np.isfinite(table[name]).all() for name in COLUMNS[kind].names or ())
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
    assert len(made.parts["fixed"]) == 2 * 2 * 3 + 3


def test_arms_pull_outwards(mesh: Make) -> None:
    made = mesh(geometry=STAGGER, steady_arm=ARM)
    struts = made.parts["struts"]
    assert made.positions[struts["node"], 0].tolist() == [50.0, 100.0, 150.0]
    across, up = struts["direction"][:, 1:].T
    np.testing.assert_allclose(across, np.array([-1, 1, -1]) * cos(radians(10)))
    np.testing.assert_allclose(up, sin(radians(10)))
    np.testing.assert_allclose(struts["rest_length"], 1.2)
    np.testing.assert_allclose(struts["stiffness"], 17e6 / 1.2)
    # A bar turning about its hinge: a third of it moves, half of it hangs.
    np.testing.assert_allclose(struts["moving_mass"], 0.7 * 1.2 / 3)
    np.testing.assert_allclose(struts["hanging_mass"], 0.7 * 1.2 / 2)
    assert [s.steady_arm for s in made.supports] == [None, 0, 1, 2, None]


def test_design_leaves_lengths_open_and_as_built_gives_them(mesh: Make) -> None:
    assert np.all(mesh().parts["links"]["adjust"])
    lengths = [1.1, 0.9, 0.8, 0.9, 1.1]
    span = {"length": 50.0, "droppers": {"positions": [5, 15, 25, 35, 45], "lengths": lengths}}
    built = mesh(span_types={"span": span}).parts["links"]
    assert not np.any(built["adjust"])
    np.testing.assert_allclose(built["rest_length"], lengths * 4)
    np.testing.assert_allclose(built["stiffness"], 2e5)


def test_droppers_that_cannot_slacken(mesh: Make) -> None:
    stiff = {"stiffness": 2e5, "slackens": False}
    assert not np.any(mesh(dropper=stiff).parts["links"]["unilateral"])
    assert np.all(mesh().parts["links"]["unilateral"])


def test_presag_lowers_the_first_guess(mesh: Make) -> None:
    span = {"length": 50.0, "droppers": {"positions": [10, 25, 40], "presag": [0.02, 0.05, 0.02]}}
    made = mesh(span_types={"span": span})
    heights = made.positions[made.parts["links"]["nodes"][:3, 1], 1]
    np.testing.assert_allclose(heights, [5.28, 5.25, 5.28])


def test_springs_say_how_they_rest(mesh: Make) -> None:
    springs = mesh().parts["springs"]
    held, unloaded = (np.sum(springs["mode"] == mode) for mode in (HELD, UNLOADED))
    assert held == unloaded == 3  # messenger supports and steady arms
    assert set(springs["stiffness"]) == {5e5, 300.0}
    assert not np.any(springs["mode"] == GIVEN)
    along = {"vertical_stiffness": 5e5, "longitudinal_stiffness": 1e6}
    more = mesh(support=along).parts["springs"]
    assert np.sum(more["component"] == 0) == 3


def test_masses_appear_only_where_there_is_mass(mesh: Make) -> None:
    assert len(mesh().parts["masses"]) == 0
    dropper = {"stiffness": 2e5, "clamp_mass_contact_wire": 0.165, "clamp_mass_messenger_wire": 0.2}
    arm = {"kind": "spring", "vertical_stiffness": 300.0, "mass": 1.0}
    masses = mesh(dropper=dropper, steady_arm=arm).parts["masses"]["mass"]
    assert sorted(set(masses)) == [0.165, 0.2, 1.0]
    assert len(masses) == 2 * 20 + 3


@pytest.mark.parametrize(("ends", "free"), [("fixed", False), ("constant_force", True)])
def test_ends(mesh: Make, ends: str, free: bool) -> None:
    wire = {"mass": 1.35, "axial_stiffness": 15e6, "bending_stiffness": 180.0, "tension": 22e3}
    made = mesh(contact_wire={**wire, "ends": ends})
    table = made.parts["ends"]
    assert dict(table[["node", "force"]].tolist()) == {
        made.contact_nodes[-1]: 22e3,
        made.messenger_nodes[-1]: 16e3,
    }
    released = dict(table[["node", "released"]].tolist())
    assert released == {made.contact_nodes[-1]: free, made.messenger_nodes[-1]: False}


@pytest.mark.parametrize("change", [{"geometry": STAGGER}, {"steady_arm": ARM}])
def test_planar_calculation_of_a_spatial_line_is_refused(mesh: Make, change: dict) -> None:
    with pytest.raises(MeshError, match=r"solver\.dimension: got planar, expected auto"):
        mesh({"dimension": "planar"}, **change)


def test_spatial_calculation_of_a_planar_line_is_allowed(mesh: Make) -> None:
    assert mesh({"dimension": "spatial"}).dimension == 3


@pytest.mark.parametrize("columns", [{"node": 1}, {"node": 1, "component": 0, "force": 1.0}])
def test_a_row_has_every_column_of_its_table_and_no_other(columns: dict) -> None:
    with pytest.raises(TypeError, match="fixed: columns node"):
        Parts().add("fixed", **columns)
