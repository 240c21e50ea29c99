"""A line of which every number can be checked by hand."""

from collections.abc import Callable
from typing import Any

import pytest

from arcless.mesh import Mesh, build_mesh
from arcless.model import Line, load_line
from arcless.model.settings.run_settings import Solver

SPAN = 50.0
POSITIONS = [5.0, 15.0, 25.0, 35.0, 45.0]


def line_data(**changes: Any) -> dict[str, Any]:
    wire = {"mass": 1.35, "axial_stiffness": 15e6, "bending_stiffness": 180.0, "tension": 22e3}
    messenger = {"mass": 1.08, "axial_stiffness": 11e6, "bending_stiffness": 0.0, "tension": 16e3}
    data = {
        "name": "by hand",
        "contact_wire": wire,
        "messenger_wire": messenger,
        "dropper": {"stiffness": 2e5, "mass": 0.1},
        "support": {"vertical_stiffness": 5e5},
        "steady_arm": {"kind": "spring", "vertical_stiffness": 300.0},
        "geometry": {"contact_wire_height": 5.3, "encumbrance": 1.2},
        "span_types": {"span": {"length": SPAN, "droppers": {"positions": POSITIONS}}},
        "spans": [{"type": "span", "count": 4}],
    }
    for path, value in changes.items():
        *groups, last = path.split("__")
        place: Any = data
        for group in groups:
            place = place[group]
        place[last] = value
    return data


@pytest.fixture
def line() -> Callable[..., Line]:
    """Return a maker of lines of four spans; changes by path, dots written as ``__``."""
    return lambda **changes: load_line(line_data(**changes))


@pytest.fixture
def mesh(line: Callable[..., Line]) -> Callable[..., Mesh]:
    """Return a maker of meshes; `solver` holds solver settings, the rest changes the line."""

    def make(solver: dict[str, Any] | None = None, **changes: Any) -> Mesh:
        return build_mesh(line(**changes), Solver.model_validate(solver or {}))

    return make
