"""Meshes of stitched and compound lines."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from arcless.mesh import Mesh, build_mesh
from arcless.model import load_line
from arcless.model.settings.run_settings import Solver
from tests.support.line_types import compound_data, stitched_data


def made(data: dict[str, Any], **solver: Any) -> Mesh:
    return build_mesh(load_line(data), Solver.model_validate(solver))


def test_a_stitch_wire_ends_on_nodes_of_the_messenger_wire() -> None:
    mesh = made(stitched_data())
    assert [stitch.support for stitch in mesh.stitches] == [2, 3, 4, 5, 6]
    for stitch, support in zip(mesh.stitches, mesh.supports[1:-1], strict=True):
        x = mesh.positions[stitch.nodes, 0]
        assert (x[0], x[-1]) == (support.x - 9.0, support.x + 9.0)
        assert np.all(np.diff(x) > 0)
        assert np.diff(x).max() <= 2.9 + 1e-9
        assert {stitch.nodes[0], stitch.nodes[-1]} <= set(mesh.messenger_nodes)
        assert not set(stitch.nodes[1:-1]) & set(mesh.messenger_nodes)


def test_wires_turn_freely_at_the_clamps() -> None:
    mesh = made(stitched_data())
    wires = mesh.parts["wires"]
    integers = np.hstack([wires["nodes"], wires["slope_nodes"]])
    of_messenger = set(mesh.messenger_nodes)
    for stitch in mesh.stitches:
        first, last = integers[stitch.rows[0]], integers[stitch.rows[-1]]
        assert first[0] != first[2]
        assert last[1] != last[3]
        behind = [row for row in integers if row[0] == first[0] and row[1] in of_messenger]
        # The slope behind the clamp is neither the one before it nor that of the stitch wire.
        assert len({int(behind[0][2]), int(first[2]), int(first[0])}) == 3
    holders = integers[:, 2:].ravel()
    named = {*mesh.contact_nodes, *of_messenger, *(n for s in mesh.stitches for n in s.nodes)}
    extra = set(holders.tolist()) - named
    # Per inner support: one of the saddle, two of each clamp, one of each dropper on the stitch.
    assert len(extra) == 5 * (1 + 2 * 2 + 2)
    assert named | extra == set(range(len(mesh.positions)))


def test_between_the_clamps_the_messenger_wire_keeps_the_rest_of_its_tension() -> None:
    for model in ("hermite", "lumped"):
        mesh = made(stitched_data(), wire_model=model)
        nodes, tensions = mesh.elements["nodes"], mesh.elements["design_tension"]
        tension = dict(zip(map(tuple, nodes.tolist()), tensions, strict=True))
        for a, b in pairwise(mesh.messenger_nodes):
            x = mesh.positions[[a, b], 0].mean()
            inside = any(abs(x - support.x) < 9.0 for support in mesh.supports[1:-1])
            assert tension[a, b] == (12.2e3 if inside else 15e3)
        for stitch in mesh.stitches:
            assert set(tensions[stitch.rows]) == {2.8e3}


def test_lumped_wires_have_no_bend_where_they_turn_freely() -> None:
    mesh = made(stitched_data(), wire_model="lumped")
    before = mesh.parts["bends"]["segments"][:, 0]
    bent = set(mesh.parts["segments"]["nodes"][before, 1].tolist())
    clamps = {node for s in mesh.stitches for node in (s.nodes[0], s.nodes[-1])}
    assert not bent & clamps
    on_stitch = {d.nodes[0] for d in mesh.droppers if d.wires[0] == "stitch wire"}
    assert {node for s in mesh.stitches for node in s.nodes[1:-1]} - bent == on_stitch


def test_droppers_below_a_stitch_wire_hang_on_it_but_not_at_the_ends_of_the_line() -> None:
    mesh = made(stitched_data())
    on_stitch = [d.name for d in mesh.droppers if d.wires[0] == "stitch wire"]
    assert on_stitch[:3] == ["span 1 dropper 6", "span 2 dropper 1", "span 2 dropper 6"]
    assert len(on_stitch) == 2 * 5
    at_clamp = made(stitched_data(stitch_wire__length=10.0, span_types__span__droppers__positions=[
        3, 5, 30, 55, 57
    ]))  # fmt: skip
    hung = {d.x: d.wires[0] for d in at_clamp.droppers if d.span == 3}
    assert hung == {
        123.0: "stitch wire",
        125.0: "messenger wire",
        150.0: "messenger wire",
        175.0: "messenger wire",
        177.0: "stitch wire",
    }


def test_clamps_have_mass() -> None:
    mesh = made(stitched_data())
    masses = mesh.parts["masses"]
    clamps = sorted(node for s in mesh.stitches for node in (s.nodes[0], s.nodes[-1]))
    heavy = sorted(masses["node"][masses["mass"] == 0.5].tolist())
    assert heavy == clamps


def test_hangers_come_before_the_droppers_that_carry_them() -> None:
    mesh = made(compound_data())
    links = mesh.parts["links"]
    auxiliary, contact = set(mesh.auxiliary_nodes), set(mesh.contact_nodes)
    hangers = [d for d in mesh.droppers if d.wires == ("auxiliary wire", "contact wire")]
    droppers = [d for d in mesh.droppers if d.wires == ("messenger wire", "auxiliary wire")]
    assert (len(hangers), len(droppers)) == (60, 30)
    assert max(d.link for d in hangers) < min(d.link for d in droppers)
    for d in mesh.droppers:
        assert tuple(links["nodes"][d.link]) == d.nodes
    assert all(d.nodes[0] in auxiliary and d.nodes[1] in contact for d in hangers)
    assert all(d.nodes[1] in auxiliary for d in droppers)
    assert {links["stiffness"][d.link] for d in hangers} == {2e5}
    assert {links["stiffness"][d.link] for d in droppers} == {1e5}
    assert [d.name for d in mesh.droppers][:3] == [
        "span 1 hanger 1",
        "span 1 dropper 1",
        "span 1 hanger 2",
    ]


def test_the_auxiliary_wire_is_held_sideways_where_the_arms_hold_the_contact_wire() -> None:
    staggered = compound_data(geometry__stagger_contact_wire=[0.2, -0.2])
    mesh = made(staggered)
    fixed = set(mesh.parts["fixed"].tolist())
    x, y = mesh.positions[mesh.auxiliary_nodes, :2].T
    for index, support in enumerate(mesh.supports[1:-1], start=1):
        node = mesh.auxiliary_nodes[int(np.searchsorted(x, support.x - 1e-6))]
        assert (node, 1) in fixed
        assert (node, 2) not in fixed
        assert mesh.positions[node, 1] == (-0.2 if index % 2 else 0.2)
    own = made({**staggered, "geometry": {**staggered["geometry"], "stagger_auxiliary_wire": [0]}})
    assert np.ptp(y) == pytest.approx(0.4)
    assert not own.positions[own.auxiliary_nodes, 1].any()


def test_a_compound_line_may_be_stitched() -> None:
    mesh = made(compound_data(stitch_wire=stitched_data()["stitch_wire"]))
    kinds = {d.wires for d in mesh.droppers}
    assert kinds == {
        ("auxiliary wire", "contact wire"),
        ("messenger wire", "auxiliary wire"),
        ("stitch wire", "auxiliary wire"),
    }
