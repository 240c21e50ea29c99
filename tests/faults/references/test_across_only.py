"""Faults that the comparison with a second program, without motion along the wires, notices."""

from collections.abc import Callable

import pytest

from tests.faults.closed_forms.test_across import not_asked
from tests.support.evidence import Evidence
from tests.support.faults import spoiled
from tests.verification.references import test_across_only as checks

Noticed = Callable[..., None]
second = checks.second


@pytest.mark.evidence
@pytest.mark.parametrize("family", checks.FAMILIES)
def test_motion_along(noticed: Noticed, second: dict[str, float], family: str) -> None:
    def check(evidence: Evidence) -> None:
        checks.test_second_program(family, second, evidence)

    with spoiled(not_asked):
        noticed(f"wires move along the track after all, {family}", check)
