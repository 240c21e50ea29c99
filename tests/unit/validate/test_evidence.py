"""The language of evidence, and its records."""

import math
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import pytest

from arcless.validate.evidence import Measurement, NoticedFault, Topic
from tests.support import records
from tests.support.evidence import Evidence, OutsideError
from tests.support.faults import Fault

WHY = "a reason"


def test_values_inside_are_recorded_with_their_bounds() -> None:
    found = Evidence("test_x")
    found.close("speed", 100.1, 100.0, unit="m/s", relative=0.01, reason=WHY)
    found.below("residual", 1e-10, 1e-9, unit="1", reason=WHY)
    found.within("share", 0.4, 0.0, 1.0, unit="1", reason=WHY)
    found.same("bits", compared=7, differing=0, reason=WHY)
    speed, residual, share, bits = found.rows
    assert (speed.low, speed.high) == pytest.approx((99.0, 101.0))
    assert speed.share == pytest.approx(0.1)
    assert residual.share == pytest.approx(0.1)
    assert share.share == pytest.approx(0.2)
    assert bits.share is None
    assert {row.verdict for row in found.rows} == {"inside"}


@pytest.mark.parametrize("value", [98.9, 101.1, math.nan, math.inf])
def test_values_outside_fail(value: float) -> None:
    with pytest.raises(OutsideError, match="speed"):
        Evidence().close("speed", value, 100.0, unit="m/s", relative=0.01, reason=WHY)


def test_nothing_passes_without_being_compared() -> None:
    with pytest.raises(AssertionError, match="nothing was compared"):
        Evidence().same("bits", compared=0, differing=0, reason=WHY)
    with pytest.raises(OutsideError):
        Evidence().same("bits", compared=5, differing=1, reason=WHY)


@pytest.mark.parametrize(
    "tolerances", [{}, {"relative": 0.1, "absolute": 0.1}, {"absolute": 0.0}, {"relative": 0.0}]
)
def test_a_value_has_one_tolerance_above_zero(tolerances: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="tolerance"):
        Evidence().close("speed", 1.0, 1.0, unit="m/s", reason=WHY, **tolerances)


def test_a_tolerance_has_a_reason_and_a_name_of_its_own() -> None:
    found = Evidence()
    with pytest.raises(ValueError, match="reason"):
        found.below("residual", 0.0, 1.0, unit="1", reason=" ")
    found.below("residual", 0.0, 1.0, unit="1", reason=WHY)
    with pytest.raises(ValueError, match="twice"):
        found.below("residual", 0.0, 1.0, unit="1", reason=WHY)
    with pytest.raises(ValueError, match="negative"):
        found.below("difference", -1.0, 1.0, unit="1", reason=WHY)


def test_an_order_needs_three_sizes_and_is_the_slope() -> None:
    found = Evidence()
    sizes = [1.0, 0.5, 0.25]
    found.order("second", sizes, [3 * s**2 for s in sizes], 2, tolerance=0.1, reason=WHY, unit="m")
    assert found.rows[0].value == pytest.approx(2.0)
    assert found.rows[0].table[2] == pytest.approx([0.25, 3 / 16, 2.0])
    with pytest.raises(ValueError, match="3 sizes"):
        found.order("short", [1, 2], [1, 2], 1, tolerance=0.1, reason=WHY, unit="m")
    with pytest.raises(AssertionError, match="logarithm"):
        found.order("exact", sizes, [1.0, 0.1, 0.0], 2, tolerance=0.1, reason=WHY, unit="m")
    with pytest.raises(OutsideError):
        found.order("first", sizes, sizes, 2, tolerance=0.1, reason=WHY, unit="m")


def test_a_published_range_gives_a_verdict() -> None:
    found = Evidence()
    for what, value, mark in (("a", 60.0, "A"), ("b", 40.0, "A"), ("c", 40.0, "C*")):
        found.published(what, value, 50.0, 75.0, unit="N", mark=mark, source="somewhere")
    assert [row.verdict for row in found.rows] == ["inside", "outside", "outside (unverified)"]


def measured(**changes: object) -> Measurement:
    base = {
        "what": "speed", "unit": "m/s", "value": 10.0, "reference": 10.0, "low": 9.0, "high": 11.0,
        "allowed": "± 1 m/s", "reason": WHY, "mark": "", "verdict": "inside", "test": "test_x",
    }  # fmt: skip
    return Measurement(**base | changes)


@pytest.fixture
def record(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Keep records in a folder of this test, with one of `measured`."""
    monkeypatch.setattr(records, "RECORDS", tmp_path)
    file = Path("tests/verification/closed_forms/test_speed.py")
    topic = Topic("closed_forms", "speed", "Speed", "c = 1", "0.1.0", [measured()])
    records.path_of("closed_forms", "speed").parent.mkdir()
    records.path_of("closed_forms", "speed").write_text(topic.to_json(), encoding="utf-8")
    return file


def test_a_record_equals_what_was_measured(record: Path) -> None:
    records.compare_rows(record, "test_x", [measured(value=10.09)])  # under a tenth of 1 m/s


@pytest.mark.parametrize(
    "changes",
    [
        {"value": 10.2}, {"value": math.nan}, {"reference": 10.2}, {"reason": "another"},
        {"high": 12.0}, {"high": None}, {"verdict": "outside"}, {"what": "other"},
    ],
)  # fmt: skip
def test_a_record_that_differs_is_noticed(record: Path, changes: dict[str, object]) -> None:
    with pytest.raises(AssertionError, match="make evidence"):
        records.compare_rows(record, "test_x", [measured(**changes)])


@pytest.mark.parametrize(("compared", "passes"), [(20_952, True), (24_879, True), (20_951, False)])
def test_more_numbers_may_be_compared_than_recorded(
    record: Path, monkeypatch: pytest.MonkeyPatch, compared: int, passes: bool
) -> None:
    now = measured(unit=f"of {compared} numbers")
    then = Topic("closed_forms", "speed", rows=[measured(unit="of 20952 numbers")])
    monkeypatch.setattr(records, "load", lambda *_: then)
    with nullcontext() if passes else pytest.raises(AssertionError, match="unit changed"):
        records.compare_rows(record, "test_x", [now])
    # What is written has the count of today.
    assert (records._steady([now], then.rows) == then.rows) == (compared == 20_952)


def test_records_are_written_of_whole_files() -> None:
    records.check_selection(publish=True, markers="", keywords="")
    records.check_selection(publish=False, markers="not evidence", keywords="test_x")
    for markers, keywords in (("not evidence", ""), ("", "test_x")):
        with pytest.raises(pytest.UsageError, match='run `pytest -m "" --publish FILE`'):
            records.check_selection(publish=True, markers=markers, keywords=keywords)


def test_rows_that_are_missing_or_new_are_noticed(record: Path) -> None:
    for rows in ([], [measured(), measured(what="more")]):
        with pytest.raises(AssertionError, match="not as recorded"):
            records.compare_rows(record, "test_x", rows)


def test_a_record_forgets_what_no_test_measures(record: Path) -> None:
    module = ModuleType("test_speed", "Speed")
    module.test_x = module.test_new = lambda: None  # type: ignore[attr-defined]
    found = [measured(what="new", test="test_new")]
    records.publish_rows(record, module, "test_new", found, [], tests={"test_x", "test_new"})
    known = [row.what for row in records.load("closed_forms", "speed").rows]
    assert known == ["new", "speed"]
    records.publish_rows(record, module, "test_new", found, [], tests={"test_new"})
    assert [row.what for row in records.load("closed_forms", "speed").rows] == ["new"]


def test_a_fault_is_noticed_each_time_it_is_put_in() -> None:
    entered = []

    @contextmanager
    def broken(name: str) -> Iterator[None]:
        entered.append(name)
        yield

    def check(evidence: Evidence, size: float, path: Path) -> None:
        assert path == Path("fixture of path")
        evidence.below("size", size, 1.0, unit="m", reason=WHY)

    fault = Fault("too large", [broken("one"), broken("two")], check, size=2.0)
    for _ in range(2):
        found = fault.noticed(lambda name: Path(f"fixture of {name}"))
        assert found == NoticedFault("too large", "size", "2; ≤ 1 m", "check[too large]")
    assert entered == ["one", "two"] * 2


def test_a_fault_that_a_check_does_not_notice_fails() -> None:
    def check(size: float) -> None:
        assert size > 1.0, "it is small\nand more"

    assert Fault("small", (), check, size=0.5).noticed(str).found == "it is small"
    with pytest.raises(AssertionError, match="check does not notice: none"):
        Fault("none", (), check, size=2.0).noticed(str)


def test_records_of_faults_are_in_the_order_of_their_table(record: Path) -> None:
    def check() -> None:
        """Notice nothing: this test says what was noticed."""

    faults = [Fault("mass", (), check, wire=wire) for wire in ("chain", "cubic", "bar")]
    first, second, third = (
        NoticedFault(f.what, f"row {n}", "", f.name) for n, f in enumerate(faults)
    )
    for noticed in (first, third, second, first):
        records.publish_fault(record, faults, noticed)
    topic = records.load("closed_forms", "speed")
    assert topic.faults == [first, second, third]
    records.compare_fault(record, second)
    with pytest.raises(AssertionError, match="make evidence"):
        records.compare_fault(record, replace(second, row="row 0"))
    records.publish_fault(record, faults[1:2], replace(second, found="another"))
    assert records.load("closed_forms", "speed").faults == [second]  # its tolerance is as before
    now_slow = replace(second, slow=True)
    records.publish_fault(record, faults[1:2], now_slow)
    assert records.load("closed_forms", "speed").faults == [now_slow]
