"""Variants: scenario files that name another scenario and hold what differs from it."""

import json
from pathlib import Path

import pytest

from arcless import load
from arcless.errors import ModelError
from arcless.model.load import load_any
from arcless.model.variants.variant_files import variant_text

BASE = "norway-s25-250"
HEAD = "format: arcless-scenario/1\nname: tight\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path


def written(folder: Path, text: str, name: str = "tight") -> Path:
    path = folder / f"{name}.yaml"
    path.write_text(HEAD + text, "utf-8")
    return path


def test_a_variant_is_its_base_with_fields_set(folder: Path) -> None:
    set_ = {"line.contact_wire.tension": "17 kN", "speed": "260 km/h", "pantographs.0.mass": None}
    del set_["pantographs.0.mass"]
    path = folder / "tight.yaml"
    path.write_text(variant_text("tight", BASE, set_), "utf-8")
    variant, base = load(path), load(BASE)
    assert variant.name == "tight"
    assert variant.description == base.description
    plain, expected = variant.to_dict(), base.with_(**set_).to_dict()
    for data in (plain, expected):
        for document in (data, data["line"]):
            del document["name"], document["provenance"]
    assert plain == expected
    # What stands in its file is no change of a run: folders of runs are not named by it.
    assert variant.changes == {}
    assert variant.with_(speed="200 km/h").changes == {"speed": "200 km/h"}
    assert variant.as_typed("speed") == "260 km/h"
    assert variant.line.as_typed("contact_wire.tension") == "17 kN"
    assert load_any(path).to_dict() == variant.to_dict()


def test_a_value_says_where_it_comes_from(folder: Path) -> None:
    text = (
        f"base: {BASE}\nsources: {{memo: Memo 12}}\n"
        "set:\n  line.contact_wire.tension: {value: 17 kN, mark: A, source: memo}\n"
    )
    line = load(written(folder, text)).line
    origin = line.provenance["contact_wire.tension"]
    assert (origin.mark, origin.source, origin.given) == ("A", "memo", "17 kN")
    assert line.sources["memo"] == "Memo 12"
    assert "memo" not in load(BASE).line.sources


def test_a_variant_of_a_variant_and_files_beside_it(folder: Path) -> None:
    written(folder, f"base: {BASE}\nset: {{speed: 240 km/h}}\n", "slow")
    (folder / "below").mkdir()
    line = load(BASE).line.to_dict() | {"name": "my-line"}

    (folder / "below" / "my-line.json").write_text(json.dumps(line), "utf-8")
    text = "base: ../slow.yaml\nset: {line: my-line.json, line.contact_wire.tension: 16 kN}\n"
    found = load(written(folder / "below", text))
    assert found.speed == pytest.approx(240 / 3.6, rel=1e-12)  # the rounding of a division
    assert found.line.name == "my-line"
    assert found.line.contact_wire.tension == 16e3


def test_empty_variant(folder: Path) -> None:
    assert load(written(folder, f"base: {BASE}\n")).speed == load(BASE).speed


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("base: norway-s25-25\n", 3, ("base: unknown scenario", "did you mean norway-s25-250?")),
        ("base: 3\n", 3, ("base",)),
        ("base: gone.yaml\n", None, ("no such file", "named in")),
        (f"base: {BASE}\nspeed: 3\n", 4, ("speed: unknown field",)),
        (f"base: {BASE}\nset: 3\n", 4, ("set: got 3",)),
        (f"base: {BASE}\nset:\n  speed: 200 km/h\n  line.tention: 3\n", 6, ("unknown field",)),
        (f"base: {BASE}\nset:\n  speed: 200 km\n", 5, ('speed: got "200 km"',)),
        (f"base: {BASE}\nset:\n  pantographs.0.mass: 3\n", 5, ("unknown field",)),
        (f"base: {BASE}\nset:\n  name: other\n", 5, ("name is in the variant itself",)),
        (
            f"base: {BASE}\nset:\n  speed: {{value: 200 km/h, source: memo}}\n",
            5,
            ('unknown source: got "memo"',),
        ),
        (f"base: {BASE}\nset:\n  speed: {{value: 200 km/h, sauce: memo}}\n", 5, ("sauce",)),
    ],
)
def test_mistakes(folder: Path, text: str, line: int | None, words: tuple[str, ...]) -> None:
    path = written(folder, text)
    with pytest.raises(ModelError) as raised:
        load(path)
    assert line is None or f"{path}:{line}: " in str(raised.value)
    for word in words:
        assert word in str(raised.value)


def test_tables_named_in_a_variant_stand_beside_it(folder: Path) -> None:
    (folder / "errors.csv").write_text("span,dropper,length_error mm\n1,1,5\n", "utf-8")
    path = written(folder, f"base: {BASE}\nset:\n  as_built.dropper_length_errors: errors.csv\n")
    (error,) = load(path).as_built.dropper_length_errors
    assert error.length_error == pytest.approx(0.005, rel=1e-12)  # 5 mm, rounding


def test_a_wrong_table_is_named_with_the_field_that_names_it(folder: Path) -> None:
    roof = folder / "roof.csv"
    roof.write_text("time [s],displacement [mm]\n0,0,0\n", "utf-8")
    path = written(folder, f"base: {BASE}\nset:\n  pantographs.0.roof_motion: {{file: roof.csv}}\n")
    with pytest.raises(ModelError) as raised:
        load(path)
    assert f"{roof}:2 (named in {path}:" in str(raised.value)


def test_a_circle(folder: Path) -> None:
    first = written(folder, "base: other.yaml\n")
    written(folder, "base: tight.yaml\n", "other")
    with pytest.raises(ModelError, match="recursive reference"):
        load(first)


def test_text() -> None:
    assert variant_text("a", "b.yaml", {"speed": "200 km/h", "output.motion": True}) == (
        "format: arcless-scenario/1\nname: a\nbase: b.yaml\n"
        "set:\n  speed: 200 km/h\n  output.motion: true\n"
    )
    assert variant_text("a", "b", {}) == "format: arcless-scenario/1\nname: a\nbase: b\n"
