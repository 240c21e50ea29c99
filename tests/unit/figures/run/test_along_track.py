"""Figures along the track: their layers, the worst place, samples of filtered channels."""

import numpy as np
import pytest

from arcless.assess import assess
from arcless.figures.description import Curve, Figure, Points, Rules, Texts
from arcless.figures.run import along_track
from arcless.figures.run.run_data import RunData
from arcless.figures.run.track import place_name, span_at
from tests.support.synthetic import SPAN_M, synthetic_dataset

SPEED = 20.0
MEAN, PULSE = 100.0, 60.0


def run_of(**more) -> RunData:
    dataset = synthetic_dataset(**more)
    return RunData(dataset, assess(dataset))


def pulse(at_m: float, height_N: float = PULSE):
    """A force with one smooth pulse at a place, slow enough for the low-pass."""
    return lambda t: MEAN + height_N * np.exp(-(((SPEED * t - at_m) / 5.0) ** 2))


def layers_of(figure: Figure, kind: type, name: str) -> list:
    return [one for one in figure.layers if isinstance(one, kind) and one.name == name]


def test_no_share_of_the_force_with_one_contact_each() -> None:
    assert along_track.shares(run_of()) == []


def test_each_contact_has_a_figure() -> None:
    dataset = synthetic_dataset()
    name = str(dataset["pantograph"].values[0])
    labels = [f"{name} strip 1 wire 1", f"{name} strip 1 wire 2"]
    force = np.column_stack([np.full(dataset.sizes["time"], share) for share in (80.0, 40.0)])
    dataset = dataset.assign_coords(contact=labels)
    dataset["wire_contact_force"] = (("time", "contact"), force)
    figures = along_track.shares(RunData(dataset, assess(dataset)))
    for figure, label, share in zip(figures, labels, (80.0, 40.0), strict=True):
        (curve,) = layers_of(figure, Curve, label)
        # A low-pass leaves what is constant: rounding alone.
        np.testing.assert_allclose(curve.y, share, rtol=1e-9)
    assert figures[0].y == figures[1].y


def test_no_line_joins_the_end_of_one_contact_wire_to_the_next() -> None:
    dataset = synthetic_dataset()
    nodes = dataset.sizes["contact_wire_node"]
    number = np.where(np.arange(nodes) < nodes // 2, 1, 2)
    dataset["contact_wire_node_wire"] = (("contact_wire_node",), number)
    (figure,) = along_track.height(RunData(dataset, assess(dataset)))
    (rest,) = layers_of(figure, Curve, "contact wire at rest")
    gaps = np.isnan(rest.y)
    # One behind each of the two wires, and every node is there.
    assert gaps.sum() == 2
    assert gaps.size == nodes + 2
    assert gaps[nodes // 2]


def test_the_worst_place_is_that_of_the_pulse() -> None:
    run = run_of(force=pulse(312.0))
    pantograph, kind, x, force = along_track.worst(run)
    assert (pantograph, kind) == (0, "maximum")
    assert x == pytest.approx(312.0, abs=0.05)  # the train runs 0.02 m from sample to sample
    # The low-pass takes less than 0.1 % off a pulse of half a second.
    assert force == pytest.approx(MEAN + PULSE, rel=1e-3)
    assert place_name(run, x) == "312.0 m, span 7, 3.0 m before dropper 2"


def test_a_minimum_is_the_worst_place_too() -> None:
    assert along_track.worst(run_of(force=pulse(312.0, -PULSE)))[1] == "minimum"


@pytest.mark.parametrize(
    ("x", "words"),
    [
        (300.1, "300.1 m, span 7, at support 7"),
        (341.0, "341.0 m, span 7, 4.0 m before dropper 5"),
        (302.0, "302.0 m, span 7, 2.0 m after support 7"),
        (348.9, "348.9 m, span 7, 1.1 m before support 8"),
        (-3.0, "-3.0 m"),
    ],
)
def test_places_have_names(x: float, words: str) -> None:
    assert place_name(run_of(), x) == words


def test_spans_count_from_one() -> None:
    run = run_of()
    assert [span_at(run, x) for x in (0.0, 49.9, 50.0, 599.9)] == [1, 1, 2, 12]
    assert span_at(run, -1.0) is None
    assert span_at(run, 601.0) is None


def test_the_first_figure_shows_three_spans_with_limits() -> None:
    run = run_of(force=pulse(312.0, 150.0))
    (figure,) = along_track.lead(run)
    assert (figure.x.low, figure.x.high) == (250.0, 400.0)
    numbers = run.assessment.pantographs[0]
    (mean,) = layers_of(figure, Rules, "mean F_m")
    (spread,) = layers_of(figure, Rules, "F_m ± 3σ")
    assert mean.at == [numbers.mean_force_N]
    assert [*spread.at] == [numbers.statistical_min_N, numbers.statistical_max_N]
    (limit,) = layers_of(figure, Rules, "limits of F_m ± 3σ: 0 and 300 N")
    assert [*limit.at] == [0.0, 300.0]
    texts = [text for one in figure.layers if isinstance(one, Texts) for text in one.texts]
    assert {"span 6", "span 7", "span 8", "maximum 250 N"} <= {*texts}
    (peak,) = [one for one in figure.layers if isinstance(one, Points) and one.y > MEAN + 1]
    assert peak.x == pytest.approx(312.0, abs=0.05)  # from sample to sample
    assert "312.0 m, span 7" in figure.alt


def test_a_limit_far_above_the_force_is_left_out() -> None:
    (figure,) = along_track.force(run_of())  # 100 N all the time, limit 300 N
    limits = [layer for layer in figure.layers if layer.colour == "limit"]
    assert [layer.name for layer in limits] == ["limit of F_m − 3σ: 0 N"]
    assert figure.y.high < 200.0


def test_the_pantograph_with_the_worst_place_comes_first() -> None:
    dataset = synthetic_dataset(pantographs=("front", "rear"), force=pulse(312.0))
    dataset["contact_force"].values[:, 0] = MEAN
    figures = along_track.lead(RunData(dataset, assess(dataset)))
    assert [figure.title.rpartition(", ")[2] for figure in figures] == ["rear", "front"]
    assert figures[0].y == figures[1].y


def test_pantographs_have_a_figure_each_with_the_same_axes() -> None:
    figures = along_track.force(run_of(pantographs=("a", "b", "c")))
    assert [figure.key for figure in figures] == ["force-1", "force-2", "force-3"]
    assert len({figure.x.group for figure in figures}) == 1
    assert len({(figure.y.low, figure.y.high) for figure in figures}) == 1
    colours = [layers_of(f, Curve, "filtered, 0–20 Hz")[0].colour for f in figures]
    assert colours == ["pantograph_1", "pantograph_2", "pantograph_3"]


def test_filtered_channels_are_drawn_by_even_samples() -> None:
    run = run_of(force=lambda t: MEAN + 10.0 * np.sin(2.0 * np.pi * 10.0 * t))
    (figure,) = along_track.force(run)
    (curve,) = layers_of(figure, Curve, "filtered, 0–20 Hz")
    steps = np.diff(curve.x)
    np.testing.assert_allclose(steps, steps[0], rtol=1e-9)  # rounding of positions
    whole = np.interp(run.position[:, 0], curve.x, curve.y)
    left_out = np.abs(whole - run.record.bands.total[:, 0]).max()
    # Straight pieces of 1/250 s leave 1 - cos(π·10/250) = 0.79 % of a wave at 10 Hz out.
    assert left_out == pytest.approx(10.0 * 0.0079, rel=0.02)


def test_samples_of_a_long_run_still_carry_what_the_filter_lets_through() -> None:
    run = run_of(duration_s=600.0, step_s=5e-3, line_every=200, section=(1000.0, 11000.0))
    assert run.sampled is not None
    rate = 1.0 / np.diff(run.sampled[0].t).max()
    assert rate >= 2.5 * run.assessment.low_pass_Hz - 1e-6  # rounding of times


def test_a_run_too_long_for_samples_keeps_its_extremes_and_says_so() -> None:
    run = run_of(
        duration_s=3600.0, step_s=1e-2, line_every=200, section=(1000.0, 71000.0),
        force=lambda t: MEAN + PULSE * np.exp(-(((t - 1800.0) / 0.5) ** 2)),
    )  # fmt: skip
    assert run.sampled is None
    (figure,) = along_track.force(run)
    (curve,) = layers_of(figure, Curve, "filtered, 0–20 Hz")
    assert curve.y.max() == run.record.bands.total.max()
    assert curve.x.size < 10_000
    assert "extremes" in figure.caption


GAP = "Gap between contact strip and contact wire"


def test_the_gap_is_drawn_for_the_pantographs_that_lose_contact() -> None:
    assert along_track.gap(run_of()) == []
    dataset = synthetic_dataset(pantographs=("a", "b"), gap=lambda t: 1e-3 * (t > 12.0))
    dataset["contact_force"].values[:, 1] *= dataset["time"].values <= 12.0
    (figure,) = along_track.gap(RunData(dataset, assess(dataset)))
    assert figure.title == f"{GAP}, b"
    assert "1.00 mm" in figure.alt


def test_alternative_text_has_the_numbers() -> None:
    run = run_of(force=pulse(312.0))
    numbers = run.assessment.pantographs[0]
    (figure,) = along_track.lead(run)
    assert f"Mean {numbers.mean_force_N:.1f} N" in figure.alt
    assert f"deviation {numbers.std_force_N:.1f} N" in figure.alt
    assert SPAN_M == 50.0  # what the places above are written for
