"""A valid model survives its own plain data: through dictionaries, JSON and files."""

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from arcless.model import load, load_line
from arcless.model.shipped.library import shipped

LINE = load_line("ac-simple-55").to_dict()


@pytest.mark.parametrize("name", shipped("scenario"))
def test_shipped_scenarios(name: str, tmp_path: Path) -> None:
    scenario = load(name)
    text = json.dumps(scenario.to_dict(), allow_nan=False)
    assert load(json.loads(text)) == scenario
    path = tmp_path / "again.json"
    path.write_text(text, encoding="utf-8")
    assert load(path) == scenario


def test_json_writes_rare_characters_in_two_halves(tmp_path: Path) -> None:
    scenario = load("en50318-ac-simple-320-planar").with_(name="𨫤 line")
    text = json.dumps(scenario.to_dict())
    assert r'"\ud862\udee4 line"' in text
    path = tmp_path / "again.json"
    path.write_text(text, encoding="utf-8")
    assert load(path) == scenario


def test_provenance_is_part_of_the_data() -> None:
    data = load("en50318-ac-simple-320-planar").to_dict()
    assert data["line"]["provenance"]["contact_wire.tension"] == {
        "mark": "A",
        "source": "S1, S2",
        "note": None,
        "given": "22 kN",
    }
    assert data["line"]["sources"]["S2"].startswith("Python/C++ scripts")


def positive(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(min_value=low, max_value=high, allow_nan=False)


@st.composite
def lines(draw: st.DrawFn) -> dict[str, Any]:
    """Lines with any spans, droppers and steady arms that the format allows."""
    names = draw(
        st.lists(st.text("abc-1", min_size=1, max_size=4), min_size=1, unique=True, max_size=3)
    )
    types = {}
    for key in names:
        length = draw(positive(20, 80))
        count = draw(st.integers(0, 6))
        positions = [length * (i + 1) / (count + 1) for i in range(count)]
        kind = draw(st.sampled_from(["presag", "lengths", None]))
        values = draw(st.lists(positive(0.01, 1), min_size=count, max_size=count))
        droppers: dict[str, Any] = {"positions": positions}
        types[key] = {"length": length, "droppers": droppers | ({kind: values} if kind else {})}
    runs = draw(
        st.lists(st.tuples(st.sampled_from(names), st.integers(1, 9)), min_size=3, max_size=5)
    )
    arm = draw(
        st.one_of(
            st.builds(lambda k: {"kind": "spring", "vertical_stiffness": k}, positive(0, 1e4)),
            st.builds(lambda length: {"kind": "arm", "length": length}, positive(0.5, 3)),
        )
    )
    stagger = draw(st.lists(positive(-0.4, 0.4), min_size=1, max_size=4))
    return LINE | {
        "provenance": {},
        "span_types": types,
        "spans": [{"type": key, "count": count} for key, count in runs],
        "steady_arm": arm,
        "geometry": LINE["geometry"] | {"stagger_contact_wire": stagger},
    }


@settings(max_examples=60, deadline=None)
# Slower than 5 m/s, a long line takes more steps than are allowed.
@given(line=lines(), speed=positive(5, 65))
def test_any_valid_model(line: dict[str, Any], speed: float) -> None:
    scenario = load(
        {"name": "x", "line": line, "pantographs": [{"model": "dsa-380"}], "speed": speed}
    )
    assert load(json.loads(json.dumps(scenario.to_dict()))) == scenario
    assert scenario.with_(speed=speed).line == scenario.line
    first, last = scenario.analysis_range()
    assert 0 <= first < last <= scenario.line.total_length


def test_completion_shows_the_model_and_not_what_it_is_built_with() -> None:
    shown = dir(load("norway-s25-250"))
    assert {"line", "pantographs", "with_", "to_dict"} <= set(shown)
    assert not {"parse_obj", "from_orm", "schema_json", "construct", "model_dump"} & set(shown)
