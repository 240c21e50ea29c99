"""Random lines for the checks: each seed can be built, is always the same, and of its kind."""

import pytest

import arcless
from tests.support import random_lines
from tests.support.random_trains import spacing


@pytest.mark.parametrize("seed", range(len(random_lines.KINDS)))
def test_a_seed_is_a_scenario_with_a_section_below_every_pantograph(seed: int) -> None:
    scenario = random_lines.scenario_of(seed)
    first, last = scenario.analysis_range()
    start, end = scenario.travel_range()
    assert start <= first < last <= end - scenario.pantographs[-1].distance
    assert last - first > 0.1 * scenario.line.total_length
    assert random_lines.data_of.__wrapped__(seed) == random_lines.data_of(seed)


def test_kinds_are_what_they_are_called() -> None:
    lines = {seed: random_lines.data_of(seed)["line"] for seed in range(len(random_lines.KINDS))}
    fields = {
        "stitched": "stitch_wire",
        "compound": "auxiliary_wire",
        "twin": "twin_contact_wires",
        "overlap": "overlap",
        "trolley": "bridle",
    }
    for seed, kind in enumerate(random_lines.KINDS):
        for word, name in fields.items():
            assert (name in lines[seed]) == kind.startswith(word)


def test_spacings_are_those_of_the_rule() -> None:
    asked = [spacing(speed / 3.6) for speed in (60, 100, 200, 249, 250, 320)]
    assert asked == [8.0, 15.0, 85.0, 85.0, 200.0, 200.0]


def test_speed_stays_below_the_wave_speed() -> None:
    for seed in range(len(random_lines.KINDS)):
        scenario: arcless.Scenario = random_lines.scenario_of(seed)
        waves = scenario.line.wave_speed
        assert waves is None or scenario.top_speed <= 0.7 * waves
