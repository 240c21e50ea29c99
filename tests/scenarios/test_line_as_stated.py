"""Readings of a line file that docs/theory/line.md states, where several are possible."""

from math import sqrt

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

import arcless
from arcless.equilibrium.equilibrium import find
from arcless.mesh import Mesh, build_mesh
from arcless.mesh.division.smooth_curves import smooth
from arcless.model import load
from arcless.model.settings.run_settings import Solver
from tests.support.line_types import scenario_data
from tests.support.overlaps import overlap_data

PLACES = np.array([0.0, 50.0, 110.0, 165.0, 215.0])
RAISES = np.array([0.5, 0.06, 0.0, 0.0, 0.0])


def test_the_raise_has_the_slopes_of_fritsch_and_butland_inside() -> None:
    expected = PchipInterpolator(PLACES, RAISES).derivative()(PLACES[1:-1])
    step = 1e-3
    found = smooth(PLACES, RAISES, PLACES[1:-1] + step) - smooth(
        PLACES, RAISES, PLACES[1:-1] - step
    )
    # The curvature jumps at a support by some 1e-3 1/m: a quarter of that times the step.
    np.testing.assert_allclose(found / (2 * step), expected, atol=1e-6)


def test_the_raise_is_not_curved_at_the_anchor() -> None:
    step = 0.5
    near = smooth(PLACES, RAISES, np.array([0.0, step, 2 * step]))
    inside = smooth(PLACES, RAISES, np.array([20.0, 20.0 + step, 20.0 + 2 * step]))
    at_anchor, within = (abs(np.diff(part, 2)[0]) / step**2 for part in (near, inside))
    # The second difference of a cubic that is straight at 0 is its curvature a step away.
    assert at_anchor == pytest.approx(within * step / (20.0 + step), rel=1e-9)


def test_the_contact_wire_hangs_free_at_a_support() -> None:
    """Sag of a string of L between the droppers next to it, less the rounding of kinks at these.

    A force F rounds the kink F/T of a wire over λ = √(EI/T): near it the wire lies F λ/2T higher.
    """
    scenario = arcless.load("en50318-ac-simple-320-planar")
    found = find(scenario)
    line = scenario.line
    wire, first = line.contact_wire, line.span_types["standard"].droppers.positions[0]
    support = found.mesh.supports[10]
    beside = [i for i, d in enumerate(found.mesh.droppers) if abs(d.x - support.x) < 1.1 * first]
    force = found.of_droppers("link_tension")[beside].mean()
    bend = sqrt(wire.bending_stiffness / wire.tension)
    sag = wire.mass * 9.81 * (2 * first) ** 2 / (8 * wire.tension) - force * bend / 2 / wire.tension
    below = line.geometry.contact_wire_height - found.positions[support.contact_node, 2]
    # The tangents of chains of 0.3 m and of strings: some 1e-2 of the sag.
    assert below == pytest.approx(sag, rel=0.01)


def made(**changes: object) -> Mesh:
    return build_mesh(load(scenario_data(overlap_data(**changes))).line, Solver())


def test_messenger_wires_keep_half_of_the_separation() -> None:
    staggers = {"overlap__stagger_in": [0.3, 0.2, 0.1, 0.0], "overlap__stagger_out": [-0.3] * 4}
    plain, given = made(), made(**staggers)
    for before, after in zip(plain.systems, given.systems, strict=True):
        apart = [
            np.abs(given.positions[new, 1] - plain.positions[old, 1]).max()
            for old, new in (
                (before.messenger, after.messenger),
                (before.contact["contact wire"], after.contact["contact wire"]),
            )
        ]
        assert apart[0] == 0.0
        assert apart[1] > 0.1


def test_clamps_are_damped_like_the_wire_that_they_sit_on() -> None:
    rayleigh = {"contact_wire__damping": {"alpha": 0.3}, "messenger_wire__damping": {"alpha": 0.2}}
    masses = {"dropper__clamp_mass_contact_wire": 0.2, "dropper__clamp_mass_messenger_wire": 0.1}
    mesh = made(**rayleigh, **masses, support__mass=4.0)
    rows = mesh.parts["masses"]
    alphas = {0.2: 0.3, 0.1: 0.2, 4.0: 0.0}
    for mass, alpha in alphas.items():
        assert set(rows["alpha"][rows["mass"] == mass]) == {alpha}
