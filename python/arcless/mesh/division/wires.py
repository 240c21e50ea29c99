"""Division of the wires into elements, and what their ends and lengths are."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import ceil, sqrt

import numpy as np

from arcless.mesh.division.masses_and_inserts import places_on_wires
from arcless.mesh.division.systems import WireSystem
from arcless.mesh.division.wire_names import AUXILIARY, BRIDLE, MESSENGER, STITCH
from arcless.mesh.tables.mesh_types import Floats
from arcless.model.line.line import Line
from arcless.model.line.parts.components import DropperType, TensionedWire
from arcless.model.line.parts.spans import SpanDroppers

# Stations closer than this are one: far below a clamp, far above rounding. In m.
SAME_PLACE = 1e-6


@dataclass(frozen=True)
class Hanging:
    """A dropper or hanger to be meshed: what it is, where it hangs, between which wires.

    Attributes
    ----------
    presag : the lower wire below its nominal height, m, where the length is to be found
    length : given length, m
    """

    name: str
    span: int
    x: float
    upper: str
    lower: str
    kind: DropperType
    presag: float | None
    length: float | None


@dataclass(frozen=True)
class Stations:
    """Places that need a node along the wires of a system, positions in m.

    Attributes
    ----------
    system : heights, staggers and supports
    clamps : first and last clamp of the stitch wire at each inner support; empty without them
    bridles : first and last clamp of the bridle at each inner support; empty without them
    single : by wire, places of its own that need a node: joints, masses, ends of inserts
    hangings : droppers and hangers, those that hold the contact wire first: the design calculation
        finds forces in this order, and what hangs below adds to what holds it
    """

    system: WireSystem
    clamps: list[tuple[float, float]]
    hangings: list[Hanging]
    bridles: list[tuple[float, float]] = field(default_factory=list)
    single: dict[str, list[float]] = field(default_factory=dict)

    @property
    def supports(self) -> list[float]:
        """Positions of the supports in m, the two anchors among them."""
        return self.system.supports

    def along(self, wire: str) -> list[float]:
        """Return the places of a wire that need a node, in order."""
        if wire == BRIDLE:
            return sorted([*self.supports[1:-1], *(x for pair in self.bridles for x in pair)])
        ends = self.supports if wire != STITCH else []
        pairs = self.clamps if wire in {STITCH, MESSENGER} else []
        pairs = self.bridles if wire in self.system.contact_wires else pairs
        clamps = [x for pair in pairs for x in pair]
        hung = [h.x for h in self.hangings if wire in {h.upper, h.lower}]
        return sorted([*ends, *clamps, *hung, *self.single.get(wire, [])])


def stations(line: Line, system: WireSystem) -> Stations:
    """Collect the places of a wire system that need nodes."""
    supports = system.supports
    reach = 0.5 * line.stitch_wire.length if line.stitch_wire is not None else 0.0
    clamps = [(x - reach, x + reach) for x in supports[1:-1]] if reach else []
    hangers: list[Hanging] = []
    droppers: list[Hanging] = []
    for place, (start, span) in enumerate(zip(supports, system.spans, strict=False)):
        # At the anchors there is no stitch wire.
        first = reach if place > 0 else 0.0
        last = span.length - (reach if place < len(system.spans) - 1 else 0.0)

        def upper(x: float, first: float = first, last: float = last) -> str:
            return MESSENGER if first - SAME_PLACE <= x <= last + SAME_PLACE else STITCH

        hung = _Hung(line, system, system.first + place, start)
        droppers += hung.from_messenger(span.droppers, upper)
        if span.hangers is not None:
            hangers += hung.from_auxiliary(span.hangers)
    half = 0.5 * line.bridle.length if line.bridle is not None else 0.0
    bridles = [(x - half, x + half) for x in supports[1:-1]] if half else []
    single = places_on_wires(line, system)
    for wire in system.contact_wires:
        single[wire] = [*single.get(wire, []), *_bent(line, supports)]
    return Stations(system, clamps, [*hangers, *droppers], bridles, single)


def _bent(line: Line, supports: list[float]) -> list[float]:
    """Return places next to the supports at which a contact wire without messenger wire is held.

    It turns there by w L/T within some √(EI/T), far less than an element. With a node at twice
    that on either side the sag is right to 0.1 mm with any element; without, to 2 mm with 1.45 m.
    """
    wire = line.contact_wire
    if line.contact_support is None or line.bridle is not None or wire.tension == 0.0:
        return []
    beside = 2.0 * sqrt(wire.bending_stiffness / wire.tension)
    places = [x + side for x in supports[1:-1] for side in (-beside, beside)]
    return [x for x in places if supports[0] < x < supports[-1]]


@dataclass(frozen=True)
class _Hung:
    """Makes the droppers and hangers of one span, which starts at a place in m."""

    line: Line
    system: WireSystem
    span: int
    start: float

    def from_messenger(self, own: SpanDroppers, upper: Callable[[float], str]) -> list[Hanging]:
        line = self.line
        return [
            self._hanging(f"dropper {index + 1}{which}", own, index, (upper(x), lower))
            for index, x in enumerate(own.positions)
            for lower, which in (
                self._contacts(index) if line.auxiliary_wire is None else [(AUXILIARY, "")]
            )
        ]

    def from_auxiliary(self, own: SpanDroppers) -> list[Hanging]:
        return [
            self._hanging(f"hanger {index + 1}{which}", own, index, (AUXILIARY, lower))
            for index in range(len(own.positions))
            for lower, which in self._contacts(index)
        ]

    def _contacts(self, index: int) -> list[tuple[str, str]]:
        """Return the contact wires that a dropper holds, and what tells its name from others."""
        names, twin = list(self.system.contact_wires), self.line.twin_contact_wires
        if twin is not None and twin.droppers == "paired":
            return [(name, f" wire {number}") for number, name in enumerate(names, start=1)]
        return [(names[index % len(names)], "")]

    def _hanging(
        self, name: str, own: SpanDroppers, index: int, between: tuple[str, str]
    ) -> Hanging:
        full = self.system.named(f"span {self.span} {name}")
        x = self.start + own.positions[index]
        hanger = self.line.hanger if between[0] == AUXILIARY else None
        kind = hanger or self.line.dropper
        assert kind is not None
        return Hanging(full, self.span, x, *between, kind, *_design(own, index))


def _design(own: SpanDroppers, index: int) -> tuple[float | None, float | None]:
    """Return pre-sag and length of a dropper, one of them None."""
    if own.lengths is not None:
        return None, own.lengths[index]
    return own.design_presag[index], None


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


def stretch(wire: TensionedWire) -> float:
    """Return |r′| of the wire under its tension: T = EA ½ (s² − 1) s, by Newton's method."""
    s = 1.0 + wire.tension / wire.axial_stiffness
    for _ in range(20):
        error = wire.axial_stiffness * 0.5 * (s * s - 1.0) * s - wire.tension
        s -= error / (wire.axial_stiffness * 0.5 * (3.0 * s * s - 1.0))
    return s


def chain_stretch(wire: TensionedWire) -> float:
    """Return ℓ/L of a straight link under the wire's tension: T = EA (ℓ − L)/L."""
    return 1.0 + wire.tension / wire.axial_stiffness


def slopes(points: Floats, magnitude: float) -> Floats:
    """Slope vectors r′ of the given length along a line of points (n × 3)."""
    tangent = np.gradient(points, axis=0)
    return np.asarray(magnitude * tangent / np.linalg.norm(tangent, axis=1, keepdims=True))


def chord_lengths(points: Floats, magnitude: float | Floats) -> Floats:
    """Unstretched length of each element in m, from its chord."""
    return np.asarray(np.linalg.norm(np.diff(points, axis=0), axis=1) / magnitude)
