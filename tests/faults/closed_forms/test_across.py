"""Faults that the checks of motion across the track notice."""

from collections.abc import Callable
from typing import Any

import pytest

from tests.support.evidence import Evidence
from tests.support.faults import scaled, spoiled
from tests.verification.closed_forms import test_across as checks

Noticed = Callable[..., None]


def not_asked(arguments: dict[str, Any]) -> bool:
    """Let the wires move along the track; the other line of the check does so anyway."""
    before, arguments["across_only"] = arguments["across_only"], False
    return bool(before)


@pytest.mark.parametrize("model", checks.MODELS)
def test_motion_along(noticed: Noticed, model: str) -> None:
    def check(evidence: Evidence) -> None:
        checks.test_frequencies(model, evidence)

    with spoiled(not_asked):
        noticed(f"wires move along the track after all, {checks.MODELS[model]}", check)


def test_mass_1_percent_high(noticed: Noticed) -> None:
    def check(evidence: Evidence) -> None:
        checks.test_frequencies("hermite", evidence)

    with scaled("wires", "mass", 1.01):
        noticed("mass 1 % too high", check)
