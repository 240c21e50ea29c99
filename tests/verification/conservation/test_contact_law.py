"""Contact: the recorded force is that of the recorded overlap, with droppers going slack

At each instant of balance the overlap p of strip and wire is told by two recorded heights, that of
the wire at the contact and that of the head, which come from the motion of line and pantograph and
not from the complementarity problem:

* compliant contact: `F = k_c p` where `F > 0`, else the gap is `−p`
* rigid contact: `p = 0` where `F > 0`, else the gap is `−p`; nothing ever passes through

The solver finds forces of contacts and corrections of slack droppers together from influence
columns; a wrong coupling or a stale column moves the wire elsewhere than the solver thought.

The law itself; the level of the head at the start is the only constant, taken from the first
instant. Asked as AC simple over 340 m with 230 N of static force: droppers slacken, contact is
lost.
"""

from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

import arcless
from tests.support.evidence import Evidence
from tests.support.faults import Fault
from tests.support.run_faults import contact_scaled, prepared_with

STIFFNESS = 50e3
RUN: dict[str, Any] = {
    "pantographs.0.static_force": 230.0,
    "travel.end": "400 m",
    "analysis.spans": [3, 6],
    "output.energy": "never",
}


@pytest.mark.parametrize(
    ("law", "scheme"),
    [
        ("compliant", {"name": "generalised-alpha", "spectral_radius": 0.9}),
        ("compliant", {"name": "newmark", "beta": 0.3025, "gamma": 0.6}),
        ("rigid", {"name": "newmark", "beta": 0.3025, "gamma": 0.6}),
    ],
)
def test_law(evidence: Evidence, law: str, scheme: dict[str, Any]) -> None:
    changes = {"contact.law": law, "solver.scheme": scheme}
    data = arcless.run(arcless.load("en50318-ac-simple-320-planar").with_(**RUN, **changes)).dataset
    force, gap = data["contact_force"].values[:, 0], data["contact_gap"].values[:, 0]
    compliance = 1.0 / STIFFNESS if law == "compliant" else 0.0
    overlap = data["mass_displacement"].values[:, 0, -1] - data["contact_height"].values[:, 0]
    overlap += force[0] * compliance - overlap[0]
    closed = force > 0.0
    # Both laws of both kinds are asked: contact and lift-off, with and without slack droppers.
    assert closed.sum() > 100
    assert (~closed).sum() > 3
    assert data["slack_droppers"].values.max() >= 3
    case = f"{law}, {scheme['name']}"
    reason = "rounding of heights of 5 m, 1e-15 m, through a dozen additions"
    evidence.below(
        f"largest |p − F/k| in contact, {case}",
        float(abs(overlap - compliance * force)[closed].max()),
        3e-14,
        unit="m",
        reason=reason,
    )
    evidence.below(
        f"largest |gap + p| out of contact, {case}",
        float(abs(overlap + gap)[~closed].max()),
        3e-14,
        unit="m",
        reason=reason,
    )
    assert np.all(gap[closed] == 0.0)
    assert np.all(overlap[~closed] < 3e-14)


NEWMARK = {"name": "newmark", "beta": 0.3025, "gamma": 0.6}
FAULTS = [
    Fault("contact 0.01 % stiffer", contact_scaled(1.0001), test_law, law="compliant",
          scheme=NEWMARK),
    Fault("contact of 1e12 N/m for a rigid one", prepared_with(contact_stiffness=lambda _: 1e12),
          test_law, law="rigid", scheme=NEWMARK),
    Fault("1e-9 more stiffness expected", patch.multiple(__name__, STIFFNESS=50e3 * (1.0 + 1e-9)),
          test_law, law="compliant", scheme={"name": "generalised-alpha", "spectral_radius": 0.9}),
]  # fmt: skip
