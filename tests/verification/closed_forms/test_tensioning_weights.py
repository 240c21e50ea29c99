"""Weights on a pulley: tension in the band of its friction, way of both ends, mass along the wire

A weight m hangs on a pulley of ratio n and efficiency η, set to T₀ = n m g. The wire has the length
L and spans l, its weight is w, and θ is the difference of temperature since the installation.

* **At rest the device holds still** as long as the tension T of a wire between anchors stays in
  [η T₀, T₀/η]; that T follows from `α θ + (T − T₀)/EA − (wl)²/24 (1/T² − 1/T₀²) = 0`.
* **Beyond, it pulls with the bound,** `T₁ = η T₀` where the wire grows longer and `T₀/η` where it
  grows shorter, and the wire grows by `u = L (α θ + (T₁ − T₀)/EA − (wl)²/24 (1/T₁² − 1/T₀²))`: at
  its end, or half of it at either end with an anchor in the middle.
* **Along the wire** the end has the mass `M = n² m = n T₀/g`: the weight goes n times as far. The
  natural frequencies of a rod that is held at one end and has M at the other follow from
  `λ tan λ = μL/M`, `λ = ωL/√(EA/μ)`; asked without gravity, so that there is no sag.

Friction as Coulomb's law with one bound for each direction; the rod with a mass: Timoshenko,
Vibration Problems in Engineering, from memory; both derived here. Asked as ten spans of 40 m,
12 kN, α = 17e-6 1/K, η = 0.97, n = 3, by chains and by cubic elements of 0.5 m.
"""

from typing import Any
from unittest.mock import patch

import numpy as np
import pytest
from scipy.optimize import brentq

from arcless.equilibrium import equilibrium
from arcless.mesh.build.wires_and_droppers import Wiring
from arcless.model import Wire, load
from tests.support.evidence import Evidence
from tests.support.explicit import both_kinds
from tests.support.faults import Fault, expansion, scaled
from tests.support.line_types import scenario_data
from tests.support.python_faults import wrong
from tests.support.simple_lines import trolley_data

LENGTH, AXIAL, MASS, TENSION = 400.0, 14e6, 1.1, 12e3
LOAD = MASS * 9.81 * 40.0
EXPANSION, EFFICIENCY, RATIO = 17e-6, 0.97, 3.0
WEIGHTS = {
    "contact_wire__ends": "weights",
    "contact_wire__end_ratio": RATIO,
    "contact_wire__end_efficiency": EFFICIENCY,
    "contact_wire__bending_stiffness": 0.0,
}
HELD = {"midpoint_anchor": {"stiffness": 1e7}}
WIRES = both_kinds(0.5, 5e-4)
# The band is reached at 1.7 K: 238 N/K less an eighth for the sag, and 360 or 371 N.
STILL, SLIDING = (-1.0, 1.0), (-40.0, -3.0, 3.0, 40.0)
ANCHORS = {"anchored at the start": {}, "anchored in the middle": HELD}


def as_built(difference: float, more: dict[str, Any], wires: str) -> equilibrium.Equilibrium:
    line = trolley_data(**WEIGHTS, **more)
    data = scenario_data(line, as_built__temperature_difference=difference, **WIRES[wires])
    return equilibrium.find(load(data))


def pull(found: equilibrium.Equilibrium, end: int) -> float:
    """Horizontal tension in N of the wire's first (0) or last (-1) element."""
    row = found.mesh.contact_rows[end]
    nodes = np.concatenate([found.mesh.parts[kind]["nodes"] for kind in ("wires", "segments")])
    first, last = found.positions[nodes[row]]
    cosine = (last - first)[0] / np.linalg.norm(last - first)
    return float(found.arrays["wire_tension"][row] * cosine)


def growth(difference: float, tension: float) -> float:
    """Strain of the line, sag included, at a temperature and a tension in N."""
    sag = LOAD**2 / 24 * (1 / tension**2 - 1 / TENSION**2)
    return EXPANSION * difference + (tension - TENSION) / AXIAL - sag


@pytest.mark.parametrize("wires", WIRES)
@pytest.mark.parametrize("difference", STILL)
def test_a_device_with_friction_holds_still(
    evidence: Evidence, difference: float, wires: str
) -> None:
    found = as_built(difference, HELD, wires)
    tension = brentq(lambda t: growth(difference, t), 0.5 * TENSION, 2 * TENSION)
    evidence.close(
        f"change of tension within the band, {difference:+g} K, {wires}", pull(found, -1) - TENSION,
        tension - TENSION, unit="N", relative=5e-3,
        reason="Green's strain of 1e-3 is stiffer by three times that; cubic elements round the "
        "kinks at supports off, which stiffens the sag",
    )  # fmt: skip
    ways = [found.end_travel(end)[0] for end in (0, -1)]
    evidence.below(
        f"way of the ends within the band, {difference:+g} K, {wires}", max(map(abs, ways)), 1e-12,
        unit="m", reason="held: rounding of a position of 400 m",
    )  # fmt: skip


@pytest.mark.parametrize("wires", WIRES)
@pytest.mark.parametrize("case", ANCHORS)
@pytest.mark.parametrize("difference", SLIDING)
def test_a_device_with_friction_slides(
    evidence: Evidence, difference: float, case: str, wires: str
) -> None:
    found, both = as_built(difference, ANCHORS[case], wires), bool(ANCHORS[case])
    bound = TENSION * EFFICIENCY if difference > 0 else TENSION / EFFICIENCY
    evidence.close(
        f"tension beyond the band, {case}, {difference:+g} K, {wires}", pull(found, -1), bound,
        unit="N", absolute=0.01,
        reason="along the chord of an element of 0.5 m, not along its curve: T (wh/T)²/24, 1e-3 N,"
        " and the settling of the statics",
    )  # fmt: skip
    way = LENGTH * growth(difference, bound) / (2.0 if both else 1.0)
    evidence.close(
        f"way of the end, {case}, {difference:+g} K, {wires}", found.end_travel()[0], way,
        unit="m", absolute=2e-3 * abs(way) + 5e-3 * abs(LENGTH * (bound - TENSION) / AXIAL),
        reason="the stretched wire grows by 1e-3 more, twice that; Green's strain is stiffer by "
        "three times 1e-3 in what friction stretches, 10 mm",
    )  # fmt: skip
    if both:
        evidence.close(
            f"way of the start, {difference:+g} K, {wires}", found.end_travel(0)[0],
            -found.end_travel()[0], unit="m", absolute=1e-8,
            reason="the anchor is in the middle: both sides alike to the settling of the statics, "
            "8 ε L EA/h in force, on a wire of L/EA",
        )  # fmt: skip


def test_mass_of_the_weights_along_the_wire(evidence: Evidence) -> None:
    """Frequencies of the wire as a rod, with nothing but its own mass and that of the weights."""
    line = trolley_data(**{**WEIGHTS, "contact_wire__end_efficiency": None})
    data = scenario_data(line, solver__gravity=0.0, solver__contact_wire_element=1.0)
    found = equilibrium.find(load(data)).frequencies(60)
    share = MASS * LENGTH * 9.81 / (RATIO * TENSION)
    wave = np.sqrt(AXIAL / MASS)
    for order in range(2):
        low, high = order * np.pi + 1e-9, (order + 0.5) * np.pi - 1e-9
        turn = brentq(lambda x: x * np.tan(x) - share, low, high)
        exact = turn * wave / LENGTH / (2 * np.pi)
        evidence.close(
            f"frequency along the wire, order {order + 1}", found[np.abs(found - exact).argmin()],
            exact, unit="Hz", relative=3e-3,
            reason="the stretched wire of the model has 1e-3 less mass per metre, and Green's "
            "strain of 1e-3 is stiffer by three times that: half of both",
        )  # fmt: skip


START, MIDDLE = ANCHORS
FAULTS = [
    Fault("η 0.98 for 0.97",
          patch.object(Wire, "end_band", property(lambda w: (0.98 * w.tension, w.tension / 0.98))),
          test_a_device_with_friction_slides, difference=40.0, case=MIDDLE,
          wires="chains"),
    Fault("no friction where the wire grows longer",
          patch.object(Wire, "end_band", property(lambda w: (w.tension, w.tension / 0.97))),
          test_a_device_with_friction_slides, difference=3.0, case=START,
          wires="chains"),
    Fault("friction left out", patch.object(Wire, "has_friction", False),
          test_a_device_with_friction_holds_still, difference=1.0, wires="cubic elements"),
    Fault("anchor at support 7 of 11", wrong(Wiring, "_midpoint", lambda place: place + 40.0),
          test_a_device_with_friction_slides, difference=-40.0, case=MIDDLE,
          wires="cubic elements"),
    Fault("wires expand 1 % too much", expansion(1.01), test_a_device_with_friction_holds_still,
          difference=1.0, wires="cubic elements"),
    Fault("wires expand 1 % too much", expansion(1.01), test_a_device_with_friction_slides,
          difference=-40.0, case=START, wires="chains"),
    Fault("weights felt as n m",
          patch.object(Wire, "end_mass", property(lambda w: w.tension / 9.81)),
          test_mass_of_the_weights_along_the_wire),
    Fault("weights 2 % light", scaled("masses", "mass", 0.98),
          test_mass_of_the_weights_along_the_wire),
]  # fmt: skip
