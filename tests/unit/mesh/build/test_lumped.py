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
        name: {kind: len(integers) for kind, (integers, _) in made.parts.items()}
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
    integers, floats = made.parts["segments"]
    assert [tuple(row) for row in integers[made.contact_rows]] == list(pairwise(made.contact_nodes))
    assert set(floats[made.contact_rows][:, 2]) == {1.35}
    assert len(integers) == len(made.contact_nodes) + len(made.messenger_nodes) - 2


def test_rest_lengths_give_the_tension_of_the_design(mesh: Make) -> None:
    made = mesh(SOLVER)
    integers, floats = made.parts["segments"]
    ends = made.positions[integers]
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    rest, stiffness, tension = floats[:, 0], floats[:, 1], floats[:, 5]
    # The link's own law, T = EA (ℓ − L)/L; lengths of metres are good to 1e-16, strains are 1e-3.
    np.testing.assert_allclose(stiffness * (length - rest) / rest, tension, rtol=1e-11)
    assert set(tension) == {22e3, 16e3}


def test_stretch_of_a_link() -> None:
    wire = load_line("praks").contact_wire
    assert wire.axial_stiffness * (chain_stretch(wire) - 1) == pytest.approx(wire.tension)


def test_bends_join_neighbours_but_for_hinges_and_ends(mesh: Make) -> None:
    made = mesh(SOLVER, messenger_wire=STIFF)
    segments, _ = made.parts["segments"]
    bends, floats = made.parts["bends"]
    before, behind = segments[bends[:, 0]], segments[bends[:, 1]]
    np.testing.assert_array_equal(before[:, 1], behind[:, 0])
    joints = before[:, 1].tolist()
    assert len(joints) == len(set(joints))
    supports = [0.0, 50.0, 100.0, 150.0, 200.0]
    contact = made.contact_nodes[1:-1]
    messenger = [n for n in made.messenger_nodes if made.positions[n, 0] not in supports]
    assert set(joints) == {*contact, *messenger}
    # At supports the contact wire bends, the messenger wire does not.
    assert {made.positions[n, 0] for n in set(joints) & set(contact)} >= set(supports[1:-1])
    stiff = dict(zip(joints, floats[:, 0].tolist(), strict=True))
    assert {stiff[n] for n in contact} == {180.0}
    assert {stiff[n] for n in messenger} == {110.0}


def test_a_wire_without_bending_stiffness_has_no_bends(mesh: Make) -> None:
    made = mesh(SOLVER)  # its messenger wire has none
    bends, _ = made.parts["bends"]
    assert len(bends) == len(made.contact_nodes) - 2


def test_damping_goes_with_its_wire(mesh: Make) -> None:
    damped = {**STIFF, "damping": {"alpha": 0.01, "beta": 2e-4}}
    made = mesh(SOLVER, messenger_wire=damped)
    _, segments = made.parts["segments"]
    _, bends = made.parts["bends"]
    is_messenger = segments[:, 5] == 16e3
    assert {tuple(row) for row in segments[is_messenger][:, 3:5]} == {(0.01, 2e-4)}
    assert {tuple(row) for row in segments[~is_messenger][:, 3:5]} == {(0.0, 0.0)}
    assert {tuple(row) for row in bends} == {(110.0, 2e-4), (180.0, 0.0)}


def test_a_spatial_chain(mesh: Make) -> None:
    made = mesh({**SOLVER, "dimension": "spatial"})
    assert made.dimension == 3
    fixed, _ = made.parts["fixed"]
    assert len(fixed) == 2 * 2 * 3 + 3


@pytest.mark.parametrize("wire_model", ["hermite", "lumped"])
def test_without_steady_arms_nothing_holds_the_contact_wire_at_supports(
    mesh: Make, wire_model: str
) -> None:
    made = mesh({**SOLVER, "wire_model": wire_model}, steady_arm={"kind": "none"})
    springs, _ = made.parts["springs"]
    held = {int(node) for node in springs[:, 0]}
    assert held <= set(made.messenger_nodes)
    assert len(held) == 3
    assert len(made.parts["struts"][0]) == len(made.parts["masses"][0]) == 0
    # Its uplift there is still of interest.
    assert [made.positions[s.contact_node, 0] for s in made.supports] == [0, 50, 100, 150, 200]
    assert all(s.contact_node in made.contact_nodes for s in made.supports)
    assert all(s.steady_arm is None for s in made.supports)
