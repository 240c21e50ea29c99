"""Parts of random lines: wires, droppers, steady arms, spans.

Drawn around those of the shipped lines, within the bands that a published form warns outside of
(tension 13 to 24 kN, wires 0.8 to 1.1 kg/m, droppers 0.07 to 0.2 kg/m, clamps 0.1 to 0.2 kg,
stitch clamps 0.2 to 0.5 kg, arms 0.8 to 1.5 m and 0.6 to 1.1 kg/m), a little widened where shipped
lines lie outside.
"""

from collections.abc import Callable
from math import pi
from random import Random
from typing import Any

Data = dict[str, Any]
DENSITY_KG_M3 = 8900.0
YOUNG_PA = 120e9


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
    length = length_of(line)
    masses = [
        {
            "wire": draw.choice(["contact_wire", "messenger_wire"]),
            "position": round(length * draw.uniform(0.35, 0.65), 1),
            "mass": draw.uniform(0.5, 5.0),
        }
        for _ in range(draw.choice([1, 2]))
    ]
    return {"point_masses": masses}


def length_of(line: Data) -> float:
    """Return the length of a line in m."""
    own = {name: span["length"] for name, span in line["span_types"].items()}
    return float(sum(own[run["type"]] * run["count"] for run in line["spans"]))
