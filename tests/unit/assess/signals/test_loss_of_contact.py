"""Loss of contact on gaps that were drawn sample by sample."""

import numpy as np
import pytest

from arcless.assess.signals.loss_of_contact import contact_loss_percent, longest_loss_s

STEP = 1e-3


def force_with(*gaps: tuple[int, int], samples: int = 1000) -> np.ndarray:
    force = np.full(samples, 100.0)
    for first, count in gaps:
        force[first : first + count] = 0.0
    return force


@pytest.mark.parametrize(
    ("gaps", "percent", "longest"),
    [
        ([], 0.0, 0.0),
        ([(500, 1)], 0.1, 0.001),
        ([(100, 5), (300, 7), (600, 3)], 1.5, 0.007),
        ([(0, 4)], 0.4, 0.004),
        ([(996, 4)], 0.4, 0.004),
        ([(0, 1000)], 100.0, 1.0),
        ([(10, 2), (13, 2)], 0.4, 0.002),
    ],
)
def test_share_and_longest(gaps, percent: float, longest: float) -> None:
    force = force_with(*gaps)
    # Counts times a step: round-off.
    assert contact_loss_percent(force) == pytest.approx(percent, rel=1e-12)
    assert longest_loss_s(force, STEP) == pytest.approx(longest, rel=1e-12)


def test_a_small_force_is_contact() -> None:
    assert contact_loss_percent(np.array([1e-9, 50.0])) == 0.0


def test_a_negative_force_of_a_foreign_record_counts_as_loss() -> None:
    assert contact_loss_percent(np.array([-1.0, 50.0])) == 50.0
