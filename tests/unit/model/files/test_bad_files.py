"""Files that are no model files at all: each is one message, soon, and never a traceback."""

import time
from contextlib import suppress
from pathlib import Path

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from arcless.errors import ModelError
from arcless.model import load
from arcless.model.files.yaml_nodes import MAX_NODES
from arcless.model.files.yaml_reader import MAX_BYTES, parse

BOMB = "a: &a [x, x, x, x, x, x, x, x, x]\n" + "\n".join(
    f"{name}: &{name} [{', '.join([f'*{before}'] * 9)}]"
    for before, name in zip("abcdefgh", "bcdefghi", strict=True)
)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "empty file: expected a model file that starts with format:"),
        (b"# only a comment\n", "empty file"),
        ("a: 1".encode("utf-16"), "not a text file in UTF-8: got text in UTF-16"),
        (b"\x89PNG\r\n\x1a\n\0\0", "not a text file: got binary data"),
        ("name: Straße".encode("latin-1"), "x.yaml:1: not a text file: got byte 0xdf"),
        (b"a: [1, 2\nb: 3", "x.yaml:2: not valid YAML"),
        (b"a: \x07", "not valid YAML"),
        (b"- a", "x.yaml:1: not a model file: got a list of 1"),
        (b"a: 1\n---\nb: 2", "x.yaml:2: not a model file: got a second document"),
        (b"name: a\nname: b", 'x.yaml:2: not a model file: got "name" again; it is in line 1'),
        (b"a: !!python/object:os.system x", "plain YAML without tags"),
        (b"a: &a [*a]", "the alias *a inside its own anchor"),
        (b"a: *b", "x.yaml:1: not"),
        (b"a: &a {b: 1}\nc: {<<: *a}", "x.yaml:2: not a model file: got a merge key"),
        (b'name: "\\U00110000"', "x.yaml:1: not valid YAML"),
        (
            b'a: 1\nb: "\\ud83d\\ude00 \\ud83d"',
            "x.yaml:2: not a model file: got half of a character",
        ),
        (b'a: 1\nb: "\\U0000D83D"', "x.yaml:2: not a model file: got half of a character"),
        ("é: 1\nb: \x07".encode(), "x.yaml:2: not valid YAML: got the character U+0007"),
        (b"a:\n\tb: 1", "x.yaml:2: not valid YAML"),
        (b"[1, 2]: 3", "a key that is not plain text"),
        (b'a: 1\nb: "\\ud83d"', "x.yaml:2: not a model file: got half of a character"),
        (b'{"\\ude00": 1}', "x.yaml:1: not a model file: got half of a character"),
        (BOMB.encode(), f"more than {MAX_NODES} values, aliases written out"),
        (b"a: " + b"[" * 500, "x.yaml:1: not a model file: got deeper nesting"),
        (b"a:\n " + b"[" * 5_000, "x.yaml:2: not a model file: got deeper nesting"),
        (b"a: " + b"{b: " * 5_000, "deeper nesting"),
    ],
)
def test_refused(tmp_path: Path, content: bytes, message: str) -> None:
    path = tmp_path / "x.yaml"
    path.write_bytes(content)
    with pytest.raises(ModelError) as caught:
        load(path)
    assert message in str(caught.value)
    assert caught.value.exit_code == 2


def test_a_huge_file_is_refused_without_being_read(tmp_path: Path) -> None:
    path = tmp_path / "huge.yaml"
    with path.open("wb") as file:
        file.truncate(100_000_000)
    started = time.perf_counter()
    with pytest.raises(ModelError, match=r"file too large: got 100\.0 MB, expected at most 5 MB"):
        load(path)
    # Reading and parsing 100 MB takes minutes; a look at the size takes microseconds.
    assert time.perf_counter() - started < 1
    assert MAX_BYTES == 5_000_000


@pytest.mark.parametrize(
    ("path", "message"),
    [
        ("nope.yaml", "nope.yaml: no such file"),
        (".", "not a file: got a folder"),
        (Path("/dev/zero"), "not a file: got a device or a pipe"),
        ("en50318-ac-simple-32", "did you mean en50318-ac-simple-320?"),
        ("a\0b", "unknown scenario"),
        ("x" * 5000, "unknown scenario"),
    ],
)
def test_no_such_file(tmp_path: Path, path: str | Path, message: str) -> None:
    with pytest.raises(ModelError) as caught:
        load(tmp_path if path == "." else path)
    assert message in str(caught.value)


def test_a_scenario_that_names_itself(tmp_path: Path) -> None:
    path = tmp_path / "self.yaml"
    path.write_text("format: arcless-scenario/1\nname: x\nline: ./self.yaml\n", encoding="utf-8")
    with pytest.raises(ModelError) as caught:
        load(path)
    assert "recursive reference: got self.yaml → self.yaml" in str(caught.value)
    assert f"named in {path}:3" in str(caught.value)


def test_scenarios_that_name_each_other(tmp_path: Path) -> None:
    for name, other in (("a", "b"), ("b", "a")):
        text = f"format: arcless-scenario/1\nname: {name}\nline: {other}.yaml\n"
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(ModelError) as caught:
        load(tmp_path / "a.yaml")
    assert 'format: wrong format: got "arcless-scenario/1", expected arcless-line/1' in str(
        caught.value
    )
    assert f"named in {tmp_path / 'a.yaml'}:3" in str(caught.value)


def test_a_text_read_twice_gives_data_of_its_own() -> None:
    text = "a: &a [1, {b: 2}]\nc: *a\n"
    first, positions = parse(text, "x.yaml")
    first["a"][1]["b"], first["d"] = 3, 4
    positions.clear()
    again, where = parse(text, "x.yaml")
    assert again == {"a": [1, {"b": 2}], "c": [1, {"b": 2}]}
    assert where[("c",)] == (2, 1)


def test_a_text_under_two_names_is_refused_by_each() -> None:
    for name in ("x.yaml", "y.yaml", "y.yaml"):
        with pytest.raises(ModelError, match=f"{name}:1: not a model file"):
            parse("a: *b", name)


@pytest.mark.parametrize("parser", ["of libyaml", "of its own"])
def test_both_parsers_of_pyyaml_read_the_same(parser: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if parser == "of its own":
        monkeypatch.delattr(yaml, "CBaseLoader", raising=False)
    text = (
        "# é\na: {b: [1, 2.5, 1e3], 'c': \"\\ud83d\\ude00\\\\ud83d\"}\r\nd: |\n  x\n  y\n"
        "e: &n [yes, ~]\nf: *n\ng: \\ud83d\\ude00 \\uDaAa\n"
    )
    data, positions = parse(text, "x")
    assert data == {
        "a": {"b": [1, 2.5, 1000.0], "c": "😀\\ud83d"},
        "d": "x\ny\n",
        "e": ["yes", None],
        "f": ["yes", None],
        "g": r"\ud83d\ude00 \uDaAa",
    }
    assert positions[("a", "c")] == (2, 23)
    assert positions[("f",)] == (7, 1)
    for bad in ('a: "\\U00110000"', "a: [1", "a: *b", "a: \x07", "a: 1\na: 2", "--- 1\n--- 2"):
        with pytest.raises(ModelError, match=r"x(:\d)?: not "):
            parse(bad, "x")


def test_data_that_contain_themselves() -> None:
    data: dict[str, object] = {"name": "x", "speed": 10}
    data["contact"] = data
    with pytest.raises(ModelError, match="nested too deep"):
        load(data)


@settings(max_examples=300, deadline=None)
@given(text=st.text(alphabet="ab:-[]{}&*!|>'\"#%@,?\n\t <~.1e", max_size=60))
def test_any_text_gives_data_or_a_model_error(text: str) -> None:
    with suppress(ModelError):
        assert isinstance(parse(text, "x")[0], dict)


@settings(max_examples=100, deadline=None)
@given(content=st.binary(max_size=60))
def test_any_bytes_give_a_model_error(
    content: bytes, tmp_path_factory: pytest.TempPathFactory
) -> None:
    path = tmp_path_factory.getbasetemp() / "bytes.yaml"
    path.write_bytes(content)
    with pytest.raises(ModelError):
        load(path)
