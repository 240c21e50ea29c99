"""The checks of dropper lengths notice tensions, weights and dropper stiffness that are off."""

from collections.abc import Callable

import pytest

from tests.support import fresh
from tests.support.faults import plain_chains, scaled
from tests.support.python_faults import tension
from tests.verification.references import test_dropper_lengths as checks

Noticed = Callable[..., None]


@pytest.mark.parametrize("wires", checks.WIRES)
def test_tension_1_percent_low(noticed: Noticed, wires: str) -> None:
    check = checks.test_nine_lengths
    with tension(0.99):
        noticed("tensions 1 % too low", check, at_rest=fresh.at_rest, wires=wires)


def test_chains_with_corners_as_of_links(noticed: Noticed) -> None:
    """Points that yield as those of a plain chain do: corners at droppers are too sharp."""
    with plain_chains():
        noticed("chains as they are", checks.test_mesh, at_rest=fresh.at_rest, wires="as shipped")


def test_one_clamp_heavier(noticed: Noticed) -> None:
    with scaled("masses", "mass", 2.0, rows=[40]):
        noticed(
            "one clamp twice as heavy", checks.test_inner_spans_are_alike, at_rest=fresh.at_rest
        )


def test_droppers_that_stretch_more_as_built(noticed: Noticed) -> None:
    def at_rest(name: str, changes: dict[str, object] | None = None) -> object:
        if not changes:
            return fresh.at_rest(name)
        with scaled("links", "stiffness", 0.5):
            return fresh.at_rest(name, changes)

    noticed("droppers half as stiff as designed", checks.test_as_built, at_rest=at_rest)
