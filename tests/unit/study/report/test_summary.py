"""First screen and table of a study's report: verdicts in words, pantographs by name, ends."""

from pathlib import Path
from typing import Any

import pytest

from arcless.figures.description import Area, Curve, Points, Rules
from arcless.report.drawing.bokeh_figure import Drawing
from arcless.study import Study
from arcless.study.report import html, summary, variants
from arcless.study.report.data.judge import judge
from arcless.study.report.data.record import Record
from arcless.study.report.figures.canvas import Canvas
from arcless.study.report.figures.scatters import Scatters
from tests.support.studies import filled, filled_by

SWEEP: dict[str, Any] = {
    "variables": {"v": {"field": "speed", "values": ["150 km/h", "200 km/h", "250 km/h"]}},
    "design": {"kind": "list"},
}
RATIO = {"r": "std_force_N / mean_force_N"}


def canvas(made: Study, folder: Path) -> Canvas:
    record = Record(made, folder)
    return Canvas(record, judge(record))


def headline(folder: Path, ratios: list[float | None], **changes: Any) -> Any:
    left = iter(ratios)
    made = filled_by(folder, lambda _values: {"r": next(left)},
                     **{**SWEEP, "outputs": RATIO, **changes})  # fmt: skip
    record = Record(made, folder)
    return summary.headline(record, judge(record))


def test_the_headline_counts_and_names_the_limit_that_is_missed(tmp_path: Path) -> None:
    found = headline(tmp_path, [0.2, 0.31, 0.35])
    assert (
        found.text
        == "1 of 3 variants meets the 2 criteria that are judged; 3 other criteria are not"
    )
    assert found.state == "open"
    assert found.items[:2] == [
        "Most often not met: standard deviation σ, 2 of 3 variants.",
        "Complete: 3 of 3 variants computed.",
    ]
    assert found.items[2].startswith("Not judged, as no output has them: ")


@pytest.mark.parametrize(
    ("ratios", "text", "state"),
    [
        ([0.1, 0.2, 0.3], "All 3 variants meet", "met"),
        ([0.4, 0.5, 0.6], "0 of 3 variants meet", "missed"),
    ],
)
def test_all_and_none(tmp_path: Path, ratios: list[float | None], text: str, state: str) -> None:
    found = headline(tmp_path, ratios)
    judged = "the 2 criteria that are judged; 3 other criteria are not"
    assert (found.text, found.state) == (f"{text} {judged}", state)


@pytest.mark.parametrize(
    ("oks", "text", "rest"),
    [
        ([1.0, 1.0, None], "All 2 variants that could be judged meet", "1 of 3 could not"),
        ([1.0, 0.0, None], "1 of 2 variants that could be judged meets", "1 of 3 could not"),
        ([1.0, None, None], "The variant that could be judged meets", "2 of 3 could not"),
        ([None, None, None], "None of 3 variants could be judged", ""),
    ],
)
def test_variants_that_could_not_be_judged_are_counted_apart(
    oks: list[float | None], text: str, rest: str, tmp_path: Path
) -> None:
    left = iter(oks)
    made = filled_by(tmp_path, lambda _values: {"ok": next(left)}, **SWEEP,
                     outputs={"ok": "passed"})  # fmt: skip
    record = Record(made, tmp_path)
    found = summary.headline(record, judge(record))
    assert found.text.removesuffix(" all criteria that decide") == text
    assert found.rest == (f"{rest} be judged" if rest else "")
    assert found.state == "open"


def test_the_output_passed_tells_of_all_criteria(tmp_path: Path) -> None:
    left = iter([1.0, 0.0, None])
    made = filled_by(tmp_path, lambda _values: {"ok": next(left)}, **SWEEP,
                     outputs={"ok": "passed"})  # fmt: skip
    record = Record(made, tmp_path)
    found = summary.headline(record, judge(record))
    assert found.text == "1 of 2 variants that could be judged meets all criteria that decide"
    assert found.rest == "1 of 3 could not be judged"
    assert not any("Not known" in text for text in found.items)


def test_without_a_limit_there_is_no_verdict(tmp_path: Path) -> None:
    # On a rail there is no wave speed, and dropper forces have no limit.
    made = filled_by(tmp_path, lambda _values: {"d": 1.0}, **SWEEP, outputs={"d": "steps"})
    record = Record(made, tmp_path)
    verdicts = judge(record)
    assert [one.name for one in verdicts.items] == ["wave_speed_use"]
    page = html(made, tmp_path)
    assert "All 3 variants meet the one criterion that is judged; " in page


def test_every_label_says_of_which_pantograph(tmp_path: Path) -> None:
    outputs = {
        "std_force_N": "std_force_N", "s2": "P2.std_force_N", "worst": "worst.max_force_N",
        "gap": "P2.mean_force_N - mean_force_N", "uplift": "max_uplift_at_support_mm",
    }  # fmt: skip
    two = {"scenario": "ac-simple-320-two-pantographs", "set": {}}
    made = filled(tmp_path, **two, **SWEEP, outputs=outputs)
    headings = [one.heading for one in Record(made, tmp_path).outputs]
    assert headings == [
        "standard deviation σ, leading pantograph",
        "s2, trailing pantograph",
        "worst, worst of 2 pantographs",
        "gap, leading pantograph and trailing pantograph",
        "uplift",
    ]
    page = html(made, tmp_path)
    assert "standard deviation σ, leading pantograph over v" in page
    assert "s2, trailing pantograph over v" in page


def test_one_pantograph_needs_no_name(tmp_path: Path) -> None:
    made = filled(tmp_path, **SWEEP, outputs={"s": "std_force_N", "p": "P1.std_force_N"})
    assert [one.heading for one in Record(made, tmp_path).outputs] == ["s", "p"]


def test_the_table_marks_ends_and_verdicts(tmp_path: Path) -> None:
    left = iter([0.2, 0.31, 0.25])
    made = filled_by(tmp_path, lambda _values: {"r": next(left)}, **SWEEP, outputs=RATIO)
    found = variants.table(canvas(made, tmp_path), Drawing())
    first, second, third = found.rows.split("\n")
    assert first.endswith("<td class=m>✔ 0.20<small>lowest</small>")
    assert second.endswith("<td class=n>✘ 0.31<small>highest</small>")
    assert third.endswith("<td class=m>✔ 0.25")
    assert "✘ not met" in second
    assert [head.name for head in found.heads] == ["variant", "verdict", "v", "r"]
    assert [head.below for head in found.heads] == ["", "", "km/h", "at most 0.3"]
    assert [(one.variant, one.why) for one in found.marked] == [
        (1, "lowest r, 0.2"), (2, "highest r, 0.31")
    ]  # fmt: skip


def test_a_tolerance_stands_behind_its_limit_and_unverified_has_its_sign(tmp_path: Path) -> None:
    left = iter([180.0, 111.0, 190.0])
    made = filled_by(tmp_path, lambda _values: {"m": next(left)}, **SWEEP,
                     outputs={"m": "mean_force_N"})  # fmt: skip
    drawn = canvas(made, tmp_path)
    (shown,) = summary.ranges(drawn)
    assert shown.limit == "limit ≤ (100.6 to 130.6) + 1 N"
    assert shown.verdict == "not met: 1, unverified: 2 of 3"
    limits = [row["limit"] for row in summary.criterion_rows(drawn.verdicts)]
    assert "≤ (100.6 to 130.6) + 1 N" in limits
    first, second, third = variants.table(drawn, Drawing()).rows.split("\n")
    assert "? 180" in first
    assert "? 111" in second  # 108.8 N, and 1 N
    assert "✘ 190" in third
    assert variants.columns(drawn)[-1].below == "N, limit by variant, tolerance 1"


def test_one_variant_is_one(tmp_path: Path) -> None:
    one = {"variables": {"v": {"field": "speed", "values": ["250 km/h"]}}}
    found = headline(tmp_path, [0.2], **one)
    assert found.text.startswith("The variant meets the ")
    assert found.items[0] == "Complete: 1 of 1 variant computed."
    record = Record(filled_by(tmp_path / "b", lambda _values: {"r": 0.2}, outputs=RATIO,
                              **{**SWEEP, **one}), tmp_path / "b")  # fmt: skip
    assert dict(summary.identity(record))["Design"].endswith("; 1 variant")


def test_a_sweep_has_its_limit_and_its_verdicts(tmp_path: Path) -> None:
    left = iter([{"s": 20.0, "m": 90.0}, {"s": 40.0, "m": 100.0}, {"s": 30.0, "m": 120.0}])
    outputs = {"s": "std_force_N", "m": "mean_force_N"}
    made = filled_by(tmp_path, lambda _values: next(left), **SWEEP, outputs=outputs)
    ((_, (figure,)), *_) = Scatters(canvas(made, tmp_path)).effects()
    curves = {one.name: one for one in figure.layers if isinstance(one, Curve)}
    assert curves["limit, standard deviation σ"].y.tolist() == pytest.approx([27, 30, 36])
    points = {one.name: one for one in figure.layers if isinstance(one, Points)}
    assert set(points) == {"met, 2", "not met, 1"}
    assert points["met, 2"].shape != points["not met, 1"].shape
    assert "at most 27 to 36 N" in figure.caption


def test_a_limit_that_differs_by_variant_of_a_sample_is_told(tmp_path: Path) -> None:
    tension = {"field": "line.contact_wire.tension", "range": ["18 kN", "26 kN"]}
    force = {"field": "pantographs.0.static_force", "range": ["60 N", "90 N"]}
    made = filled_by(
        tmp_path, lambda values: {"s": 20.0, "m": values["force"]},
        variables={"tension": tension, "force": force}, design={"kind": "monte-carlo", "count": 30},
        outputs={"s": "std_force_N", "m": "mean_force_N"},
    )  # fmt: skip
    drawn = canvas(made, tmp_path)
    over_tension, over_force = drawn.record.variables
    sigma = drawn.outputs[0]
    layers, words = drawn.limits(over_tension, sigma)
    assert layers == []
    assert words[0].endswith("It differs by variant, and is not drawn.")
    # Over what it follows from it is a straight line.
    (line,), _ = drawn.limits(over_force, sigma)
    assert isinstance(line, Curve)
    assert not isinstance(line, Rules | Area)
