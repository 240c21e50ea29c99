"""Two pantographs below each shipped line

Two pantographs below every shipped line, at the spacing that is asked for at its speed (TSI ENE
4.2.13: 200 m from 250 km/h, 85 m above 120, 15 m above 80, 8 m below) and 100 m apart, against the
limit as in Random lines. Pantograph, speed and force are those of the scenario of the line, the
solver is left to the default. The trailing pantograph meets what the leading one has stirred up: it
shows errors of waves and of point forces that a single one hides.
"""

from typing import Any

import pytest

from tests.support.against_limit import compare
from tests.support.limit_rows import record
from tests.support.pairs import EQUAL, LINES, OWN, pair_below

ASKED: dict[str, Any] = {}


@pytest.mark.evidence
@pytest.mark.parametrize("where", [OWN, EQUAL])
@pytest.mark.parametrize("line", LINES)
def test_pair(evidence: Any, line: str, where: str) -> None:
    record(evidence, f"{line}, {where}", compare(pair_below(line, where), ASKED))
