"""Random valid scenarios of all kinds, from a seed: what an engineer could bring.

A drawing whose droppers or arms would have to push cannot be built; it is drawn again, from the
same stream of numbers.
"""

from collections.abc import Callable
from functools import cache
from random import Random
from typing import Any

import arcless
from arcless.equilibrium import equilibrium
from arcless.errors import ArclessError
from tests.support.random_parts import (
    damping,
    dropper,
    hanging,
    hung,
    on_wires,
    simple_spans,
    spans,
    spread,
    wire,
)
from tests.support.random_trains import train

Data = dict[str, Any]
# Of the first hundred seeds two overlaps were drawn again, once each.
MOST_DRAWINGS = 20


def scenario_of(seed: int) -> arcless.Scenario:
    """Return the scenario of a seed, ready to run."""
    return arcless.load(data_of(seed))


@cache
def data_of(seed: int) -> Data:
    """Return the scenario of a seed as a model file would hold it; not to be changed."""
    draw = Random(seed)
    for _ in range(MOST_DRAWINGS):
        data = _drawing(seed, draw)
        try:
            equilibrium.find(arcless.load(data))
        except ArclessError:
            continue
        return data
    raise AssertionError(f"seed {seed}: {MOST_DRAWINGS} drawings in a row could not be built")


def _drawing(seed: int, draw: Random) -> Data:
    kind = list(KINDS)[seed % len(KINDS)]
    line = KINDS[kind](draw)
    return {
        "format": "arcless-scenario/1",
        "name": f"random-{seed}",
        "description": f"Random line, {kind}",
        "line": {"format": "arcless-line/1", "name": f"random-{seed}", **line},
        **train(line, draw),
    }


def simple(draw: Random) -> Data:
    """Return a simple line, planar or in space."""
    line = {**hung(draw, draw.random() < 0.5), **simple_spans(draw, draw.randint(12, 16))}
    return {**line, **on_wires(draw, line)}


def stitched(draw: Random) -> Data:
    """Return a line with stitch wires; one dropper hangs on either half of each."""
    line = hung(draw, draw.random() < 0.5)
    length = draw.uniform(12, 20)
    near = draw.uniform(3.0, 0.5 * length - 1.5)
    apart = draw.uniform(6.5, 9.5)
    share = draw.choice([0.0, 0.0, 0.5e-3])

    def span(own: float) -> Data:
        begin = 0.5 * length + draw.uniform(1.5, 4.0)
        places = [near, *spread(draw, own, round(begin, 2), apart), own - near]
        return {"length": own, "droppers": hanging(own, places, share * own)}

    stitch = wire(draw, draw.choice([25, 35]), (60, 100), draw.uniform(0.05, 0.3))
    stitch |= {"length": length, "clamp_mass": draw.uniform(0.2, 0.5)}
    line["geometry"]["encumbrance"] = draw.uniform(1.5, 1.9)
    return {**line, "stitch_wire": stitch, **spans(draw, span, draw.randint(12, 16))}


def compound(draw: Random) -> Data:
    """Return a line with an auxiliary wire."""
    line = hung(draw, draw.random() < 0.5)
    auxiliary = wire(draw, draw.choice([95, 120, 150]), (80, 120), draw.uniform(0.05, 0.5))
    line["auxiliary_wire"] = auxiliary | {"height": draw.uniform(0.2, 0.4)}
    line["messenger_wire"]["tension"] = draw.uniform(18e3, 27e3)
    line["hanger"] = dropper(draw)
    line["geometry"]["encumbrance"] = draw.uniform(1.4, 1.8)
    many = draw.choice([4, 5, 6])

    def span(length: float) -> Data:
        step = length / many
        above = [(i + 0.5) * step for i in range(many)]
        below = [(i + 0.5) * step / 2 for i in range(2 * many)]
        return {
            "length": length,
            "droppers": {"positions": above},
            "hangers": {"positions": below},
        }

    return {**line, **spans(draw, span, draw.randint(12, 15))}


def twin(draw: Random) -> Data:
    """Return a line with two contact wires."""
    line = hung(draw, draw.random() < 0.7)
    line["messenger_wire"] |= {
        key: 1.6 * line["messenger_wire"][key] for key in ("mass", "axial_stiffness")
    }
    line["messenger_wire"]["tension"] = draw.uniform(15e3, 26e3)
    line["contact_wire"]["tension"] *= 0.8
    line["geometry"]["encumbrance"] = draw.uniform(1.4, 1.8)
    line["design"] = {"supply": draw.choice(["DC 3 kV", "DC 1.5 kV"])}
    droppers = draw.choice(["paired", "alternating"])
    line["twin_contact_wires"] = {"separation": 0.04, "droppers": droppers}
    near, apart = draw.uniform(3, 5), draw.uniform(5.5, 8.0)
    beside = draw.choice([0.4, 0.5, 0.6])

    def span(length: float) -> Data:
        places = spread(draw, length, round(near, 2), apart)
        if droppers == "alternating":
            places = [x + side for x in places for side in (-0.5 * beside, 0.5 * beside)]
        return {"length": length, "droppers": hanging(length, places, 0.0)}

    return {**line, **spans(draw, span, draw.randint(12, 14))}


def overlap(draw: Random) -> Data:
    """Return two or three tension lengths, the overlaps where the line is assessed."""
    line = {**hung(draw, True), **simple_spans(draw, 15)}
    line.pop("track", None)
    if len(line["geometry"]["stagger_contact_wire"]) == 1:
        line["geometry"] |= {
            name: [0.2, -0.2] for name in ("stagger_contact_wire", "stagger_messenger_wire")
        }
    shared, first = draw.choice([3, 4]), draw.choice([6, 7])
    lengths = [{"from_span": 1, "to_span": first + shared - 1}, {"from_span": first, "to_span": 15}]
    raised = [draw.uniform(0.35, 0.5), draw.uniform(0.04, 0.08)]
    meet = {"raise": raised, "separation": draw.choice([0.2, 0.3, 0.45])}
    return {**line, "tension_lengths": lengths, "overlap": meet}


def trolley(draw: Random) -> Data:
    """Return a wire on bridles."""
    contact = wire(draw, draw.choice([80, 100, 120]), (80, 110))
    bridle = wire(draw, 35, (55, 75), draw.uniform(0.05, 0.3))
    bridle |= {"length": draw.uniform(5, 8), "clamp_mass": draw.uniform(0.1, 0.4)}
    span = {"length": round(draw.uniform(25, 38), 1)}
    return {
        "contact_wire": contact,
        "bridle": bridle,
        "contact_support": {
            "vertical_stiffness": 10 ** draw.uniform(4.7, 5.7),
            "mass": draw.uniform(0, 3),
        },
        "steady_arm": {"kind": "spring", "vertical_stiffness": draw.uniform(50, 200), "mass": 0.5},
        "geometry": {"contact_wire_height": 5.5},
        "span_types": {"span": span},
        "spans": [{"type": "span", "count": 16}],
        "design": {"supply": "DC 1.5 kV"},
    }


def rail(draw: Random) -> Data:
    """Return a conductor rail."""
    return {
        "contact_wire": {
            "kind": "conductor_rail",
            "mass": draw.uniform(6.5, 9.0),
            "bending_stiffness": draw.uniform(1.5e5, 2.6e5),
            "axial_stiffness": 2e8,
            "tension": 0.0,
            "damping": damping(draw),
            "joints": {"mass": draw.uniform(1, 3), "spacing": 12.0},
        },
        "contact_support": {
            "vertical_stiffness": 10 ** draw.uniform(6, 7.7),
            "mass": draw.uniform(2, 8),
        },
        "geometry": {"contact_wire_height": 4.4},
        "span_types": {"span": {"length": round(draw.uniform(6.5, 11), 1)}},
        "spans": [{"type": "span", "count": 30}],
        "design": {"supply": "DC 1.5 kV"},
    }


# Which kind a seed gives: that of its remainder.
KINDS: dict[str, Callable[[Random], Data]] = {
    "simple": simple,
    "stitched": stitched,
    "compound": compound,
    "twin contact wires": twin,
    "simple again": simple,
    "overlap": overlap,
    "stitched again": stitched,
    "trolley wire on bridles": trolley,
    "twin contact wires again": twin,
    "conductor rail": rail,
}


def label_of(seed: int) -> str:
    """Return in a few words what a seed gives, from the drawing alone."""
    data = data_of(seed)
    line, kind = data["line"], data["description"].partition(", ")[2].removesuffix(" again")
    space = "in space" if "stagger_contact_wire" in line["geometry"] else "planar"
    count, speed = len(data["pantographs"]), 3.6 * data["speed"]
    if "track" in line:
        space = "in a curve"
    many = "1 pantograph" if count == 1 else f"{count} pantographs"
    return f"{kind}, {space}, {many}, {speed:.0f} km/h"
