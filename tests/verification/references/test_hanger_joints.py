"""Founding paper: what its worked example (PRAKS) concludes

The text of the paper that we have (Kolesnikov & Kuvshinov, about 2009) gives conclusions and
captions, no curves. They are checked in the words in which this project states them: the contact
force changes fast where the contact passes hanger joints; its interval widens with the speed; above
300 km/h there are gaps, at 180 and 250 km/h none. How they are measured, and the limits, are ours;
the inputs that the paper does not give are assumed (page praks).

Asked as `praks-180`, `-250`, `-340`, `-360` with the paper's own method.
"""

from collections.abc import Callable
from functools import wraps

from arcless.results import Result
from arcless.validate import founding_paper
from arcless.validate.observation import observe
from tests.support import fresh
from tests.support.evidence import Evidence
from tests.support.faults import Fault

RunOnce = Callable[..., Result]
SOURCE = "conclusions read in the paper (A); limits ours"


def test_conclusions(evidence: Evidence, run_once: RunOnce) -> None:
    rows = founding_paper.rows([observe(run_once(name)) for name in founding_paper.SCENARIOS])
    assert len(rows) == 16
    for row in rows:
        assert row.value is not None
        evidence.published(
            row.quantity, row.value, row.low, row.high, unit=row.unit or "1", mark=row.mark,
            source=SOURCE,
        )  # fmt: skip
    assert all(founding_paper.held(rows).values())


# A wire of next to no weight, which no hanger's force can bend, on hangers that hold next to
# nothing and joints without mass.
NO_EFFECT = {
    "line.dropper.clamp_mass_contact_wire": 0.0,
    "line.dropper.stiffness": 36.0,
    "line.contact_wire.mass": 0.05,
}


@wraps(test_conclusions)
def without_effect(evidence: Evidence, run_once: RunOnce) -> None:
    def run(name: str, changes: object = None) -> Result:
        return fresh.run(name, NO_EFFECT) if name == "praks-360" else run_once(name, changes)

    test_conclusions(evidence, run)


FAULTS = [
    Fault("hangers that have no effect, 360 km/h", (), without_effect),
]  # fmt: skip
