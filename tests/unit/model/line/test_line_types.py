"""Stitched and compound lines: what is refused, and that a file says all of it."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load_line
from tests.support.line_types import STITCH, compound_data, stitched_data


def refusal(data: dict[str, Any]) -> str:
    with pytest.raises(ModelError) as caught:
        load_line(data)
    return str(caught.value)


@pytest.mark.parametrize("data", [stitched_data(), compound_data()], ids=lambda d: d["name"])
def test_round_trip(data: dict[str, Any]) -> None:
    line = load_line(data)
    assert load_line(line.to_dict()) == line


def test_without_the_fields_a_line_is_simple() -> None:
    line = load_line(stitched_data(stitch_wire=None))
    assert line.stitch_wire is None
    assert line.auxiliary_wire is None
    assert line.span_types["span"].holders is line.span_types["span"].droppers


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"stitch_wire__length": 60.0},
            "stitch_wire.length: stitch wire longer than a span: got 60 m, expected less than 60 m,"
            " the shortest span; hint: half of it reaches into each span, where that of the next"
            " support begins",
        ),
        (
            {"stitch_wire__length": 9.0},
            "stitch_wire.length: no dropper on the stitch wire: got the nearest one 5 m from a"
            " support, expected one less than 4.5 m, half of the stitch wire, from it; hint: a"
            " stitch wire of more than 10 m, or a dropper nearer to each support",
        ),
        (
            {"span_types__span__droppers__positions": []},
            "stitch_wire.length: no dropper on the stitch wire: got no dropper, expected one less"
            " than 9 m, half of the stitch wire, from it; hint: give the spans next to the supports"
            " droppers",
        ),
        (
            {"stitch_wire__tension": 15e3},
            "stitch_wire.tension: stitch wire with all of the messenger wire's tension: got 15000"
            " N, expected less than 15000 N, the tension of the messenger wire; hint: between the"
            " clamps the messenger wire keeps the difference",
        ),
        (
            {"spans": [{"type": "span"}]},
            "stitch_wire: no support for a stitch wire: got a line of one span, expected at least"
            " two spans; hint: stitch wires hang at the supports between two spans",
        ),
    ],
)
def test_impossible_stitch_wires(changes: dict[str, Any], message: str) -> None:
    assert refusal(stitched_data(**changes)).endswith(message)


def test_a_stitch_wire_needs_its_length() -> None:
    data = stitched_data(stitch_wire={k: v for k, v in STITCH.items() if k != "length"})
    assert "stitch_wire.length: missing field" in refusal(data)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"auxiliary_wire__height": 1.8},
            "auxiliary_wire.height: auxiliary wire not between contact and messenger wire: got 1.8"
            " m above the contact wire, expected less than the encumbrance, 1.8 m",
        ),
        (
            {"span_types__span__droppers__presag": [0, 0, 0.3, 0, 0]},
            "span_types.span.droppers.presag.2: auxiliary wire not between contact and messenger"
            " wire: got 0 m above the contact wire: auxiliary_wire.height, 0.3 m, less a pre-sag of"
            " 0.3 m, expected a height between 0 and 1.8 m above it; hint: droppers hold the"
            " auxiliary wire: their pre-sag is that of this wire; that of the contact wire belongs"
            " to hangers",
        ),
        (
            {"span_types__span__hangers__presag": [0, -0.3, *[0] * 8]},
            "span_types.span.hangers.presag.1: contact wire above the auxiliary wire: got 0.3 m"
            " above its nominal height, expected less than 0.3 m; hint: pre-sag is positive"
            " downwards",
        ),
        (
            {"span_types__span__hangers__positions": [2.5, 50.0]},
            "span_types.span.hangers.positions.1: hanger outside its span: got 50 m, expected a"
            " position between 0 and 50 m, the span's length; hint: positions count from the left"
            " support of the span",
        ),
        (
            {"span_types__span__hangers": None},
            "span_types.span.hangers: missing field: expected hangers: what the contact wire hangs"
            " on below the auxiliary wire; hint: for instance hangers: {positions: [10 m, 20 m,"
            " 30 m, 40 m]}",
        ),
        (
            {"auxiliary_wire": None},
            "hanger: hangers without an auxiliary wire: expected auxiliary_wire, or no hanger;"
            " hint: without that wire the contact wire hangs on droppers",
        ),
        (
            {"auxiliary_wire": None, "hanger": None},
            "span_types.span.hangers: hangers without an auxiliary wire: expected auxiliary_wire,"
            " or droppers alone; hint: hangers hold the contact wire below an auxiliary wire",
        ),
    ],
)
def test_impossible_auxiliary_wires(changes: dict[str, Any], message: str) -> None:
    assert refusal(compound_data(**changes)).endswith(message)


def test_hangers_without_data_of_their_own_are_droppers() -> None:
    assert load_line(compound_data(hanger=None)).hanger is None
    assert load_line(compound_data()).auxiliary_wire is not None
