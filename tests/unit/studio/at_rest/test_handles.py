"""Fields of the text behind droppers and supports: changed there, these and no others move."""

from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.model import edit
from arcless.studio.at_rest.bench import Bench
from arcless.studio.at_rest.question import Question

LINES = Path(arcless.__file__).parent / "models" / "lines"
# A position in m that a dropper is moved by.
AWAY = 0.25


def look(text: str, file: Path = LINES / "ac-simple-55-3d.yaml") -> Any:
    return Bench().answer(Question(file, file.parent, text, {}, frozenset({"line"}), 1))


def text_of(name: str) -> str:
    return (LINES / f"{name}.yaml").read_text("utf-8")


@pytest.mark.parametrize("name", ["ac-simple-55-3d", "norway-s25", "ac-simple-overlap"])
def test_a_dropper_moves_with_its_field(name: str) -> None:
    text = text_of(name)
    found = look(text)
    handle, dropper = found["handles"]["droppers"][7], found["line"]["droppers"][7]
    moved = f"{dropper['x_m'] - handle['from_m'] + AWAY} m"
    after = look(edit.change(text, handle["field"], moved).apply(text))
    for index, one in enumerate(found["line"]["droppers"]):
        same = found["handles"]["droppers"][index] is not None
        same = same and found["handles"]["droppers"][index]["field"] == handle["field"]
        away = after["line"]["droppers"][index]["x_m"] - one["x_m"]
        assert away == pytest.approx(AWAY if same else 0.0, abs=1e-9), one["name"]


def test_the_stagger_at_a_support_is_its_field() -> None:
    text = text_of("ac-simple-55-3d")
    found = look(text)
    field = found["handles"]["supports"][3]["field"]
    after = look(edit.change(text, field, "-0.25 m").apply(text))
    for index, handle in enumerate(found["handles"]["supports"]):
        same = handle["field"] == field
        assert same == (index % 2 == 1)
        before, now = (one["line"]["supports"][index]["stagger_m"] for one in (found, after))
        # Anchors and arms hold the stagger that is asked for.
        assert now == pytest.approx(-0.25 if same else before, abs=1e-6)


def test_hangers_and_staggers_of_overlaps_have_no_field() -> None:
    hangers = look(text_of("shinkansen-heavy-compound"))
    named = zip(hangers["line"]["droppers"], hangers["handles"]["droppers"], strict=True)
    assert all(("hanger" in dropper["name"]) == (handle is None) for dropper, handle in named)
    assert set(map(str, look(text_of("ac-simple-overlap"))["handles"]["supports"])) == {"None"}


def test_a_scenario_has_the_fields_of_a_line_that_is_written_in_it(tmp_path: Path) -> None:
    named = (LINES.parent / "scenarios" / "en50318-ac-simple-320.yaml").read_text("utf-8")
    file = tmp_path / "scenario.yaml"
    assert set(look(named, file)["handles"]["droppers"]) == {None}
    assert "line: ac-simple-55-3d" in named
    inner = "\n".join(f"  {row}" for row in text_of("ac-simple-55-3d").splitlines())
    written = look(named.replace("line: ac-simple-55-3d", f"line:\n{inner}"), file)
    assert written["handles"]["droppers"][0]["field"] == (
        "line.span_types.standard.droppers.positions.0"
    )
