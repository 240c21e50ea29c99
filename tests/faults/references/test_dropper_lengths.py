"""The checks of dropper lengths notice tensions, weights and dropper stiffness that are off."""

from collections.abc import Callable

from tests.support import fresh
from tests.support.faults import scaled
from tests.support.python_faults import tension
from tests.verification.references import test_dropper_lengths as checks

Noticed = Callable[..., None]


def test_tension_1_percent_low(noticed: Noticed) -> None:
    with tension(0.99):
        noticed("tensions 1 % too low", checks.test_nine_lengths, at_rest=fresh.at_rest)


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
