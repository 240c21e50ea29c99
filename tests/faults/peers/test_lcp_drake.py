"""What the comparison with Drake notices."""

from tests.support.lcp_faults import complementarity
from tests.verification.peers import test_lcp_drake as checked


def test_transposed(noticed) -> None:
    with complementarity(lambda H, w: (H.T, w)):
        noticed("rows and columns of H exchanged", checked.test_same_forces, name="skew")


def test_stale_column(noticed) -> None:
    def stale(H, w):
        H = H.copy()
        H[:, 0] *= 1.0 + 1e-9  # a contact moved on, its column did not quite
        return H, w

    with complementarity(stale):
        noticed("first column of H off by 1e-9", checked.test_same_forces, name="definite")


def test_gap_forgotten(noticed) -> None:
    with complementarity(lambda H, w: (H, w - 1e-12)):
        noticed("gaps 1e-12 m too small", checked.test_same_forces_in_a_run)


def test_no_complementarity(noticed) -> None:
    with complementarity(lambda H, w: (H, w), lambda x: x + 1e-6):
        noticed("forces 1 µN too large", checked.test_same_forces, name="ring")


def test_a_changed_problem(noticed) -> None:
    with complementarity(lambda H, w: (H * (1.0 + 1e-9), w)):
        check = checked.test_same_forces_where_drake_changes_the_problem
        noticed("H off by 1e-9", check)
