"""The geometry of a line at rest as plain data, which JSON holds: wires, droppers, supports.

Points are (along, to the left, up) in m. Wires stand kind by kind in the order of a result's
dimensions (`contact_wire_node` and so on), and hold the nodes of the mesh in their order: a motion
that was recorded node by node fits them.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Point = list[float]

# Kind of a wire in the page → its dimension in a result, without `_node`, and its name.
KINDS = {
    "contact": ("contact_wire", "contact wire"),
    "messenger": ("messenger_wire", "messenger wire"),
    "auxiliary": ("auxiliary_wire", "auxiliary wire"),
    "stitch": ("stitch_wire", "stitch wire"),
    "bridle": ("bridle", "bridle"),
}
# Digits after the point of coordinates in m. A micrometre is a hundredth of a pixel at the largest
# exaggeration; with more the answer grows by a half, with fewer pre-sag has steps when enlarged.
DIGITS = 6


class WireData(TypedDict):
    """A wire. `first` is the number of its first node among all of its kind in a result."""

    name: str
    kind: str
    first: int
    x: list[float]
    y: list[float]
    z: list[float]


class DropperData(TypedDict):
    """A dropper; `wire` and `node` are of its lower end, `top_wire` and `top_node` of the upper."""

    name: str
    span: int
    x_m: float
    top: Point
    bottom: Point
    length_m: float
    force_N: float
    wire: int
    node: int
    top_wire: int
    top_node: int


# A steady arm, from the contact wire to its hinge; `from` is a keyword of Python.
ArmData = TypedDict("ArmData", {"from": Point, "to": Point})


class SupportData(TypedDict):
    """A support; `wire` and `node` are of the contact wire there."""

    name: str
    x_m: float
    stagger_m: float
    wire: int
    node: int
    arms: list[ArmData]


class SpanData(TypedDict):
    """A span: its number from 1, and where it begins and ends."""

    number: int
    start_m: float
    end_m: float


class Geometry(TypedDict):
    """A line at rest, in SI units."""

    name: str
    spatial: bool
    height_m: float
    spans: list[SpanData]
    wires: list[WireData]
    droppers: list[DropperData]
    supports: list[SupportData]


class Wires:
    """Wires that are collected kind by kind, in the order of `KINDS`."""

    def __init__(self) -> None:
        self.plain: list[WireData] = []
        self.points: list[Floats] = []

    def add(self, kind: str, pieces: Sequence[Floats], at: Sequence[int] | None = None) -> None:
        """Add the wires of a kind.

        Parameters
        ----------
        kind
            One of `KINDS`.
        pieces
            Points (n × 3) in m of each wire; one without points is left out.
        at
            Support of each, from 1, where wires of the kind belong to one.
        """
        first, several = 0, sum(len(piece) > 0 for piece in pieces) > 1
        for number, points in enumerate(pieces, start=1):
            if not len(points):
                continue
            name = KINDS[kind][1]
            if at is not None:
                name = f"{name} at support {at[number - 1]}"
            elif several:
                name = f"{name} {number}"
            x, y, z = rounded(points.T)
            self.plain.append({"name": name, "kind": kind, "first": first, "x": x, "y": y, "z": z})
            self.points.append(points)
            first += len(points)

    def numbers(self, kind: str) -> list[int]:
        """Return the numbers of the wires of a kind, from 0."""
        return [number for number, wire in enumerate(self.plain) if wire["kind"] == kind]


def rounded(values: Floats) -> Any:
    """Return coordinates in m as lists, to the micrometre."""
    return (np.round(values, DIGITS) + 0.0).tolist()  # without the sign of -0.0


def spans_between(places: Sequence[float]) -> list[SpanData]:
    """Return the spans between supports, whose positions in m are given in their order."""
    return [
        {"number": number, "start_m": left, "end_m": right}
        for number, (left, right) in enumerate(pairwise(places), start=1)
    ]
