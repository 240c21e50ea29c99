"""Residual flexibility: results that hardly depend on the elements, in all ways to run a line."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import Scenario
from arcless.results import Result
from arcless.simulate import statics

Run = Callable[..., Result]
Short = Callable[..., Scenario]

ON: dict[str, Any] = {"solver.residual_flexibility": True}
RIGID = {"name": "generalised-alpha", "spectral_radius": 0.0}
LONG = {"solver.contact_wire_element": 1.45, "solver.messenger_wire_element": 2.9}
FINE = {"solver.contact_wire_element": 0.3, "solver.messenger_wire_element": 0.5}


def force(result: Result) -> Any:
    """Contact force, N."""
    return result.dataset["contact_force"].values


def test_a_run_depends_less_on_its_elements(run: Run) -> None:
    fine = force(run(**FINE, **ON))
    with_it, without = (np.std(force(run(**LONG, **some)) - fine) for some in (ON, {}))
    # Measured: a third.
    assert with_it < 0.6 * without


def test_droppers_are_as_long_as_with_fine_elements(short: Short) -> None:
    def lengths(**changes: Any) -> Any:
        return np.array([d["length_m"] for d in statics(short(**changes)).droppers])

    fine = lengths(**FINE, **ON)
    # Elements of 0.3 m miss a quarter of a fifth of what long ones do (1.4 mm).
    assert np.abs(lengths(**FINE) - fine).max() < 0.2e-3
    assert np.abs(lengths(**LONG, **ON) - fine).max() < 0.15e-3
    assert np.abs(lengths(**LONG) - fine).max() > 0.5e-3


def test_energy_is_kept(run: Run) -> None:
    for scheme in ("trapezoidal", "generalised-alpha"):
        result = run(**ON, **{"solver.scheme": scheme, "output.energy": "always"})
        # Rounding of some thousand sums; the ledger without it closes as well.
        assert result.metadata["energy_residual_relative"] < 1e-9


@pytest.mark.parametrize(
    "changes",
    [
        {"as_built.dropper_length_errors": [{"span": 3, "dropper": 2, "length_error": "20 mm"}]},
        {"contact.law": "rigid", "solver.scheme": RIGID},
        {"solver.dimension": "spatial"},
        {"output.points": [100.0, 101.3]},
    ],
    ids=["as built", "rigid", "in space", "points"],
)
def test_it_goes_with_other_choices(run: Run, changes: dict[str, Any]) -> None:
    on, off = (run(**LONG, **changes, **some) for some in (ON, {}))
    fine = force(run(**FINE, **changes, **ON))
    with_it, without = (np.std(force(result) - fine) for result in (on, off))
    # Measured: a third to a half, in the rigid contact of whole newtons.
    assert with_it < 0.7 * without
    if "output.points" in changes:
        uplift = [r.dataset["point_uplift"].values.max(axis=0) for r in (on, off)]
        np.testing.assert_allclose(uplift[0], uplift[1], rtol=0.1)


def test_statics_and_dynamics_agree_on_the_elasticity(short: Short) -> None:
    """A pantograph that stands lifts the wire by its force times the elasticity, also with R."""
    found = statics(short(**ON))
    without = statics(short())
    e, plain = (np.array(s.elasticity_m_per_N) for s in (found, without))
    # More by up to 0.03 of an element over T at the contact and at droppers: 2 % of 0.3 mm/N.
    assert np.all(e > plain * 0.999)
    assert 1.002 < np.mean(e / plain) < 1.05


def test_it_is_there_by_default_wherever_it_can_be() -> None:
    scenario = arcless.load("en50318-ac-simple-320-planar")
    solved = scenario.with_(**{"solver.scheme": "generalised-alpha"})
    assert solved.stepping.residual_flexibility is True
    updated = solved.with_(**{"solver.kinematics": "updated"})
    assert updated.stepping.residual_flexibility is False
