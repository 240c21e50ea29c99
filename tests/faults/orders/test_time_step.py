"""What the checks of the order of each scheme notice."""

from collections.abc import Callable

import pytest

from tests.support.faults import scaled
from tests.support.run_faults import prepared_with, rider_scaled
from tests.support.schemes import ALL, DEFAULT, Member, newmark
from tests.verification.orders import test_time_step as topic

Notice = Callable[..., None]


@pytest.mark.parametrize("scheme", ALL, ids=lambda scheme: scheme.label)
def test_error_that_stays(noticed: Notice, scheme: Member) -> None:
    with scaled("springs", "stiffness", 1.01):
        noticed(f"{scheme.label}: spring of the line 1 % stiff", topic.test_order, scheme=scheme)
    with rider_scaled("damping", 1.1):
        what = f"{scheme.label}: damper of the pantograph 10 % strong"
        noticed(what, topic.test_order, scheme=scheme)


def test_a_little_of_first_order(noticed: Notice) -> None:
    with prepared_with(scheme=lambda asked: (asked[0], [0.26, 0.51])):
        what = "newmark with γ = 0.51 in place of 0.5"
        noticed(what, topic.test_order, scheme=newmark(0.25, 0.5))


def test_scheme_of_second_order(noticed: Notice) -> None:
    with prepared_with(scheme=lambda _asked: (DEFAULT.name, list(DEFAULT.numbers))):
        what = "default scheme in place of one-sided differences"
        noticed(what, topic.test_order, scheme=ALL[-1])
