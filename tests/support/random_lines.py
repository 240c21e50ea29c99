"""Random valid scenarios of all kinds, from a seed: what an engineer could bring.

Tensions, masses, stiffnesses and geometry are drawn around those of the shipped lines, within the
bands that a published form warns outside of (tension 13 to 24 kN, wires 0.8 to 1.1 kg/m, droppers
0.07 to 0.2 kg/m, clamps 0.1 to 0.2 kg, stitch clamps 0.2 to 0.5 kg, arms 0.8 to 1.5 m and 0.6 to
1.1 kg/m), a little widened where shipped lines lie outside. A drawing whose droppers would have to
push, or whose arms would, cannot be built; it is drawn again, from the same stream of numbers.
"""

from collections.abc import Callable
from itertools import accumulate
from math import pi, sqrt
from random import Random
from typing import Any

import arcless
from arcless.errors import ArclessError
from tests.support.random_trains import train

Data = dict[str, Any]
DENSITY_KG_M3 = 8900.0
YOUNG_PA = 120e9
# A drawing in three cannot be built; twenty in a row never happened in a thousand seeds.
MOST_DRAWINGS = 20


def scenario_of(seed: int) -> arcless.Scenario:
    """Return the scenario of a seed, ready to run."""
    return arcless.load(data_of(seed))


def data_of(seed: int) -> Data:
    """Return the scenario of a seed as a model file would hold it."""
    draw = Random(seed)
    for _ in range(MOST_DRAWINGS):
        data = _drawing(seed, draw)
        try:
            arcless.statics(arcless.load(data))
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


def wire(draw: Random, area_mm2: float, stress_MPa: tuple[float, float], bent: float = 1.0) -> Data:
    """Return a copper wire; `bent` is its bending stiffness over that of a solid round section."""
    area = 1e-6 * area_mm2
    stiffness = YOUNG_PA * draw.uniform(0.9, 1.05)
    return {
        "mass": DENSITY_KG_M3 * area,
        "axial_stiffness": stiffness * area,
        "bending_stiffness": bent * stiffness * area**2 / (4 * pi),
        "tension": 1e6 * draw.uniform(*stress_MPa) * area,
        "damping": damping(draw),
    }


def damping(draw: Random) -> Data:
    """Return what lines are given (0.12 % at 1.4 Hz), or what was measured (1 to 5 %)."""
    if draw.random() < 0.5:
        return {"alpha": 0.0125, "beta": 1e-4}
    return {"alpha": draw.uniform(0.05, 0.5), "beta": draw.uniform(0.0, 2e-4)}


def hung(draw: Random, spatial: bool) -> Data:
    """Return all of a line with a messenger wire but its spans."""
    contact = wire(draw, draw.choice([100, 107, 120, 120, 150, 150]), (95, 215))
    messenger = wire(draw, draw.choice([50, 70, 95, 120, 150]), (100, 200), draw.uniform(0.05, 1))
    messenger["tension"] = min(max(messenger["tension"], 9e3), 25e3)
    return {
        "contact_wire": contact,
        "messenger_wire": messenger,
        "dropper": dropper(draw),
        "support": {
            "vertical_stiffness": 10 ** draw.uniform(5.3, 6.7),
            "vertical_damping": draw.choice([0.0, 1000.0]),
            "mass": draw.choice([0.0, 3.0]),
        },
        **sides(draw, spatial),
        "design": {"supply": draw.choice(["AC 25 kV", "AC 25 kV", "AC 15 kV", "DC 3 kV"])},
    }


def dropper(draw: Random) -> Data:
    """Return what hangs between two wires."""
    return {
        "stiffness": 10 ** draw.uniform(4.85, 5.5),
        "mass": draw.uniform(0.07, 0.24),
        "clamp_mass_contact_wire": draw.uniform(0.1, 0.3),
        "clamp_mass_messenger_wire": draw.uniform(0.1, 0.3),
        "slackens": draw.random() < 0.9,
        **({"damping": draw.uniform(1, 20)} if draw.random() < 0.3 else {}),
    }


def sides(draw: Random, spatial: bool) -> Data:
    """Return steady arms, heights and staggers."""
    heights = {"contact_wire_height": 5.3, "encumbrance": draw.uniform(1.2, 1.8)}
    spring = {
        "kind": "spring",
        "vertical_stiffness": draw.uniform(100, 600),
        "mass": draw.uniform(0, 1.5),
    }
    if not spatial:
        return {"steady_arm": spring, "geometry": heights}
    aside = draw.choice([0.15, 0.2, 0.25, 0.3])
    stagger = [aside, -aside]
    above = draw.choice([stagger, stagger, [0.0]])
    arm = {
        "kind": "arm",
        "length": draw.uniform(0.8, 1.5),
        "mass": draw.uniform(0.6, 1.1),
        "slope": draw.uniform(0.05, 0.2),
    }
    staggers = {"stagger_contact_wire": stagger, "stagger_messenger_wire": above}
    curve: Data = {}
    if draw.random() < 0.25:  # the whole line lies in it, and wires lean to the outside
        radius, side = draw.uniform(1500, 4000), draw.choice(["left", "right"])
        out = -aside if side == "left" else aside
        staggers = {"stagger_contact_wire": [out], "stagger_messenger_wire": [out]}
        curve = {"track": {"curves": [{"from": -1e3, "to": 4e3, "radius": radius, "side": side}]}}
    kind = arm if draw.random() < 0.7 else spring
    return {"steady_arm": kind, "geometry": {**heights, **staggers}, **curve}


def spread(draw: Random, length: float, first: float, apart: float) -> list[float]:
    """Return droppers that divide a span evenly between the first and the last one."""
    gaps = max(1, round((length - 2 * first) / apart))
    places = [first + i * (length - 2 * first) / gaps for i in range(gaps + 1)]
    if draw.random() < 0.3:  # drawn by hand: not quite even, to the decimetre
        inner = [round(x + draw.uniform(-0.1, 0.1) * apart, 1) for x in places[1:-1]]
        places = [places[0], *inner, places[-1]]
    return places


def hanging(length: float, positions: list[float], sag: float) -> Data:
    """Return droppers with a parabolic pre-sag between the first and the last one."""
    first, last = positions[0], positions[-1]
    presag = [4 * sag * (x - first) * (last - x) / (last - first) ** 2 for x in positions]
    return {"positions": positions, "presag": presag}


def spans(draw: Random, make: Callable[[float], Data], count: int) -> Data:
    """Return spans of one length, or of three in a random order."""
    length = draw.uniform(44, 64)
    lengths = [length] if draw.random() < 0.5 else [length, 0.9 * length, 0.8 * length]
    types = {f"span-{i}": make(round(one, 1)) for i, one in enumerate(lengths)}
    runs = [{"type": draw.choice(list(types)), "count": 1} for _ in range(count)]
    return {"span_types": types, "spans": runs}


def simple_spans(draw: Random, count: int, first: tuple[float, float] = (2.5, 6.0)) -> Data:
    """Return spans with plain droppers."""
    near, apart = draw.uniform(*first), draw.uniform(4.5, 9.5)
    share = draw.choice([0.0, 0.0, 0.5e-3, 1e-3])

    def span(length: float) -> Data:
        places = spread(draw, length, round(near, 2), apart)
        return {"length": length, "droppers": hanging(length, places, share * length)}

    return spans(draw, span, count)


def on_wires(draw: Random, line: Data) -> Data:
    """Return masses on the wires: none, or one or two where the line is assessed."""
    if draw.random() < 0.6:
        return {}
    by_name = {name: span["length"] for name, span in line["span_types"].items()}
    length = sum(by_name[run["type"]] * run["count"] for run in line["spans"])
    masses = [
        {
            "wire": draw.choice(["contact_wire", "messenger_wire"]),
            "position": round(length * draw.uniform(0.35, 0.65), 1),
            "mass": draw.uniform(0.5, 5.0),
        }
        for _ in range(draw.choice([1, 2]))
    ]
    return {"point_masses": masses}


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


def length_of(line: Data) -> float:
    """Return the length of a line in m."""
    own = {name: span["length"] for name, span in line["span_types"].items()}
    return list(accumulate(own[run["type"]] * run["count"] for run in line["spans"]))[-1]


def wave_speed(line: Data) -> float:
    """Return the wave speed of a contact wire in m/s."""
    contact = line["contact_wire"]
    return sqrt(contact["tension"] / contact["mass"])


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
