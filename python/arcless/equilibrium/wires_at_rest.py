"""Wires of a line at rest: sag of each span, tension and stress of each wire.

The sag f is the depth of a wire below the chord between two supports. A wire that hangs freely
under its weight q per metre with the horizontal tension H has f = q L²/(8 H); with forces P of
droppers at x it is the bending moment of a simple beam under both, over H:

  H f(x) = M(x)

`contact_wire_sag_m` of an initial configuration is another number: maximum less minimum height.
"""

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Line
from arcless.model.line.wire_section import WireSection

Floats = NDArray[np.float64]

ALONG, UP = 0, 2
# A node this near to a support, in m, is at it; the shortest elements are longer by far.
AT_SUPPORT = 1e-6
PASCAL_PER_MPA = 1e6
MM2_PER_M2 = 1e6


def spans(found: Equilibrium) -> list[dict[str, Any]]:
    """Return heights and sag of messenger and contact wire in each span; twice in an overlap.

    Heights in m above rail; `tension_length` is empty where there is one.
    """
    return [
        one
        for number, (left, right) in enumerate(pairwise(found.support_places()), start=1)
        for one in _in_span(found, number, left, right)
    ]


def _in_span(
    found: Equilibrium, number: int, left: float, right: float
) -> Iterator[dict[str, Any]]:
    for system in found.mesh.systems:
        contacts = [_between(found, nodes, left, right) for nodes in system.contact.values()]
        through = [piece for piece in contacts if len(piece)]
        if not through:
            continue
        messenger = _between(found, system.messenger, left, right)
        contact = np.concatenate(through)
        yield {
            "span": number,
            "tension_length": system.label,
            "from_m": left,
            "to_m": right,
            "messenger_wire_sag_below_chord_m": _sag(messenger) if len(messenger) else None,
            "messenger_wire_lowest_m": float(messenger[:, UP].min()) if len(messenger) else None,
            "contact_wire_sag_below_chord_m": max(map(_sag, through)),
            "contact_wire_lowest_m": float(contact[:, UP].min()),
            "contact_wire_highest_m": float(contact[:, UP].max()),
        }


def _between(found: Equilibrium, nodes: list[int], left: float, right: float) -> Floats:
    """Return the points of a wire from support to support; none where it does not run through."""
    points: Floats = found.positions[nodes]
    x = points[:, ALONG]
    inside: Floats = points[(x >= left - AT_SUPPORT) & (x <= right + AT_SUPPORT)]
    # A wire is anchored at a support, or hangs on one: nodes there move along by millimetres.
    designed: Floats = found.mesh.positions[nodes, ALONG]
    if not len(nodes) or designed[0] > left + AT_SUPPORT or designed[-1] < right - AT_SUPPORT:
        return np.empty((0, 3))
    return inside if len(inside) > 1 else np.empty((0, 3))


def _sag(points: Floats) -> float:
    """Return the largest depth in m below the chord between the ends."""
    x, z = points[:, ALONG], points[:, UP]
    chord = np.interp(x, x[[0, -1]], z[[0, -1]])
    return float((chord - z).max())


def wires(found: Equilibrium, line: Line) -> list[dict[str, Any]]:
    """Return tension and axial stress σ = T/A of each wire, by its field of the line.

    Tension and stress are the mean along the wire, the largest and the smallest of an element. The
    area is that of a full round section; stress and area are None of a wire without EI.
    """
    return [
        {"wire": name, **_stress(found.arrays["wire_tension"][rows], _section(line, name))}
        for name, rows in found.mesh.wire_rows.items()
        if rows
    ]


def _section(line: Line, name: str) -> WireSection | None:
    wire = getattr(line, name, None)
    return None if wire is None else WireSection.of(wire)


def _stress(tension: Floats, section: WireSection | None) -> dict[str, float | None]:
    ends = {"mean": tension.mean(), "min": tension.min(), "max": tension.max()}
    area = None if section is None else section.area
    return {
        **{f"tension_{name}_N": float(value) for name, value in ends.items()},
        "area_mm2": None if area is None else MM2_PER_M2 * area,
        **{
            f"stress_{name}_MPa": None if area is None else float(value) / area / PASCAL_PER_MPA
            for name, value in ends.items()
        },
    }
