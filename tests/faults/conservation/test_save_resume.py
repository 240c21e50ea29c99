"""What the parts of a run notice: a state of which one thing is lost."""

from collections.abc import Callable
from pathlib import Path
from typing import Any
from unittest.mock import patch

import pytest

from arcless.errors import ContactError
from arcless.results import Result
from arcless.simulate.runs import checkpoint
from tests.verification.conservation import test_save_resume

Noticed = Callable[..., None]
DEFAULT = "default"
LEDGER = "trapezoidal rule with ledger and friction"
CONTROLLED = "PID, sampled and late"
EXPLICIT = "point masses, explicit steps"
LOST = {
    "line_acceleration": DEFAULT,
    "contact_force": LEDGER,
    "controller_0": CONTROLLED,
    "grid_across": EXPLICIT,
}
LOST_TOO = {
    "line_displacement": DEFAULT,
    "line_velocity": DEFAULT,
    "link_elongation": DEFAULT,
    "link_max": DEFAULT,
    "rider_0_velocity": DEFAULT,
    "rider_0_start": DEFAULT,
    "rider_0_preload_ground_actuator": DEFAULT,
    "pivot_counts": DEFAULT,
    "contact_weights": LEDGER,
    "energy": LEDGER,
    "energy_sums": LEDGER,
    "rider_0_waiting": CONTROLLED,
    "grid_along": EXPLICIT,
}
read = checkpoint.read


def lose(noticed: Noticed, folder: Path, name: str, case: str) -> None:
    hits = []

    def forgetful(result: Result) -> Any:
        saved = read(result)
        hits.append(bool(saved.numbers[name].any()))
        saved.numbers[name][:] = 0.0
        return saved

    with patch.object(checkpoint, "read", forgetful):
        noticed(f"`{name}` lost", parts, tmp_path=folder, case=case)
    assert any(hits), "there was something to lose"


def parts(evidence: Any, **given: Any) -> None:
    """Check the parts; an energy balance that does not close notices as well."""
    try:
        test_save_resume.test_parts(evidence, **given)
    except ContactError as error:
        raise AssertionError(str(error)) from error


@pytest.mark.parametrize("name", LOST)
def test_a_part_of_the_state_is_lost(noticed: Noticed, tmp_path: Path, name: str) -> None:
    lose(noticed, tmp_path, name, LOST[name])


@pytest.mark.evidence
@pytest.mark.parametrize("name", LOST_TOO)
def test_another_part_is_lost(noticed: Noticed, tmp_path: Path, name: str) -> None:
    lose(noticed, tmp_path, name, LOST_TOO[name])
