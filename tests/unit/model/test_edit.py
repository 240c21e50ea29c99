"""Model files are changed in place: one value is rewritten, every other byte stays."""

import shutil
import stat
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from arcless.errors import ModelError, OutputError
from arcless.model import load, load_line
from arcless.model.edit import change, edit_file, remove, undo_in_file
from arcless.model.files.yaml_reader import parse
from arcless.model.shipped.library import FOLDER
from tests.support.hostile import searching

TEXT = """\
# top
wire:   # w
  tension: {value: 22 kN, mark: A, note: "x, y"} # t
  mass: 1.350 kg/m   # m
  flow: {a: 1, "b": '2 m', c, d: [1, 2,
     3]}  # f
  text: |
    one
    two

  empty:
  list:
    # c
    - type: a
      count: 2
    - {type: b} # bb
    - 5
    - - 1
      - 2
  block:   # bc
    x: 1

    y: 2   # yy
  anchored: &q {z: 1}
  alias: *q
  alone: &r 5 m
last: "q"
"""


@pytest.mark.parametrize(
    ("path", "value", "old", "new"),
    [
        ("wire.tension", "12 kN", "value: 22 kN", "value: 12 kN"),
        ("wire.tension.mark", "B", "mark: A", "mark: B"),
        ("wire.tension.source", "S1", '"x, y"}', '"x, y", source: S1}'),
        (
            "wire.tension",
            {"value": "3 kN"},
            '{value: 22 kN, mark: A, note: "x, y"}',
            "{value: 3 kN}",
        ),
        ("wire.mass", "1.2 kg/m", "1.350 kg/m ", "1.2 kg/m "),
        ("wire.mass", 1.25, "1.350 kg/m ", "1.25 "),
        ("wire.flow.b", "3 m", "'2 m'", "'3 m'"),
        ("wire.flow.b", "it's", "'2 m'", "'it''s'"),
        ("wire.flow.c", True, " c,", " c: true,"),
        ("wire.flow.d.2", 7.5, "     3]", "     7.5]"),
        ("wire.flow.d.3", "8 m", "     3]", "     3, 8 m]"),
        ("wire.flow.e", "x: y", "3]}", '3], e: "x: y"}'),
        ("wire.flow.e.f", 1, "3]}", "3], e: {f: 1}}"),
        ("wire.text", "new", "|\n    one\n    two\n", "new\n"),
        ("wire.empty", "v", "empty:\n", "empty: v\n"),
        ("wire.empty.deep.er", 1, "empty:\n", "empty: {deep: {er: 1}}\n"),
        ("wire.list.0.count", 3, "count: 2", "count: 3"),
        ("wire.list.0.new", "true", "count: 2\n", 'count: 2\n      new: "true"\n'),
        ("wire.list.4", {"a": [1, None]}, "      - 2\n", "      - 2\n    - {a: [1, null]}\n"),
        ("wire.list.3.2", 9, "      - 2\n", "      - 2\n      - 9\n"),
        ("wire.block.z", "5 m", "# yy\n", "# yy\n    z: 5 m\n"),
        ("wire.block", 1, ":   # bc\n    x: 1\n\n    y: 2   # yy", ": 1   # bc   # yy"),
        ("wire.alias", 2, "*q", "2"),
        ("wire.alone", "6 m", "&r 5 m", "&r 6 m"),
        ("last", "z\n", '"q"', '"z\\n"'),
        ("new.deeper", "1", '"q"\n', '"q"\nnew: {deeper: "1"}\n'),
    ],
)
@pytest.mark.parametrize("line_end", ["\n", "\r\n"])
def test_changes(path: str, value: Any, old: str, new: str, line_end: str) -> None:
    text = TEXT.replace("\n", line_end)
    patch = change(text, path, value)
    assert TEXT.count(old) == 1
    changed = patch.apply(text)
    assert changed == TEXT.replace(old, new).replace("\n", line_end)
    assert patch.undo.apply(changed) == text


@pytest.mark.parametrize(
    ("path", "old", "new"),
    [
        ("wire.tension", '  tension: {value: 22 kN, mark: A, note: "x, y"} # t\n', ""),
        ("wire.tension.mark", "mark: A, ", ""),
        ("wire.flow.a", "a: 1, ", ""),
        ("wire.flow.d.2", ",\n     3]", "]"),
        ("wire.flow.d", ", d: [1, 2,\n     3]", ""),
        ("wire.text", "  text: |\n    one\n    two\n", ""),
        ("wire.empty", "  empty:\n", ""),
        ("wire.list.0", "    - type: a\n      count: 2\n", ""),
        ("wire.list.0.type", "type: a\n      ", ""),
        ("wire.list.1.type", "{type: b}", "{}"),
        ("wire.list.3.0", "- 1\n      ", ""),
        ("wire.block.y", "    y: 2   # yy\n", ""),
        ("last", 'last: "q"\n', ""),
    ],
)
def test_removals(path: str, old: str, new: str) -> None:
    patch = remove(TEXT, path)
    assert TEXT.count(old) == 1
    assert patch.apply(TEXT) == TEXT.replace(old, new)


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        (
            "wire.alias.z",
            2,
            "model file:25: wire.alias.z: cannot be edited here: got the value",
        ),
        ("wire.alias.new", 2, "the value of an alias"),
        ("wire.anchored.z", 2, "expected a change of this value alone; hint: is it used again by"),
        ("wire.mass.x", 1, "wire.mass.x: not a group of fields: got a text"),
        ("wire.list.9", 1, 'unknown item: got "9", expected a number from 0 to 4'),
        ("wire.mass", float("nan"), "expected a text, a finite number"),
        ("wire.mass", object(), "expected a text, a finite number"),
        ("wire.<<", 1, "cannot be edited in place"),
    ],
)
def test_refused(path: str, value: Any, message: str) -> None:
    with pytest.raises(ModelError) as caught:
        change(TEXT, path, value)
    assert message in str(caught.value)


@pytest.mark.parametrize("path", ["nope", "wire.nope", "wire.list.7", "wire.alias.z"])
def test_removals_refused(path: str) -> None:
    with pytest.raises(ModelError):
        remove(TEXT, path)


@pytest.mark.parametrize("content", ["", "a: [", "- 1\n", "a: 1\na: 2\n"])
def test_what_is_no_model_file(content: str) -> None:
    with pytest.raises(ModelError):
        change(content, "a", 1)


def test_json_stays_json() -> None:
    text = '{"a": {"b": "1 m"}, "c": []}'
    assert change(text, "a.b", "2 m").apply(text) == '{"a": {"b": "2 m"}, "c": []}'
    assert change(text, "a.d", "2 m").apply(text) == '{"a": {"b": "1 m", "d": "2 m"}, "c": []}'
    assert change(text, "c.0", {"e": "x"}).apply(text).startswith('{"a": {"b": "1 m"}, "c": [')


def test_a_file(tmp_path: Path) -> None:
    file = tmp_path / "line.yaml"
    shutil.copy(FOLDER / "lines" / "ac-simple-55.yaml", file)
    before = b"\xef\xbb\xbf" + file.read_bytes().replace(b"\n", b"\r\n")
    file.write_bytes(before)
    file.chmod(0o640)
    link = tmp_path / "link.yaml"
    link.symlink_to(file)
    patches = edit_file(link, {"contact_wire.tension": "21 kN", "name": "mine"}, ["description"])
    assert load_line(file).contact_wire.tension == 21000
    assert load_line(file).as_typed("contact_wire.tension") == "21 kN"
    assert (load_line(file).name, load_line(file).description) == ("mine", "")
    assert link.is_symlink()
    assert stat.S_IMODE(file.stat().st_mode) == 0o640
    undo_in_file(file, patches)
    assert file.read_bytes() == before
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["line.yaml", "link.yaml"]


def test_all_changes_or_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "a.yaml"
    file.write_text(TEXT, encoding="utf-8")
    with pytest.raises(ModelError):
        edit_file(file, {"last": "x", "wire.alias.z": 1})
    assert file.read_text(encoding="utf-8") == TEXT

    def full(_handle: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(OutputError, match="No space left"):
        edit_file(file, {"last": "x"})
    assert file.read_text(encoding="utf-8") == TEXT
    assert len(list(tmp_path.iterdir())) == 1


def test_a_file_that_was_changed_since_is_left_alone(tmp_path: Path) -> None:
    file = tmp_path / "a.yaml"
    file.write_text(TEXT, encoding="utf-8")
    patches = edit_file(file, {"last": "x"})
    file.write_text("# another\n", encoding="utf-8")
    with pytest.raises(ModelError):
        undo_in_file(file, patches)
    assert file.read_text(encoding="utf-8") == "# another\n"


FILES = sorted(FOLDER.glob("*/*.yaml"))
TEXTS = {file.name: file.read_bytes().decode() for file in FILES}
SMALL = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-(10**20), 10**20),
    st.floats(allow_nan=False, allow_infinity=False),
    st.text(max_size=12),
    st.sampled_from(["12 kN", "1.5e3 N/m", "195 N m²", "a: b", "# x", "- 1", "null", "0x1", "1_0"]),
)
VALUES = st.recursive(
    SMALL,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.dictionaries(st.text("abc1 :", min_size=1), inner, max_size=3),
    ),
    max_leaves=5,
)


def places(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """All paths in data that can be said with dots."""
    items = data.items() if isinstance(data, dict) else enumerate(data)
    found = []
    for key, item in items:
        if "." not in str(key):
            found.append((*path, key))
            found += places(item, (*path, key)) if isinstance(item, dict | list) else []
    return found


def at(data: Any, path: tuple[Any, ...]) -> Any:
    for part in path:
        data = data[part]
    return data


def same(one: Any, other: Any) -> bool:
    return repr(one) == repr(other)


@searching(150)
@given(data=st.data())
def test_any_edit_of_a_shipped_file_is_exactly_that(data: Any) -> None:
    name = data.draw(st.sampled_from(sorted(TEXTS)))
    text = TEXTS[name]
    if data.draw(st.booleans()):
        text = text.replace("\n", "\r\n")
    expected = deepcopy(parse(text, name)[0])
    place = data.draw(st.sampled_from(places(expected)))
    kind = data.draw(st.sampled_from(["change", "remove", "add"]))
    value = data.draw(VALUES)
    around = at(expected, place[:-1])
    if kind == "remove":
        patch = remove(text, ".".join(map(str, place)))
        del around[place[-1]]
    else:
        if kind == "add" and isinstance(at(expected, place), dict | list):
            around = at(expected, place)
            if isinstance(around, dict) and "value" in around:
                return  # what is added goes into its value
            place = (*place, len(around) if isinstance(around, list) else "added")
        if isinstance(around, dict) and isinstance(around.get(place[-1]), dict):
            inside = around[place[-1]]
            if "value" in inside and not (isinstance(value, dict) and "value" in value):
                around, place = inside, (*place, "value")
        patch = change(text, ".".join(map(str, place)), value)
        if isinstance(around, list) and place[-1] == len(around):
            around.append(value)
        else:
            around[place[-1]] = value
    changed = patch.apply(text)
    assert same(parse(changed, name)[0], expected)
    assert patch.undo.apply(changed) == text
    assert len(text) - len(patch.before) == len(changed) - len(patch.after)


def test_an_edited_scenario_loads(tmp_path: Path) -> None:
    file = tmp_path / "a.yaml"
    shutil.copy(FOLDER / "scenarios" / "en50318-ac-simple-320.yaml", file)
    edit_file(file, {"speed": "300 km/h", "contact.stiffness": "60 kN/m"})
    scenario = load(file)
    assert (scenario.as_typed("speed"), scenario.contact.stiffness) == ("300 km/h", 60000)


def test_a_field_that_a_variant_sets_is_one_key() -> None:
    text = (
        "format: arcless-scenario/1\nname: v\nbase: b\nset:\n"
        "  speed: 200 km/h\n  line.wire.tension: {value: 22 kN, mark: A}  # as drawn\n"
    )
    after = change(text, "set.line.wire.tension", "23 kN").apply(text)
    assert after == text.replace("22 kN", "23 kN")
    after = change(text, "set.line.wire.tension.mark", "B").apply(text)
    assert after == text.replace("mark: A", "mark: B")
    after = change(text, "set.line.wire.mass", "1 kg/m").apply(text)
    assert after == f"{text}  line.wire.mass: 1 kg/m\n"
    assert remove(text, "set.speed").apply(text) == text.replace("  speed: 200 km/h\n", "")
    # Of what is no variant, dots lead into groups.
    with pytest.raises(ModelError, match="no such field"):
        remove(text.replace("base: b\n", ""), "set.line.wire.tension")
