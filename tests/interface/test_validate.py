"""Reference cases: what the published ranges are, and what a value outside of one means."""

import json
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest
from typer.testing import Result

from arcless.validate import CASES, VERIFIED, cases, compare, reference

Arcless = Callable[..., Result]


def middle(case: reference.Case) -> dict[str, Any]:
    """Return an assessment with every value in the middle of its range."""
    values = {allowed.key: (allowed.low + allowed.high) / 2 for allowed in case.ranges}
    return {"pantographs": [values], "max_uplift_at_support_mm": values["max_uplift_at_support_mm"]}


@pytest.fixture
def assessed(monkeypatch: pytest.MonkeyPatch) -> dict[str, dict[str, Any]]:
    """Replace the computation: every case answers with the assessment kept here."""
    answers = {case.scenario: middle(case) for case in CASES}
    droppers = [
        {"span": span, "length_m": length}
        for span in range(1, 6)
        for length in reference.DROPPERS.lengths
    ]

    def simulated(scenario: Any, **_: object) -> Any:
        answer = answers[scenario.name]
        return SimpleNamespace(assessment=SimpleNamespace(to_dict=lambda: answer))

    statics = SimpleNamespace(to_dict=lambda: {"droppers": droppers})
    monkeypatch.setattr("arcless.simulate.run", simulated)
    monkeypatch.setattr("arcless.simulate.statics", lambda *_, **__: statics)
    monkeypatch.setattr(cases, "load", lambda name: SimpleNamespace(name=name))
    return answers


def test_verified_ranges_are_those_of_the_first_edition() -> None:
    verified = [allowed for case in CASES for allowed in case.ranges if allowed.mark == VERIFIED]
    assert len(verified) == 16
    assert all(allowed.low <= allowed.high for case in CASES for allowed in case.ranges)


def test_verdicts() -> None:
    allowed = reference.Range("mean_force_N", "mean force", "N", 110.0, 120.0, VERIFIED)
    assert [allowed.verdict(value) for value in (110.0, 120.0)] == ["inside", "inside"]
    assert [allowed.verdict(value) for value in (109.99, 120.01, None)] == ["outside"] * 3
    remembered = reference.Range("mean_force_N", "mean force", "N", 110.0, 120.0, "C*")
    assert remembered.verdict(121.0) == "outside (unverified)"


def test_all_inside_ends_with_0(arcless: Arcless, assessed: dict[str, Any]) -> None:
    done = arcless("validate", "--json")
    rows = json.loads(done.stdout)
    assert done.exit_code == 0
    assert {row["verdict"] for row in rows} == {"inside"}
    assert len(rows) == 9 + 16 + 18  # dropper lengths, EN 50318:2002, AC simple


def test_outside_of_a_verified_range_ends_with_1(
    arcless: Arcless, assessed: dict[str, Any]
) -> None:
    assessed["en50318-2002-250"]["pantographs"][0]["std_force_N"] = 31.2
    done = arcless("validate", "en50318")
    assert done.exit_code == 1
    assert "24 of 25 values are inside the verified ranges" in done.stdout


def test_outside_of_a_remembered_range_ends_with_0(
    arcless: Arcless, assessed: dict[str, Any]
) -> None:
    assessed["en50318-ac-simple-320"]["pantographs"][0]["std_force_N"] = 70.0
    done = arcless("validate")
    assert done.exit_code == 0
    assert "outside (unverified)" in done.stdout


def test_ranges_belong_to_the_unchanged_scenario() -> None:
    import arcless

    shipped = arcless.load("en50318-2002-250")
    case = cases.case_of(shipped)
    assert case is not None
    assert case.scenario == "en50318-2002-250"
    assert cases.case_of(shipped.with_(**{"output.line_every": 7})) is not None
    assert cases.case_of(shipped.with_(speed="251 km/h")) is None
    assert [row.verdict for row in compare(case, middle(case))] == ["inside"] * 8
