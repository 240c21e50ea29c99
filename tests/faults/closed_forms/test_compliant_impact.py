"""What the checks of the compliant impact notice."""

from collections.abc import Callable

from tests.support.run_faults import prepared_with, rider_scaled
from tests.support.schemes import DAMPED
from tests.verification.closed_forms import test_compliant_impact as topic

Notice = Callable[..., None]


def test_compliance(noticed: Notice) -> None:
    with prepared_with(contact_stiffness=lambda stiffness: 1.01 * stiffness):
        noticed("contact 1 % stiff", topic.test_a_bounce)


def test_mass(noticed: Notice) -> None:
    with rider_scaled("mass", 1.01):
        noticed("mass 1 % high", topic.test_a_bounce)


def test_scheme_that_damps(noticed: Notice) -> None:
    with prepared_with(scheme=lambda _asked: (DAMPED.name, list(DAMPED.numbers))):
        noticed(f"{DAMPED.label} in place of the default scheme", topic.test_a_bounce)
