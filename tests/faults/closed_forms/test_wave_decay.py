"""Faults that the decay of waves must notice."""

from collections.abc import Callable
from dataclasses import replace

from tests.support import schemes
from tests.support.faults import scaled
from tests.verification.closed_forms import test_wave_decay as checks

Noticed = Callable[..., None]


def test_damping_off_or_dropped(noticed: Noticed) -> None:
    for column in ("alpha", "beta"):
        for kind, lumped in (("wires", False), ("segments", True)):
            with scaled(kind, column, 1.01):
                noticed(
                    f"{column} of the {kind} 1 % too large",
                    checks.test_damping, which=column, lumped=lumped,
                )  # fmt: skip
        with scaled("wires", column, 0.0):
            noticed(f"{column} dropped", checks.test_damping, which=column, lumped=False)


def test_scheme_with_another_number(noticed: Noticed) -> None:
    wrong = replace(schemes.DEFAULT, numbers=(0.8,))
    noticed("spectral radius 0.8 in place of 0.9", checks.test_scheme, member=wrong)
    wrong = replace(schemes.DAMPED, numbers=(0.3025, 0.601))
    noticed("γ = 0.601 in place of 0.6", checks.test_scheme, member=wrong)
