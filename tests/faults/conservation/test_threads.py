"""What runs side by side notice: something that one run leaves for the next."""

from collections.abc import Callable
from itertools import count
from typing import Any
from unittest.mock import patch

from arcless.simulate.setup import controllers, pantographs
from tests.verification.conservation import test_threads

Noticed = Callable[..., None]
rider = pantographs.rider


def test_a_controller_that_is_shared(noticed: Noticed) -> None:
    with patch.object(controllers, "fresh", lambda function: function):
        noticed("a controller remembers the run before", test_threads.test_order_and_threads)


def test_a_force_that_creeps(noticed: Noticed) -> None:
    runs = count()

    def creeping(pantograph: Any, force: float, *rest: Any) -> Any:
        return rider(pantograph, force + 1e-12 * next(runs), *rest)

    with patch.object(pantographs, "rider", creeping):
        check = test_threads.test_one_line_for_several_runs
        noticed("each run adds 1e-12 N to the static force", check)
