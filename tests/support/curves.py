"""Wires in a curve: as the track sees them, and as they are in space."""

from math import sin

import numpy as np

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.mesh.tables.columns import GIVEN
from arcless.mesh.tables.parts import Parts
from tests.support.structures import add_element, at_rest, mesh_of

AXIAL, MASS = 14e6, 1.1


def two_spans(
    kind: str, count: int, *, radius: float, span: float, tension: float, stiffness: float,
    from_track: bool, gravity: float = 0.0,
) -> Equilibrium:  # fmt: skip
    """Bring a wire over two spans to rest, held aside in the middle by a spring alone.

    Parameters
    ----------
    kind
        wires (cubic elements) or segments (point masses).
    count
        Elements of each span.
    radius, span
        Of the track, m, to the left; between supports on a circle, m.
    tension
        Of the wire without weight, N; supports stand where it lies straight then.
    stiffness
        Of the spring across the track in the middle, N/m; it holds the wire where it is drawn.
    from_track
        Whether positions are counted from the track, or from a straight line through the support in
        the middle, normal to the spring.
    gravity
        In m/s².
    """
    angle = span / radius
    chord = 2.0 * radius * sin(0.5 * angle)
    strain = tension / AXIAL  # of both laws but for squares, 1e-6
    rest = chord / (1.0 + strain)
    share = np.linspace(-1.0, 1.0, 2 * count + 1)
    lean = 0.5 * angle
    points = np.zeros((len(share), 3))
    if from_track:
        inside = np.abs(share)
        points[:, 0] = span * share
        points[:, 1] = span * span / (2.0 * radius) * inside * (1.0 - inside)
    else:
        points[:, 0] = chord * np.cos(lean) * share
        points[:, 1] = chord * np.sin(lean) * np.abs(share)
    slopes = np.gradient(points, rest / count, axis=0)
    parts = Parts()
    add_wire(parts, kind, 2 * count, rest / count, tension)
    for _ in range(2 * count if from_track else 0):
        parts.add("turns", angle=angle / count)
    for end in (0, 2 * count):
        parts.fix(end, 0, 1, 2)
    parts.fix(count, 2)
    held = 2.0 * tension * sin(lean)
    parts.add_spring(count, 1, GIVEN, stiffness=stiffness, rest=-held / stiffness)
    mesh = mesh_of(3, points, slopes, parts, list(range(2 * count)), gravity=gravity)
    return at_rest(mesh)


def one_span(kind: str, count: int, *, radius: float, span: float, tension: float) -> Equilibrium:
    """Bring a weightless wire between two fixed points of the track to rest, see `two_spans`."""
    angle = span / radius
    rest = 2.0 * radius * sin(0.5 * angle) / (1.0 + tension / AXIAL)
    share = np.linspace(0.0, 1.0, count + 1)
    points = np.zeros((count + 1, 3))
    points[:, 0] = span * share
    points[:, 1] = 0.5 * span * angle * share * (1.0 - share)
    parts = Parts()
    add_wire(parts, kind, count, rest / count, tension)
    for end in (0, count):
        parts.fix(end, 0, 1, 2)
    for _ in range(count):
        parts.add("turns", angle=angle / count)
    slopes = np.gradient(points, rest / count, axis=0)
    return at_rest(mesh_of(3, points, slopes, parts, list(range(count))))


def add_wire(parts: Parts, kind: str, count: int, rest: float, tension: float) -> None:
    """Add a wire without bending stiffness, of elements of a length in m."""
    for i in range(count):
        bending = 0.0 if kind == "wires" else None
        add_element(parts, i, rest=rest, axial=AXIAL, mass=MASS, tension=tension, bending=bending)
