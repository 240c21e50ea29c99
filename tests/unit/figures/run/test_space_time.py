"""Space–time figure: velocity, paths and fronts where they belong, drawn by all libraries."""

import numpy as np
import pytest

import arcless
from arcless.assess import assess
from arcless.figures import paper
from arcless.figures.description import Curve, Map, Segments
from arcless.figures.run import space_time
from arcless.figures.run.run_data import RunData
from arcless.figures.run.space_time import COLUMNS, ROWS, WaveLine, fronts
from arcless.figures.wires.wire_motion import contact_wires
from arcless.figures.wires.wire_velocity import Grid, WireMotion, velocity_grid
from tests.support.synthetic import SPAN_M, synthetic_dataset

# Ahead of the pantograph, m: nearer the wire follows it, farther away little moves.
AHEAD_M = (30.0, 120.0)
SPEED, C = 20.0, 100.0  # m/s; the drawn wire has 10 kN and 1 kg/m


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch) -> RunData:
    """A run whose wire has one pulse that leaves 250 m at the time the pantograph is there."""
    dataset = synthetic_dataset(pantographs=("P1", "P2"), distance_m=30.0)
    x = np.arange(0.0, 601.0, 1.0)
    t = np.arange(8.0, 24.0, 0.01)
    at = x[None, :] - 250.0 - C * (t[:, None] - 250.0 / SPEED)
    up = (0.01 * np.exp(-((at / 5.0) ** 2))).astype(np.float32)
    motion = WireMotion(t, x, np.zeros(t.size, dtype=int), up)
    monkeypatch.setattr(space_time, "contact_wires", lambda _: [motion])
    return RunData(dataset, assess(dataset))


def test_without_recorded_motion_there_is_no_figure() -> None:
    dataset = synthetic_dataset()
    assert space_time.space_time(RunData(dataset, assess(dataset))) == []


def test_the_image_has_some_spans_and_is_bounded(run: RunData) -> None:
    (figure,) = space_time.space_time(run)
    grid = next(one for one in figure.layers if isinstance(one, Map))
    rows, columns = grid.values.shape
    assert rows <= ROWS
    assert columns <= COLUMNS
    assert grid.x[1] - grid.x[0] == pytest.approx(space_time.SPANS * SPAN_M)
    assert figure.scale is not None
    assert figure.scale.low == -figure.scale.high


def test_the_pulse_lies_on_the_front_that_is_drawn(run: RunData) -> None:
    (figure,) = space_time.space_time(run)
    grid = next(one for one in figure.layers if isinstance(one, Map))
    wave = next(one for one in figure.layers if one.name.startswith("wave speed"))
    assert isinstance(wave, Segments)
    starts = np.flatnonzero(np.isclose(wave.x0, 250.0) & np.isclose(wave.y0, 12.5))
    ahead = next(k for k in starts if wave.x1[k] > 250.0)
    slope = (wave.x1[ahead] - wave.x0[ahead]) / (wave.y1[ahead] - wave.y0[ahead])
    # The speed of the drawn wire, in double precision.
    assert slope == pytest.approx(C, rel=1e-12)
    # The velocity is largest 3.5 m before and behind the top of the pulse, where its slope is.
    rows, columns = grid.values.shape
    for beyond in (40.0, 90.0):
        row = int((12.5 + beyond / C - grid.y[0]) / (grid.y[1] - grid.y[0]) * rows)
        column = int(np.nanargmax(np.abs(grid.values[row])))
        place = grid.x[0] + (column + 0.5) / columns * (grid.x[1] - grid.x[0])
        assert place == pytest.approx(250.0 + beyond, abs=5.0)


def test_paths_have_the_speed_of_the_train(run: RunData) -> None:
    (figure,) = space_time.space_time(run)
    paths = [one for one in figure.layers if isinstance(one, Curve) and one.name.startswith("path")]
    assert [one.name for one in paths] == ["path of P1", "path of P2"]
    for path in paths:
        np.testing.assert_allclose(np.diff(path.x) / np.diff(path.y), SPEED, rtol=1e-6)
    # 30 m behind, at 20 m/s.
    first, second = (np.interp(300.0, one.x, one.y) for one in paths)
    assert second - first == pytest.approx(1.5, abs=1e-6)


def grid_of(known) -> Grid:
    """A grid of 100 m and 0.75 s that has velocities where a function of x and t says so."""
    x, t = np.meshgrid(np.arange(0.5, 100.0), np.arange(0.005, 0.75, 0.01))
    return Grid((0.0, 100.0), (0.0, 0.75), np.where(known(x, t), 0.1, np.nan), 0.1)


def test_fronts_end_at_the_edges() -> None:
    everywhere = grid_of(lambda x, _: x > -1.0)
    ahead, behind = fronts([WaveLine(50.0, 0.5)], 100.0, everywhere)
    # The last of 400 pieces of 0.25 s is on the edge, and belongs to no cell.
    assert ahead == pytest.approx((50.0, 0.5, 75.0, 0.75), abs=0.1)
    assert behind == pytest.approx((50.0, 0.5, 25.0, 0.75), abs=0.1)
    assert fronts([WaveLine(50.0, 1.0)], 100.0, everywhere) == []


def test_fronts_end_where_nothing_was_recorded() -> None:
    near = grid_of(lambda x, _: (x > 40.0) & (x < 70.0))
    ahead, behind = fronts([WaveLine(50.0, 0.1)], 100.0, near)
    # A cell is 1 m wide.
    assert ahead.x1 == pytest.approx(70.0, abs=1.0)
    assert behind.x1 == pytest.approx(40.0, abs=1.0)
    # One that begins elsewhere is seen from where it comes in.
    (seen,) = fronts([WaveLine(20.0, 0.1)], 100.0, near)
    assert seen.x0 == pytest.approx(40.0, abs=1.0)
    assert seen.x1 == pytest.approx(70.0, abs=1.0)


def test_a_line_as_designed_has_the_wave_speed_of_tension_and_mass(run: RunData) -> None:
    assert space_time.wave_speed(run) == pytest.approx(C)


def test_in_a_run_the_pattern_ahead_of_the_pantograph_follows_the_fronts() -> None:
    """Of cells along lines of one slope, those at the drawn speed are most alike."""
    scenario = arcless.load("en50318-ac-simple-320-planar").with_(output={"motion": True})
    result = arcless.run(scenario)
    data = result.dataset
    time, place = data["time"].values, data["position"].values[:, 0]
    begin, end = 4.0, 6.0  # s, spans 8 to 11 of 20
    x = float(np.interp(begin, time, place)), float(np.interp(end, time, place)) + AHEAD_M[1]
    grid = velocity_grid(contact_wires(data), x, (begin, end), 800, 500)
    rows, columns = grid.values.shape
    step, apart = (end - begin) / rows, (x[1] - x[0]) / columns
    at = x[0] + apart * (np.arange(columns) + 0.5)
    away = at[None, :] - np.interp(begin + step * (np.arange(rows) + 0.5), time, place)[:, None]
    # Behind the pantograph waves run both ways; ahead of it they run away.
    values = np.where((away > AHEAD_M[0]) & (away < AHEAD_M[1]), grid.values, np.nan)

    def alike(speed: float) -> float:
        lag = round(0.1 / step)
        shift = round(speed * lag * step / apart)
        one, two = values[:-lag, : columns - shift], values[lag:, shift:]
        both = np.isfinite(one) & np.isfinite(two)
        return float(np.corrcoef(one[both], two[both])[0, 1])

    speeds = np.arange(90.0, 200.0, 2.0)
    found = speeds[int(np.argmax([alike(speed) for speed in speeds]))]
    drawn = space_time.wave_speed(RunData(data, result.assessment))
    # Droppers and clamps slow waves down, bending makes short ones faster: both by some percent.
    # The messenger wire has 121.7 m/s, and the train 88.9 m/s.
    assert found == pytest.approx(drawn, rel=0.03)


def test_few_cells_are_beyond_the_scale(run: RunData) -> None:
    (figure,) = space_time.space_time(run)
    grid = next(one for one in figure.layers if isinstance(one, Map))
    known = np.abs(grid.values[np.isfinite(grid.values)])
    assert figure.scale is not None
    beyond = 100.0 * np.mean(known > figure.scale.high)
    assert beyond <= space_time.BEYOND_PERCENT


def test_the_figure_is_drawn_on_paper(run: RunData) -> None:
    pytest.importorskip("matplotlib")
    (figure,) = space_time.space_time(run)
    drawn = paper.draw(figure)
    assert len(drawn.axes[0].images) == 1
