"""Reference cases: what the published ranges are, and what a value outside of one means."""

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from typer.testing import Result

from arcless.validate import (
    CASES,
    VERIFIED,
    Row,
    cases,
    compare,
    founding_paper,
    recorded,
    reference,
)
from tests.support.bokeh_pages import text_in

Arcless = Callable[..., Result]
CONCLUDED = [
    Row.of(
        founding_paper.INTERVAL,
        reference.Range("force_interval_N", "width", "N", 0.0, None, "A"),
        1.0,
    )
]


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
    monkeypatch.setattr(founding_paper, "runs", lambda *_: [])
    monkeypatch.setattr(founding_paper, "rows", lambda _: list(CONCLUDED))
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
    # dropper lengths, EN 50318:2002, AC simple, conclusions
    live = [row for row in rows if not row["note"].startswith("recorded")]
    assert len(live) == 9 + 16 + 36 + len(CONCLUDED)
    assert {row["verdict"] for row in live} == {"inside"}
    # What tests recorded of real runs says nothing about this one.
    assert len(rows) - len(live) == sum(len(topic.rows) for topic in recorded()) > 0


def test_outside_of_a_verified_range_ends_with_3(
    arcless: Arcless, assessed: dict[str, Any]
) -> None:
    assessed["en50318-2002-250"]["pantographs"][0]["std_force_N"] = 31.2
    done = arcless("validate", "en50318")
    assert done.exit_code == 3
    assert "24 of 25 values are inside the verified ranges" in done.stdout


def test_all_lists_the_recorded_evidence_and_says_that_it_is_recorded(
    arcless: Arcless, assessed: dict[str, Any]
) -> None:
    shown = " ".join(arcless("validate").stdout.split())
    topics = recorded()
    assert len(topics) > 20
    for topic in topics:
        assert topic.title.split(":")[0] in shown
    assert f"{sum(len(topic.rows) for topic in topics)} values" in shown
    assert "not computed again here" in shown
    assert "not computed again here" not in arcless("validate", "en50318").stdout


def test_outside_of_a_remembered_range_ends_with_0(
    arcless: Arcless, assessed: dict[str, Any]
) -> None:
    assessed["en50318-ac-simple-320-planar"]["pantographs"][0]["std_force_N"] = 70.0
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


def test_ranges_belong_to_the_numbers_that_stand_for_a_word() -> None:
    """Results may be of the time when elements were numbers by default."""
    import arcless

    shipped = arcless.load("en50318-ac-simple-320-planar")
    assert shipped.solver.contact_wire_element == "auto"
    taken = shipped.stepping
    numbers = {
        "contact_wire_element": taken.contact_wire_element_m,
        "messenger_wire_element": taken.messenger_wire_element_m,
        "wire_model": taken.wires,
    }
    given = shipped.with_(**{f"solver.{name}": value for name, value in numbers.items()})
    assert cases.case_of(given) == cases.case_of(shipped) is not None
    assert cases.case_of(given.with_(**{"solver.contact_wire_element": 0.2})) is None


def test_limits_as_text() -> None:
    def limit(low: float | None, high: float | None, **options: Any) -> str:
        return reference.Range("key", "label", "N", low, high, "A", **options).limit

    assert limit(110.0, 120.0) == "110 … 120"
    assert limit(31.9, 34.0) == "31.9 … 34.0"
    assert limit(1.0137, 1.0197, digits=4) == "1.014 … 1.020"
    assert (limit(2.0, None), limit(None, 2.5)) == ("≥ 2", "≤ 2.5")
    assert limit(1e-3, None, strict=True, digits=3) == "> 0.001"


def test_strict_bounds_are_not_allowed_themselves() -> None:
    allowed = reference.Range("key", "label", "N", 1.0, None, VERIFIED, strict=True)
    assert [allowed.verdict(value) for value in (1.0, 1.0001)] == ["outside", "inside"]


def test_the_conclusions_hold_and_are_reported(arcless: Arcless, tmp_path: Path) -> None:
    done = arcless("validate", "seed", "--report", "praks.html")
    assert done.exit_code == 0, done.stdout
    for words in (
        "16 of 16 values are inside",
        "located at 9 of 9 joints",
        *(f"{speed} km/h: width of the interval of" for speed in (180, 250, 340, 360)),
        "Checked: ",
        "Assumption: ",
        "G. N. Kolesnikov",
        "curves",
        "wrote praks.html",
    ):
        assert words in done.stdout, words
    page = text_in((tmp_path / "praks.html").read_text("utf-8"))
    assert "16 of 16 values are inside the verified ranges" in page
    assert page.count("holds") == 3
    for key in ("force-180", "force-250", "force-340", "force-360", "force-intervals", "gap-360"):
        assert f'id="figure-{key}"' in (tmp_path / "praks.html").read_text("utf-8"), key
    assert "Published ranges" not in page


def test_the_page_of_all_suites_counts_what_the_terminal_counts(
    arcless: Arcless, assessed: dict[str, Any], tmp_path: Path
) -> None:
    assessed["en50318-2002-250"]["pantographs"][0]["std_force_N"] = 31.2
    assessed["en50318-ac-simple-320-planar"]["pantographs"][0]["std_force_N"] = 70.0
    done = arcless("validate", "--once", "--report", "all.html")
    assert done.exit_code == 3
    page = text_in((tmp_path / "all.html").read_text("utf-8"))
    # 9 dropper lengths, 16 values of EN 50318:2002, one conclusion; 36 of AC simple.
    assert "Outside its verified range: 1 of 26 values 25 inside" in page
    assert "25 of 26 values are inside the verified ranges" in done.stdout
    assert "standard deviation σ: 31.2 N, range 26 … 31 N (outside, mark A)" in page
    assert "35 of 36 values are inside ranges that are from memory" in page
    values = sum(len(topic.rows) for topic in recorded())
    assert f"{values} values: " in page
    assert all(topic.title in page for topic in recorded())


def test_a_page_of_published_ranges_alone(
    arcless: Arcless, assessed: dict[str, Any], tmp_path: Path
) -> None:
    done = arcless("validate", "en50318", "--report", "ranges.html")
    assert done.exit_code == 0, done.stdout
    page = text_in((tmp_path / "ranges.html").read_text("utf-8"))
    assert "25 of 25 values are inside the verified ranges" in page
    assert "Founding paper" not in page
    assert "Recorded evidence" not in page


def test_a_conclusion_that_does_not_hold_ends_with_3(
    arcless: Arcless, monkeypatch: pytest.MonkeyPatch
) -> None:
    light = {"line.dropper.clamp_mass_contact_wire": 0.0}
    shipped = founding_paper.load
    monkeypatch.setattr(founding_paper, "load", lambda name: shipped(name).with_(**light))
    done = arcless("validate", "seed", "--json")
    assert done.exit_code == 3
    outside = [row for row in json.loads(done.stdout) if row["verdict"] == "outside"]
    assert {row["case"] for row in outside} == {founding_paper.GAPS}
    assert [row["quantity"][:8] for row in outside] == ["340 km/h", "360 km/h"]
    assert all(row["checked"] and "fittings" in row["assumption"] for row in outside)
