"""What the comparison with QuantEcon notices."""

from tests.support.lcp_faults import noticed_slips
from tests.verification.peers import test_lcp_quantecon as checked


def test_slips(noticed) -> None:
    noticed_slips(noticed, checked)
