"""A line with one wrong dropper: it is where the force differs most from what repeats."""

import numpy as np
import pytest

import arcless
from arcless.explanation import PantographExplanation

# Of the section, spans 6 to 15, in places drawn once at random.
WRONG = ((6, 4), (7, 8), (9, 3), (10, 5), (11, 7), (14, 2))
KINDS = {
    "missing": lambda span, dropper: {"missing_droppers": [f"span {span} dropper {dropper}"]},
    "longer": lambda span, dropper: {
        "dropper_length_errors": [{"span": span, "dropper": dropper, "length_error": 0.02}]
    },
}
# Of twenty of each kind 18 and 19 are found (docs/guide/why-sigma.md): of six, four or less with a
# chance of 2 %, by chance alone (3 of 90 droppers) with 10⁻⁶.
LEAST = 5


def places_of(base: arcless.Scenario) -> list[float]:
    lines = zip(base.line.support_positions(), base.line.span_list(), strict=False)
    return [left + x for left, span in lines for x in span.droppers.positions]


@pytest.mark.parametrize("kind", KINDS)
def test_the_wrong_dropper_is_named(kind: str) -> None:
    base = arcless.load("en50318-ac-simple-275-planar")
    scenarios = [base.with_(as_built=KINDS[kind](*one)) for one in WRONG]
    outcomes = arcless.batch(scenarios, keep="result", workers=1)
    droppers = np.array(places_of(base))
    near, named = 0, 0
    for (span, dropper), outcome in zip(WRONG, outcomes, strict=True):
        assert outcome.result is not None, outcome.error
        (found,) = outcome.result.explain().pantographs
        own = 9 * (span - 1) + dropper - 1
        nearest = int(np.abs(droppers - found.irregular[0].position_m).argmin())
        near += abs(nearest - own) <= 1
        named += is_named(found, f"span {span} dropper {dropper} ")
    assert near >= LEAST
    assert named >= LEAST


def is_named(found: PantographExplanation, name: str) -> bool:
    """Say whether the first irregular place and the sentences name a part."""
    told = found.irregular[0].as_built or ""
    return told.startswith(name) and name in found.sentences()[1]


def test_a_sound_line_names_nothing() -> None:
    (found,) = arcless.run(arcless.load("en50318-ac-simple-275-planar")).explain().pantographs
    assert all(one.as_built is None for one in (*found.worst, *found.irregular))
