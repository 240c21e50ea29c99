"""What the comparison with a run of other hands notices."""

from unittest.mock import patch

import pytest

from arcless.simulate.setup import trajectory
from tests.support.faults import scaled
from tests.support.lcp_faults import complementarity
from tests.verification.peers import test_lcp_run as checked


@pytest.fixture(autouse=True)
def _own_run():
    checked.run.cache_clear()
    yield
    checked.run.cache_clear()


def test_damping_of_droppers(noticed) -> None:
    with scaled("links", "beta", 1.01):
        noticed("damping of droppers 1 % too large", checked.test_contact_force)


def test_contact_stiffness(noticed) -> None:
    with patch.object(trajectory, "contact_stiffness", lambda s: 1.0001 * s.contact.stiffness):
        noticed("contact 1e-4 too stiff", checked.test_contact_force)


def test_sign_of_the_coupling(noticed) -> None:
    def other_sign(H, w):
        H = H.copy()
        H[0, 1:] *= -1.0
        return H, w

    with complementarity(other_sign):
        noticed("droppers push the contact the wrong way", checked.test_problems_of_the_run)
