"""Faults that the checks of a shipped line's elasticity notice."""

from collections.abc import Callable

from tests.support.faults import plain_chains, scaled
from tests.verification.closed_forms import test_elasticity_shipped as checks

Noticed = Callable[..., None]


def test_tension_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "tension", 1.01):
        noticed("tensions 1 % too high", checks.test_cubic_elements, elements=(0.25, 0.25))


def test_tension_of_chains_1_percent_high(noticed: Noticed) -> None:
    with scaled("segments", "tension", 1.01):
        noticed("tensions 1 % too high", checks.test_chains, elements=(0.45, 0.6))


def test_chords_between_the_points_of_a_chain(noticed: Noticed) -> None:
    with plain_chains():
        noticed("chains as they are", checks.test_chains, elements=(0.45, 0.6))


def test_arms_and_supports_20_percent_stiff(noticed: Noticed) -> None:
    with scaled("springs", "stiffness", 1.2):
        noticed(
            "arms and supports 20 % too stiff", checks.test_cubic_elements, elements=(1.45, 2.9)
        )
