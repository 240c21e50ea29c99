"""What the comparison of pairs of pantographs with their limit notices."""

from collections.abc import Callable
from unittest.mock import patch

import pytest

from tests.support.pairs import EQUAL
from tests.verification.limits import test_pairs as topic

Noticed = Callable[..., None]
LONG = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": 1.45,
    "solver.messenger_wire_element": 2.9,
}


@pytest.mark.evidence
@pytest.mark.parametrize("line", ["ac-simple-55", "spain-ca-200-25kv"])
def test_long_cubic_elements(noticed: Noticed, line: str) -> None:
    with patch.object(topic, "ASKED", LONG):
        fault = f"{line}: cubic elements of 1.45 m and 2.9 m that miss point forces"
        noticed(fault, topic.test_pair, line=line, where=EQUAL)
