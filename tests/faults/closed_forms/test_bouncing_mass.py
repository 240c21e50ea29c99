"""What the checks of the bouncing mass notice."""

from collections.abc import Callable
from math import isinf

import pytest

from tests.support.run_faults import prepared_with, rider_scaled
from tests.support.schemes import PUBLISHED, Member
from tests.verification.closed_forms import test_bouncing_mass as topic

Notice = Callable[..., None]


@pytest.mark.parametrize("scheme", topic.LAWS, ids=lambda scheme: scheme.label)
def test_yielding_contact(noticed: Notice, scheme: Member) -> None:
    with prepared_with(contact_stiffness=lambda rigid: 1e9 if isinf(rigid) else rigid):
        what = f"{scheme.label}: rigid contact yields by 1 m for 1e9 N"
        noticed(what, topic.test_speed_after_a_rigid_impact, scheme=scheme)


@pytest.mark.parametrize("scheme", [s for s in topic.LAWS if s.numbers], ids=lambda s: s.label)
def test_parameter_of_the_scheme(noticed: Notice, scheme: Member) -> None:
    def other(asked: tuple[str, list[float]]) -> tuple[str, list[float]]:
        return asked[0], [asked[1][0] + 1e-6, *asked[1][1:]]

    with prepared_with(scheme=other):
        what = f"{scheme.label}: first parameter 1e-6 high"
        noticed(what, topic.test_speed_after_a_rigid_impact, scheme=scheme)


def test_mass(noticed: Notice) -> None:
    with rider_scaled("mass", 1.01):
        noticed("mass 1 % high", topic.test_bounces_end_in_equilibrium)
        noticed("mass 1 % high", topic.test_speed_after_a_rigid_impact, scheme=PUBLISHED)
