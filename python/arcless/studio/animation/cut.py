"""A geometry with fewer nodes: wires, and the droppers and supports that are held by nodes left."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from arcless.studio.at_rest.plain_geometry import DropperData, Geometry, SupportData, WireData

Numbers = list[NDArray[np.intp]]
AXES: tuple[Literal["x"], Literal["y"], Literal["z"]] = ("x", "y", "z")


@dataclass(frozen=True)
class Cut:
    """A smaller geometry, and which droppers and supports of the whole one it has, from 0."""

    geometry: Geometry
    droppers: NDArray[np.intp]
    supports: NDArray[np.intp]


def cut(geometry: Geometry, kept: list[NDArray[np.bool_]]) -> Cut:
    """Return the geometry of the nodes that are kept; droppers with both ends, and supports.

    Parameters
    ----------
    geometry
        A line at rest.
    kept
        Which nodes stay, by wire (node).
    """
    number = [np.cumsum(mask) - 1 for mask in kept]

    def stays(wire: int, node: int) -> bool:
        return bool(kept[wire][node])

    droppers = [
        at
        for at, one in enumerate(geometry["droppers"])
        if stays(one["wire"], one["node"]) and stays(one["top_wire"], one["top_node"])
    ]
    supports = [
        at for at, one in enumerate(geometry["supports"]) if stays(one["wire"], one["node"])
    ]
    low, high = _ends(geometry, kept)
    small: Geometry = {
        **geometry,
        "wires": [_wire(*pair) for pair in zip(geometry["wires"], kept, strict=True)],
        "droppers": [_dropper(geometry["droppers"][at], number) for at in droppers],
        "supports": [_support(geometry["supports"][at], number) for at in supports],
        "spans": [s for s in geometry["spans"] if s["end_m"] >= low and s["start_m"] <= high],
    }
    return Cut(small, np.array(droppers, dtype=np.intp), np.array(supports, dtype=np.intp))


def _wire(wire: WireData, mask: NDArray[np.bool_]) -> WireData:
    x, y, z = (np.asarray(wire[axis])[mask].tolist() for axis in AXES)
    return {**wire, "x": x, "y": y, "z": z}


def _dropper(one: DropperData, number: Numbers) -> DropperData:
    node, top = number[one["wire"]][one["node"]], number[one["top_wire"]][one["top_node"]]
    return {**one, "node": int(node), "top_node": int(top)}


def _support(one: SupportData, number: Numbers) -> SupportData:
    return {**one, "node": int(number[one["wire"]][one["node"]])}


def _ends(geometry: Geometry, kept: list[NDArray[np.bool_]]) -> tuple[float, float]:
    """Return the positions in m of the first and the last node that is kept."""
    wires = zip(geometry["wires"], kept, strict=True)
    along = np.concatenate([np.asarray(wire["x"])[mask] for wire, mask in wires])
    return float(along.min()), float(along.max())
