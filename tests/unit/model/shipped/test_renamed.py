"""Scenarios of earlier names: they still load, and say what they are called now."""

import pytest

from arcless.model import ModelRenamed, library, load, load_any
from arcless.model.shipped.library import RENAMED, shipped


@pytest.mark.parametrize("old", sorted(RENAMED["scenario"]))
def test_an_earlier_name_loads_the_same_scenario_and_says_so(old: str) -> None:
    new = RENAMED["scenario"][old]
    with pytest.warns(ModelRenamed, match=f"{old} is now called {new}"):
        found = load(old)
    assert found == load(new)
    assert found.name == new
    with pytest.warns(ModelRenamed):
        assert load_any(old) == found


def test_the_library_lists_new_names_alone() -> None:
    names = {entry.name for entry in library()}
    for kind, renamed in RENAMED.items():
        assert not names & set(renamed)
        assert set(renamed.values()) <= set(shipped(kind))


def test_the_case_is_a_line_in_space_and_its_planar_form_stands_beside_it() -> None:
    for speed in (275, 320):
        assert load(f"en50318-ac-simple-{speed}").line.name == "ac-simple-55-3d"
        assert load(f"en50318-ac-simple-{speed}-planar").line.name == "ac-simple-55"
