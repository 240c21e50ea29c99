"""What the comparison with Drake notices."""

from tests.support.lcp_faults import complementarity, noticed_slips
from tests.verification.peers import test_lcp_drake as checked


def test_slips(noticed) -> None:
    noticed_slips(noticed, checked)


def test_a_changed_problem(noticed) -> None:
    with complementarity(lambda H, w: (H * (1.0 + 1e-9), w)):
        check = checked.test_same_forces_where_drake_changes_the_problem
        noticed("H off by 1e-9", check)
