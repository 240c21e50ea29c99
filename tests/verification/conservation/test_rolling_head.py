"""Head that rolls: the energy balance closes while the wire slides from side to side

A collector head with two strips that can roll. The wire of a staggered line sweeps over the strips,
so the direction e(y) in which the contact force acts on the head changes in every step, and with it
the answer of the head. All that is stored, dissipated and supplied, the work of the sliding contact
included, must add up to nothing but rounding (docs/theory/energy.md).

Conservation; no reference values are needed. Asked as `en50318-ac-simple-320` over 150 m at 320
km/h with cubic elements, trapezoidal rule and generalised-α: its explicit steps keep no ledger.
"""

import pytest

import arcless
from arcless.results import Result
from tests.support.evidence import Evidence
from tests.support.explicit import SOLVED
from tests.support.faults import Fault
from tests.support.python_faults import wrong

HEAD = {
    "half_length": 0.8, "mass": 3.75, "stiffness": 3500.0, "damping": 22.5, "strip_spacing": 0.58,
    "roll": {"inertia": 0.8, "stiffness": 1700.0, "damping": 11.0},
}  # fmt: skip
ROLLING = {
    "name": "rolling",
    "masses": [{"mass": 9.0, "stiffness": 160.0, "damping": 100.0}],
    "head": HEAD,
}
SHORT = {
    "pantographs": [{"model": ROLLING, "static_force": 120.0}],
    "travel": {"start": "60 m", "end": "210 m"},
    "analysis": {"from": "80 m", "to": "200 m"},
    "output.energy": "always",
}


@pytest.mark.parametrize("scheme", ["trapezoidal", "generalised-alpha"])
def test_ledger(evidence: Evidence, scheme: str) -> None:
    changes = {**SHORT, **SOLVED, "solver.scheme": scheme}
    result = arcless.run(arcless.load("en50318-ac-simple-320").with_(**changes))
    lateral = result.dataset["contact_lateral"].values
    assert lateral.max() - lateral.min() > 0.3  # the wire does slide
    evidence.below(
        f"residual of the ledger over what was turned over, {scheme}",
        result.metadata["energy_residual_relative"],
        1e-10,
        unit="1",
        reason="rounding of 1700 steps of 1e4 numbers that nearly cancel: ε √(2e7) · 100",
    )


def leaking(found: Result) -> Result:
    """Say that the traction was not booked: at the border of the core both sides would miss it."""
    work = float(abs(found.dataset["energy_work_traction"].values[-1]))
    turned = float(abs(found.dataset["energy_work_uplift"].values).max())
    found.dataset.attrs["energy_residual_relative"] = work / turned
    return found


FAULTS = [
    Fault("work of traction not booked", wrong(arcless, "run", leaking), test_ledger,
          scheme="trapezoidal"),
]  # fmt: skip
