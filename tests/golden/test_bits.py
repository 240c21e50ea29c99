"""No bit of a result changes unless it is meant to.

These digests were made by this program, so they say nothing about what is right: they tell that
something moved. Whoever means to change results keeps them anew, with the reason:
``python -m tests.golden --renew "reason"``.
"""

import pytest

from tests.golden import bits
from tests.golden.cases import IN_SPACE, PLANAR, Case, cases

# One of each kind of steps and of callers: some seconds. The others take minutes.
QUICK = {
    f"run {IN_SPACE}",
    f"run {PLANAR}, two pantographs",
    "stopped and resumed",
    "session, forces given",
    "session, matrix",
}


def _each() -> list[object]:
    return [
        pytest.param(name, case, id=name, marks=() if name in QUICK else pytest.mark.evidence)
        for name, case in cases()
    ]


@pytest.mark.parametrize(("name", "case"), _each())
def test_bits_are_those_kept(name: str, case: Case) -> None:
    kept = bits.read()
    if (reason := bits.elsewhere(kept)) is not None:
        pytest.skip(reason)
    before, now = kept["digests"][name], bits.digests(case)
    told = f"{bits.described(before, now)}; if meant: `python -m tests.golden --renew REASON`"
    assert not bits.differences(before, now), told


def test_a_changed_bit_is_noticed() -> None:
    before = bits.digests(lambda: {"force": [1.0, 2.0], "name": "a"})
    after = bits.digests(lambda: {"force": [1.0, 2.0 + 2**-51], "name": "a"})
    assert bits.differences(before, after) == ["force"]
    assert bits.differences(before, {"force": before["force"]}) == ["name"]


def test_what_differs_is_said() -> None:
    before = {"force": "a", "0 @scenario": "b", "old": "c"}
    now = {"force": "a", "0 @scenario": "x", "gap": "d"}
    said = bits.described(before, now)
    assert said == (
        "1 changed: 0 @scenario; 1 new: gap; 1 gone: old"
        " (the scenario kept with the result, no number)"
    )
    assert bits.described(before, before | {"force": "x"}) == "1 changed: force"


def test_a_refusal_has_a_digest() -> None:
    def refused() -> dict[str, object]:
        raise ValueError("no\nmore")

    assert bits.digests(refused) == {"error": "ValueError: no"}
