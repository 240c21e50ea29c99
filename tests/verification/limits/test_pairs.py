"""Two pantographs below each shipped line

Two pantographs below every shipped line, at the spacing that is asked for at its speed (TSI ENE
4.2.13: 200 m from 250 km/h, 85 m above 120, 15 m above 80, 8 m below) and 100 m apart, against the
limit as in Random lines. Pantograph, speed and force are those of the scenario of the line, the
solver is left to the default. The trailing pantograph meets what the leading one has stirred up: it
shows errors of waves and of point forces that a single one hides.
"""

from typing import Any
from unittest.mock import patch

import pytest

from tests.support.against_limit import compare
from tests.support.faults import Fault
from tests.support.limit_rows import record
from tests.support.pairs import EQUAL, LINES, OWN, pair_below

ASKED: dict[str, Any] = {}


@pytest.mark.evidence
@pytest.mark.parametrize("where", [OWN, EQUAL])
@pytest.mark.parametrize("line", LINES)
def test_pair(evidence: Any, line: str, where: str) -> None:
    record(evidence, f"{line}, {where}", compare(pair_below(line, where), ASKED))


LONG = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": 1.45,
    "solver.messenger_wire_element": 2.9,
}
FAULTS = [
    Fault(f"{line}: cubic elements of 1.45 m and 2.9 m that miss point forces",
          patch.multiple(__name__, ASKED=LONG), test_pair, line=line, where=EQUAL, slow=True)
    for line in ("ac-simple-55", "spain-ca-200-25kv")
]  # fmt: skip
