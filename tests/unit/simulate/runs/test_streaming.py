"""A record written during the run is the record written at its end, bit for bit."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray

import arcless
from arcless.errors import ModelError, ResultFormatError
from arcless.figures.description import Curve, Map
from arcless.simulate import is_long
from arcless.simulate.runs import job

SHORT = Path(__file__).parents[3] / "interface" / "data" / "short.yaml"
TRAVEL = {
    "travel.start": "60 m",
    "travel.end": "260 m",
    "analysis.from": "80 m",
    "analysis.to": "240 m",
}
# The clock, and what follows from it.
OF_ITS_OWN = {"created", "wall_time_s", "setup_time_s", "real_time_factor"}
KINDS: dict[str, dict[str, Any]] = {
    "as it is": {},
    "near the pantographs": {"output.around": "60 m"},
    "rows that do not meet the pieces": {
        "output.contact_every": 70,
        "output.line_every": 3,
        "output.energy": "always",
        "analysis.low_pass": "2 Hz",
        "analysis.band_split": "1 Hz",
    },
    "no droppers, but points": {
        "output.droppers": False,
        "output.supports": False,
        "output.points": [120.0, 130.0],
    },
}


@pytest.fixture(autouse=True)
def small_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(job, "PIECE", 10_000)


def check_same(one: xarray.Dataset, other: xarray.Dataset) -> None:
    assert set(one.variables) == set(other.variables)
    for name, variable in one.variables.items():
        of = other[name]
        assert (variable.dims, variable.dtype, variable.attrs) == (of.dims, of.dtype, of.attrs)
        assert variable.values.tobytes() == of.values.tobytes(), name
    kept = [{n: v for n, v in d.attrs.items() if n not in OF_ITS_OWN} for d in (one, other)]
    assert kept[0] == kept[1]
    assert one.attrs.keys() == other.attrs.keys()


@pytest.mark.parametrize("kind", KINDS)
def test_streamed_is_whole(kind: str, tmp_path: Path) -> None:
    scenario = arcless.load(SHORT).with_(**TRAVEL, **KINDS[kind])
    whole, streamed = tmp_path / "whole.nc", tmp_path / "streamed.nc"
    arcless.run(scenario).save(whole)
    result = arcless.run(scenario, to=streamed)
    check_same(arcless.open(whole).dataset, result.dataset)
    check_same(arcless.open(streamed).dataset, result.dataset)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["streamed.nc", "whole.nc"]


@pytest.mark.parametrize("kind", ["as it is", "near the pantographs"])
def test_streamed_in_parts_is_whole(kind: str, tmp_path: Path) -> None:
    scenario = arcless.load(SHORT).with_(**TRAVEL, **KINDS[kind])
    whole, parts = tmp_path / "whole.nc", tmp_path / "parts.nc"
    arcless.run(scenario).save(whole)
    begun = arcless.run(scenario, until="2 s", to=parts)
    assert not begun.is_complete
    ended = arcless.resume(begun, to=parts)
    check_same(arcless.open(whole).dataset, ended.dataset)


def test_no_more_than_a_piece_is_held(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from arcless.simulate.runs import streaming

    taken: list[int] = []
    take = streaming.Stream.take

    def count(stream: Any, raw: dict[str, Any]) -> None:
        taken.append(sum(np.size(values) for values in raw.values()))
        take(stream, raw)

    monkeypatch.setattr(streaming.Stream, "take", count)
    arcless.run(arcless.load(SHORT).with_(**TRAVEL), to=tmp_path / "x.nc")
    assert len(taken) > 3
    # A piece ends where the observer is called: less than 256 steps of 20 numbers later.
    assert max(taken[:-1]) < 10_000 + 256 * 40


def test_what_fails_leaves_nothing(tmp_path: Path) -> None:
    scenario = arcless.load(SHORT).with_(**TRAVEL)
    asked = iter([False] * 6 + [True] * 100)
    (tmp_path / "older.nc").write_bytes(b"an older result")
    with pytest.raises(KeyboardInterrupt):
        arcless.run(scenario, to=tmp_path / "older.nc", cancel=lambda: next(asked))
    with pytest.raises(arcless.OutputError, match="cannot be written"):
        arcless.run(scenario, to=tmp_path / "no folder" / "x.nc")
    assert [path.name for path in tmp_path.iterdir()] == ["older.nc"]
    assert (tmp_path / "older.nc").read_bytes() == b"an older result"


def test_a_value_that_is_not_finite_is_named(tmp_path: Path, monkeypatch: Any) -> None:
    from arcless.simulate.recording import record

    series = record.series

    def spoilt(*given: Any, **options: Any) -> dict[str, Any]:
        found = series(*given, **options)
        found["speed"][-1] = np.nan
        return found

    monkeypatch.setattr(record, "series", spoilt)
    with pytest.raises(ResultFormatError, match="speed at time"):
        arcless.run(arcless.load(SHORT).with_(**TRAVEL), to=tmp_path / "x.nc")
    assert list(tmp_path.iterdir()) == []


def test_long_is_what_takes_many_steps() -> None:
    short = arcless.load(SHORT)
    assert not is_long(short)
    assert is_long(short.with_(**{"solver.time_step": "0.02 ms"}))


def test_passages_are_those_of_the_whole_record() -> None:
    scenario = arcless.load(SHORT).with_(**TRAVEL)
    whole = arcless.run(scenario)
    near = arcless.run(scenario.with_(**{"output.around": "60 m"}))
    assert "dropper_force" not in near.dataset
    for place, name in (("dropper", "span 3 dropper 2"), ("support", "support 4")):
        everything, cut = whole.passage(place, name), near.passage(place, name)
        assert 50 < cut.size < everything.size
        assert (cut == everything.sel(line_time=cut["line_time"])).all()
        assert cut.attrs == everything.attrs
    # Passages hold the moments when the pantograph is there.
    x = float(near.dataset["support_x"][3])
    there = np.interp(x, near.dataset["position"][:, 0], near.dataset["time"])
    times = near.passage("support", "support 4")["line_time"]
    assert float(times[0]) < there - 1.0 < there + 1.0 < float(times[-1])
    with pytest.raises(ModelError, match="unknown dropper"):
        near.passage("dropper", "span 99 dropper 1")
    assert near.assessment.to_dict()["criteria"] == whole.assessment.to_dict()["criteria"]


def test_report_of_a_long_line_draws_the_same_passages() -> None:
    from arcless.figures.run import response
    from arcless.figures.run.run_data import RunData

    scenario = arcless.load(SHORT).with_(**TRAVEL)
    drawn = []
    # What is drawn reaches 200 m behind: so does what is recorded, here.
    for around in ("whole line", "200 m"):
        result = arcless.run(scenario.with_(**{"output.around": around}))
        run = RunData(result.dataset, result.assessment)
        (passages,), (droppers,) = response.uplift_passages(run), response.dropper_map(run)
        curves = [layer for layer in passages.layers if isinstance(layer, Curve)]
        grids = [layer for layer in droppers.layers if isinstance(layer, Map)]
        drawn.append([curve.y for curve in curves] + [grid.values for grid in grids])
    assert len(drawn[0]) >= 2
    for whole, near in zip(*drawn, strict=True):
        np.testing.assert_array_equal(whole, near)
