"""Division of the two wires into elements, and a first guess of their shape."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil

import numpy as np

from arcless.mesh.types import Floats
from arcless.model.components import Wire
from arcless.model.line import Line

# Stations closer than this are one: far below a clamp, far above rounding. In m.
SAME_PLACE = 1e-6


@dataclass(frozen=True)
class Stations:
    """Positions along the track that need a node: supports, and droppers with their span.

    Attributes
    ----------
    supports : positions of the supports, m
    droppers : (span from 1, position m, height of the contact wire below nominal m or None,
        given length m or None) of each dropper
    """

    supports: list[float]
    droppers: list[tuple[int, float, float | None, float | None]]


def stations(line: Line) -> Stations:
    """Collect the places of a line that need nodes."""
    supports = line.support_positions()
    droppers: list[tuple[int, float, float | None, float | None]] = []
    for number, (start, span) in enumerate(zip(supports, line.span_list(), strict=False), start=1):
        own = span.droppers
        for index, position in enumerate(own.positions):
            length = None if own.lengths is None else own.lengths[index]
            presag = own.design_presag[index] if length is None else None
            droppers.append((number, start + position, presag, length))
    return Stations(supports, droppers)


def divide(places: Sequence[float], longest: float) -> Floats:
    """Return node positions in m: all places, and equal elements no longer than asked between."""
    nodes = [places[0]]
    for left, right in pairwise(places):
        if right - left < SAME_PLACE:
            continue
        # A trifle of slack, so that a spacing equal to the longest element is not divided.
        count = max(1, ceil((right - left) / longest - 1e-9))
        nodes.extend(left + (right - left) * i / count for i in range(1, count + 1))
    return np.array(nodes)


def stretch(wire: Wire) -> float:
    """Return |r′| of the wire under its tension: T = EA ½ (s² − 1) s, by Newton's method."""
    s = 1.0 + wire.tension / wire.axial_stiffness
    for _ in range(20):
        error = wire.axial_stiffness * 0.5 * (s * s - 1.0) * s - wire.tension
        s -= error / (wire.axial_stiffness * 0.5 * (3.0 * s * s - 1.0))
    return s


def chain_stretch(wire: Wire) -> float:
    """Return ℓ/L of a straight link under the wire's tension: T = EA (ℓ − L)/L."""
    return 1.0 + wire.tension / wire.axial_stiffness


def messenger_guess(line: Line, supports: Sequence[float], x: Floats, gravity: float) -> Floats:
    """Height of the messenger wire in m: parabolas q x (L − x) / 2T, q the weight of both wires."""
    load = (line.messenger_wire.mass + line.contact_wire.mass) * gravity
    span = np.clip(np.searchsorted(supports, x, side="right") - 1, 0, len(supports) - 2)
    left = np.asarray(supports)[span]
    right = np.asarray(supports)[span + 1]
    sag = load * (x - left) * (right - x) / (2.0 * line.messenger_wire.tension)
    top = line.geometry.contact_wire_height + line.geometry.encumbrance
    return np.asarray(top - sag)


def contact_guess(line: Line, places: Stations, x: Floats, gravity: float) -> Floats:
    """Height of the contact wire in m: straight between the heights known at the droppers."""
    height = line.geometry.contact_wire_height
    known: dict[float, float] = {places.supports[0]: height, places.supports[-1]: height}
    messenger = messenger_guess(
        line, places.supports, np.array([d[1] for d in places.droppers]), gravity
    )
    for (_, position, presag, length), top in zip(places.droppers, messenger, strict=True):
        known[position] = height - presag if presag is not None else float(top) - (length or 0.0)
    ordered = sorted(known)
    return np.interp(x, ordered, [known[position] for position in ordered])


def stagger_guess(pattern: Sequence[float], supports: Sequence[float], x: Floats) -> Floats:
    """Lateral position in m: straight between the staggers of the supports."""
    values = [pattern[i % len(pattern)] for i in range(len(supports))]
    return np.interp(x, supports, values)


def slopes(points: Floats, magnitude: float) -> Floats:
    """Slope vectors r′ of the given length along a line of points (n × 3)."""
    tangent = np.gradient(points, axis=0)
    return np.asarray(magnitude * tangent / np.linalg.norm(tangent, axis=1, keepdims=True))


def chord_lengths(points: Floats, magnitude: float) -> Floats:
    """Unstretched length of each element in m, from its chord."""
    return np.asarray(np.linalg.norm(np.diff(points, axis=0), axis=1) / magnitude)
