"""What the comparison with QuantEcon notices."""

from tests.support.lcp_faults import notice_slips
from tests.verification.peers import test_lcp_quantecon as checked


def test_slips(noticed) -> None:
    notice_slips(noticed, checked)
