"""Faults that waves under explicit steps must notice."""

from collections.abc import Callable
from unittest.mock import patch

import numpy as np

from tests.support.faults import plain_chains, scaled
from tests.support.run_faults import prepared_with
from tests.verification.closed_forms import test_explicit_waves as checks

Noticed = Callable[..., None]


def test_wire_off(noticed: Noticed) -> None:
    for column in ("tension", "mass"):
        with scaled("segments", column, 1.001):
            noticed(f"{column} of the chain 0.1 % too large", checks.test_phase_speed, bending=0.0)
    with scaled("bends", "EI", 1.01):
        noticed("EI 1 % too large", checks.test_phase_speed, bending=200.0)
    with plain_chains():
        noticed("points yield as those of a chain", checks.test_phase_speed, bending=200.0)


def test_other_steps(noticed: Noticed) -> None:
    with patch.object(checks, "X", np.arange(-40.0, 280.2, 0.4)):
        noticed("masses 0.4 m apart in place of 0.5 m", checks.test_phase_speed, bending=0.0)
    solved = {"scheme": lambda _: ("trapezoidal", [])}
    with prepared_with(**solved):
        noticed("steps that are solved for", checks.test_phase_speed, bending=0.0)


def test_damping_off_or_dropped(noticed: Noticed) -> None:
    for column in ("alpha", "beta"):
        for factor, fault in ((1.01, "1 % too large"), (0.0, "dropped")):
            with scaled("segments", column, factor):
                noticed(f"{column} {fault}", checks.test_damping, which=column, bending=0.0)
