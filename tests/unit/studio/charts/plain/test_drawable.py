"""Figures as plain data: the same numbers, thinned where they are many, in the range asked for."""

import json
from base64 import b64decode

import numpy as np
import pytest

from arcless.assess import assess
from arcless.figures.description import Axis, Curve, Figure, Map, Points, Scale, Tip
from arcless.figures.run import figures
from arcless.figures.run.run_data import RunData
from arcless.studio.charts.plain.drawable import Shown, drawable, packed
from arcless.studio.charts.plain.pyramid import Pyramid
from tests.support.synthetic import synthetic_dataset

X = Axis("position along the track", "m")
Y = Axis("contact force", "N")
ALL = Shown()


def unpacked(text: str) -> np.ndarray:
    return np.frombuffer(b64decode(text), dtype="<f4")


def curve_of(curve: Curve, shown: Shown = ALL) -> dict:
    told = drawable(Figure("k", "title", X, Y, [curve]), shown, Pyramid.of)
    return told["layers"][0]


def test_numbers_are_little_endian_singles() -> None:
    assert b64decode(packed(np.array([1.0, np.nan]))) == np.array([1.0, np.nan], "<f4").tobytes()


def test_a_peak_of_one_sample_survives_thinning() -> None:
    x = np.linspace(0.0, 1000.0, 200_000)
    y = np.zeros_like(x)
    y[123_456] = 7.0
    told = curve_of(Curve(x, y), Shown(points=500))
    shown_x, shown_y = unpacked(told["x"]), unpacked(told["y"])
    assert told["samples"] == x.size
    assert shown_x.size <= 500
    peak = int(shown_y.argmax())
    assert shown_y[peak] == 7.0
    # A single at 1000 m is off by 1000 / 2²⁵ at most.
    assert shown_x[peak] == pytest.approx(x[123_456], abs=1000.0 / 2**25)


def test_a_range_has_its_samples_and_one_beyond_each_end() -> None:
    x = np.arange(1000.0)
    told = curve_of(Curve(x, x), Shown(100.0, 200.0))
    np.testing.assert_array_equal(unpacked(told["x"]), np.arange(99.0, 202.0))


def test_a_place_where_the_train_stands_is_found() -> None:
    x = np.concatenate([np.arange(100.0), np.full(50, 100.0), 100.0 + np.arange(100.0)])
    told = curve_of(Curve(x, x), Shown(100.0, 100.0))
    assert (unpacked(told["x"]) == 100.0).sum() == 51


def test_curves_that_go_back_are_told_as_a_whole() -> None:
    x = np.tile(np.append(np.arange(10.0), np.nan), 3)
    told = curve_of(Curve(x, x), Shown(2.0, 3.0))
    np.testing.assert_array_equal(unpacked(told["x"]), x)


def test_gaps_between_thinned_pieces_stay() -> None:
    piece = np.append(np.linspace(0.0, 1.0, 999), np.nan)
    told = curve_of(Curve(np.tile(piece, 4), np.tile(piece, 4)), Shown(points=100))
    assert np.isnan(unpacked(told["y"])).sum() == 4


def test_tips_follow_the_samples_that_are_kept() -> None:
    x = np.arange(50_000.0)
    tips = (
        Tip("force", "y", "N"),
        Tip("time", x / 50.0, "s"),
        Tip("", [f"{k}" for k in range(50_000)]),
    )
    told = curve_of(Curve(x, np.sin(x), tips=tips), Shown(points=100))
    place = unpacked(told["x"])
    np.testing.assert_allclose(
        unpacked(told["tips"][1]["values"]["numbers"]), place / 50.0, rtol=1e-6
    )
    assert told["tips"][2]["values"]["texts"] == [f"{one:.0f}" for one in place]
    assert told["tips"][0]["values"] == "y"


def test_a_map_keeps_its_shape_and_its_holes() -> None:
    values = np.array([[1.0, np.nan, 3.0], [4.0, 5.0, 6.0]])
    figure = Figure("k", "title", X, Y, [Map((0.0, 3.0), (0.0, 2.0), values)],
                    scale=Scale("density", "dB", 1.0, 6.0))  # fmt: skip
    told = drawable(figure, Shown(), Pyramid.of)
    layer = told["layers"][0]
    assert layer["shape"] == [2, 3]
    np.testing.assert_array_equal(unpacked(layer["values"]), values.astype("f4").ravel())
    assert told["scale"]["order"][0].startswith("#")


def test_points_without_values_have_none() -> None:
    told = drawable(Figure("k", "t", X, Y, [Points(np.ones(1), np.ones(1))]), Shown(), Pyramid.of)
    assert told["layers"][0]["values"] is None


@pytest.mark.parametrize("whole", [False, True])
def test_all_figures_of_a_run_are_json(whole: bool) -> None:
    dataset = synthetic_dataset()
    found = figures(RunData(dataset, assess(dataset), whole=whole))
    for figure in (one for group in found.values() for one in group):
        text = json.dumps(drawable(figure, Shown(), Pyramid.of), allow_nan=False)
        assert json.loads(text)["key"] == figure.key


def test_whole_figures_have_all_samples_of_unfiltered_channels() -> None:
    dataset = synthetic_dataset(duration_s=20.0)
    (figure,) = figures(RunData(dataset, assess(dataset), whole=True))["force"]
    longest = max(one.x.size for one in figure.layers if isinstance(one, Curve))
    assert longest == dataset.sizes["time"]
