"""Balance of forces of a line at rest

In a long line of equal spans each span hangs on its own. Per span of length L:

    droppers     carry the contact wire, their lower clamps and half of themselves
    supports     carry both wires, all droppers and all clamps
    steady arms  pull across the track with 4 a T/L where the stagger is ± a; a hinged arm
                 with the slope γ carries that by 4 a T/(L cos γ)

Source: balance of forces. A wire is lighter per metre by its stretch s, and its arc longer than
the span: by (8f/L)²/24 for the contact wire, whose pre-sag is f = 55 mm; that of the messenger wire
is summed up along a string with the droppers' loads.

The program is asked by `en50318-ac-simple-320-planar`, twenty spans, with the chains that it is
shipped with and with cubic elements, of which the inner ten count (lengths of droppers are the
program's). A chain stretches by N/EA, a cubic element by `green`: 3e-6 less. And it is asked by
six spans of 60 m with a stagger of 0.2 m, arms at 0.1 rad, chains without bending stiffness,
which would round the kinks.
"""

from collections.abc import Callable
from math import cos
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

import arcless
from arcless.model import load
from arcless.simulate import StaticsResult
from tests.support import fresh
from tests.support.catenary import green
from tests.support.evidence import Evidence
from tests.support.explicit import BY_MATRIX
from tests.support.faults import Fault, scaled, spoiled
from tests.support.line_types import scenario_data, stitched_data
from tests.support.two_beams import hung_string

AtRest = Callable[..., StaticsResult]

GRAVITY = 9.81
SPAN, COUNT, DROPPERS = 55.0, 10, 9
CONTACT, MESSENGER = 1.35, 1.08
CLAMP, UPPER_CLAMP, PER_METRE = 0.165, 0.195, 0.117
PRESAG = 0.055


def inner(found: StaticsResult) -> tuple[list[Any], float]:
    """Return the droppers of the inner spans, and their mass in kg per span."""
    droppers = [d for d in found.droppers if 6 <= d["span"] <= 15]
    assert len(droppers) == COUNT * DROPPERS
    return droppers, PER_METRE * sum(d["length_m"] for d in droppers) / COUNT


def hooke(tension: Any, axial: float) -> Any:
    """Stretch by N = EA (s − 1), the law of straight links."""
    return 1.0 + tension / axial


Law = Callable[[Any, float], Any]
WIRES: dict[str, tuple[dict[str, Any], Law]] = {
    "chains": ({}, hooke),
    "cubic elements": (BY_MATRIX, green),
}


def contact_wire(law: Law) -> float:
    """Mass in kg of the contact wire of a span."""
    return CONTACT * SPAN / float(law(22e3, 15e6)) * (1 + (8 * PRESAG / SPAN) ** 2 / 24)


def messenger_wire(droppers: list[Any], law: Law) -> float:
    """Mass in kg of the messenger wire of a span, which hangs in the shape of a string."""
    own = GRAVITY * (UPPER_CLAMP + 0.5 * PER_METRE * 0.85)
    places = np.array([d["x_m"] for d in droppers[:DROPPERS]]) - 5 * SPAN
    loads = np.array([d["force_N"] for d in droppers[:DROPPERS]]) + own
    height = hung_string(SPAN, 16e3, MESSENGER * GRAVITY, places, loads)
    x = np.linspace(0.0, SPAN - 1e-9, 5501)
    slope = np.diff([height(place) for place in x]) / np.diff(x)
    arc = SPAN * (1 + 0.5 * np.mean(slope**2))
    tension = 16e3 * (1 + 0.5 * np.mean(slope**2))
    return MESSENGER * arc / float(law(tension, 11.64e6))


@pytest.mark.parametrize("wires", WIRES)
def test_droppers_carry_the_contact_wire(evidence: Evidence, at_rest: AtRest, wires: str) -> None:
    changes, law = WIRES[wires]
    droppers, mass = inner(at_rest("en50318-ac-simple-320-planar", changes))
    weight = GRAVITY * (contact_wire(law) + DROPPERS * CLAMP + 0.5 * mass)
    evidence.close(
        f"droppers of a span, {wires}", sum(d["force_N"] for d in droppers) / COUNT, weight,
        unit="N", relative=(8 * PRESAG / SPAN) ** 2 / 24,
        reason="what the arc adds: the sag of the contact wire between droppers is left out",
    )  # fmt: skip


@pytest.mark.parametrize("wires", WIRES)
def test_supports_carry_all(evidence: Evidence, at_rest: AtRest, wires: str) -> None:
    changes, law = WIRES[wires]
    found = at_rest("en50318-ac-simple-320-planar", changes)
    droppers, mass = inner(found)
    both = contact_wire(law) + messenger_wire(droppers, law)
    weight = GRAVITY * (both + DROPPERS * (CLAMP + UPPER_CLAMP) + mass)
    forces = [s["messenger_force_N"] for s in found.supports[6:15]]
    slope = weight / 2 / 16e3
    evidence.close(
        f"a support, {wires}", float(np.mean(forces)), weight, unit="N", relative=slope**4 / 8,
        reason="fourth powers of the slope at a support, 0.042, in the length of the arc",
    )  # fmt: skip


def test_arms_hold_the_stagger(evidence: Evidence) -> None:
    limp = {f"{wire}_wire__bending_stiffness": 0.0 for wire in ("contact", "messenger")}
    stagger = {f"geometry__stagger_{wire}_wire": [0.2, -0.2] for wire in ("contact", "messenger")}
    arm = {"kind": "arm", "length": 1.2, "slope": 0.1, "mass": 0.7}
    line = stitched_data(stitch_wire=None, steady_arm=arm, **limp, **stagger)
    found = arcless.statics(
        load(scenario_data(line, solver={"wire_model": "lumped", "scheme": "generalised-alpha"}))
    )
    forces = [s["steady_arm_force_N"] for s in found.supports[1:-1]]
    assert len(forces) == 5
    pull = 4 * 0.2 * 15e3 / 60.0 / cos(0.1)
    evidence.below(
        "worst of 5 steady arms", max(abs(force - pull) for force in forces),
        8 * 2.2e-16 * 360.0 * 14e6 / 1.45, unit="N", reason="the statics balances to 8 ε L EA/h",
    )  # fmt: skip


def shift(arguments: dict[str, Any]) -> bool:
    """Move every support that stands to the left by 1 mm more."""
    across = arguments["positions"][:, 1]
    across[across > 0.15] += 1e-3
    return bool((across > 0.15).any())


FAULTS = [
    *(Fault(what, scaled(kind, "mass", factor), check, at_rest=fresh.at_rest, wires=wires)
      for what, kind, factor, check in (
          ("clamps 1 % too light", "masses", 0.99, test_droppers_carry_the_contact_wire),
          ("droppers 1 % too light", "links", 0.99, test_supports_carry_all),
          ("wires 0.1 % too heavy", "wires", 1.001, test_supports_carry_all),
      )
      for wires in sorted(WIRES)),
    Fault("chains that stretch like cubic elements",
          patch.multiple(__name__, WIRES={"chains": ({}, green)}), test_supports_carry_all,
          at_rest=fresh.at_rest, wires="chains"),
    Fault("stagger 1 mm too large on one side", spoiled(shift), test_arms_hold_the_stagger),
    Fault("tension 0.1 % too high", scaled("segments", "tension", 1.001),
          test_arms_hold_the_stagger),
]  # fmt: skip
