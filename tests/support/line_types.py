"""A stitched and a compound line that are short and have round numbers."""

from typing import Any

WIRE = {"mass": 1.1, "axial_stiffness": 14e6, "bending_stiffness": 130.0, "tension": 15e3}
MESSENGER = {"mass": 0.6, "axial_stiffness": 7.4e6, "bending_stiffness": 30.0, "tension": 15e3}
STITCH = {
    "mass": 0.3,
    "axial_stiffness": 3.9e6,
    "bending_stiffness": 10.0,
    "tension": 2.8e3,
    "length": 18.0,
    "clamp_mass": 0.5,
}
AUXILIARY = {
    "mass": 1.4,
    "axial_stiffness": 15e6,
    "bending_stiffness": 10.0,
    "tension": 14e3,
    "height": 0.3,
}


def stitched_data(**changes: Any) -> dict[str, Any]:
    """Return six stitched spans of 60 m; changes by path, dots written as ``__``."""
    data: dict[str, Any] = {
        "name": "stitched",
        "contact_wire": dict(WIRE),
        "messenger_wire": dict(MESSENGER),
        "stitch_wire": dict(STITCH),
        "dropper": {"stiffness": 1e5, "mass": 0.1},
        "support": {"vertical_stiffness": 5e5},
        "steady_arm": {"kind": "spring", "vertical_stiffness": 300.0},
        "geometry": {"contact_wire_height": 5.3, "encumbrance": 1.8},
        "span_types": {
            "span": {"length": 60.0, "droppers": {"positions": [5, 15, 25, 35, 45, 55]}}
        },
        "spans": [{"type": "span", "count": 6}],
    }
    return changed(data, changes)


def compound_data(**changes: Any) -> dict[str, Any]:
    """Return six compound spans of 50 m; changes by path, dots written as ``__``."""
    data = stitched_data()
    del data["stitch_wire"]
    data["name"] = "compound"
    data["auxiliary_wire"] = dict(AUXILIARY)
    data["hanger"] = {"stiffness": 2e5, "clamp_mass_contact_wire": 0.2}
    data["span_types"]["span"] = {
        "length": 50.0,
        "droppers": {"positions": [5, 15, 25, 35, 45]},
        "hangers": {"positions": [2.5, 7.5, 12.5, 17.5, 22.5, 27.5, 32.5, 37.5, 42.5, 47.5]},
    }
    return changed(data, changes)


def scenario_data(line: dict[str, Any], **changes: Any) -> dict[str, Any]:
    """Return a run of two seconds on a line."""
    data: dict[str, Any] = {
        "name": line["name"],
        "line": line,
        "pantographs": [{"model": "dsa-250", "static_force": 120.0}],
        "speed": 60.0,
        "travel": {"start": 70.0, "end": 190.0},
        "analysis": {"from": 100.0, "to": 180.0},
    }
    return changed(data, changes)


def changed(data: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    """Change data by paths with dots written as ``__``; None takes a field away."""
    for path, value in changes.items():
        *groups, last = path.split("__")
        place: Any = data
        for group in groups:
            place = place.setdefault(group, {})
        if value is None:
            place.pop(last, None)
        else:
            place[last] = value
    return data
