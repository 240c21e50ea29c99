"""Pantographs as far apart as the speed asks for."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import Scenario, load
from arcless.model.pantograph.spacing import tsi_spacing

KMH = 1 / 3.6
TABLE = [
    (350, 200), (250, 200), (249.9, 85), (200, 85), (120.1, 85), (120, 15), (80.1, 15), (80, 8),
    (40, 8),
]  # fmt: skip


def scenario(speed: Any = "275 km/h", **second: Any) -> Scenario:
    one = {"model": "dsa-380", "static_force": 120.0}
    given = {"speed": speed} if isinstance(speed, str) else {"speed_profile": speed}
    behind = {"distance": "tsi", **second}
    return load(
        {"name": "pair", "line": "ac-simple-55", "pantographs": [one, one | behind], **given}
    )


@pytest.mark.parametrize(("speed", "distance"), TABLE)
def test_the_table(speed: float, distance: float) -> None:
    assert tsi_spacing(speed * KMH) == distance
    assert scenario(f"{speed} km/h").pantographs[1].distance == distance


def test_it_follows_the_speed() -> None:
    pair = scenario()
    slower = pair.with_(speed="200 km/h")
    assert [p.distance for p in pair.pantographs] == [0.0, 200.0]
    assert [p.distance for p in slower.pantographs] == [0.0, 85.0]
    # A change may share what it does not touch with the scenario that it was made from.
    assert pair.pantographs[1].distance == 200.0
    assert slower.travel_range()[0] == pair.travel_range()[0] - 115.0


def test_the_word_is_what_is_kept() -> None:
    data = scenario().to_dict()
    assert data["pantographs"][1]["distance"] == "tsi"
    assert load(data) == scenario()
    changed = scenario().with_(**{"pantographs.1.distance": "100 m"})
    assert changed.pantographs[1].distance == 100.0


def test_each_counts_from_the_one_before() -> None:
    one = {"model": "dsa-380", "static_force": 120.0}
    behind = [{**one, "distance": "30 m"}, {**one, "distance": "tsi"}, {**one, "distance": "tsi"}]
    three = load({
        "name": "four", "line": "ac-simple-55", "speed": "160 km/h", "pantographs": [one, *behind],
    })  # fmt: skip
    assert [p.distance for p in three.pantographs] == [0.0, 30.0, 115.0, 200.0]


def test_of_a_profile_the_highest_speed_counts() -> None:
    profile = {"time": [0, 10], "speed": ["200 km/h", "260 km/h"]}
    assert scenario(profile).pantographs[1].distance == 200.0


def test_what_is_refused() -> None:
    with pytest.raises(ModelError, match=r"distance: got \"far\", expected a length .* or \"tsi\""):
        scenario(distance="far")
    one = {"model": "dsa-380", "static_force": 120.0, "distance": "tsi"}
    with pytest.raises(ModelError, match="got 85 m, expected 0 m for the first pantograph"):
        load({"name": "one", "line": "ac-simple-55", "speed": 50.0, "pantographs": [one]})
    with pytest.raises(ModelError, match="missing field: expected speed or speed_profile"):
        load({"name": "none", "line": "ac-simple-55", "pantographs": [{**one, "distance": 0}, one]})
