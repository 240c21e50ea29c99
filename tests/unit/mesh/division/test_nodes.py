"""Nodes: where they are, in which order, and what is named after them."""

from collections.abc import Callable

import numpy as np
import pytest

from arcless.mesh import Mesh
from arcless.mesh.division.wires import divide, stretch
from arcless.model import load_line

Make = Callable[..., Mesh]


def test_nodes_are_ordered_along_the_track(mesh: Make) -> None:
    x = mesh().positions[:, 0]
    assert np.all(np.diff(x) >= 0)
    assert (x[0], x[-1]) == (0.0, 200.0)


def test_each_node_belongs_to_one_wire_or_is_the_far_side_of_a_hinge(mesh: Make) -> None:
    made = mesh()
    named = set(made.contact_nodes) | set(made.messenger_nodes)
    assert not set(made.contact_nodes) & set(made.messenger_nodes)
    wires = made.parts["wires"]
    behind_hinges = set(wires["slope_nodes"][:, 0]) - set(wires["nodes"][:, 0])
    assert named | behind_hinges == set(range(len(made.positions)))
    assert len(behind_hinges) == 3  # the inner supports of four spans


def test_hinges_stand_at_the_messenger_supports_only(mesh: Make) -> None:
    made = mesh()
    wires = made.parts["wires"]
    nodes, slopes = (wires[name][:, 0] for name in ("nodes", "slope_nodes"))
    hinged = slopes != nodes
    assert made.positions[nodes[hinged], 0].tolist() == [50.0, 100.0, 150.0]
    assert set(nodes[hinged]) <= set(made.messenger_nodes)
    # Slopes arrive at the node itself and leave from its companion at the same place.
    np.testing.assert_array_equal(made.positions[nodes], made.positions[slopes])
    assert np.all(wires["slope_nodes"][:, 1] == wires["nodes"][:, 1])


@pytest.mark.parametrize(("contact", "messenger"), [(1.45, 2.9), (0.8, 1.6), (10.0, 20.0)])
def test_elements_are_no_longer_than_asked(mesh: Make, contact: float, messenger: float) -> None:
    made = mesh({"contact_wire_element": contact, "messenger_wire_element": messenger})
    for nodes, longest in ((made.contact_nodes, contact), (made.messenger_nodes, messenger)):
        lengths = np.diff(made.positions[nodes, 0])
        assert np.all(lengths > 0)
        assert lengths.max() <= longest + 1e-9
    places = [0.0, 5.0, 15.0, 25.0, 35.0, 45.0, 50.0]
    for place in places:
        for nodes in (made.contact_nodes, made.messenger_nodes):
            assert place in made.positions[nodes, 0]


def test_division_is_even_and_never_finer_than_needed() -> None:
    np.testing.assert_allclose(divide([0.0, 10.0, 13.0], 2.5), [0, 2.5, 5, 7.5, 10, 11.5, 13])
    # Places a clamp apart at the same spot are one.
    np.testing.assert_allclose(divide([0.0, 5.0, 5.0 + 1e-9, 10.0], 5.0), [0, 5, 10])


def test_the_path_is_the_contact_wire_from_left_to_right(mesh: Make) -> None:
    made = mesh()
    contact = made.parts["wires"][made.contact_rows]
    assert contact["nodes"][:, 0].tolist() == made.contact_nodes[:-1]
    assert contact["nodes"][:, 1].tolist() == made.contact_nodes[1:]
    assert set(contact["mass"]) == {1.35}
    assert len(made.parts["wires"]) == len(made.contact_nodes) + len(made.messenger_nodes) - 2


def test_names_and_places(mesh: Make) -> None:
    made = mesh()
    assert [d.name for d in made.droppers][:6] == [
        *(f"span 1 dropper {i}" for i in range(1, 6)),
        "span 2 dropper 1",
    ]
    assert [d.x for d in made.droppers][5:7] == [55.0, 65.0]
    assert [d.link for d in made.droppers] == list(range(20))
    assert [s.name for s in made.supports] == [f"support {i}" for i in range(1, 6)]
    assert [s.x for s in made.supports] == [0.0, 50.0, 100.0, 150.0, 200.0]
    ends = made.supports[0], made.supports[-1]
    assert all(s.messenger_spring is None and s.steady_arm is None for s in ends)
    assert all(made.positions[s.contact_node, 0] == s.x for s in made.supports)


def test_droppers_hang_between_the_wires(mesh: Make) -> None:
    made = mesh()
    links = made.parts["links"]
    for dropper in made.droppers:
        upper, lower = links["nodes"][dropper.link]
        assert upper in made.messenger_nodes
        assert lower in made.contact_nodes
        assert made.positions[upper, 0] == made.positions[lower, 0] == dropper.x
        assert made.positions[upper, 1] > made.positions[lower, 1]


def test_mixed_spans(mesh: Make) -> None:
    types = {
        "span": {"length": 50.0, "droppers": {"positions": [10.0, 40.0]}},
        "bare": {"length": 30.0, "droppers": {"positions": []}},
    }
    made = mesh(
        span_types=types,
        spans=[{"type": "bare"}, {"type": "span", "count": 2}, {"type": "bare"}],
    )
    assert [s.x for s in made.supports] == [0.0, 30.0, 80.0, 130.0, 160.0]
    assert [(d.span, d.x) for d in made.droppers] == [
        (2, 40.0),
        (2, 70.0),
        (3, 90.0),
        (3, 120.0),
    ]


def test_stretch_of_the_unloaded_wire_gives_its_tension() -> None:
    wire = load_line("ac-simple-55").contact_wire
    s = stretch(wire)
    # The element's own law: axial force times slope vector, T = EA ½ (s² − 1) s.
    assert wire.axial_stiffness * 0.5 * (s * s - 1) * s == pytest.approx(22e3, rel=1e-12)


def test_300_spans_are_300_times_one(mesh: Make) -> None:
    sizes = {}
    for count in (30, 300):
        made = mesh(spans=[{"type": "span", "count": count}])
        parts = {kind: len(table) for kind, table in made.parts.items()}
        sizes[count] = (len(made.contact_nodes), len(made.messenger_nodes), parts["wires"])
        assert parts["links"] == 5 * count
        assert parts["springs"] == 2 * (count - 1)
    # Counts grow with the line, nothing with its square.
    for short, long in zip(sizes[30], sizes[300], strict=True):
        assert long == pytest.approx(10 * short, rel=0.01)
