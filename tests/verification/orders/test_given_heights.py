"""Irregular heights: what elements and steps resolve of them

Heights of a contact wire that were measured on a real line matter down to a sixteenth of the
interval of droppers (Song, Jiang, Nåvik, Rønnquist, Railway Engineering Science 29 (2021) 350–361,
abstract, mark A). So the elements of the contact wire and the way of a step, v Δt, must be shorter
than that, with the solver as each scenario is shipped; of paired droppers the interval is that of
the pairs.

Then AC simple, planar, 275 km/h, 160 N, with another height at each dropper and support
(`as_built.measured_heights`: normal errors of 2 mm, the same drawing each time): elements of both
wires and the step halved must change nothing that matters. Errors of 5 mm from dropper to dropper
are refused: no wire of this tension hangs like that.
"""

from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

import arcless
from arcless.model.shipped.library import shipped
from tests.support.evidence import Evidence
from tests.support.faults import Fault

SHARE, DEVIATION, PAIRED = 16.0, 2e-3, 0.6  # of the interval; m; m, the widest pair
SCENARIO = "en50318-ac-simple-275-planar"
ELEMENTS = ("contact_wire_element", "messenger_wire_element")


COARSE: dict[str, Any] = {}


def scenarios() -> list[str]:
    """Return the shipped scenarios with droppers, without those of the published method."""
    names = [name for name in shipped("scenario") if not name.startswith("praks")]
    return [name for name in names if arcless.load(name).line.messenger_wire is not None]


def test_resolution(evidence: Evidence) -> None:
    shares = []
    for name in scenarios():
        scenario = arcless.load(name).with_(**COARSE)
        own = scenario.stepping
        between = np.diff(scenario.line.span_list()[0].holders.positions)
        interval = float(np.median(between[between > PAIRED]))
        longest = max(own.contact_wire_element_m, scenario.top_speed * own.time_step)
        shares.append(SHARE * longest / interval)
    assert len(shares) > 20
    evidence.below(
        "longest element or way of a step, over a sixteenth of the interval of droppers",
        max(shares), 1.0, unit="1", mark="A", reason="finer irregularities do not matter there",
    )  # fmt: skip


KNOWN: dict[str, dict[str, tuple[float, str]]] = {}


def numbers(changes: dict[str, Any]) -> dict[str, tuple[float, str]]:
    """Run with heights that differ from the design, once; return numbers with their units."""
    key = repr(changes)
    if key not in KNOWN:
        KNOWN[key] = assessed(changes)
    return KNOWN[key]


def assessed(changes: dict[str, Any]) -> dict[str, tuple[float, str]]:
    base = arcless.load(SCENARIO)
    line, height = base.line, base.line.geometry.contact_wire_height
    drawn = np.random.Generator(np.random.PCG64(7))
    places = [(x, 0.0) for x in line.support_positions()]
    for start, span in zip(line.support_positions(), line.span_list(), strict=False):
        own = span.holders
        places += [(start + x, s) for x, s in zip(own.positions, own.design_presag, strict=True)]
    rows = [
        {"position": x, "height": height - presag + DEVIATION * float(drawn.standard_normal())}
        for x, presag in sorted(places)
    ]
    given = {"mean_force": None, "static_force": 160.0}
    force = {f"pantographs.0.{name}": value for name, value in given.items()}
    found = arcless.run(base.with_(**force, **{"as_built.measured_heights": rows}, **changes))
    of = found.assessment.pantographs[0]
    return {
        "standard deviation": (of.std_force_N, "N"),
        "standard deviation, 5 to 20 Hz": (of.std_force_5_20Hz_N, "N"),
        "statistical maximum": (of.statistical_max_N, "N"),
        "range of the contact point": (of.contact_point_range_mm, "mm"),
    }


@pytest.mark.evidence
def test_halving(evidence: Evidence) -> None:
    own = arcless.load(SCENARIO).stepping
    half = {f"solver.{name}": 0.5 * getattr(own, f"{name}_m") for name in ELEMENTS}
    default, fine = numbers(COARSE), numbers(half | {"solver.time_step": 0.5 * own.time_step})
    for name, (value, unit) in default.items():
        evidence.close(
            f"{name}, as shipped against elements and step halved", value, fine[name][0],
            unit=unit, relative=0.01, reason="as on the line as designed, where σ moves by 0.3 %",
        )  # fmt: skip


LONG = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": 1.45,
    "solver.messenger_wire_element": 2.9,
}
FAULTS = [
    Fault("elements of 1.45 m by default", patch.multiple(__name__, COARSE=LONG), test_resolution),
    Fault("elements of a quarter of the interval", patch.multiple(__name__, COARSE=LONG),
          test_halving, slow=True),
]  # fmt: skip
