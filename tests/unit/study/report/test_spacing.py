"""Worst and best spacing of two pantographs in a study: curves, sentences, where they stand."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.simulate.resonance import Band
from arcless.study.analysis.spacings import spacing_curves
from arcless.study.report import html, spacing
from arcless.study.report.data.record import Record
from arcless.study.report.paper import document
from tests.support.studies import QUICK, SHORT, filled, filled_by

SPEED = 50.0  # m/s
GAP = {"field": "pantographs.1.distance", "range": ["30 m", "220 m"], "count": 39}
OUTPUTS = {"front": "std_force_N", "behind": "P2.std_force_N"}
PERIOD = 80.0


def pair() -> dict[str, Any]:
    """Return changes that put a second pantograph on the short line."""
    from arcless.model import load

    one = load(SHORT).to_dict()["pantographs"][0]
    second = {**one, "name": "rear", "distance": 30.0}
    return {**QUICK, "line.spans": [{"type": "span", "count": 12}], "speed": SPEED,
            "pantographs": [one, second], "travel": {"start": 290.0, "end": 540.0},
            "analysis": {"from": 300.0, "to": 310.0}}  # fmt: skip


def swinging(values: dict[str, Any]) -> dict[str, Any]:
    """Return a trailing pantograph whose mean square has a period of 80 m with crests at 60 m."""
    turns = 2.0 * np.pi * (values["gap"] - 60.0) / PERIOD
    return {"front": 30.0, "behind": float(np.sqrt(2000.0 + 1500.0 * np.cos(turns)))}


def made(folder: Path, **changes: Any) -> Any:
    given = {"set": pair(), "variables": {"gap": GAP}, "outputs": OUTPUTS, **changes}
    return filled_by(folder, swinging, **given)


def test_the_report_names_the_worst_the_best_and_the_period(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    study = made(tmp_path)
    monkeypatch.setattr(spacing, "_swing", lambda _: Band(0.60, 0.62, 0.64))
    intro, told = spacing.spacing_texts(Record(study, tmp_path))
    assert "f d/v" in intro
    # √3500 N at 60, 140 and 220 m, 2.0 times 30 N; √500 N at 100 m and 180 m.
    assert told.startswith("behind is highest at 60 m with 59.2 N, 2.0 times the leading one's,")
    assert "lowest at 100 m with 22.4 N" in told
    assert "f = v/period = 0.62 Hz, and the spans of the line swing" in told  # 50/80
    assert "Its crests are at 60, 140, 220 m." in told
    assert "The worst spacing is 0.00 periods from a crest, the best one 0.50." in told
    page = html(study, tmp_path)
    assert "<h2>Spacing of pantographs</h2>" in page
    assert "highest at 60 m" in page
    titles = [one.title for one in document(Record(study, tmp_path)).sections]
    assert "Spacing of pantographs" in titles


def test_another_wave_than_the_swing_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    study = made(tmp_path)
    monkeypatch.setattr(spacing, "_swing", lambda _: Band(1.20, 1.30, 1.40))
    _, told = spacing.spacing_texts(Record(study, tmp_path))
    assert "but the spans of the line swing as one half wave each at 1.20 to 1.40 Hz" in told
    assert "another wave" in told


def test_the_band_is_that_of_the_line(tmp_path: Path) -> None:
    from arcless.simulate import resonance_speeds

    study = made(tmp_path)
    band = spacing._swing(Record(study, tmp_path))
    found = resonance_speeds(study.base).speeds
    swing = next(one for one in found if one.kind == "span of the line")
    assert band.middle == swing.frequency_Hz


def test_each_speed_has_a_curve_of_its_own(tmp_path: Path) -> None:
    speeds = {"field": "speed", "values": ["180 km/h", "90 km/h"]}
    rest = {field: value for field, value in pair().items() if field != "speed"}
    study = made(tmp_path, set=rest, variables={"gap": GAP, "v": speeds})
    record = Record(study, tmp_path)
    slow, fast = sorted(spacing_curves(study, record.done), key=lambda one: one.others["v"])
    assert (slow.others, fast.others) == ({"v": 25.0}, {"v": 50.0})
    np.testing.assert_array_equal(slow.spacings, np.linspace(30.0, 220.0, 39))
    _, *told = spacing.spacing_texts(record)
    assert [text.partition(":")[0] for text in told] == ["v 180 km/h", "v 90 km/h"]
    assert "0.62 Hz" in told[0]
    assert "0.31 Hz" in told[1]


def test_no_period_is_no_explanation(tmp_path: Path) -> None:
    noise = iter(np.random.default_rng(1).uniform(20.0, 60.0, 39))
    study = filled_by(
        tmp_path, lambda _: {"front": 30.0, "behind": float(next(noise))},
        set=pair(), variables={"gap": GAP}, outputs=OUTPUTS,
    )  # fmt: skip
    _, told = spacing.spacing_texts(Record(study, tmp_path))
    assert "No single period explains this" in told
    assert "crests" not in told


def test_few_spacings_have_a_worst_but_no_period(tmp_path: Path) -> None:
    study = made(tmp_path, variables={"gap": {**GAP, "values": ["60 m", "85 m", "100 m"]} | {
        "range": None, "count": None}})  # fmt: skip
    _, told = spacing.spacing_texts(Record(study, tmp_path))
    assert "highest at 60 m" in told
    assert "Too few spacings" in told


@pytest.mark.parametrize("outputs", [{"front": "std_force_N"}, {"behind": "P2.max_force_N"}])
def test_without_the_trailing_deviation_there_is_nothing(
    tmp_path: Path, outputs: dict[str, str]
) -> None:
    study = filled(tmp_path, set=pair(), variables={"gap": GAP}, outputs=outputs)
    assert spacing.spacing_texts(Record(study, tmp_path)) == []
    assert "Spacing of pantographs" not in html(study, tmp_path)


def test_one_pantograph_has_no_spacing(tmp_path: Path) -> None:
    study = filled(tmp_path)
    assert spacing.spacing_texts(Record(study, tmp_path)) == []
