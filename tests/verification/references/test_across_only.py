"""Programs that move across the track only

Many published programs know no motion along the wires: straight beams under tensions that stay,
droppers that act upright. `solver.motion: across` computes that. A second program of this kind
(`tests/support/across.py`: cubic beams of 0.25 m and 0.5 m on straight wires, trapezoidal rule of
1 ms, slack droppers found by trial), runs the reference line of EN 50318:2002 at 250 km/h.

The program is asked by `en50318-2002-250` with `motion: across`, by either family of elements.
"""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless.assess.signals.filter import low_pass
from tests.support import across
from tests.support.evidence import Evidence
from tests.support.faults import Fault, without

SCENARIO = "en50318-2002-250"
STEP = 1e-3
# Behind the assessed spans, m: beyond what the filter makes up at the end of a record.
BEHIND = 25.0
AUTO = {"solver.contact_wire_element": "auto", "solver.messenger_wire_element": "auto"}
FAMILIES: dict[str, dict[str, Any]] = {
    "cubic elements": {"solver.residual_flexibility": True},
    "explicit steps": {"solver.scheme": "central-difference", **AUTO},
}


@pytest.fixture(scope="module")
def second() -> dict[str, float]:
    """Assessed numbers of the second program, in N."""
    scenario = arcless.load(SCENARIO)
    first, last = scenario.analysis_range()
    start = first - 180.0  # where the program begins too, one span from the end
    speed = 250.0 / 3.6
    places = np.arange(start, last + BEHIND, speed * STEP)
    force = low_pass(across.run(scenario, STEP, places), 1.0 / STEP, 20.0)
    inside = force[(places >= first) & (places <= last)]
    return {
        "mean": float(inside.mean()), "standard deviation": float(inside.std()),
        "maximum": float(inside.max()), "minimum": float(inside.min()),
    }  # fmt: skip


@pytest.mark.evidence
@pytest.mark.parametrize("family", FAMILIES)
def test_second_program(family: str, second: dict[str, float], evidence: Evidence) -> None:
    changes = {"solver.motion": "across", **FAMILIES[family]}
    found = arcless.run(arcless.load(SCENARIO).with_(**changes)).assessment.pantographs[0]
    values = {
        "mean": found.mean_force_N, "standard deviation": found.std_force_N,
        "maximum": found.max_force_N, "minimum": found.min_force_N,
    }  # fmt: skip
    for name, value in values.items():
        evidence.close(
            f"{name}, {family}", value, second[name], unit="N", absolute=0.8,
            reason="elements of 0.45 or 0.8 m, 0.25 m; motion along moves them by up to 3 N",
        )  # fmt: skip


FAULTS = [
    Fault(f"wires move along the track after all, {family}", without("across_only"),
          test_second_program, family=family, slow=True)
    for family in sorted(FAMILIES)
]  # fmt: skip
