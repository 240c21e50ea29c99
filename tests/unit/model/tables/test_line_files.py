"""Line files that tables are laid over: what stays of their text, of their marks and sources."""

from pathlib import Path

import pytest

import arcless
from arcless.errors import ModelError
from arcless.model.shipped.library import shipped
from arcless.model.table_edit import edit_line, edited_line
from arcless.model.tables.files import write_tables
from arcless.model.tables.of_line import tables_of
from tests.support.line_tables import content, loaded

NAME = "norway-s25"
TEXT = shipped("line")[NAME].read_text("utf-8")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return the tables of a line whose span 7 is longer and whose span 9 has another name."""
    folder = tmp_path / "office"
    write_tables(folder, tables_of(arcless.load_line(NAME)))
    spans = (folder / "spans.csv").read_text()
    spans = spans.replace("7,standard,60.0", "7,standard,61.5")
    (folder / "spans.csv").write_text(spans.replace("9,standard,", "9,bridge,"))
    return folder


def unlike(text: str, other: str) -> list[str]:
    """Return the lines of a text that another one does not have."""
    return [line for line in text.splitlines() if line not in other.splitlines()]


def test_all_other_lines_stay(folder: Path) -> None:
    found = edited_line(TEXT, "line.yaml", folder)
    assert found.changed == ["span_types.standard-7", "span_types.bridge", "spans"]
    assert [line.split(":")[0] for line in unlike(TEXT, found.text)] == ["spans"]
    new = unlike(found.text, TEXT)
    # Each over two lines, the second further in.
    assert [line.strip().split(":")[0] for line in new[::2]] == ["standard-7", "bridge", "spans"]
    assert all(line.endswith("note: from office}") for line in new[1::2])
    assert all(len(line) <= 100 for line in new)


def test_marks_of_what_is_changed_go_and_the_others_stay(folder: Path) -> None:
    line = loaded(edited_line(TEXT, "line.yaml", folder).text)
    before = loaded(TEXT)
    for path in ("spans", "span_types.standard-7", "span_types.bridge"):
        assert (line.provenance[path].mark, line.provenance[path].note) == (None, "from office")
    kept = {path: entry for path, entry in before.provenance.items() if path != "spans"}
    assert {path: line.provenance[path] for path in kept} == kept


def test_a_file_is_replaced_as_a_whole_and_keeps_its_line_ends(
    folder: Path, tmp_path: Path
) -> None:
    file = tmp_path / "line.yaml"
    file.write_bytes(b"\xef\xbb\xbf" + TEXT.replace("\n", "\r\n").encode())
    edit_line(file, folder)
    raw = file.read_bytes()
    assert raw.startswith(b"\xef\xbb\xbf")
    assert raw.count(b"\n") == raw.count(b"\r\n")
    assert content(loaded(raw.decode("utf-8-sig"))) == content(
        loaded(edited_line(TEXT, "line.yaml", folder).text)
    )


def test_a_type_that_no_span_has_any_more_goes(folder: Path) -> None:
    spans = (folder / "spans.csv").read_text().replace("standard", "new")
    (folder / "spans.csv").write_text(spans)
    found = edited_line(TEXT, "line.yaml", folder)
    line = loaded(found.text)
    assert list(line.span_types) == ["new", "new-7", "bridge"]
    assert "span_types:\n  new: {value: {length: 60," in found.text


def test_a_type_that_no_span_had_stays(folder: Path) -> None:
    more = TEXT.replace(
        "span_types:\n", "span_types:\n  spare: {length: 50, droppers: {positions: [8, 42]}}\n"
    )
    found = edited_line(more, "line.yaml", folder)
    assert "  spare: {length: 50, droppers: {positions: [8, 42]}}\n" in found.text


def test_a_text_without_a_last_line_end_is_edited(folder: Path) -> None:
    short = TEXT[: TEXT.index("design:")].rstrip("\n")
    assert edited_line(short, "line.yaml", folder).changed[-1] == "spans"


def test_what_stands_for_an_anchor_is_edited_by_hand(folder: Path) -> None:
    start = TEXT.index("span_types:")
    end = TEXT.index("spans:")
    shared = TEXT[:start] + TEXT[start:end].replace("standard:", "standard: &s") + (
        "  other: *s\n" + TEXT[end:]
    )  # fmt: skip
    spans = (folder / "spans.csv").read_text()
    (folder / "spans.csv").write_text(spans.replace(",60.0", ",62"))
    with pytest.raises(ModelError, match=r"cannot be edited in place.*write them out"):
        edited_line(shared, "line.yaml", folder)


def test_a_line_that_is_wrong_is_told_before_the_tables(tmp_path: Path) -> None:
    wrong = TEXT.replace("15 kN", "15 kg", 1)
    with pytest.raises(ModelError, match=r"line.yaml:\d+: contact_wire.tension"):
        edited_line(wrong, "line.yaml", tmp_path / "absent")
