"""The checks of the trolley wire notice what is wrong with a wire or its supports."""

from collections.abc import Callable

from tests.support.faults import gravity, scaled
from tests.support.python_faults import tension
from tests.verification.closed_forms import test_trolley_wire as checks

Noticed = Callable[..., None]


def test_gravity_a_thousandth_too_large(noticed: Noticed) -> None:
    with gravity(1.001):
        noticed("gravity 0.1 % too large", checks.test_supports)


def test_tension_1_percent_high(noticed: Noticed) -> None:
    for model in ("hermite", "lumped"):
        with tension(1.01):
            noticed(f"tension 1 % too high, {model}", checks.test_sag, model=model)


def test_no_bending_stiffness(noticed: Noticed) -> None:
    with scaled("wires", "EI", 0.0):
        noticed("no bending stiffness", checks.test_elasticity)


def test_supports_1_percent_softer(noticed: Noticed) -> None:
    with scaled("springs", "stiffness", 0.99):
        noticed("supports 1 % softer", checks.test_elasticity)
