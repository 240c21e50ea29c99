"""Spanish lines: uplift at the steady arm under two pantographs

Published for CA-200 and CA-220 with two pantographs at the highest speed: 46 and 43 mm (mark A,
S13). Spacing and pantograph of the published values are not known, so the bracket is that of one
pantograph and of pairs 80, 100 and 200 m apart.

Asked as `spain-ca-200-200` and `spain-ca-220-220`; eight runs.
"""

from collections.abc import Callable

import pytest

import arcless
from arcless.results import Result
from tests.support.evidence import Evidence

RunOnce = Callable[..., Result]
PUBLISHED = {"spain-ca-200-200": 46.0, "spain-ca-220-220": 43.0}
SPACINGS = (None, 80.0, 100.0, 200.0)


def uplift(run_once: RunOnce, scenario: str, spacing: float | None) -> float:
    """Highest uplift at a support in mm with one pantograph, or with two so far apart in m."""
    one = arcless.load(scenario).to_dict()["pantographs"][0]
    place = [one] if spacing is None else [one, {**one, "name": "P2", "distance": spacing}]
    changes = {"pantographs": place, "output": {"line_every": 1000, "droppers": False}}
    found = run_once(scenario, changes).assessment.max_uplift_at_support_mm
    assert found is not None
    return found


@pytest.mark.evidence
@pytest.mark.parametrize("scenario", PUBLISHED)
def test_published(evidence: Evidence, run_once: RunOnce, scenario: str) -> None:
    found = [uplift(run_once, scenario, spacing) for spacing in SPACINGS]
    middle, half = (max(found) + min(found)) / 2, (max(found) - min(found)) / 2
    evidence.close(
        f"middle of the uplifts found, {scenario}",
        middle,
        PUBLISHED[scenario],
        unit="mm",
        absolute=half + 0.1 * max(found),
        mark="A",
        reason="half of what the spacing makes, and 10 % for the pantograph, which is not named",
    )
