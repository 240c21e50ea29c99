"""Verdicts on the variants of a study, from outputs, rules and scenarios."""

from pathlib import Path
from typing import Any

import pytest

from arcless.assess import MET, NOT_JUDGED, NOT_MET, NOT_MET_UNVERIFIED, TOO_CLOSE
from arcless.study.report.data.judge import judge
from arcless.study.report.data.judged import VERDICTS, Judged, Verdicts
from arcless.study.report.data.record import Record
from arcless.study.report.data.scenes import TARGET_MET_N
from tests.support.studies import filled_by

SPEEDS = {"v": {"field": "speed", "values": ["150 km/h", "250 km/h", "321 km/h"]}}
LIST = {"kind": "list"}
TWO: dict[str, Any] = {"scenario": "ac-simple-320-two-pantographs", "set": {}}
# The last digits of a limit computed here and there in another order.
EXACT = pytest.approx


def verdicts(folder: Path, outputs: dict[str, str], rows: dict[float, dict[str, Any]],
             **changes: Any) -> Verdicts:  # fmt: skip
    """Return the verdicts on made-up outputs, given by the speed in km/h."""
    made = filled_by(
        folder, lambda values: dict(rows[round(3.6 * values["v"])]),
        **{"variables": SPEEDS, "design": LIST, "outputs": outputs, **changes},
    )  # fmt: skip
    return judge(Record(made, folder))


def words(codes: Any) -> list[str]:
    return [VERDICTS[int(code)] for code in codes]


def item(found: Verdicts, name: str) -> Judged:
    (one,) = [one for one in found.items if one.name == name]
    return one


def test_a_limit_of_the_mean_force_of_each_variant(tmp_path: Path) -> None:
    rows = {150: {"s": 29.0, "m": 100.0}, 250: {"s": 31.0, "m": 100.0}, 321: {"s": 31.0, "m": 110}}
    found = verdicts(tmp_path, {"s": "std_force_N", "m": "mean_force_N"}, rows)
    sigma = item(found, "standard_deviation")
    assert sigma.limits.tolist() == EXACT([30.0, 30.0, 33.0], rel=1e-12)
    assert words(sigma.codes) == [MET, NOT_MET, MET]
    upper = item(found, "mean_force")
    # Up to 200 km/h 0.00047 v² + 90, remembered; above 0.00097 v² + 70, read.
    expected = [0.00047 * 150**2 + 90, 0.00097 * 250**2 + 70, 0.00097 * 321**2 + 70]
    assert upper.limits.tolist() == EXACT(expected, rel=1e-9)
    assert upper.sure.tolist() == [False, True, True]
    assert upper.marks == ("C", "A")
    assert words(found.codes) == [MET, NOT_MET, MET]
    assert not found.whole
    assert "statistical maximum F_m + 3σ" in found.unknown


def test_a_limit_that_is_only_remembered_decides_nothing(tmp_path: Path) -> None:
    rows = {v: {"m": 125.0} for v in (150, 250, 321)}
    found = verdicts(tmp_path, {"m": "mean_force_N"}, rows)
    assert words(item(found, "mean_force").codes) == [NOT_MET_UNVERIFIED, MET, MET]
    # At 150 km/h the scenario's speed over wave speed alone decides, and is met.
    assert words(found.codes) == [MET, MET, MET]


def test_a_mean_force_that_is_asked_for_stands_for_one_that_is_no_output(tmp_path: Path) -> None:
    limit = 0.3 * 169.3
    rows = {150: {"s": limit - 0.5}, 250: {"s": limit + 0.4 * TARGET_MET_N * 0.3},
            321: {"s": limit + 0.5}}  # fmt: skip
    found = verdicts(tmp_path, {"s": "P2.std_force_N"}, rows, **TWO)
    sigma = item(found, "standard_deviation")
    assert words(sigma.codes) == [MET, TOO_CLOSE, NOT_MET]
    assert sigma.owners == (1,)
    assert "that the scenario requires" in sigma.how
    assert "standard deviation σ (leading)" in found.unknown


def test_the_mean_force_that_is_asked_for_is_judged_itself(tmp_path: Path) -> None:
    """Its limit follows the speed of each variant, the force that is asked for does not."""
    rows = {v: {"s": 20.0} for v in (150, 250, 321)}
    found = verdicts(tmp_path, {"s": "std_force_N"}, rows, **TWO)
    upper = item(found, "mean_force")
    assert set(upper.values) == {169.3}
    assert upper.limits.tolist() == EXACT(
        [0.00047 * 150**2 + 90, 0.00097 * 250**2 + 70, 0.00097 * 321**2 + 70], rel=1e-9
    )
    assert words(upper.codes) == [NOT_MET_UNVERIFIED, NOT_MET, MET]
    assert upper.owners == (0, 1)
    assert words(found.codes) == [MET, NOT_MET, MET]
    assert not any("mean contact force" in text for text in found.unknown)
    # An output that has it is judged in its place.
    both = verdicts(
        tmp_path / "both", {"m": "mean_force_N", "n": "P2.mean_force_N"},
        {v: {"m": 100.0, "n": 100.0} for v in (150, 250, 321)}, **TWO,
    )  # fmt: skip
    assert all(one.output is not None for one in both.items if one.name == "mean_force")


def test_without_a_mean_force_there_is_no_limit(tmp_path: Path) -> None:
    found = verdicts(tmp_path, {"s": "std_force_N"}, {v: {"s": 20.0} for v in (150, 250, 321)})
    assert [one.name for one in found.items] == ["wave_speed_use"]
    assert "standard deviation σ" in found.unknown


def test_the_worst_of_pantographs_is_of_all(tmp_path: Path) -> None:
    rows = {150: {"s": 20.0}, 250: {"s": 60.0}, 321: {"s": None}}
    found = verdicts(tmp_path, {"s": "worst.std_force_N"}, rows, **TWO)
    sigma = item(found, "standard_deviation")
    assert sigma.owners == (0, 1)
    assert words(sigma.codes) == [MET, NOT_MET, NOT_JUDGED]
    assert not any("standard deviation" in text for text in found.unknown)


def test_a_share_has_the_factor_as_its_limit(tmp_path: Path) -> None:
    rows = {150: {"r": 0.29}, 250: {"r": 0.31}, 321: {"r": 0.3}}
    found = verdicts(tmp_path, {"r": "std_force_N / mean_force_N"}, rows)
    ratio = item(found, "standard_deviation")
    assert set(ratio.limits) == {0.3}
    assert words(ratio.codes) == [MET, NOT_MET, MET]
    assert ratio.unit == ""
    other = verdicts(tmp_path / "other", {"r": "std_force_N / max_force_N"}, rows)
    assert [one.name for one in other.items] == ["wave_speed_use"]


def test_limits_by_speed_and_of_uplift(tmp_path: Path) -> None:
    rows = {v: {"top": 360.0, "up": 70.0} for v in (150, 250, 321)}
    outputs = {"top": "statistical_max_N", "up": "max_uplift_at_support_mm"}
    space = {"line.design.uplift_space": "150 mm"}
    found = verdicts(tmp_path, outputs, rows, set=space)
    top = item(found, "statistical_max")
    assert top.limits.tolist() == [300.0, 350.0, 400.0]
    assert words(top.codes) == [NOT_MET, NOT_MET, MET]
    up = item(found, "uplift_space")
    assert set(up.limits) == {75.0}  # half of the space
    assert words(up.codes) == [MET] * 3


def test_the_line_of_each_variant_gives_its_limits(tmp_path: Path) -> None:
    variables = {"space": {"field": "line.design.uplift_space", "values": ["100 mm", "160 mm"]}}
    made = filled_by(tmp_path, lambda _values: {"up": 60.0}, variables=variables, design=LIST,
                     outputs={"up": "max_uplift_at_support_mm"})  # fmt: skip
    up = item(judge(Record(made, tmp_path)), "uplift_space")
    assert up.limits.tolist() == EXACT([50.0, 80.0], rel=1e-12)
    assert words(up.codes) == [NOT_MET, MET]


def test_verdicts_that_are_outputs(tmp_path: Path) -> None:
    rows = {
        150: {"ok": 1.0, "s": 1.0},
        250: {"ok": 0.0, "s": 0.0},
        321: {"ok": None, "s": None, "error": "ok: too close to tell: standard_deviation"},
    }
    outputs = {"ok": "passed", "s": "criteria.standard_deviation"}
    found = verdicts(tmp_path, outputs, rows)
    assert found.whole
    assert found.unknown == ()
    assert words(found.codes) == [MET, NOT_MET, TOO_CLOSE]
    assert words(item(found, "standard_deviation").codes) == [MET, NOT_MET, TOO_CLOSE]


def test_margins_that_are_outputs(tmp_path: Path) -> None:
    rows = {150: {"m": 4.0}, 250: {"m": -0.1}, 321: {"m": None}}
    found = verdicts(tmp_path, {"m": "criteria.statistical_max.margin"}, rows)
    margin = item(found, "statistical_max")
    assert words(margin.codes) == [MET, NOT_MET, NOT_JUDGED]
    assert (margin.unit, margin.relation) == ("N", ">=")
    assert margin.limits.tolist() == [0.0, 0.0, 0.0]
    # A number of a criterion that says nothing by itself, and a sum of verdicts, are not judged.
    for text in ("criteria.statistical_max.limit", "criteria.statistical_max * passed"):
        told = verdicts(tmp_path / text[-5:].strip("* "), {"m": text}, rows)
        assert "statistical_max" not in [one.name for one in told.items]


def test_the_mark_of_a_criterion_is_that_of_each_variant(tmp_path: Path) -> None:
    """Up to 200 km/h the limit of F_m is remembered, above it was read."""
    rows = {v: {"f": 190.0, "c": 0.0, "m": -1.0} for v in (150, 250, 321)}
    outputs = {"f": "mean_force_N", "c": "criteria.mean_force", "m": "criteria.mean_force.margin"}
    found = [one for one in verdicts(tmp_path, outputs, rows).items if one.name == "mean_force"]
    assert len(found) == 3
    for one in found:
        assert words(one.codes) == [NOT_MET_UNVERIFIED, NOT_MET, NOT_MET]
        assert one.sure.tolist() == [False, True, True]
        assert set(one.marks) == {"A", "C"}


def test_a_margin_has_the_tolerance_in_it_already(tmp_path: Path) -> None:
    rows = {150: {"m": 0.0}, 250: {"m": -0.5}, 321: {"m": 0.5}}
    found = verdicts(tmp_path, {"m": "criteria.mean_force.margin"}, rows)
    assert words(item(found, "mean_force").codes) == [MET, NOT_MET, MET]


def test_the_speed_over_the_wave_speed_needs_no_output(tmp_path: Path) -> None:
    speeds = {"v": {"field": "speed", "values": ["150 km/h", "321 km/h", "400 km/h"]}}
    rows = {v: {"h": 1.0} for v in (150, 321, 400)}
    found = verdicts(tmp_path, {"h": "max_force_N"}, rows, variables=speeds)
    use = item(found, "wave_speed_use")
    wave = (22e3 / 1.35) ** 0.5  # of the contact wire of the short line
    assert use.values.tolist() == EXACT([v / 3.6 / wave for v in (150, 321, 400)], rel=1e-12)
    assert words(found.codes) == [MET, MET, NOT_MET]


def test_the_tension_of_each_variant_gives_its_wave_speed(tmp_path: Path) -> None:
    variables = {"t": {"field": "line.contact_wire.tension", "values": ["12 kN", "22 kN"]}}
    made = filled_by(tmp_path, lambda _values: {"h": 1.0}, variables=variables, design=LIST,
                     outputs={"h": "max_force_N"})  # fmt: skip
    use = item(judge(Record(made, tmp_path)), "wave_speed_use")
    expected = [160 / 3.6 / (tension / 1.35) ** 0.5 for tension in (12e3, 22e3)]
    assert use.values.tolist() == EXACT(expected, rel=1e-12)


def test_a_profile_of_speed_has_no_one_limit(tmp_path: Path) -> None:
    profile = {"time": [0, 10], "speed": ["100 km/h", "150 km/h"]}
    variables = {"t": {"field": "line.contact_wire.tension", "values": ["20 kN", "24 kN"]}}
    made = filled_by(
        tmp_path, lambda _values: {"top": 320.0}, variables=variables, design=LIST,
        outputs={"top": "statistical_max_N"}, set={"speed_profile": profile},
    )  # fmt: skip
    assert judge(Record(made, tmp_path)).items == ()
