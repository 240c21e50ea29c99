"""What the comparison with a run of Exudyn notices."""

from unittest.mock import patch

from arcless.simulate.setup import trajectory
from tests.support.faults import scaled
from tests.verification.peers import test_exudyn_run as checked

check = checked.test_force_over_half_a_span


def test_half_the_damping(noticed) -> None:
    with scaled("wires", "beta", 0.5):
        noticed("β of the wires halved", check)


def test_droppers_without_damping(noticed) -> None:
    with scaled("links", "beta", 0.0):
        noticed("droppers without damping", check)


def test_softer_contact(noticed) -> None:
    with patch.object(
        trajectory, "contact_stiffness", lambda scenario: 0.8 * scenario.contact.stiffness
    ):
        noticed("contact 20 % too soft", check)
