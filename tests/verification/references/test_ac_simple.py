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
from functools import wraps
from unittest.mock import patch

import pytest

from arcless.assess import statistics
from arcless.results import Result
from arcless.simulate.runs import job, mean_force
from arcless.validate import CASES
from tests.support import fresh, published
from tests.support.evidence import Evidence
from tests.support.faults import Fault

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


@wraps(test_ranges)
def assessed_anew(evidence: Evidence, run_once: RunOnce, name: str) -> None:
    known = run_once(name)
    test_ranges(evidence, lambda _: Result(known.dataset, known.scenario), name)


FAULTS = [
    Fault("the 20 Hz filter left out",
          patch.object(statistics, "low_pass", lambda signal, *_: signal), assessed_anew,
          name="en50318-ac-simple-275"),
    # A coarse copy would have told the force before.
    Fault("search for the static force stops at 1 N",
          [patch.object(job, "coarse", lambda _: None), patch.object(mean_force, "TOLERANCE", 1.0)],
          test_mean_force, run_once=fresh.run, name="en50318-ac-simple-320"),
]  # fmt: skip
