"""Lines without a messenger wire that are short and have round numbers."""

from typing import Any

from tests.support.line_types import changed

TROLLEY = {
    "mass": 1.1,
    "axial_stiffness": 14e6,
    "bending_stiffness": 130.0,
    "tension": 12e3,
    "ends": "constant_force",
}
BRIDLE = {
    "mass": 0.3,
    "axial_stiffness": 3.9e6,
    "bending_stiffness": 0.0,
    "tension": 2e3,
    "length": 10.0,
    "clamp_mass": 0.4,
}
RAIL = {
    "kind": "conductor_rail",
    "mass": 8.0,
    "axial_stiffness": 1.5e8,
    "bending_stiffness": 2e5,
    "tension": 0.0,
    "ends": "constant_force",
}


def trolley_data(**changes: Any) -> dict[str, Any]:
    """Return ten spans of 40 m of a trolley wire; changes by path, dots written as ``__``."""
    data: dict[str, Any] = {
        "name": "trolley",
        "contact_wire": dict(TROLLEY),
        "contact_support": {"vertical_stiffness": 5e5},
        "geometry": {"contact_wire_height": 5.5},
        "span_types": {"span": {"length": 40.0}},
        "spans": [{"type": "span", "count": 10}],
    }
    return changed(data, changes)


def bridle_data(**changes: Any) -> dict[str, Any]:
    """Return the same on bridles, with a light steady arm at each support."""
    data = trolley_data()
    data["name"] = "bridles"
    data["bridle"] = dict(BRIDLE)
    data["steady_arm"] = {"kind": "spring", "vertical_stiffness": 100.0, "mass": 0.5}
    return changed(data, changes)


def rail_data(**changes: Any) -> dict[str, Any]:
    """Return thirty spans of 8 m of a conductor rail without joints, on stiff supports."""
    data = trolley_data()
    data["name"] = "rail"
    data["contact_wire"] = dict(RAIL)
    data["contact_support"] = {"vertical_stiffness": 1e10}
    data["span_types"] = {"span": {"length": 8.0}}
    data["spans"] = [{"type": "span", "count": 30}]
    return changed(data, changes)


def one_span_data(**changes: Any) -> dict[str, Any]:
    """Return a trolley wire without bending stiffness over one span of 60 m: a string."""
    span = {"span_types__span__length": 60.0, "spans": [{"type": "span"}]}
    return trolley_data(**{"contact_wire__bending_stiffness": 0.0, **span, **changes})
