"""The check of twin wires notices when one of them is not like the other, or they are not half."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.support.run_faults import prepared_with
from tests.verification.conservation import test_twin_wires as checks

Noticed = Callable[..., None]


def test_one_dropper_softer(noticed: Noticed) -> None:
    with scaled("links", "stiffness", 0.999, rows=[20]):
        noticed("one dropper 0.1 % softer", checks.test_alike, kinematics="linearised")


def test_contacts_not_halved(noticed: Noticed) -> None:
    with prepared_with(contact_stiffness=lambda _: 25e3):
        noticed("contacts of 25 kN/m for both", checks.test_alike, kinematics="linearised")
