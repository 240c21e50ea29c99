"""What a shifted origin notices: something that has not stayed the same."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any
from unittest.mock import patch

from arcless.simulate.setup.trajectory import Motion
from tests.verification.conservation import test_shift

Noticed = Callable[..., None]
moved = test_shift.moved


def test_a_support_that_changes(noticed: Noticed) -> None:
    test_shift.in_place()

    def softened(mesh: Any, by: Any) -> Any:
        there = moved(mesh, by)
        springs = there.parts["springs"][1].copy()
        springs[0, 0] *= 1.0 + 1e-6
        return replace(there, parts=there.parts | {"springs": (there.parts["springs"][0], springs)})

    with patch.object(test_shift, "moved", softened):
        noticed("one support 1e-6 softer where it was moved", test_shift.test_across_and_up)


def test_a_travel_that_lags(noticed: Noticed) -> None:
    test_shift.in_place()

    def late(positions: Any, speeds: Any, step: float) -> Motion:
        return Motion(positions - 1e-6, speeds, step)

    with patch.object(test_shift, "Motion", late):
        noticed("travel 1 µm behind", test_shift.test_along_the_track)
