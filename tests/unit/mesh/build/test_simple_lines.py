"""Meshes of lines without a messenger wire, of parts on wires, and of wire ends."""

from math import sqrt
from typing import Any

import numpy as np
import pytest

from arcless.mesh import Mesh, build_mesh
from arcless.mesh.tables.columns import UNLOADED
from arcless.model import load_line
from arcless.model.settings.run_settings import Solver
from tests.support.line_types import compound_data, stitched_data
from tests.support.simple_lines import bridle_data, rail_data, trolley_data

INSULATOR = {
    "position": 150.0,
    "length": 2.0,
    "mass": 9.0,
    "axial_stiffness": 2e7,
    "bending_stiffness": 3e3,
}


def made(data: dict[str, Any], **solver: Any) -> Mesh:
    return build_mesh(load_line(data), Solver.model_validate(solver))


def along(mesh: Mesh) -> list[tuple[float, float]]:
    """Return place and stiffness of each spring along the track that starts without force."""
    springs = mesh.parts["springs"]
    free = springs[(springs["component"] == 0) & (springs["mode"] == UNLOADED)]
    places = mesh.positions[free["node"], 0].tolist()
    return list(zip(places, free["stiffness"].tolist(), strict=True))


def test_a_trolley_wire_is_all_there_is() -> None:
    mesh = made(trolley_data())
    assert not mesh.droppers
    assert not mesh.messenger_nodes
    assert set(mesh.contact_nodes) == set(range(len(mesh.positions)))
    held = [s.messenger_spring for s in mesh.supports]
    assert held[0] is None
    assert held[-1] is None
    nodes = [int(mesh.parts["springs"]["node"][row]) for row in held[1:-1] if row is not None]
    assert nodes == [s.contact_node for s in mesh.supports[1:-1]]


def test_it_has_nodes_beside_its_supports() -> None:
    beside = 2 * sqrt(130.0 / 12e3)
    x = made(trolley_data()).positions[:, 0]
    for support in range(40, 400, 40):
        for side in (-beside, beside):
            assert abs(x - support - side).min() < 1e-9
    # A limp wire has a kink there, a rail carries by bending everywhere.
    assert len(made(trolley_data(contact_wire__bending_stiffness=0.0)).positions) == 56 * 10 + 1
    assert len(made(rail_data(), contact_wire_element=1.0).positions) == 8 * 30 + 1


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_bridles_hang_on_supports_and_end_on_the_contact_wire(model: str) -> None:
    mesh = made(bridle_data(), wire_model=model)
    contact = set(mesh.contact_nodes)
    assert [bridle.support for bridle in mesh.bridles] == list(range(2, 11))
    springs = mesh.parts["springs"]
    for bridle, support in zip(mesh.bridles, mesh.supports[1:-1], strict=True):
        assert {bridle.nodes[0], bridle.nodes[-1]} <= contact
        assert not set(bridle.nodes[1:-1]) & contact
        assert support.messenger_spring is not None
        hung = int(springs["node"][support.messenger_spring])
        assert hung in bridle.nodes
        assert mesh.positions[hung, 0] == support.x
    columns = ("nodes", "design_tension")
    nodes, tensions = (mesh.elements[name].tolist() for name in columns)
    tension = dict(zip(map(tuple, nodes), tensions, strict=True))
    middle = mesh.positions[mesh.contact_nodes, 0]
    pairs = zip(mesh.contact_nodes, mesh.contact_nodes[1:], middle, middle[1:], strict=False)
    for a, b, left, right in pairs:
        x = 0.5 * (left + right)
        inside = any(abs(x - support.x) < 5.0 for support in mesh.supports[1:-1])
        assert tension[a, b] == (10e3 if inside else 12e3)


def test_joints_are_masses_on_nodes_of_their_own() -> None:
    mesh = made(rail_data(contact_wire__joints={"mass": 2.5, "spacing": 12.0}))
    masses = mesh.parts["masses"]
    places = mesh.positions[masses["node"], 0]
    assert places.tolist() == [12.0 * i for i in range(1, 20)]
    assert set(masses["mass"]) == {2.5}


@pytest.mark.parametrize("wire", ["contact_wire", "messenger_wire", "auxiliary_wire"])
@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_an_insert_replaces_its_piece_of_wire(wire: str, model: str) -> None:
    plain = made(compound_data(), wire_model=model)
    mesh = made(compound_data(inserts=[{**INSULATOR, "wire": wire}]), wire_model=model)
    elements = mesh.elements
    ends = mesh.positions[elements["nodes"], 0]
    own = np.zeros(len(elements), dtype=bool)
    own[mesh.wire_rows[wire]] = True
    inside = own & (ends[:, 0] > 149.0 - 1e-9) & (ends[:, 1] < 151.0 + 1e-9)
    assert ends[inside].min() == 149.0
    assert ends[inside].max() == 151.0
    assert set(elements["axial_stiffness"][inside]) == {2e7}
    assert set(elements["mass"][inside]) == {4.5}
    assert not (elements["axial_stiffness"][~inside] == 2e7).any()
    # Tension and damping are those of the wire.
    before = plain.elements[plain.wire_rows[wire]]
    for name in ("design_tension", "alpha", "beta"):
        assert set(elements[name][inside]) == set(before[name])


def test_at_the_end_of_an_insert_flexibilities_share_a_bend() -> None:
    mesh = made(trolley_data(inserts=[INSULATOR]), wire_model="lumped")
    found = sorted(set(mesh.parts["bends"]["bending_stiffness"]))
    assert found == [130.0, pytest.approx(2 / (1 / 130.0 + 1 / 3e3)), 3e3]


def test_masses_sit_on_the_wire_that_is_named() -> None:
    wires = ("contact_wire", "messenger_wire", "auxiliary_wire")
    parts = [{"wire": wire, "position": 131.3, "mass": 3.0 + i} for i, wire in enumerate(wires)]
    mesh = made(compound_data(point_masses=parts))
    found = {float(m): int(n) for n, m in mesh.parts["masses"][["node", "mass"]]}
    lists = (mesh.contact_nodes, mesh.messenger_nodes, mesh.auxiliary_nodes)
    for i, own in enumerate(lists):
        assert found[3.0 + i] in own
        assert mesh.positions[found[3.0 + i], 0] == 131.3


def test_a_midpoint_anchor_frees_both_ends() -> None:
    both = {f"{wire}__ends": "constant_force" for wire in ("contact_wire", "messenger_wire")}
    plain, held = (
        made(stitched_data(**both, **anchor))
        for anchor in ({}, {"midpoint_anchor": {"stiffness": 1e6}})
    )
    assert len(plain.parts["ends"]) == 2
    ends = sorted(
        (float(held.positions[end["node"], 0]), bool(end["released"]), float(end["force"]))
        for end in held.parts["ends"]
    )
    assert ends == [(0.0, True, -15e3)] * 2 + [(360.0, True, 15e3)] * 2
    assert along(held) == [(180.0, 1e6)] * 2


def test_springs_stand_at_the_ends_that_move() -> None:
    springs = {"contact_wire__ends": "spring", "contact_wire__end_stiffness": 2e4}
    assert along(made(trolley_data(**springs))) == [(400.0, 2e4)]
    anchored = made(trolley_data(**springs, midpoint_anchor={"stiffness": 1e6, "support": 3}))
    assert sorted(along(anchored)) == [(0.0, 2e4), (80.0, 1e6), (400.0, 2e4)]
