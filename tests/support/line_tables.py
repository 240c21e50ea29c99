"""Lines to lay tables over, and lines compared without the names and notes of their files."""

import json
from typing import Any

import arcless
from arcless.model import Line
from arcless.model.tables.of_line import staggers


def other_text(line: Line) -> str:
    """Return a line file with the wires of a line and nothing that its tables hold.

    Two kinds of span, equal and with other droppers, other heights, masses, curves, overlaps.
    """
    data = line.to_dict()
    del data["provenance"]
    name, kind = next(iter(data["span_types"].items()))
    for hung in ("droppers", "hangers"):
        if kind[hung] is not None and kind[hung]["positions"]:
            # The outer ones stay: stitch wires need droppers near the supports.
            places = kind[hung]["positions"]
            kind[hung] = {"positions": [places[0] + 0.01, *places[2:]]}
    data["span_types"] = {name: kind, "nowhere else": kind}
    data["spans"] = [{"type": name, "count": 30}, {"type": "nowhere else", "count": 2}]
    if line.tension_lengths is not None:
        first, second = line.tension_lengths[:2]
        shared = first.to_span - second.from_span + 1
        own = ((1, 9 + shared), (10, 32))
        data["tension_lengths"] = [{"from_span": one, "to_span": other} for one, other in own]
    data["geometry"] |= {
        "contact_wire_height": 5.0,
        "height_changes": [{"from_support": 2, "to_support": 3, "height": 5.01}],
    }
    if data["midpoint_anchor"] is not None:
        data["midpoint_anchor"]["support"] = None
    data["track"]["curves"] = []
    data["point_masses"] = [{"position": 100.0, "mass": 1.0, "name": "clamp"}]
    data["inserts"] = []
    return json.dumps(_given(data))


def _given(value: Any) -> Any:
    """Return data without what is not given."""
    if isinstance(value, dict):
        return {key: _given(item) for key, item in value.items() if item is not None}
    return [_given(item) for item in value] if isinstance(value, list) else value


def content(line: Line) -> dict[str, Any]:
    """Return all that a line is, place by place: what a mesh is made from."""
    data = line.to_dict()
    for name in ("span_types", "spans", "provenance", "name", "description", "sources"):
        del data[name]
    for name in ("contact_wire_height", "height_changes"):
        del data["geometry"][name]
    count = len(line.support_positions())
    for wire in ("contact_wire", "messenger_wire", "auxiliary_wire"):
        data["geometry"][f"stagger_{wire}"] = staggers(line, wire, count)
    data["heights"] = line.contact_wire_heights()
    data["spans"] = [
        [span.length, *_hung(span.droppers), *_hung(span.holders)] for span in line.span_list()
    ]
    return data


def _hung(own: Any) -> list[Any]:
    nothing = None if own.positions else ()
    return [own.positions, own.presag or nothing, own.lengths or nothing]


def loaded(text: str) -> Line:
    """Return the line in a text."""
    from arcless.model.files.yaml_reader import parse

    return arcless.load_line(parse(text, "line")[0])
