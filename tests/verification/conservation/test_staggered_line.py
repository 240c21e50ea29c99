"""Line with stagger in space against the plane line with the arm that its stagger makes

A stagger of ± s makes a radial force at each arm, `2T · 2s/L` and what droppers pull to the middle;
over the arm's length it holds the wire like a spring. So the three-dimensional line has the
elasticity of the planar one whose arms have 320 N/1.2 m = 267 N/m, but for slanting droppers and
the slope of the arms: some per cent, no missing factor. And mirroring the stagger changes no force
(group conservation, mirrored line).

Derived here. Asked as `en50318-ac-simple-320` and `en50318-ac-simple-320-planar` at rest, both with
cubic elements; runs of the former at the mean force asked for.
"""

from collections.abc import Callable
from math import cos, radians
from typing import Any

import numpy as np
import pytest

from arcless.results import Result
from arcless.simulate import StaticsResult
from tests.support import fresh
from tests.support.evidence import Evidence
from tests.support.explicit import BY_MATRIX, SOLVED
from tests.support.faults import Fault, scaled
from tests.support.python_faults import tension

AtRest = Callable[..., StaticsResult]
RunOnce = Callable[..., Result]
SPATIAL = "en50318-ac-simple-320"
STEPS: dict[str, dict[str, Any]] = {"solved for": SOLVED, "explicit": {}}
SOFT = {"line.steady_arm.vertical_stiffness": 267.36}


@pytest.mark.parametrize("steps", STEPS)
def test_elasticity(evidence: Evidence, at_rest: AtRest, steps: str) -> None:
    planar_steps = BY_MATRIX if steps == "solved for" else {}
    spatial = at_rest(SPATIAL, STEPS[steps])
    planar = at_rest("en50318-ac-simple-320-planar", SOFT | planar_steps)
    assert spatial.equilibrium.mesh.dimension == 3
    found, expected = spatial.elasticity_m_per_N, planar.elasticity_m_per_N
    evidence.close(
        f"{steps}: elasticity at a support against the planar line",
        found[0],
        expected[0],
        unit="m/N",
        relative=0.02,
        reason="slanting droppers add to the radial force; the arm's slope of 10° takes 1.5 %",
    )
    evidence.close(
        f"{steps}: elasticity in mid-span against the planar line",
        found[len(found) // 2],
        expected[len(expected) // 2],
        unit="m/N",
        relative=0.01,
        reason="a tenth of what differs at the support arrives, and droppers slant",
    )


def test_force_of_an_arm(evidence: Evidence, at_rest: AtRest) -> None:
    found = at_rest(SPATIAL, SOLVED)
    arms = np.array([support["steady_arm_force_N"] for support in found.supports[5:15]])
    expected = radial_force(found) / cos(radians(10))
    assert arms.size == 10
    evidence.close(
        "force of an arm, the one that is farthest off",
        float(arms[np.argmax(abs(arms - expected))]),
        expected,
        unit="N",
        relative=1e-2,
        reason="the lateral place of the wire between supports is taken as a straight line",
    )


def radial_force(found: StaticsResult, span: int = 10) -> float:
    """Lateral force on an arm: the bend of the wire, and droppers that pull it to the middle."""
    length, tension = 55.0, 22e3
    geometry = found.scenario.line.geometry
    stagger, beside = geometry.stagger_contact_wire[0], geometry.stagger_messenger_wire[0]
    radial = 2 * tension * 2 * stagger / length
    for dropper in found.droppers:
        if dropper["span"] == span:
            place = dropper["x_m"] % length / length
            aside = (stagger - beside) * (1 - 2 * place)
            # Pulls aside/length of its force sideways; the lever rule shares it between the arms,
            # and the neighbouring span does the same.
            pull = dropper["force_N"] * aside / dropper["length_m"]
            radial += 2 * pull * (1 - place)
    return radial


@pytest.mark.evidence
@pytest.mark.parametrize("steps", STEPS)
def test_mean_force(evidence: Evidence, run_once: RunOnce, steps: str) -> None:
    pantograph = run_once(SPATIAL, STEPS[steps]).assessment.pantographs[0]
    assert pantograph.contact_loss_percent == 0.0
    evidence.close(
        f"mean force in space against the one asked for, steps {steps}",
        pantograph.mean_force_N,
        169.3,
        unit="N",
        absolute=0.02,
        reason="the tolerance that the search for the static force documents",
    )


def stiffer(name: str, changes: dict[str, Any] | None = None) -> StaticsResult:
    """Find the plane line at rest, its springs twice as stiff."""
    if name == SPATIAL:
        return fresh.at_rest(name, changes)
    # What is looked for is a missing factor. The wires hold a support far more than the arm:
    # 10 % of the arm are 0.5 % of the elasticity there.
    with scaled("springs", "stiffness", 2.0):
        return fresh.at_rest(name, changes)


FAULTS = [
    Fault("tensions 2 % too high", tension(1.02), test_force_of_an_arm, at_rest=fresh.at_rest),
    *(Fault("springs of the plane line twice as stiff", (), test_elasticity, at_rest=stiffer,
            steps=steps, slow=steps == "explicit")
      for steps in sorted(STEPS)),
]  # fmt: skip
