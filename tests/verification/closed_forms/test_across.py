"""Motion across the track only

With `solver.motion: across` nothing moves along the track and tensions stay those at rest. A wire
that sags is a string then, whatever its axial stiffness, since its sag is not drawn out:

    f_n = n/(2L) √(H/μ),    μ per metre of track

(H the horizontal force.) With the motion along the wire the first symmetric mode is another one:
see that of a wire that sags. If x alone were held, it would be stiffer still: each element
stretched by z′w′.

The program is asked by a scenario: one span of 60 m, 1.1 kg/m, EA = 14 MN, EI = 0, under 6 kN
between fixed ends, elements of 0.75 m, of either kind.
"""

from math import sqrt

import numpy as np
import pytest

from tests.support.catenary import green
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled, without
from tests.support.one_wire import AXIAL, MASS, SPAN, WEIGHT, one_wire

TENSION, COUNT = 6e3, 4
MODELS = {"hermite": "cubic elements", "lumped": "point masses"}


@pytest.mark.parametrize("model", MODELS)
def test_frequencies(model: str, evidence: Evidence) -> None:
    line = {"contact_wire__tension": TENSION}
    found = one_wire(
        line, contact_wire_element=0.75, wire_model=model, motion="across"
    ).frequencies(COUNT)
    full = one_wire(line, contact_wire_element=0.75, wire_model=model).frequencies(COUNT)
    slope = WEIGHT * SPAN / TENSION
    # Along the arc there are more metres than along the track, and stretched ones.
    mass = MASS / float(green(TENSION, AXIAL)) * (1.0 + slope**2 / 24.0)
    exact = np.arange(1, COUNT + 1) / (2.0 * SPAN) * sqrt(TENSION / mass)
    assert abs(full[0] / exact[0] - 1.0) > 0.3, "sag matters"
    for number, (value, reference) in enumerate(zip(found, exact, strict=True), start=1):
        evidence.close(
            f"mode {number}, {MODELS[model]}", float(value), float(reference), unit="Hz",
            # Point masses of 0.75 m are late by (kℓ)²/24: 1e-3 for the fourth.
            relative=1.5e-3, reason="squares of slopes, (wL/T)²/48, and of the elements' lengths",
        )  # fmt: skip


FAULTS = [
    *(Fault(f"wires move along the track after all, {name}", without("across_only"),
            test_frequencies, model=model)
      for model, name in MODELS.items()),
    Fault("mass 1 % too high", scaled("wires", "mass", 1.01), test_frequencies, model="hermite"),
]  # fmt: skip
