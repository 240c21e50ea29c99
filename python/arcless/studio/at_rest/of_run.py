"""The geometry of a line at rest, from the result of a run.

Wires are those of the result, node for node, by whatever version it was computed. What a result
does not have is taken from the line of its scenario: which contact wire a support holds, and where
its steady arm is hinged, as designed.
"""

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np

from arcless.dataset.plain_dataset import Dataset
from arcless.mesh import PLANAR, Mesh, SupportPlace, build_mesh
from arcless.results import Result
from arcless.studio.at_rest.plain_geometry import (
    KINDS,
    ArmData,
    DropperData,
    Floats,
    Geometry,
    SupportData,
    Wires,
    rounded,
    spans_between,
)

ALONG, ACROSS, UP = 0, 1, 2


def geometry_of_run(result: Result) -> Geometry:
    """Return the geometry of the line of a run, before it moved.

    Parameters
    ----------
    result
        A run, finished or stopped early.
    """
    data, line = result.latest, result.scenario.line
    wires, mesh = _wires(data), build_mesh(line, result.scenario.stepping)
    return {
        "name": line.name,
        "spatial": mesh.dimension != PLANAR,
        "height_m": line.geometry.contact_wire_height,
        "spans": spans_between(sorted({support.x for support in mesh.supports})),
        "wires": wires.plain,
        "droppers": list(_droppers(data, wires)) if "dropper_x" in data else [],
        "supports": list(_supports(mesh, wires)),
    }


def _wires(data: Dataset) -> Wires:
    wires = Wires()
    for kind, (name, _) in KINDS.items():
        if f"{name}_node_x" not in data:
            continue
        points = np.column_stack([_values(data, f"{name}_node_{axis}") for axis in "xyz"])
        of = [_values(data, f"{name}_node_{by}") for by in ("wire", "support")]
        at = of[1][_begins(of, len(points))] if len(of[1]) else None
        pieces = np.split(points, _begins(of, len(points))[1:])
        wires.add(kind, pieces, None if at is None else at.astype(int).tolist())
    return wires


def _begins(of: list[Floats], count: int) -> list[int]:
    """Return where wires begin: where a number that tells them apart changes."""
    changes = [np.flatnonzero(np.diff(numbers)) + 1 for numbers in of if len(numbers)]
    inner = np.unique(np.concatenate(changes)).tolist() if changes else []
    return [0, *inner] if count else []


def _values(data: Dataset, name: str) -> Any:
    """Return the values of a variable; none where the result does not have it."""
    return np.asarray(data[name].values) if name in data else np.zeros(0)


def _droppers(data: Dataset, wires: Wires) -> Iterator[DropperData]:
    names = ("span", "x", "top_z", "bottom_z", "length", "force_static")
    columns = [_values(data, f"dropper_{name}").tolist() for name in names]
    rows = zip(np.asarray(data["dropper"].values).tolist(), *columns, strict=True)
    nodes = _Nodes(wires)
    for name, span, x, top_z, bottom_z, length, force in rows:
        upper, lower = nodes.joined(x, top_z, bottom_z, length)
        (top_wire, top_node), (wire, node) = nodes.place(upper), nodes.place(lower)
        yield {
            "name": name, "span": int(span), "x_m": x,
            "top": rounded(nodes.points[upper]), "bottom": rounded(nodes.points[lower]),
            "length_m": length, "force_N": force,
            "wire": wire, "node": node, "top_wire": top_wire, "top_node": top_node,
        }  # fmt: skip


class _Nodes:
    """All nodes of wires, by height: a clamp has exactly the height of its node."""

    def __init__(self, wires: Wires) -> None:
        self.points = np.concatenate(wires.points)
        counts = [len(piece) for piece in wires.points]
        self._of = np.repeat(np.arange(len(counts)), counts)
        self._in = np.concatenate([np.arange(count) for count in counts])
        self._order = np.argsort(self.points[:, UP], kind="stable")
        self._z = self.points[self._order, UP]

    def place(self, node: int) -> tuple[int, int]:
        """Return the number of the wire of a node, and its place in it."""
        return int(self._of[node]), int(self._in[node])

    def joined(self, x: float, top_z: float, bottom_z: float, length: float) -> tuple[int, int]:
        """Return the upper and the lower node of a dropper; all in m.

        In an overlap wires of two tension lengths may have one height at one place: of these, those
        that are as far apart as the dropper is long.
        """
        ends = product(self._at(x, top_z), self._at(x, bottom_z))
        return min(ends, key=lambda pair: abs(self._distance(*pair) - length))

    def _distance(self, one: int, other: int) -> float:
        return float(np.linalg.norm(self.points[one] - self.points[other]))

    def _at(self, x: float, z: float) -> list[int]:
        """Return the nodes of the height z that are nearest to x, both in m."""
        first, last = (int(np.searchsorted(self._z, z, side)) for side in ("left", "right"))
        # A height that no node has, as after a conversion of the file: the nearest one.
        first, last = (first, last) if last > first else (max(first - 1, 0), first + 1)
        level = self._order[first:last]
        away = np.abs(self.points[level, ALONG] - x)
        found: list[int] = level[away == away.min()].tolist()
        return found


def _supports(mesh: Mesh, wires: Wires) -> Iterator[SupportData]:
    held = {node: number for number, nodes in enumerate(mesh.contact_wires) for node in nodes}
    contacts = wires.numbers("contact")
    for support in mesh.supports:
        wire = contacts[held[support.contact_node]]
        points = wires.points[wire]
        node = int(np.argmin(np.abs(points[:, ALONG] - support.x)))
        yield {
            "name": support.name, "x_m": support.x, "stagger_m": float(points[node, ACROSS]),
            "wire": wire, "node": node, "arms": _arms(mesh, support, points[node]),
        }  # fmt: skip


def _arms(mesh: Mesh, support: SupportPlace, clamp: Floats) -> list[ArmData]:
    if support.steady_arm is None:
        return []
    bar = mesh.parts["struts"][support.steady_arm]
    way = bar["rest_length"] * bar["direction"]
    if mesh.dimension == PLANAR:  # along and up
        way = np.array([way[0], 0.0, way[1]])
    return [{"from": rounded(clamp), "to": rounded(clamp + way)}]
