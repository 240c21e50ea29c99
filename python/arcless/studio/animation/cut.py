"""A geometry with fewer nodes: wires, and the droppers and supports that are held by nodes left."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.studio.at_rest.plain_geometry import Geometry


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
    droppers, supports = [], []
    for at, dropper in enumerate(geometry["droppers"]):
        ends = (dropper["wire"], dropper["node"]), (dropper["top_wire"], dropper["top_node"])
        if all(kept[wire][node] for wire, node in ends):
            droppers.append(at)
    for at, support in enumerate(geometry["supports"]):
        if kept[support["wire"]][support["node"]]:
            supports.append(at)
    low, high = _ends(geometry, kept)
    small: Geometry = {
        **geometry,
        "wires": [
            {
                **wire,
                "x": np.asarray(wire["x"])[mask].tolist(),
                "y": np.asarray(wire["y"])[mask].tolist(),
                "z": np.asarray(wire["z"])[mask].tolist(),
            }
            for wire, mask in zip(geometry["wires"], kept, strict=True)
        ],
        "droppers": [
            {
                **geometry["droppers"][at],
                "node": int(number[geometry["droppers"][at]["wire"]][geometry["droppers"][at]["node"]]),
                "top_node": int(
                    number[geometry["droppers"][at]["top_wire"]][geometry["droppers"][at]["top_node"]]
                ),
            }
            for at in droppers
        ],
        "supports": [
            {
                **geometry["supports"][at],
                "node": int(number[geometry["supports"][at]["wire"]][geometry["supports"][at]["node"]]),
            }
            for at in supports
        ],
        "spans": [s for s in geometry["spans"] if s["end_m"] >= low and s["start_m"] <= high],
    }  # fmt: skip
    return Cut(small, np.array(droppers, dtype=np.intp), np.array(supports, dtype=np.intp))


def _ends(geometry: Geometry, kept: list[NDArray[np.bool_]]) -> tuple[float, float]:
    """Return the positions in m of the first and the last node that is kept."""
    wires = zip(geometry["wires"], kept, strict=True)
    along = np.concatenate([np.asarray(wire["x"])[mask] for wire, mask in wires])
    return float(along.min()), float(along.max())
