"""What the checks of the order of a run notice."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

from tests.support.run_faults import prepared_with, spoiled
from tests.support.schemes import DEFAULT, newmark
from tests.verification.orders import test_time_step_of_a_run as topic

Notice = Callable[..., None]


@pytest.fixture(autouse=True)
def _nothing_kept() -> Iterator[None]:
    """A reference that was made without the fault, or with it, is not used for the other."""
    topic.reference.cache_clear()
    yield
    topic.reference.cache_clear()


@pytest.mark.parametrize("model", ["cubic, planar", "point masses, spatial"])
def test_contact_half_a_step_behind(noticed: Notice, model: str) -> None:
    def behind(arguments: dict[str, Any]) -> None:
        x = np.array(arguments["positions"])
        arguments["positions"] = [x[0], *(0.5 * (x[1:] + x[:-1]))]

    with spoiled(running=behind):
        what = f"{model}: contact where it was half a step ago"
        noticed(what, topic.test_order, model=model, kinematics="linearised", scheme=DEFAULT)


def test_a_little_of_first_order(noticed: Notice) -> None:
    topic.reference("cubic, planar", "linearised")
    with prepared_with(scheme=lambda asked: (asked[0], [0.26, 0.51])):
        what = "newmark with γ = 0.51 in place of 0.5"
        noticed(
            what,
            topic.test_order,
            model="cubic, planar",
            kinematics="linearised",
            scheme=newmark(0.25, 0.5),
        )


def test_contact_of_another_stiffness(noticed: Notice) -> None:
    topic.reference("cubic, planar", "linearised")
    with prepared_with(contact_stiffness=lambda stiffness: 1.1 * stiffness):
        what = "contact 10 % stiff, in all but the reference"
        noticed(
            what, topic.test_order, model="cubic, planar", kinematics="linearised", scheme=DEFAULT
        )
