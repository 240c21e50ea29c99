"""Two contact wires side by side move like one of twice everything

A line with two equal contact wires, each with its own droppers, arms and contact (25 kN/m), against
the same line with one wire of twice the mass, EA, EI and tension, one dropper and arm of twice the
stiffness and one contact of 50 kN/m. In the plane, where two wires side by side are in one place,
the equations are the same, summed in another order.

Symmetry; derived here. Asked as ten spans of 60 m, 250 km/h over 350 m.
"""

from typing import Any

import pytest

import arcless
from arcless.model import load
from arcless.results import Result
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.line_types import scenario_data
from tests.support.overlaps import plain_data
from tests.support.run_faults import prepared_with

DOUBLE = {"mass": 2.2, "axial_stiffness": 28e6, "bending_stiffness": 260.0, "tension": 30e3}
DAMPING = {"alpha": 0.0125, "beta": 1e-4}


def pair() -> dict[str, Any]:
    twin = {"separation": 0.04, "droppers": "paired"}
    return plain_data(10, twin_contact_wires=twin, contact_wire__damping=DAMPING)


def single() -> dict[str, Any]:
    line = plain_data(10, contact_wire={**DOUBLE, "damping": DAMPING})
    line["dropper"] = {"stiffness": 2e5, "mass": 0.2}
    line["steady_arm"] = {"kind": "spring", "vertical_stiffness": 600.0}
    return line


def ride(line: dict[str, Any], contact: float, kinematics: str) -> Result:
    data = scenario_data(
        line,
        speed="250 km/h",
        travel={"start": 130.0, "end": 480.0},
        contact={"stiffness": contact},
        solver__kinematics=kinematics,
        output__energy="never",
    )
    return arcless.run(load(data))


@pytest.mark.parametrize(
    "kinematics", ["linearised", pytest.param("updated", marks=pytest.mark.evidence)]
)
def test_alike(evidence: Evidence, kinematics: str) -> None:
    two, one = ride(pair(), 25e3, kinematics).dataset, ride(single(), 50e3, kinematics).dataset
    force, half = one["contact_force"].values, two["wire_contact_force"].values
    assert force.std() > 5.0  # it did move
    rounding = "rounding, which contacts and droppers that open and close pass on, not multiply"
    evidence.below(
        f"largest difference of the contact force, {kinematics}",
        float(abs(two["contact_force"].values - force).max()),
        1e-5 * float(force.max()),
        unit="N",
        reason=rounding,
    )
    evidence.below(
        f"largest difference between the two wires, {kinematics}",
        float(abs(half[:, 0] - half[:, 1]).max()),
        1e-5 * float(force.max()),
        unit="N",
        reason=rounding,
    )
    uplift, twice = one["support_uplift_max"].values, two["support_uplift_max"].values
    assert uplift.max() > 0.01
    evidence.below(
        f"largest difference of uplift at the arms, {kinematics}",
        float(max(abs(twice[side::2] - uplift).max() for side in (0, 1))),
        1e-8,
        unit="m",
        reason="rounding, as of the force: 1e-3 N on 1 mm/N at most",
    )


FAULTS = [
    Fault("one dropper 0.1 % softer", scaled("links", "stiffness", 0.999, rows=[20]), test_alike,
          kinematics="linearised"),
    Fault("contacts of 25 kN/m for both", prepared_with(contact_stiffness=lambda _: 25e3),
          test_alike, kinematics="linearised"),
]  # fmt: skip
