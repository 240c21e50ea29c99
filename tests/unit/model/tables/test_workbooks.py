"""Workbooks from an office: formulas, dates, merged and hidden cells, other sheets, damage."""

import re
import zipfile
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.errors import ModelError
from arcless.model.shipped.library import shipped
from arcless.model.table_edit import edited_line
from arcless.model.tables import excel_grids
from arcless.model.tables.files import write_tables
from arcless.model.tables.of_line import tables_of
from tests.support.line_tables import loaded

openpyxl = pytest.importorskip("openpyxl")

NAME = "norway-s25"
TEXT = shipped("line")[NAME].read_text("utf-8")
Change = Callable[[Any], None]


@pytest.fixture
def book(tmp_path: Path) -> Path:
    """Return a workbook with the tables of a shipped line."""
    write_tables(tmp_path / "line.xlsx", tables_of(arcless.load_line(NAME)))
    return tmp_path / "line.xlsx"


def spoil(book: Path, change: Change) -> None:
    content = openpyxl.load_workbook(book)
    change(content)
    content.save(book)


def told(book: Path) -> str:
    with pytest.raises(ModelError) as caught:
        edited_line(TEXT, "line.yaml", book)
    return str(caught.value)


def put(sheet: str, place: str, value: object) -> Change:
    def change(content: Any) -> None:
        content[sheet][place].value = value

    return change


def merge(content: Any) -> None:
    content["spans"].merge_cells("C3:C5")


def hide(content: Any) -> None:
    content["spans"].sheet_state = "hidden"


def rename(content: Any) -> None:
    content["droppers"].title = "Dropers"


def remove(content: Any) -> None:
    del content["droppers"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (put("spans", "C4", date(2026, 3, 5)),
         r"sheet spans, row 4, column C \(length\): no value: got the date 2026-03-05"),
        (put("spans", "C4", "=60"),
         r"row 4, column C \(length\): no value: got a formula without a stored value.*save it"),
        (put("spans", "C4", True), r"row 4, column C \(length\): no value: got TRUE"),
        (put("spans", "C4", "#REF!"), r"row 4, column C \(length\): no value: got the error #REF!"),
        (put("spans", "C4", None), r"row 4, column C \(length\): empty cell"),
        (put("spans", "C4", "60,5"), r"row 4, column C \(length\): no number: .*\"60,5\".*a point"),
        (put("spans", "C4", 6000), r"row 4, column C \(length\): .*at most 500 m"),
        (put("spans", "A4", 3.5), r"row 4, column A \(span\): no whole number: got \"3.5\""),
        (put("spans", "C1", "length"), r"row 1, column C \(length\): unit missing"),
        (put("spans", "C1", "=B1"),
         r"spans, row 1, column C: header without a name: got a formula without a stored value,"
         r".* write the name into this cell as a text"),
        (put("spans", "E7", "remark"), r"row 7, column E: a cell without a header: got \"remark\""),
        (put("droppers", "C97", 65), r"droppers, row 97, column C \(position\): .*outside its"),
        (put("spans", "XFD1048576", 1), r"too many cells: got a sheet to row 1048576, column X"),
        (merge, r"row 4, column C \(length\): no value: .* the merged cells C3:C5.*unmerge them"),
        (hide, r"sheet spans: hidden sheet"),
        (rename, r"sheet Dropers: unknown sheet.*did you mean droppers"),
        (remove, r"no sheet droppers: .*a messenger wire"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_by_sheet_row_and_column(
    book: Path, change: Change, message: str
) -> None:
    spoil(book, change)
    found = told(book)
    assert re.search(message, found)
    assert found.startswith(f"{book}, sheet ") or "no sheet" in found


def test_numbers_stored_as_text_are_read(book: Path) -> None:
    def change(content: Any) -> None:
        content["spans"]["A4"].value, content["spans"]["C4"].value = "3", " 60.0 "

    spoil(book, change)
    assert edited_line(TEXT, "line.yaml", book).changed == []


def test_notes_of_the_office_are_passed_over(book: Path) -> None:
    def change(content: Any) -> None:
        content.create_sheet("Remarks")["A1"] = "checked by Kari"
        content.create_sheet("# droppers")["A1"] = "before the renewal"
        content["spans"]["E1"] = "# drawing"
        content["spans"]["E4"] = "4711-B"
        content["spans"].insert_rows(1)
        content["spans"]["A30"] = "# from here on without"
        content["spans"].title = "x"
        content["x"].title = "Spans"  # at once the package would count it: Spans1
        content["supports"].row_dimensions[4].hidden = True

    spoil(book, change)
    found = edited_line(TEXT, "line.yaml", book)
    assert (found.changed, found.left_out) == ([], ["Remarks"])


def test_of_a_formula_the_stored_value_counts(book: Path) -> None:
    spoil(book, put("spans", "C4", "=C3+1.5"))
    # As a spreadsheet program saves it: the formula, and the value that it had.
    with zipfile.ZipFile(book) as packed:
        parts = {name: packed.read(name) for name in packed.namelist()}
    for name, part in parts.items():
        parts[name] = re.sub(rb"(<f>C3\+1.5</f>)<v ?/?>(</v>)?", rb"\1<v>61.5</v>", part)
    with zipfile.ZipFile(book, "w") as packed:
        for name, part in parts.items():
            packed.writestr(name, part)
    new = loaded(edited_line(TEXT, "line.yaml", book).text)
    assert [span.length for span in new.span_list()][1:4] == [60.0, 61.5, 60.0]


@pytest.mark.parametrize("raw", [b"", b"span,length\n1,2\n", b"\xd0\xcf\x11\xe0 of a password"])
def test_what_is_no_workbook_is_told(book: Path, raw: bytes) -> None:
    book.write_bytes(raw)
    assert "not a workbook: got a file of another kind" in told(book)


def test_another_archive_is_no_workbook(book: Path) -> None:
    with zipfile.ZipFile(book, "w") as packed:
        packed.writestr("word/document.xml", "<w/>")
    assert "workbook cannot be read" in told(book)


def test_a_damaged_workbook_is_told(book: Path) -> None:
    whole = book.read_bytes()
    for cut in range(1, 20):
        place = cut * len(whole) // 20
        book.write_bytes(whole[:place] + b"\0" * 40 + whole[place + 40 :])
        try:
            edited_line(TEXT, "line.yaml", book)
        except ModelError:
            continue


def test_two_gigabytes_are_refused_unread(book: Path) -> None:
    with book.open("r+b") as file:
        file.truncate(2_000_000_000)  # a hole: takes no room on the disk
    assert "file too large: got 2000.0 MB, expected at most 20 MB" in told(book)


def test_what_unpacks_to_more_is_refused(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(excel_grids, "MOST_UNPACKED", 10_000)
    assert "unpacked, expected at most" in told(book)


def test_without_the_package_the_line_to_install_it_is_told(
    book: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("arcless.model.tables.files.find_spec", lambda _: None)
    assert "pip install 'arcless[excel]'" in told(book)
