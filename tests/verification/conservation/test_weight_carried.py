"""Every line of the library: its supports carry the weight of what is between them

Forces at an inner support against the weight of one span, counted from the model's data: wires,
half of what is clamped, droppers and hangers with their clamps. A hinged arm takes `F sin(slope)`
of it, an arm that is a spring rests at zero. And every dropper pulls.

Balance of forces. Asked as every shipped line at rest.
"""

from math import sin
from typing import Any

import numpy as np
import pytest

from arcless.model import Line, load, load_line
from arcless.model.shipped.library import shipped
from arcless.simulate import StaticsResult, statics
from tests.support.evidence import Evidence
from tests.support.faults import Fault, gravity, scaled

QUICK = ("norway-s20a", "conductor-rail-1")
CASES = [
    name if name in QUICK else pytest.param(name, marks=pytest.mark.evidence)
    for name in shipped("line")
]


@pytest.mark.parametrize("name", CASES)
def test_weight(evidence: Evidence, name: str) -> None:
    data = {"name": "rest", "line": load_line(name).to_dict(), "speed": 30.0}
    data["pantographs"] = [{"model": "dsa-250", "static_force": 70.0}]
    rest = statics(load(data))
    assert all(dropper["force_N"] > 0 for dropper in rest.droppers)
    evidence.close(
        f"force at an inner support, {name}",
        carried(rest),
        9.81 * (weight_of_wires(rest.scenario.line) + weight_of_droppers(rest)),
        unit="N",
        relative=0.02,
        reason="the arm's own mass, 0.9 kg of 100 kg, and the share of an arm that is a spring",
    )


def weight_of_wires(line: Line) -> float:
    """Mass in kg of the wires of a span and of what is on them."""
    length = line.span_list()[0].length
    wires: list[Any] = [line.contact_wire, line.messenger_wire, line.auxiliary_wire]
    if line.twin_contact_wires is not None:
        wires.append(line.contact_wire)
    mass = sum(wire.mass for wire in wires if wire is not None) * length
    for between in (line.stitch_wire, line.bridle):
        if between is not None:
            mass += between.mass * between.length + 2 * between.clamp_mass
    if line.contact_support is not None:
        mass += line.contact_support.mass
    if line.contact_wire.joints is not None:
        mass += line.contact_wire.joints.mass * length / line.contact_wire.joints.spacing
    return mass


def weight_of_droppers(rest: StaticsResult) -> float:
    """Mass in kg of droppers and hangers of the third span, with their clamps."""
    line, mass = rest.scenario.line, 0.0
    for dropper in rest.droppers:
        if dropper["span"] == 3:
            kind = line.hanger if "hanger" in dropper["name"] and line.hanger else line.dropper
            mass += kind.mass * dropper["length_m"]
            mass += kind.clamp_mass_contact_wire + kind.clamp_mass_messenger_wire
    return mass


def carried(rest: StaticsResult) -> float:
    """Upward force in N at an inner support; of twin wires with an arm for each."""
    line, places = rest.scenario.line, rest.equilibrium.support_places()
    place = places[min(4, len(places) // 2)]
    if line.messenger_wire is None:
        # A joint hangs on one support or the other: what they carry on average.
        forces = [support["contact_support_force_N"] for support in rest.supports[4:-4]]
        return abs(float(np.mean(forces)))
    inner = [support for support in rest.supports if support["x_m"] == place]
    arm = line.steady_arm
    held = [
        float(support["steady_arm_force_N"]) * sin(arm.slope) if arm.kind == "arm" else 0.0
        for support in inner
    ]
    return abs(inner[0]["messenger_force_N"]) + sum(held)


FAULTS = [
    Fault("gravity 5 % too large", gravity(1.05), test_weight, name="norway-s20a"),
    Fault("wires 5 % too heavy", scaled("wires", "mass", 1.05), test_weight,
          name="conductor-rail-1"),
]  # fmt: skip
