"""Space–time answers: any part and size, what is told of it, wrong questions."""

import json

import numpy as np
import pytest

from arcless.dataset.netcdf.store import save
from arcless.figures.wires.wire_velocity import WireMotion
from arcless.studio.answers.answers import Refused
from arcless.studio.charts import charted_run, space_time
from arcless.studio.charts.charted_run import ChartedRun
from tests.support.synthetic import synthetic_dataset

VELOCITY = 0.25  # m/s, everywhere


@pytest.fixture
def run(tmp_path, monkeypatch: pytest.MonkeyPatch) -> ChartedRun:
    """A run whose wire rises at one velocity around the pantograph, which runs at 20 m/s."""
    x, t = np.arange(0.0, 601.0), np.arange(0.0, 30.0, 0.02)
    first = np.clip((20.0 * t - 50.0).astype(int), 0, 500)
    up = (VELOCITY * t[:, None] + np.zeros(101)).astype(np.float32)
    monkeypatch.setattr(charted_run, "contact_wires", lambda _: [WireMotion(t, x, first, up)])
    save(synthetic_dataset(), tmp_path / "result.nc")
    return ChartedRun(tmp_path / "result.nc")


def asked(run: ChartedRun, **question: object) -> tuple[np.ndarray, dict]:
    found = space_time.answer(run, question)
    about = json.loads(found.headers["X-About"])
    values = np.frombuffer(bytes(found.body), "<f4")
    return values.reshape(about["rows"], about["columns"]), about


def test_all_of_it_without_a_part(run: ChartedRun) -> None:
    values, about = asked(run)
    assert about["x"] == [0.0, 600.0]
    assert values.shape[0] <= 400
    assert values.shape[1] <= 600
    known = values[np.isfinite(values)]
    # Differences of singles of up to 7.5 m: 5e-7 m over 40 ms, in means of several.
    np.testing.assert_allclose(known, VELOCITY, atol=2e-5)
    assert about["wave_speed"] == pytest.approx(100.0)
    (path,) = about["paths"]
    assert path["name"] == "path of P1"


@pytest.mark.parametrize(("width", "height"), [(1, 1), (37, 53), (2400, 1600)])
def test_any_size_is_answered_with_no_more_cells(run: ChartedRun, width: int, height: int) -> None:
    part = {"x0": 200.0, "x1": 300.0, "from": 10.0, "to": 15.0}
    values, about = asked(run, **part, width=width, height=height)
    assert values.shape[1] == min(width, 100)  # nodes are 1 m apart
    assert values.shape[0] == min(height, 250)  # rows are 20 ms apart
    assert about["x"] == [200.0, 300.0]
    assert all(200.0 <= front[0] <= 300.0 for front in about["fronts"])


def test_fronts_stay_where_something_was_recorded(run: ChartedRun) -> None:
    _, about = asked(run)
    for x0, t0, x1, t1 in about["fronts"]:
        assert abs(x1 - x0) == pytest.approx(100.0 * (t1 - t0), rel=1e-9)
        # The window has 100 m, and a cell is 2 m wide.
        begin = max(20.0 * t1 - 50.0, 0.0)
        assert begin - 3.0 <= x1 <= begin + 103.0


@pytest.mark.parametrize(
    "question",
    [
        {"x0": 10.0, "x1": 10.0},
        {"from": 5.0, "to": 4.0},
        {"width": 0},
        {"height": 1e9},
        {"x0": "many"},
        {"x1": float("nan")},
    ],
)
def test_wrong_parts_are_refused(run: ChartedRun, question: dict) -> None:
    with pytest.raises(Refused):
        space_time.answer(run, question)


def test_a_part_where_nothing_was_recorded_is_empty(run: ChartedRun) -> None:
    values, about = asked(run, x0=500.0, x1=600.0, **{"from": 1.0, "to": 2.0})
    assert not np.isfinite(values).any()
    assert about["scale_end"] > 0.0
    assert about["fronts"] == []
