"""What the checks of updated kinematics notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.support.run_faults import prepared_with
from tests.support.schemes import DEFAULT, PUBLISHED, newmark
from tests.verification.orders import test_time_step_updated as topic

Notice = Callable[..., None]


def test_linearised_kinematics(noticed: Notice) -> None:
    with prepared_with(updated=lambda updated: not updated):
        noticed("kinematics about the state at rest", topic.test_order, scheme=DEFAULT)


def test_strings(noticed: Notice) -> None:
    with scaled("segments", "EA", 1.01):
        noticed("EA 1 % high", topic.test_order, scheme=DEFAULT)
    with scaled("segments", "EA", 1.1):
        noticed("EA 10 % high", topic.test_order, scheme=PUBLISHED)


def test_a_little_of_first_order(noticed: Notice) -> None:
    with prepared_with(scheme=lambda asked: (asked[0], [0.26, 0.51])):
        what = "newmark with γ = 0.51 in place of 0.5"
        noticed(what, topic.test_order, scheme=newmark(0.25, 0.5))
