"""What the mirror notices: one side that is not like the other."""

from collections.abc import Callable
from typing import Any
from unittest.mock import patch

from tests.support.faults import scaled
from tests.support.small import SPANS, small
from tests.verification.conservation import test_mirror

Noticed = Callable[..., None]


def test_a_stagger_that_is_a_tenth_of_a_millimetre_off(noticed: Noticed) -> None:
    test_mirror.straight()
    with patch.object(test_mirror, "small", lambda **more: small(across=-1.0005)):
        noticed("stagger 0.1 mm off on one side", test_mirror.test_left_and_right)


def test_a_dropper_that_is_heavier(noticed: Noticed) -> None:
    test_mirror.straight()
    with scaled("links", "mass", 1.01, [0]):
        noticed("one dropper 1 % heavier on one side", test_mirror.test_left_and_right)
    with scaled("links", "mass", 1.01, [0]):
        noticed("one dropper 1 % heavier at one end", test_mirror.test_first_and_last_end)


def test_droppers_that_were_not_turned_round(noticed: Noticed) -> None:
    test_mirror.straight()

    def half_turned(**_: Any) -> Any:
        moved = tuple((length, tuple(x + 1e-3 for x in at)) for length, at in SPANS)
        with patch("tests.support.small.SPANS", moved):
            return small(backwards=True)

    with patch.object(test_mirror, "small", half_turned):
        noticed("droppers 1 mm off at one end", test_mirror.test_first_and_last_end)
