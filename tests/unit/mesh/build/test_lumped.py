"""A wire as a chain of point masses: links, bends, and what stays as it is."""

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from arcless.mesh import Mesh
from arcless.mesh.division.wires import chain_stretch
from arcless.model import load_line

Make = Callable[..., Mesh]
SOLVER = {"wire_model": "lumped", "contact_wire_element": 2.5, "messenger_wire_element": 5.0}
STIFF = {"mass": 1.08, "axial_stiffness": 11e6, "bending_stiffness": 110.0, "tension": 16e3}


def test_a_mesh_is_of_one_wire_model(mesh: Make) -> None:
    chain, cubic = mesh(SOLVER), mesh({**SOLVER, "wire_model": "hermite"})
    rows = {
        name: {kind: len(table) for kind, table in made.parts.items()}
        for name, made in (("chain", chain), ("cubic", cubic))
    }
    assert rows["chain"]["wires"] == rows["cubic"]["segments"] == rows["cubic"]["bends"] == 0
    assert rows["chain"]["segments"] == rows["cubic"]["wires"]
    same = set(rows["chain"]) - {"wires", "segments", "bends"}
    assert {kind: rows["chain"][kind] for kind in same} == {
        kind: rows["cubic"][kind] for kind in same
    }
    np.testing.assert_array_equal(chain.slopes, np.zeros_like(chain.positions))


def test_stations_and_division_are_those_of_cubic_elements_without_hinge_nodes(mesh: Make) -> None:
    chain, cubic = mesh(SOLVER), mesh({**SOLVER, "wire_model": "hermite"})
    for name in ("contact_nodes", "messenger_nodes"):
        np.testing.assert_array_equal(
            chain.positions[getattr(chain, name)], cubic.positions[getattr(cubic, name)]
        )
    named = {*chain.contact_nodes, *chain.messenger_nodes}
    assert named == set(range(len(chain.positions)))
    assert np.all(np.diff(chain.positions[:, 0]) >= 0)


def test_the_path_is_the_contact_wire_from_left_to_right(mesh: Make) -> None:
    made = mesh(SOLVER)
    segments = made.parts["segments"]
    contact = segments[made.contact_rows]
    assert [tuple(pair) for pair in contact["nodes"]] == list(pairwise(made.contact_nodes))
    assert set(contact["mass"]) == {1.35}
    assert len(segments) == len(made.contact_nodes) + len(made.messenger_nodes) - 2


def test_rest_lengths_give_the_tension_of_the_design(mesh: Make) -> None:
    made = mesh(SOLVER)
    segments = made.parts["segments"]
    ends = made.positions[segments["nodes"]]
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    rest, tension = segments["rest_length"], segments["design_tension"]
    stiffness = segments["axial_stiffness"]
    # The link's own law, T = EA (ℓ − L)/L; lengths of metres are good to 1e-16, strains are 1e-3.
    np.testing.assert_allclose(stiffness * (length - rest) / rest, tension, rtol=1e-11)
    assert set(tension) == {22e3, 16e3}


def test_stretch_of_a_link() -> None:
    wire = load_line("praks").contact_wire
    assert wire.axial_stiffness * (chain_stretch(wire) - 1) == pytest.approx(wire.tension)


def test_bends_join_neighbours_but_for_hinges_and_ends(mesh: Make) -> None:
    made = mesh(SOLVER, messenger_wire=STIFF)
    segments, bends = made.parts["segments"]["nodes"], made.parts["bends"]
    before, behind = segments[bends["segments"].T]
    np.testing.assert_array_equal(before[:, 1], behind[:, 0])
    joints = before[:, 1].tolist()
    assert len(joints) == len(set(joints))
    supports = [0.0, 50.0, 100.0, 150.0, 200.0]
    contact = made.contact_nodes[1:-1]
    messenger = [n for n in made.messenger_nodes if made.positions[n, 0] not in supports]
    assert set(joints) == {*contact, *messenger}
    # At supports the contact wire bends, the messenger wire does not.
    assert {made.positions[n, 0] for n in set(joints) & set(contact)} >= set(supports[1:-1])
    stiff = dict(zip(joints, bends["bending_stiffness"].tolist(), strict=True))
    assert {stiff[n] for n in contact} == {180.0}
    assert {stiff[n] for n in messenger} == {110.0}


def test_a_wire_without_bending_stiffness_has_no_bends(mesh: Make) -> None:
    made = mesh(SOLVER)  # its messenger wire has none
    assert len(made.parts["bends"]) == len(made.contact_nodes) - 2


def test_damping_goes_with_its_wire(mesh: Make) -> None:
    damped = {**STIFF, "damping": {"alpha": 0.01, "beta": 2e-4}}
    made = mesh(SOLVER, messenger_wire=damped)
    is_messenger = made.parts["segments"]["design_tension"] == 16e3
    damping = made.parts["segments"][["alpha", "beta"]]
    bends = made.parts["bends"][["bending_stiffness", "beta"]]
    assert set(damping[is_messenger].tolist()) == {(0.01, 2e-4)}
    assert set(damping[~is_messenger].tolist()) == {(0.0, 0.0)}
    assert set(bends.tolist()) == {(110.0, 2e-4), (180.0, 0.0)}


def test_a_spatial_chain(mesh: Make) -> None:
    made = mesh({**SOLVER, "dimension": "spatial"})
    assert made.dimension == 3
    assert len(made.parts["fixed"]) == 2 * 2 * 3 + 3


@pytest.mark.parametrize("wire_model", ["hermite", "lumped"])
def test_without_steady_arms_nothing_holds_the_contact_wire_at_supports(
    mesh: Make, wire_model: str
) -> None:
    made = mesh({**SOLVER, "wire_model": wire_model}, steady_arm={"kind": "none"})
    held = set(made.parts["springs"]["node"].tolist())
    assert held <= set(made.messenger_nodes)
    assert len(held) == 3
    assert len(made.parts["struts"]) == len(made.parts["masses"]) == 0
    # Its uplift there is still of interest.
    assert [made.positions[s.contact_node, 0] for s in made.supports] == [0, 50, 100, 150, 200]
    assert all(s.contact_node in made.contact_nodes for s in made.supports)
    assert all(s.steady_arm is None for s in made.supports)
