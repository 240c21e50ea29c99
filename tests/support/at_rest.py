"""Errors of the line at rest against its limit: elasticity, droppers, steady arms."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import arcless
from arcless.equilibrium import equilibrium
from tests.support import limit

Floats = NDArray[np.float64]
# Contact and messenger wire elements of both families in m; the line at rest asks for no steps.
# Shorter cubic ones come to rest with more than the residual allowed: rounding of EI/ℓ³.
CUBIC, CHAINS, CHAINS_OF_RAILS = (0.25, 0.5), (0.1, 0.1), (0.06, 0.06)
STEP = 1e-4
# Places in the middle span, its supports among them.
PLACES = 9


@dataclass(frozen=True)
class AtRest:
    """Compared quantities of a line at rest.

    Attributes
    ----------
    elasticity : at equal distances over the middle span, m/N
    droppers : forces of the droppers of all spans but the outer two on either side, N
    arms : forces in the steady arms of these, N
    """

    elasticity: Floats
    droppers: Floats
    arms: Floats


def at_rest(scenario: arcless.Scenario) -> AtRest:
    """Return a line at rest."""
    found = equilibrium.find(scenario)
    places = np.linspace(*found.middle_span(), PLACES)
    supports = scenario.line.support_positions()
    low, high = supports[2], supports[-3]
    hung = np.array([low < dropper.x < high for dropper in found.mesh.droppers], dtype=bool)
    arms = [own.steady_arm for own in found.mesh.supports if low <= own.x <= high]
    return AtRest(
        found.elasticity(places),
        found.of_droppers("link_tension")[hung],
        found.arrays["strut_tension"][[arm for arm in arms if arm is not None]],
    )


def limit_at_rest(scenario: arcless.Scenario) -> tuple[AtRest, dict[str, float]]:
    """Return the mean of both families, and what they differ by, %."""
    matrix = limit.MATRIX | {"solver.wire_model": "hermite", "solver.residual_flexibility": True}
    one = at_rest(limit.divided(scenario, matrix, *CUBIC, STEP))
    rail = limit.is_rail(scenario)
    scheme = limit.MATRIX if rail else limit.QUIET | {"solver.scheme": "central-difference"}
    chains = scheme | {"solver.wire_model": "lumped", "solver.residual_flexibility": "auto"}
    lengths = CHAINS_OF_RAILS if rail else CHAINS
    other = at_rest(limit.divided(scenario, chains, *lengths, STEP))
    mean = AtRest(*(0.5 * (getattr(one, n) + getattr(other, n)) for n in NAMES))
    return mean, off(one, other)


def off(found: AtRest, right: AtRest) -> dict[str, float]:
    """Return the largest difference of each kind, %.

    Dropper forces: of their mean, since some hang nearly loose.
    """
    scales: dict[str, Callable[[Floats], Floats]] = {
        "elasticity": np.abs,
        "droppers": lambda forces: np.full_like(forces, np.abs(forces).mean()),
        "arms": np.abs,
    }
    differ = {}
    for name in NAMES:
        own, other = getattr(found, name), getattr(right, name)
        share = np.abs(own - other) / scales[name](other) if len(other) else np.zeros(1)
        differ[name] = 100.0 * float(share.max())
    return differ


NAMES = ("elasticity", "droppers", "arms")
