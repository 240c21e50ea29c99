"""Meshes of several tension lengths, and of contact wires side by side."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from arcless.mesh import Mesh, build_mesh
from arcless.mesh.division.smooth_curves import smooth
from arcless.model import load_line
from arcless.model.settings.run_settings import Solver
from tests.support.line_types import compound_data, stitched_data
from tests.support.overlaps import overlap_data, plain_data

TWIN = {"separation": 0.04}


def made(data: dict[str, Any], **solver: Any) -> Mesh:
    return build_mesh(load_line(data), Solver.model_validate(solver))


def heights(mesh: Mesh, system: int) -> dict[float, float]:
    """Height of a contact wire by position along the track."""
    nodes = next(iter(mesh.systems[system].contact.values()))
    return dict(zip(mesh.positions[nodes, 0], mesh.positions[nodes, -1], strict=True))


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_no_tension_length_shares_a_node_with_another(model: str) -> None:
    mesh = made(overlap_data(), wire_model=model)
    own = [{*s.contact["contact wire"], *s.messenger} for s in mesh.systems]
    assert not own[0] & own[1]
    for a, b in mesh.elements["nodes"]:
        assert ({a, b} <= own[0]) != ({a, b} <= own[1])
    # Numbered one after the other, each along the track.
    assert max(own[0]) < min(own[1])
    for nodes in own:
        assert np.all(np.diff(mesh.positions[sorted(nodes), 0]) >= 0.0)


def test_neighbours_are_on_different_lanes_and_the_next_but_one_on_the_first() -> None:
    mesh = made(overlap_data(ends=(6, 11), spans=15))
    nodes = mesh.parts["wires"]["nodes"]
    reach = [
        [(mesh.positions[a, 0], mesh.positions[b, 0]) for a, b in nodes[lane]]
        for lane in mesh.lanes
    ]
    assert (reach[0][0][0], reach[0][-1][1]) == (0.0, 900.0)
    assert (reach[1][0][0], reach[1][-1][1]) == (180.0, 660.0)
    for lane in reach:
        assert all(behind[0] >= before[1] for before, behind in pairwise(lane))
    gaps = [(b[1], e[0]) for b, e in pairwise(reach[0]) if e[0] > b[1]]
    assert gaps == [(360.0, 480.0)]


@pytest.mark.parametrize(("shared", "own"), [(3, [0.5, 0.06, 0, 0]), (5, [0.9, 0.5, 0.06, 0, 0])])
def test_a_wire_that_ends_is_raised_towards_its_anchor(shared: int, own: list[float]) -> None:
    mesh = made(overlap_data(shared), dimension="spatial")
    # The last span of the first tension length is the 7th, its anchor the 8th support.
    first, second = (heights(mesh, system) for system in (0, 1))
    anchors = 420.0, 60.0 * (7 - shared)
    for inwards, rise in enumerate(own):
        # Droppers five metres on both sides of a support hold the wire, not the support itself.
        assert first[anchors[0] - 60.0 * inwards] == pytest.approx(5.3 + rise, abs=8e-3)
        assert second[anchors[1] + 60.0 * inwards] == pytest.approx(5.3 + rise, abs=8e-3)
    assert {first[0.0], first[5.0], first[65.0]} == {5.3}
    springs = set(mesh.parts["springs"]["node"].tolist())
    held = [n for n in mesh.messenger_nodes if n in springs]
    above = {(mesh.positions[n, 0], round(float(mesh.positions[n, 2]), 9)) for n in held}
    for inwards, rise in enumerate(own[1:], start=1):
        assert (anchors[0] - 60.0 * inwards, round(7.1 + rise, 9)) in above


def test_both_wires_keep_their_distance_and_pull_outwards() -> None:
    arm = {"kind": "arm", "length": 1.0, "slope": 0.1}
    mesh = made(overlap_data(steady_arm=arm, geometry__stagger_contact_wire=[0.2, -0.2]))
    places = {s.name: mesh.positions[s.contact_node] for s in mesh.supports}
    # Supports 5 to 8 are those of the overlap; the wire that begins is on the positive side.
    for number, stagger in zip(range(4, 9), (-0.2, 0.2, -0.2, 0.2, -0.2), strict=True):
        if number > 4:
            assert places[f"tension length 2 support {number}"][1] == pytest.approx(stagger + 0.1)
            assert places[f"tension length 1 support {number}"][1] == pytest.approx(stagger - 0.1)
        else:
            assert places["tension length 1 support 4"][1] == pytest.approx(stagger)
            assert "tension length 2 support 4" not in places
    struts = mesh.parts["struts"]
    side = dict(zip(struts["node"].tolist(), struts["direction"][:, 1], strict=True))
    for name, length in (("tension length 1", range(2, 8)), ("tension length 2", range(6, 12))):
        for number in length:
            found = next(s for s in mesh.supports if s.name == f"{name} support {number}")
            assert side[found.contact_node] * (-1) ** (number + 1) > 0.0, found.name
    assert sum(s.steady_arm is None for s in mesh.supports) == 4  # the anchors


def test_given_staggers_of_an_overlap() -> None:
    begins, ends = [1.0, 0.3, 0.2, 0.25], [-0.25, -0.2, -0.3, -1.0]
    mesh = made(overlap_data(overlap__stagger_in=begins, overlap__stagger_out=ends))
    for number, one, other in zip(range(5, 9), begins, ends, strict=True):
        for label, y in (("tension length 2", one), ("tension length 1", other)):
            support = next(s for s in mesh.supports if s.name == f"{label} support {number}")
            assert mesh.positions[support.contact_node, 1] == pytest.approx(y)


def test_names_say_the_tension_length_only_where_there_are_several() -> None:
    mesh = made(overlap_data())
    names = [d.name for d in mesh.droppers]
    assert len(set(names)) == len(names) == 6 * (11 + 3)
    assert names[0] == "tension length 1 span 1 dropper 1"
    assert "tension length 2 span 5 dropper 4" in names
    whole = made(plain_data(11, tension_lengths=[{"from_span": 1, "to_span": 11}]))
    assert whole.droppers[0].name == "span 1 dropper 1"
    assert whole.supports[0].name == "support 1"


def test_stitch_wires_hang_at_the_inner_supports_of_each_tension_length() -> None:
    data = overlap_data(stitch_wire=stitched_data()["stitch_wire"])
    mesh = made(data)
    assert [stitch.support for stitch in mesh.systems[0].stitches] == list(range(2, 8))
    assert [stitch.support for stitch in mesh.systems[1].stitches] == list(range(6, 12))
    hung = {d.name: d.wires[0] for d in mesh.droppers}
    assert hung["tension length 1 span 5 dropper 1"] == "stitch wire"
    # There the second tension length is anchored.
    assert hung["tension length 2 span 5 dropper 1"] == "messenger wire"


def test_a_curve_through_points_is_level_where_they_are_and_does_not_swing() -> None:
    x = np.linspace(0.0, 6.0, 601)
    y = smooth(range(7), [0.5, 0.06, 0.0, 0.0, 0.0, 0.06, 0.5], x)
    # Round-off of heights below 1 m.
    np.testing.assert_allclose(y, y[::-1], atol=1e-15)
    assert not y[200:401].any()
    assert np.all(np.diff(y[:201]) <= 0.0)
    # No kink: in a smooth curve the second difference vanishes with the square of the step.
    assert np.abs(np.diff(y, 2)).max() < 1e-4
    # Straight through points on a straight line.
    np.testing.assert_allclose(smooth([0, 1, 3], [1.0, 2.0, 4.0], x[:301]), 1.0 + x[:301])


@pytest.mark.parametrize("dimension", ["planar", "spatial"])
def test_twin_wires_side_by_side(dimension: str) -> None:
    mesh = made(plain_data(4, twin_contact_wires=TWIN), dimension=dimension)
    assert len(mesh.lanes) == len(mesh.contact_wires) == 2
    ahead = [mesh.positions[nodes] for nodes in mesh.contact_wires]
    np.testing.assert_array_equal(ahead[0][:, 0], ahead[1][:, 0])
    apart = ahead[0][:, 1] - ahead[1][:, 1]
    # Round-off of one subtraction.
    np.testing.assert_allclose(apart, 0.04 if dimension == "spatial" else 0.0, atol=1e-15)
    assert sorted(mesh.wire_rows["contact_wire"]) == sorted(mesh.contact_rows)
    assert [s.name for s in mesh.supports[:3]] == [
        "support 1 wire 1",
        "support 1 wire 2",
        "support 2 wire 1",
    ]
    assert mesh.supports[2].messenger_spring == mesh.supports[3].messenger_spring


def test_paired_and_alternating_droppers() -> None:
    paired = made(plain_data(4, twin_contact_wires=TWIN))
    assert [d.name for d in paired.droppers[:3]] == [
        "span 1 dropper 1 wire 1",
        "span 1 dropper 1 wire 2",
        "span 1 dropper 2 wire 1",
    ]
    assert paired.droppers[0].nodes[0] == paired.droppers[1].nodes[0]
    assert paired.droppers[0].nodes[1] != paired.droppers[1].nodes[1]
    other = made(plain_data(4, twin_contact_wires={**TWIN, "droppers": "alternating"}))
    assert [d.name for d in other.droppers[:2]] == ["span 1 dropper 1", "span 1 dropper 2"]
    first, second = (set(nodes) for nodes in other.contact_wires)
    on = ["first" if d.nodes[1] in first else "second" for d in other.droppers]
    assert on == ["first", "second"] * 12
    assert all(d.nodes[1] in second for d in other.droppers[1::2])


def test_twin_wires_below_an_auxiliary_wire_hang_on_hangers() -> None:
    mesh = made(compound_data(twin_contact_wires=TWIN))
    hangers = [d for d in mesh.droppers if d.wires[0] == "auxiliary wire"]
    assert hangers[0].name == "span 1 hanger 1 wire 1"
    assert hangers[0].wires[1] == "contact wire 1"
    droppers = [d for d in mesh.droppers if d.wires[0] == "messenger wire"]
    assert droppers[0].name == "span 1 dropper 1"
    assert len(hangers) == 2 * 2 * len(droppers)


def test_twin_wires_in_overlaps_have_four_lanes() -> None:
    mesh = made(overlap_data(twin_contact_wires=TWIN))
    assert len(mesh.lanes) == 4
    y = {
        s.name: float(mesh.positions[s.contact_node, 1])
        for s in mesh.supports
        if "support 6" in s.name
    }
    assert y == pytest.approx(
        {
            "tension length 1 support 6 wire 1": -0.08,
            "tension length 1 support 6 wire 2": -0.12,
            "tension length 2 support 6 wire 1": 0.12,
            "tension length 2 support 6 wire 2": 0.08,
        }
    )
