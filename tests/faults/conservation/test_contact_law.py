"""The checks of the contact law notice another stiffness, and a force that acts elsewhere."""

from collections.abc import Callable
from unittest.mock import patch

from tests.support.run_faults import prepared_with
from tests.verification.conservation import test_contact_law as checks

Noticed = Callable[..., None]
NEWMARK = {"name": "newmark", "beta": 0.3025, "gamma": 0.6}


def test_another_contact_stiffness(noticed: Noticed) -> None:
    with prepared_with(contact_stiffness=lambda stiffness: 1.0001 * stiffness):
        noticed("contact 0.01 % stiffer", checks.test_law, law="compliant", scheme=NEWMARK)


def test_a_rigid_contact_that_gives(noticed: Noticed) -> None:
    with prepared_with(contact_stiffness=lambda _: 1e12):
        noticed("contact of 1e12 N/m for a rigid one", checks.test_law, law="rigid", scheme=NEWMARK)


def test_stiffness_meant_for_the_end_of_the_step(noticed: Noticed) -> None:
    with patch.object(checks, "STIFFNESS", 50e3 * (1.0 + 1e-9)):
        scheme = {"name": "generalised-alpha", "spectral_radius": 0.9}
        noticed("1e-9 more stiffness expected", checks.test_law, law="compliant", scheme=scheme)
