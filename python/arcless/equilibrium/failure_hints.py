"""Hints why a line has no shape at rest, with numbers, in the words of its file.

A wire between two holds a length L apart sags by w L²/8T, a rail by 5 w L⁴/384 EI. A dropper at the
height h, between others at h₁ and h₂ that are d₁ and d₂ away, carries

    F = w (d₁ + d₂)/2 + T ((h − h₁)/d₁ + (h − h₂)/d₂)

of a contact wire with the weight w per metre and the tension T: F < 0 is a dropper that would have
to push. These are estimates; the core has found by the whole line that it cannot hang.
"""

from collections.abc import Iterator, Mapping
from itertools import pairwise
from math import atan, degrees, floor, tan
from typing import NamedTuple

import numpy as np

from arcless.errors import EquilibriumError
from arcless.mesh import DropperPlace, Mesh
from arcless.model import Line, SteadyArmBar
from arcless.units import written_in

# Measured heights this near to a dropper may be why it would have to push. In m.
NEIGHBOURS = 50.0
# No wire and no rail in service sags by a tenth of the distance between what holds it.
DEEP = 0.1
# A sag of half of that distance is no line at all: Newton's method would wander for long.
BOTTOMLESS = 0.5
# Positions that are one. In m.
SAME = 1e-6
KILO = 1e3


def why_pushing(mesh: Mesh, line: Line, heights: Mapping[float, float], link: int) -> str | None:
    """Return a hint for a dropper that would have to push, where the reason can be told."""
    dropper = next(one for one in mesh.droppers if one.link == link)
    if heights:
        return _measured(dropper.x, heights)
    return (
        _low_messenger(line, mesh.gravity, line.span_list()[dropper.span - 1].length)
        or _lifting_arm(mesh, line, dropper)
        or _bent(mesh, line, dropper)
    )


def why_loose(line: Line, gravity: float) -> str | None:
    """Return a hint for a line that cannot be found at rest: the first wire that hangs too low."""
    span = max(span.length for span in line.span_list())
    return _low_messenger(line, gravity, span) or next(_deep(line, gravity), None)


def _measured(x: float, heights: Mapping[float, float]) -> str:
    near = [place for place in sorted(heights) if abs(place - x) < NEIGHBOURS]
    at = near.index(min(near, key=lambda place: abs(place - x)))
    read = [f"{heights[place]:.4g} m at {place:g} m" for place in near[max(at - 1, 0) : at + 2]]
    return f"measured were {', '.join(read)}: the wire cannot hang like that; check these"


def _low_messenger(line: Line, gravity: float, span: float) -> str | None:
    """Say that the messenger wire would hang below the contact wire in a span of a length in m."""
    messenger, room = line.messenger_wire, line.geometry.encumbrance
    if messenger is None or room is None:
        return None
    moment = line.hanging_mass * gravity * span**2 / 8.0
    sag = moment / messenger.tension
    if sag <= room:
        return None
    return (
        f"messenger_wire.tension is {_newtons(messenger.tension)}: with all that it carries this"
        f" wire sags by some {sag:.2g} m in a span of {span:g} m, and geometry.encumbrance is"
        f" {room:g} m; it takes some {_newtons(1.05 * moment / room)}, or a larger encumbrance"
    )


class Sag(NamedTuple):
    """Sag of a wire: its field and value, as given too, the distance of its holds, the sag in m."""

    field: str
    value: float
    given: str
    apart: float
    sag: float


def check_carried(line: Line, gravity: float) -> None:
    """Refuse a wire that hangs so deep that no shape has to be looked for."""
    for deep in _sags(line, gravity):
        if deep.sag > BOTTOMLESS * deep.apart:
            raise EquilibriumError(
                "a wire that does not carry its own weight",
                where=deep.field,
                got=f"{deep.given}: over {deep.apart:g} m it would sag by some {deep.sag:.3g} m",
                expected="a small part of that",
                hint=_unit_meant(line, deep)
                or "check its unit (N for kN?), the mass of the wire, and the spans",
            )


def _deep(line: Line, gravity: float) -> Iterator[str]:
    """Say of the contact wire or rail how deep it sags where that is no shape of a wire."""
    for deep in _sags(line, gravity):
        if deep.sag > DEEP * deep.apart:
            yield (
                f"{deep.field} is {deep.given}: where {deep.apart:g} m lie between what holds it,"
                f" it sags by some {deep.sag:.2g} m; "
                + (_unit_meant(line, deep) or "check the unit, the mass and the spans")
            )


def _unit_meant(line: Line, deep: "Sag") -> str | None:
    """Ask for kN where a tension has no unit, and a thousand times as much would carry the wire."""
    if not deep.field.endswith(".tension") or written_in(line.as_typed(deep.field), "N"):
        return None
    if deep.sag / KILO > DEEP * deep.apart:
        return None
    return f"did you mean {deep.value:g} kN? a number without a unit is in N"


def _sags(line: Line, gravity: float) -> Iterator[Sag]:
    """Yield how deep the contact wire hangs between what holds it, and the messenger wire."""
    wire, apart = line.contact_wire, _longest_free(line)
    weight = wire.mass * gravity
    if wire.tension > 0:
        sag = weight * apart**2 / (8.0 * wire.tension)
        yield Sag("contact_wire.tension", wire.tension, _newtons(wire.tension), apart, sag)
    else:
        stiffness = wire.bending_stiffness
        sag = 5.0 * weight * apart**4 / (384.0 * stiffness)
        field = "contact_wire.bending_stiffness"
        yield Sag(field, stiffness, f"{stiffness:g} N m²", apart, sag)
    above = line.messenger_wire
    if above is not None:
        span = max(span.length for span in line.span_list())
        sag = line.hanging_mass * gravity * span**2 / (8.0 * above.tension)
        field = "messenger_wire.tension"
        yield Sag(field, above.tension, _newtons(above.tension), span, sag)


def _longest_free(line: Line) -> float:
    """Return the longest distance in m along a span between the holds of the contact wire."""
    return max(
        right - left
        for span in line.span_types.values()
        for left, right in pairwise((0.0, *span.holders.positions, span.length))
    )


def _lifting_arm(mesh: Mesh, line: Line, dropper: DropperPlace) -> str | None:
    """Say that the steady arm next to a dropper lifts more contact wire than hangs there."""
    arm, supports = line.steady_arm, line.support_positions()
    index = next(
        (k for k in (dropper.span - 1, dropper.span) if _beside(mesh, line, dropper, k)), 0
    )
    if not isinstance(arm, SteadyArmBar) or not 0 < index < len(supports) - 1:
        return None
    left, here, right = supports[index - 1 : index + 2]
    height, stagger = line.geometry.contact_wire_height, line.geometry.stagger_contact_wire
    track = line.track
    before, at, behind = (stagger[k % len(stagger)] for k in (index - 1, index, index + 1))
    turn = track.mean_direction(here, right, height) - track.mean_direction(left, here, height)
    turn += (before - at) / (here - left) + (behind - at) / (right - here)
    pull = line.contact_wire.tension * abs(turn)
    hanging = _hanging_at(mesh, line, dropper, here)
    if pull * tan(arm.slope) <= hanging:
        return None
    flat = floor(10.0 * degrees(atan(hanging / pull))) / 10.0
    place = "in the curve " if track.bends(left, right) else ""
    return (
        f"{place}the steady arm at support {index + 1} pulls with some {pull:.0f} N and, with its"
        f" slope, lifts the wire by {pull * tan(arm.slope):.0f} N, more than the {hanging:.0f} N"
        f" that hang there: try a flatter arm, steady_arm.slope below some {flat:g} deg"
    )


def _beside(mesh: Mesh, line: Line, dropper: DropperPlace, support: int) -> bool:
    """Return whether no other dropper hangs between a dropper and a support, counted from 0."""
    here = line.support_positions()[support]
    low, high = sorted((here, dropper.x))
    return not any(
        low + SAME < one.x < high - SAME for one in mesh.droppers if one.wires == dropper.wires
    )


def _hanging_at(mesh: Mesh, line: Line, dropper: DropperPlace, here: float) -> float:
    """Return the weight in N of the contact wire between the droppers to both sides of x in m."""
    xs = [one.x for one in mesh.droppers if one.wires == dropper.wires]
    left = max((x for x in xs if x < here), default=here)
    right = min((x for x in xs if x > here), default=here)
    return line.contact_wire.mass * mesh.gravity * (right - left)


class Hold(NamedTuple):
    """Hold of the contact wire, a dropper or an anchor: place, nominal height and pre-sag, m."""

    x: float
    height: float
    presag: float


def _bent(mesh: Mesh, line: Line, dropper: DropperPlace) -> str | None:
    """Say which pre-sag, or which change of height, bends the contact wire too sharply."""
    if line.has_overlaps or dropper.wires[1] != "contact wire":
        return None
    own = [one for one in mesh.droppers if one.wires == dropper.wires]
    holds = [_anchor(line, 0), *(_hold(line, one) for one in own), _anchor(line, -1)]
    holds.sort()
    at = next(k for k, hold in enumerate(holds) if abs(hold.x - dropper.x) < SAME)
    left, here, right = holds[at - 1 : at + 2]
    d_left, d_right, tension = here.x - left.x, right.x - here.x, line.contact_wire.tension
    weight = line.contact_wire.mass * mesh.gravity * 0.5 * (d_left + d_right)
    by_presag = weight - tension * (
        (here.presag - left.presag) / d_left + (here.presag - right.presag) / d_right
    )
    by_height = tension * (
        (here.height - left.height) / d_left + (here.height - right.height) / d_right
    )
    if by_presag < 0:
        share = 1.0 / d_left + 1.0 / d_right
        most = left.presag / d_left + right.presag / d_right + weight / tension
        return _too_much_presag(line, dropper, (left, here, right), most / share)
    if by_presag + by_height < 0:
        return _too_much_bend(left, here, right, by_presag / -by_height)
    return None


def _too_much_presag(
    line: Line, dropper: DropperPlace, holds: tuple[Hold, Hold, Hold], most: float
) -> str:
    left, here, right = (1e3 * hold.presag for hold in holds)
    span = line.span_list()[dropper.span - 1]
    name = next(name for name, one in line.span_types.items() if one is span)
    kind = "droppers" if span.hangers is None else "hangers"
    place = dropper.x - line.support_positions()[dropper.span - 1]
    index = int(np.argmin([abs(x - place) for x in span.holders.positions]))
    downwards = "; pre-sag counts downwards" if min(left, here, right) < 0 else ""
    return (
        f"a pre-sag of {here:.4g} mm is too much between {left:.4g} mm and {right:.4g} mm next to"
        f" it: at most {floor(1e3 * most):.4g} mm hang freely there, or more next to it; see"
        f" span_types.{name}.{kind}.presag.{index}{downwards}"
    )


def _too_much_bend(left: Hold, here: Hold, right: Hold, share: float) -> str:
    before = 1e3 * (here.height - left.height) / (here.x - left.x)
    behind = 1e3 * (right.height - here.height) / (right.x - here.x)
    return (
        f"geometry.height_changes bends the wire there by {abs(behind - before):.2g} ‰, from a"
        f" gradient of {before:.2g} ‰ to {behind:.2g} ‰: at most some"
        f" {floor(10 * share * abs(behind - before)) / 10:g} ‰ hang freely; spread the change over"
        " more spans"
    )


def _anchor(line: Line, end: int) -> Hold:
    return Hold(line.support_positions()[end], line.contact_wire_heights()[end], 0.0)


def _hold(line: Line, dropper: DropperPlace) -> Hold:
    supports, heights = line.support_positions(), line.contact_wire_heights()
    holders = line.span_list()[dropper.span - 1].holders
    place = dropper.x - supports[dropper.span - 1]
    index = int(np.argmin([abs(x - place) for x in holders.positions]))
    presag = 0.0 if holders.presag is None else holders.presag[index]
    return Hold(dropper.x, float(np.interp(dropper.x, supports, heights)), presag)


def _newtons(force: float) -> str:
    return f"{force / 1e3:.3g} kN" if force >= KILO else f"{force:.3g} N"
