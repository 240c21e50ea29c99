"""Texts of messages: kind of a file, likely meaning, and nothing that steers a terminal."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.errors import ModelError
from arcless.model import Line, load, load_any, load_line, load_pantograph
from tests.unit.model.conftest import LINE

MODELS = Path(arcless.__file__).parent / "models"
STUDY = MODELS / "studies" / "speed-sweep.yaml"
SCENARIO = MODELS / "scenarios" / "praks-180.yaml"
A_LINE = MODELS / "lines" / "ac-simple-55.yaml"
PANTOGRAPH = MODELS / "pantographs" / "dsa-380.yaml"


@pytest.mark.parametrize(
    ("read", "file", "hint"),
    [
        (load, STUDY, f"this is a study: `arcless study run {STUDY}`"),
        (load_any, STUDY, f"this is a study: `arcless study run {STUDY}`"),
        (load, A_LINE, f"this is a line: `arcless statics {A_LINE}`"),
        (load, PANTOGRAPH, f"this is a pantograph: `arcless check {PANTOGRAPH}`"),
        (load_line, SCENARIO, f"this is a scenario: `arcless run {SCENARIO}`"),
        (arcless.study.load, SCENARIO, f"this is a scenario: `arcless run {SCENARIO}`"),
    ],
)
def test_a_file_of_another_kind(read: Callable[..., Any], file: Path, hint: str) -> None:
    with pytest.raises(ModelError) as caught:
        read(file)
    assert hint in str(caught.value)


def test_a_file_of_another_kind_that_is_named_in_one(data: dict[str, Any]) -> None:
    with pytest.raises(ModelError) as caught:
        load(data | {"line": str(PANTOGRAPH)})
    assert "hint: this is a pantograph" in str(caught.value)
    assert "arcless check" not in str(caught.value).partition("hint")[2].partition(":")[0]


@pytest.mark.parametrize(
    "call",
    [arcless.run, arcless.statics, arcless.realtime, arcless.resonance_speeds],
)
def test_a_name_where_a_model_is_taken(call: Callable[..., Any]) -> None:
    for given, hint in (
        ("praks-180", "arcless.load('praks-180') gives one"),
        (Path("a.yaml"), "arcless.load('a.yaml') gives one"),
        ({"name": "x"}, "arcless.load(…) gives one"),
        (load_line("ac-simple-55"), "a scenario names a line, pantographs and a speed"),
    ):
        if isinstance(given, Line) and call in (arcless.statics, arcless.resonance_speeds):
            continue  # a line by itself is at rest, too
        with pytest.raises(ModelError) as caught:
            call(given)
        assert "not a scenario: got " in str(caught.value)
        assert hint in str(caught.value)


def test_a_name_in_a_batch() -> None:
    with pytest.raises(ModelError, match="not a scenario"):
        arcless.batch(["praks-180"])  # type: ignore[list-item]


@pytest.mark.parametrize("text", ["a\0b", "\x1b]0;owned\x07", "a\x85b", "a\u202eb", "a\u2066b"])
def test_names_that_steer_a_terminal(data: dict[str, Any], text: str) -> None:
    pantograph = load_pantograph("dsa-380").to_dict()
    placed = data["pantographs"][0]
    for changed, field in (
        ({"name": text}, "name"),
        ({"description": text}, "description"),
        ({"pantographs": [placed | {"name": text}]}, "pantographs.0.name"),
        ({"pantographs": [{"model": pantograph | {"name": text}}]}, "pantographs.0.model.name"),
        ({"sources": {text: "a"}}, "sources"),
        ({"sources": {"a": text}}, "sources.a"),
    ):
        with pytest.raises(ModelError) as caught:
            load(data | changed)
        assert caught.value.what == f"{field}: character that does not print"
        assert str(caught.value).isprintable()


def test_a_name_has_one_line(data: dict[str, Any]) -> None:
    with pytest.raises(ModelError, match="expected a name in one line"):
        load(data | {"name": "a\nb"})
    assert load(data | {"description": "a\nb"}).description == "a\nb"


def test_names_of_fields_and_units_are_shown_as_texts(data: dict[str, Any]) -> None:
    long = "\u202ex" * 100
    with pytest.raises(ModelError) as caught:
        load(data | {"speed": f"50 {long}", long: 1})
    assert str(caught.value).isprintable()
    with pytest.raises(ModelError) as caught:
        load(data | {"speed": "50 \u200bkq"})
    assert str(caught.value).isprintable() and 'unit "?kq"' in str(caught.value)


@pytest.mark.parametrize("text", ["root:x:0:0:root\nbin:x:1:1\n", "'secret'", "12345", "true"])
def test_the_content_of_any_file_is_not_shown(text: str, tmp_path: Path) -> None:
    path = tmp_path / "passwd"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ModelError, match="not a model file: got a ") as caught:
        load_any(path)
    assert text.strip("'\n")[:5] not in str(caught.value).replace(str(path), "")


def test_an_unknown_field_names_the_group_and_few_others(refused: Callable[..., str]) -> None:
    message = refused("name: small", "name: small\nqqqq: 1")
    assert 'qqqq: unknown field: got "qqqq", expected a field of the line; hint: known: ' in message
    assert " more" in message and len(message) < 250
    assert LINE.startswith("format")


def test_an_unknown_field_of_a_part(refused: Callable[..., str]) -> None:
    message = refused("  mass: 1.08 kg/m", "  mas: 1.08 kg/m")
    assert "expected a field of messenger_wire; hint: did you mean mass?" in message
