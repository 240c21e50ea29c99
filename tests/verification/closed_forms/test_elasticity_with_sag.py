"""Elasticity of a simple line under its full weight

The two beams of `elasticity`, and in addition the sag of the messenger wire. As it rises by u from
its shape z₀ its length changes by ∫ z₀′ u′ dx. Ends under constant force let it; between fixed ends
a tension (EA/L) ∫ z₀′ u′ dx, L the length of the whole line, holds against it. That is one more
term in the equations (derived here); z₀ is that of a string below which the droppers hang. It
makes the line stiffer by 1.5 %. Left out are squares of slopes, the sag of the contact wire between
droppers, and that droppers lean when the wires move along the track.

The program is asked by the line of `elasticity`: six spans of 60 m, EI = 3 kN m², chains and cubic
elements of 0.25 m, seven places.
"""

from typing import Any

import numpy as np
import pytest

from arcless.equilibrium import equilibrium
from arcless.model import load
from tests.support.catenary import green
from tests.support.evidence import Evidence
from tests.support.explicit import both_kinds
from tests.support.faults import Fault, scaled
from tests.support.line_types import scenario_data, stitched_data
from tests.support.two_beams import TwoBeams, Wire, hung_string

GRAVITY = 9.81
PULL, BEAM = 15e3, 3e3
DROPPERS = (5.0, 15.0, 25.0, 35.0, 45.0, 55.0)
ALONG = np.array([120.0, 122.5, 125.0, 130.0, 140.0, 145.0, 150.0])
AXIAL = {"lower": 14e6, "upper": 7.4e6}
# Of the messenger wire at a support.
SLOPE = (1.1 + 0.6) * GRAVITY * 30.0 / PULL
WIRES = both_kinds(0.25, 2e-4)


def found(ends: str, wires: str) -> Any:
    """Return the elasticity that the program finds, in m/N."""
    names = ("contact_wire", "messenger_wire")
    line = stitched_data(
        stitch_wire=None,
        dropper={"stiffness": 1e5},
        **{f"{wire}__bending_stiffness": BEAM for wire in names},
        **{f"{wire}__ends": ends for wire in names},
    )
    return equilibrium.find(load(scenario_data(line, **WIRES[wires]))).elasticity(ALONG)


def exact(ends: str) -> Any:
    """Return the elasticity of two beams in m/N."""
    lower, upper = (Wire(PULL, BEAM / float(green(PULL, axial))) for axial in AXIAL.values())
    loads = np.full(6, 1.1 * GRAVITY * 10.0)
    line = TwoBeams(
        6, 60.0, DROPPERS, lower, upper, dropper=1e5, support=5e5, arm=300.0,
        axial=AXIAL["upper"] / 360.0 if ends == "fixed" else 0.0,
        shape=hung_string(60.0, PULL, 0.6 * GRAVITY, DROPPERS, loads),
    )  # fmt: skip
    return np.array([line.lift(x) for x in ALONG])


@pytest.mark.parametrize("wires", WIRES)
def test_fixed_ends(evidence: Evidence, wires: str) -> None:
    evidence.below(
        f"fixed ends, worst of 7 places, {wires}",
        np.abs(found("fixed", wires) / exact("fixed") - 1).max(), SLOPE**2, unit="1",
        reason="the square of the messenger wire's slope at a support, 1.1e-3",
    )  # fmt: skip


@pytest.mark.parametrize("wires", WIRES)
def test_ends_under_constant_force(evidence: Evidence, wires: str) -> None:
    held = 36 * 1.1 * GRAVITY * 10.0 / 1.3
    yielding = held / (held + AXIAL["upper"] / 360.0)
    evidence.below(
        f"ends under constant force, worst of 7 places, {wires}",
        np.abs(found("constant_force", wires) / exact("constant_force") - 1).max(),
        0.015 * yielding, unit="1",
        reason="36 leaning droppers, T/ℓ each, are 3 kN/m beside EA/L: their share of 1.5 %",
    )  # fmt: skip


FAULTS = [
    Fault("EA half as large, so that sag counts half", scaled("wires", "EA", 0.5), test_fixed_ends,
          wires="chains"),
    Fault("tensions 1 % too high", scaled("wires", "tension", 1.01), test_fixed_ends,
          wires="chains"),
    Fault("forces at the ends 1 % too high", scaled("ends", "force", 1.01),
          test_ends_under_constant_force, wires="chains"),
]  # fmt: skip
