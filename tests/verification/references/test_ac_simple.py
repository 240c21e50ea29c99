"""AC simple at 275 and 320 km/h against remembered ranges

Ranges remembered as those of EN 50318:2018 for its case AC simple (mark C*: unverified; the
standard was not read, nor is it certain that this line is its line). Agreement is encouraging and
no conformity, disagreement no failure. Nothing in the model was changed to meet them.

Asked as `en50318-ac-simple-275` and `-320`, the line in space, and as their planar forms. The mean
force is the one asked for: that is the search for the static force, not the model. A value more
than a whole range beside its range would be another problem (a wrong unit, a lost filter) and
fails.
"""

from collections.abc import Callable

import pytest

from arcless.results import Result
from arcless.validate import CASES
from tests.support import published
from tests.support.evidence import Evidence

RunOnce = Callable[..., Result]
NAMED = {case.scenario: case for case in CASES if "ac-simple" in case.scenario}


@pytest.mark.parametrize("name", NAMED)
def test_ranges(evidence: Evidence, run_once: RunOnce, name: str) -> None:
    case = NAMED[name]
    source = "remembered as EN 50318:2018; not read"
    rows = published.rows(evidence, case, run_once(name), source)
    assert len(rows) == 9
    for row in rows:
        assert row.value is not None
        assert row.low is not None
        assert row.high is not None
        room = row.high - row.low
        assert row.low - room <= row.value <= row.high + room, row


@pytest.mark.parametrize("name", NAMED)
def test_mean_force(evidence: Evidence, run_once: RunOnce, name: str) -> None:
    result = run_once(name)
    asked = result.scenario.pantographs[0].mean_force
    assert asked is not None
    evidence.close(
        f"{NAMED[name].title}: mean force against the one asked for",
        result.assessment.pantographs[0].mean_force_N,
        asked,
        unit="N",
        absolute=0.02,
        reason="the tolerance that the search for the static force documents",
    )
