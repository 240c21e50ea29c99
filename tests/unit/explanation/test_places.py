"""Places with the largest deviations, and what stands there."""

import numpy as np
import pytest

from arcless.explanation import places
from arcless.explanation.landmarks import Landmark, Landmarks, beside
from arcless.model import load
from tests.support.synthetic import scenario_data

MARKS = Landmarks(
    (0.0, 50.0, 100.0),
    (Landmark(0.0, "support 1"), Landmark(20.0, "dropper 3", 1), Landmark(50.0, "support 2"),
     Landmark(70.0, "dropper 2", 2), Landmark(100.0, "support 3")),
    (),
    (Landmark(75.0, "span 2 dropper 3 missing", 2),),
)  # fmt: skip
X = np.linspace(0.0, 100.0, 10_001)


def bell(at: float, height: float) -> np.ndarray:
    return height * np.exp(-(((X - at) / 1.0) ** 2))


def test_excursions_have_one_extreme_each() -> None:
    found = places.excursions(np.array([1.0, 3.0, 2.0, -1.0, -4.0, 1.0]))
    assert found.tolist() == [1, 4, 5]
    assert places.excursions(np.array([2.0, 1.0])).tolist() == [0]


def test_the_worst_place_has_position_span_force_and_neighbour() -> None:
    force = 100.0 + 0.1 * np.sin(X) + bell(21.5, 40.0) - bell(70.0, 30.0)
    first, second = places.worst(MARKS, X, force, 50.0)[:2]
    assert first.position_m == pytest.approx(21.5, abs=0.05)
    assert (first.span, first.nearest, first.where) == (
        1,
        "span 1 dropper 3",
        "1.5 m after dropper 3",
    )
    assert first.force_N == pytest.approx(140.0, abs=0.2)
    assert first.deviation_N > 0.0 > second.deviation_N
    assert second.where == "at dropper 2"
    waves = places.worst(MARKS, X, np.sin(X), 50.0)
    assert len(waves) == places.WORST
    assert first.stands_out is None


def test_a_part_that_is_not_as_designed_is_named_where_it_is_near() -> None:
    force = 100.0 + bell(70.0, 30.0) - bell(20.0, 20.0) + bell(81.0, 25.0)
    near, behind, far = places.worst(MARKS, X, force, 50.0)[:3]
    assert near.as_built == "span 2 dropper 3 missing, 5.0 m after it"
    assert behind.as_built == "span 2 dropper 3 missing, 6.0 m before it"
    assert far.as_built is None


def test_one_place_stands_for_half_a_span() -> None:
    rest = bell(20.0, 30.0) - bell(24.0, 29.0) + bell(80.0, 10.0)
    found = places.irregular(MARKS, X, 100.0 + rest, rest, 50.0)
    assert [round(one.position_m) for one in found[:2]] == [20, 80]


def test_noise_does_not_stand_out_and_a_kick_does() -> None:
    random = np.random.default_rng(4)
    kernel = np.exp(-(np.linspace(-3.0, 3.0, 301) ** 2))
    outstanding = 0
    for _ in range(100):
        noise = np.convolve(random.normal(size=X.size + 300), kernel, "valid")
        outstanding += any(one.stands_out for one in places.irregular(MARKS, X, noise, noise, 50.0))
    # One of a hundred is expected; five would be beyond chance (Poisson, 0.4 %).
    assert outstanding < 5
    kicked = noise / noise.std() + bell(70.0, 8.0)
    assert places.irregular(MARKS, X, kicked, kicked, 50.0)[0].stands_out


def test_words_of_a_distance() -> None:
    assert beside(0.1, "dropper 4") == "at dropper 4"
    assert beside(-1.26, "support 3") == "1.3 m before support 3"


def test_parts_of_a_line_are_found() -> None:
    data = scenario_data(
        line__point_masses=[{"position": 120.0, "mass": 5.0, "name": "clamp"}],
        line__inserts=[
            {"position": 220.0, "length": 2.0, "mass": 8.0, "axial_stiffness": 1e7,
             "bending_stiffness": 100.0}
        ],
        as_built={
            "missing_droppers": ["span 3 dropper 1"],
            "dropper_length_errors": [{"span": 4, "dropper": 2, "length_error": -0.012}],
            "support_height_errors": [{"support": 5, "height_error": 0.02}],
            "contact_wire_wear": [{"from": 300.0, "to": 350.0, "fraction": 0.15}],
        },
    )  # fmt: skip
    marks = Landmarks.of(load(data))
    assert marks.nearest(119.0) == Landmark(120.0, "clamp")
    assert marks.nearest(221.0) == Landmark(220.0, "insert of 2 m")
    assert marks.nearest(106.0).name == "support 3"  # the dropper at 105 m is missing
    assert [one.name for one in marks.changes] == [
        "span 3 dropper 1 missing", "span 4 dropper 2 12 mm shorter", "support 5 20 mm higher",
    ]  # fmt: skip
    assert marks.stretches_at(320.0) == ["contact wire worn by 15%"]
    assert marks.span_at(-1.0) is None


def test_overlaps_are_stretches() -> None:
    import arcless

    marks = Landmarks.of(arcless.load("ac-simple-overlap-275"))
    (one,) = marks.stretches
    assert one.name == "overlap of tension lengths 1 and 2"
    assert one.end - one.begin >= 50.0
