"""Rows become pieces of the wires that a page draws, whatever shares their columns."""

from typing import Any

import numpy as np

from arcless.studio.motion.layout import LineMotion, RowLayout, WirePart, in_order

# Contact wires of 6, 4 and 5 nodes: the first and the last share a lane. Stitch wires of 3 nodes,
# all of them in one lane. Values of a row are the number of the node among those of its kind.
SIZES = {"contact": [6, 4, 5], "stitch": [3, 3, 3]}


def geometry() -> Any:
    wires = []
    for kind, sizes in SIZES.items():
        first = 0
        for size in sizes:
            x = [float(node) for node in range(size)]
            wires.append({"name": kind, "kind": kind, "first": first, "x": x, "y": x, "z": x})
            first += size
    # Supports at nodes 5 of wire 0, 2 of wire 2, and 1 of wire 1: not in the order of the lanes.
    places = [(0, 5), (2, 2), (1, 1)]
    supports = [{"wire": wire, "node": node} for wire, node in places]
    return {"spatial": False, "wires": wires, "supports": supports}


LAYOUT = RowLayout(
    wires=(
        WirePart("contact_wire", (range(6), range(10, 15)), 4),
        WirePart("contact_wire", (range(6, 10),), 3),
        WirePart("stitch_wire", (range(9),), 4),
    ),
    dropper_order=np.array([0, 1, 3, 2, 4]),
    dropper_count=4,
    pantographs=(("P1", 2),),
    spatial=False,
)
LANES = [[*range(6), *range(10, 15)], [*range(6, 10)], [*range(9)]]


def row_of(first: list[int], dropper_first: int = 0) -> Any:
    row = np.zeros(1, LAYOUT.type)[0]
    row["time"], row["first"], row["dropper_first"] = 1.5, first, dropper_first
    row["up"] = np.concatenate(
        [
            lane[begin : begin + part.count]
            for lane, begin, part in zip(LANES, first, LAYOUT.wires, strict=True)
        ]
    )
    row["droppers"] = LAYOUT.dropper_order[dropper_first : dropper_first + 4]
    row["pantograph 0"] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    return row


def told(row: Any) -> dict[str, list[tuple[int, list[float]]]]:
    line = LineMotion(LAYOUT, geometry())
    found: dict[str, list[tuple[int, list[float]]]] = {}
    for piece in line.pieces(row):
        assert piece.time_s == 1.5
        name = line.channels[piece.channel].name
        found.setdefault(name, []).append((piece.first, piece.values.tolist()))
    return found


def test_channels_are_those_of_the_geometry() -> None:
    channels = LineMotion(LAYOUT, geometry()).channels
    assert [(one.name, one.size) for one in channels] == [
        ("wire.0.up", 6), ("wire.1.up", 4), ("wire.2.up", 5), ("wire.3.up", 3),
        ("wire.4.up", 3), ("wire.5.up", 3), ("droppers", 4), ("supports", 3),
        ("pantograph.0", 6),
    ]  # fmt: skip


def test_a_window_inside_of_one_wire() -> None:
    found = told(row_of([1, 0, 0]))
    assert found["wire.0.up"] == [(1, [1.0, 2.0, 3.0, 4.0])]
    assert found["wire.1.up"] == [(0, [6.0, 7.0, 8.0])]
    assert "wire.2.up" not in found


def test_a_window_over_the_end_of_a_wire_goes_on_in_the_next_of_its_lane() -> None:
    found = told(row_of([4, 1, 0]))
    assert found["wire.0.up"] == [(4, [4.0, 5.0])]
    assert found["wire.2.up"] == [(0, [10.0, 11.0])]
    assert found["wire.1.up"] == [(1, [7.0, 8.0, 9.0])]


def test_stitch_wires_are_told_apart() -> None:
    found = told(row_of([0, 0, 2]))
    assert found["wire.3.up"] == [(2, [2.0])]
    assert found["wire.4.up"] == [(0, [3.0, 4.0, 5.0])]
    assert "wire.5.up" not in found


def test_droppers_have_their_own_numbers() -> None:
    assert told(row_of([0, 0, 0]))["droppers"] == [(0, [0.0, 1.0, 2.0, 3.0])]
    assert told(row_of([0, 0, 0], 1))["droppers"] == [(1, [1.0, 2.0, 3.0, 4.0])]


def test_droppers_that_alternate_in_an_overlap_are_one_piece_of_each_tension_length() -> None:
    pieces = list(in_order(6, 1.5, np.array([7, 20, 8, 21, 9]), np.array([70, 200, 80, 210, 90])))
    assert [(one.first, one.values.tolist()) for one in pieces] == [
        (7, [70, 80, 90]),
        (20, [200, 210]),
    ]


def test_the_uplift_at_supports_is_that_of_the_wire_there() -> None:
    # Support 0 is in the window at node 5, support 1 at node 12, support 2 at node 7.
    assert told(row_of([5, 1, 0]))["supports"] == [(0, [5.0, 12.0, 7.0])]
    assert told(row_of([0, 1, 0]))["supports"] == [(2, [7.0])]


def test_pantographs_are_last() -> None:
    line = LineMotion(LAYOUT, geometry())
    last = line.pieces(row_of([0, 0, 0]))[-1]
    assert (last.channel, last.first) == (len(line.channels) - 1, 0)
    assert last.values.tolist() == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
