"""What the checks of the bar against the wall notice."""

from collections.abc import Callable, Iterator

import pytest

from tests.support.run_faults import prepared_with, rider_scaled
from tests.support.schemes import PUBLISHED, generalised_alpha
from tests.verification.closed_forms import test_bar_against_wall as topic

Notice = Callable[..., None]


@pytest.fixture(autouse=True)
def _nothing_kept() -> Iterator[None]:
    """A run that was made without the fault, or with it, is not used for the other."""
    topic.finest.cache_clear()
    yield
    topic.finest.cache_clear()


@pytest.mark.parametrize("matrix", ["mass", "stiffness"])
def test_bar(noticed: Notice, matrix: str) -> None:
    with rider_scaled(matrix, 1.01):
        noticed(f"{matrix} of the bar 1 % high", topic.test_force_and_duration)


def test_mass(noticed: Notice) -> None:
    with rider_scaled("mass", 1.01):
        noticed("mass of the bar 1 % high", topic.test_impulse_and_energy)


def test_scheme_of_first_order(noticed: Notice) -> None:
    with prepared_with(scheme=lambda _asked: (PUBLISHED.name, [])):
        what = "one-sided differences in place of the member asked for"
        noticed(what, topic.test_speed_after, scheme=generalised_alpha(0.0))


def test_yielding_contact(noticed: Notice) -> None:
    with prepared_with(contact_stiffness=lambda _rigid: 1e6):
        what = "contact of 1e6 N/m in place of a rigid one"
        noticed(what, topic.test_speed_after, scheme=generalised_alpha(0.0))
