"""Tables that are wrong: each is told by sheet, row and column, with what is expected."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

import arcless
from arcless.errors import ModelError
from arcless.model.shipped.library import shipped
from arcless.model.table_edit import edit_line, edited_line
from arcless.model.tables.files import write_tables
from arcless.model.tables.of_line import tables_of
from arcless.model.tables.sheets import SHEETS
from tests.support.line_tables import content, loaded

NAME = "norway-s25"
TEXT = shipped("line")[NAME].read_text("utf-8")
Change = Callable[[str], str]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with the tables of a shipped line."""
    write_tables(tmp_path / "tables", tables_of(arcless.load_line(NAME)))
    return tmp_path / "tables"


def spoil(folder: Path, sheet: str, change: Change) -> None:
    file = folder / f"{sheet}.csv"
    text = file.read_text("utf-8")
    assert change(text) != text
    file.write_text(change(text), "utf-8")


def told(folder: Path) -> str:
    with pytest.raises(ModelError) as caught:
        edited_line(TEXT, "line.yaml", folder)
    return str(caught.value)


def swap(old: str, new: str) -> Change:
    return lambda text: text.replace(old, new, 1)


def whole(text: str) -> Change:
    return lambda _: text


@pytest.mark.parametrize(
    ("sheet", "change", "where", "what"),
    [
        # Header.
        ("spans", swap("length [m]", "length"), "row 1, column length", "unit missing"),
        ("spans", swap("[m]", "[kN]"), "row 1, column length", "kN is the unit of a force"),
        ("spans", swap("span,", "span [m],"), "row 1, column span", "span without a unit"),
        ("spans", swap("length [m]", "lenght [m]"), "row 1, column 3", "did you mean length?"),
        ("spans", swap("type", "span"), "row 1, column 2", "column given twice"),
        ("spans", swap("span,type,", "type,"), "row 1", "missing column: got no column span"),
        ("spans", whole(""), "spans.csv", "empty sheet"),
        ("spans", whole("# nothing\n\n"), "spans.csv", "empty sheet"),
        ("spans", whole("span,length [m]\n"), "spans.csv", "no spans"),
        ("spans", swap("span,type", '"span,type'), "row ", "is a quotation mark open?"),
        # Cells.
        ("spans", swap("3,standard,60.0", "3,standard,sixty"),
         "row 4, column length", "write a number such as 1.5; its unit is in the header"),
        ("spans", swap("3,standard,60.0", "3,standard,60 m"),
         "row 4, column length", "a unit in a cell: got \"60 m\", expected a number in m; hint: the"
         " unit is in the header: write 60"),
        ("spans", swap("3,standard,60.0", "3,standard,61500 mm"),
         "row 4, column length", "write 61.5"),
        ("spans", swap("3,standard,60.0", "3,standard,60 kN"),
         "row 4, column length", "kN is the unit of a force"),
        ("spans", swap("3,standard,60.0", "3,standard,4 ft 8 in"),
         "row 4, column length", "write a number such as 1.5; its unit is in the header"),
        ("spans", swap("3,standard,60.0", "3,standard,"), "row 4, column length", "empty cell"),
        ("spans", swap("3,standard,60.0", "3,standard"), "row 4, column length", "empty cell"),
        ("spans", swap("3,standard,60.0", "3,standard,60,5"), "row 4, column 4", "with a comma?"),
        ("spans", swap("3,standard,60.0", '3,standard,"60,5"'),
         "row 4, column length", "as a point"),
        ("spans", swap("3,standard,60.0", "3,standard,nan"), "row 4, column length", "finite"),
        ("spans", swap("3,standard,60.0", "3,standard,1e999"), "row 4, column length", "finite"),
        ("spans", swap("3,standard,60.0", "3.5,standard,60.0"), "row 4, column span", "3.5"),
        ("spans", swap("3,standard,60.0", "3,standard,600"), "row 4, column length", "at most 500"),
        ("spans", swap("3,standard,60.0", "3,standard,-60"), "row 4, column length", "above 0 m"),
        # Numbers of rows.
        ("spans", swap("3,standard", "4,standard"), "row 4, column span", "got 4, expected 3"),
        ("spans", swap("3,standard", "2,standard"),
         "row 4, column span", "which row 3 has already"),
        ("supports", swap("\n4,", "\n5,"), "row 5, column support", "got 5, expected 4"),
        ("supports", lambda text: text[: text.rindex("17,")],
         "supports.csv", "16 rows, expected 17"),
        ("droppers", swap("3,2,", "3,3,"),
         "row 15, column dropper", "dropper 3 of span 3, expected 2"),
        ("droppers", swap("3,2,", "3,,"),
         "row 15, column dropper", "no number of span 3, expected 2"),
        ("droppers", swap("\n3,2,15.0,0.0,\n", "\n"),
         "row 15, column dropper", "hint: number them again, or empty the cells of column"),
        ("droppers", swap("3,2,", "3,1,"),
         "row 15, column dropper", "dropper 1 of span 3, expected 2"),
        ("droppers", swap("3,2,", "99,1,"), "row 15, column span", "expected a span from 1 to 16"),
        # Rules of the line, told by the cell.
        ("droppers", swap("16,6,55.0", "16,6,65.0"), "row 97, column position", "outside its span"),
        ("droppers", swap("3,2,15.0", "3,2,4.0"), "row 15, column position", "out of order"),
        ("droppers", swap("3,2,15.0,0.0", "3,2,15.0,25.0"),
         "row 15, column presag", "mind mm and m"),
        ("droppers", swap("3,2,15.0,0.0,", "3,2,15.0,,"),
         "row 15, column presag", "presag of some"),
        ("droppers", swap("3,2,15.0,0.0,", "3,2,15.0,0.0,1.2"),
         "row 15, column length", "got 1.2 m, and 5 empty cells of 6, expected a length of every"
         " dropper of the span, or of none; hint: presag (design) and length (as built) exclude"),
        ("supports", swap("4,5.3", "4,53"), "row 5, column contact_wire_height", "at most 20 m"),
        ("supports", swap("4,5.3,0.0", "4,5.3,3.0"),
         "row 5, column stagger_contact_wire", "at most 1 m"),
        ("point_masses", lambda text: text + ",rail,20,,3\n",
         "row 2, column wire", "contact_wire or"),
        ("curves", lambda text: text + "10,5,600,left,,\n", "row 2, column to", "empty curve"),
        ("curves", lambda text: text + "10,50,600,up,,\n", "row 2, column side", "left or right"),
        ("tension_lengths", lambda text: text + "1,9\n", "tension_length", "16"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_by_row_and_column(
    folder: Path, sheet: str, change: Change, where: str, what: str
) -> None:
    spoil(folder, sheet, change)
    message = told(folder)
    assert message.startswith(f"{folder / sheet}.csv")
    assert where in message.splitlines()[0]
    assert what in message.splitlines()[0]


def test_several_mistakes_are_told_at_once(folder: Path) -> None:
    spoil(folder, "droppers", lambda text: text.replace(",0.0,", ",none,"))
    lines = told(folder).splitlines()
    assert len(lines) == 10
    assert "row 3, column presag" in lines[1]


def test_the_file_stays_when_a_table_is_wrong(folder: Path, tmp_path: Path) -> None:
    file = tmp_path / "line.yaml"
    file.write_text(TEXT)
    spoil(folder, "droppers", swap("16,6,55.0", "16,6,65.0"))
    with pytest.raises(ModelError):
        edit_line(file, folder)
    assert file.read_text() == TEXT


@pytest.mark.parametrize(
    ("sheet", "change", "hint"),
    [
        # The unit that fits the numbers: spans of 60 m, pre-sag of millimetres, in m or in mm.
        ("spans", swap("length [m]", "length"), "write length [m]"),
        ("spans", lambda text: text.replace("length [m]", "length").replace(",60.0", ",60000"),
         "write length [mm]"),
        ("supports", swap("contact_wire_height [m]", "contact_wire_height"),
         "write contact_wire_height [m]"),
        ("droppers", swap("presag [m]", "presag"), "write presag [m"),
        ("supports", swap("stagger_contact_wire [m]", "stagger_contact_wire"),
         "write stagger_contact_wire ["),
        # The column that is meant.
        ("droppers", swap("presag [m]", "dropper sag [m]"), "did you mean presag?"),
        ("droppers", swap("presag [m]", "sag (mm)"), "did you mean presag?"),
        ("supports", swap("stagger_contact_wire", "stagger"), "did you mean"
         " stagger_contact_wire, stagger_messenger_wire or stagger_auxiliary_wire?"),
        ("supports", swap("contact_wire_height", "height"), "did you mean contact_wire_height?"),
        ("spans", swap("length [m]", "span length [m]"), "did you mean length?"),
    ],
)  # fmt: skip
def test_the_hint_fits_the_column(folder: Path, sheet: str, change: Change, hint: str) -> None:
    spoil(folder, sheet, change)
    assert f"hint: {hint}" in told(folder).splitlines()[0]


@pytest.mark.parametrize(
    ("cell", "hint"),
    [
        ("60,5 m", "the unit is in the header: write 60,5"),
        ("sixty", "write a number such as 1,5; its unit is in the header"),
        ("1.060,5", "the numbers of this file have a decimal comma: write digits without"),
    ],
)
def test_a_file_with_decimal_commas_is_answered_with_commas(
    folder: Path, cell: str, hint: str
) -> None:
    def german(text: str) -> str:
        text = text.replace(",", ";").replace(".", ",")
        return text.replace("3;standard;60,0", f"3;standard;{cell}")

    spoil(folder, "spans", german)
    message = told(folder).splitlines()[0]
    assert "row 4, column length" in message
    assert f"hint: {hint}" in message


def test_a_number_with_a_unit_shows_a_decimal_comma_too(folder: Path) -> None:
    spoil(folder, "spans", whole("span;length [m]\n1;60,5 m\n"))
    assert "hint: the unit is in the header: write 60,5" in told(folder).splitlines()[0]


@pytest.mark.parametrize("name", ["spans", "droppers"])
def test_a_sheet_that_is_missing_is_told(folder: Path, name: str) -> None:
    (folder / f"{name}.csv").unlink()
    assert told(folder).startswith(f"no sheet {name}")


def test_parts_without_a_sheet_stay(folder: Path) -> None:
    for name in ("supports", "curves", "tension_lengths", "point_masses", "inserts"):
        (folder / f"{name}.csv").unlink()
    assert edited_line(TEXT, "line.yaml", folder).changed == []


def test_files_that_are_no_tables_are_named(folder: Path) -> None:
    (folder / "remarks of the office.csv").write_text("anything")
    (folder / "picture.png").write_bytes(b"\0")
    assert edited_line(TEXT, "line.yaml", folder).left_out == ["remarks of the office.csv"]


def test_droppers_without_numbers_count_by_position(folder: Path) -> None:
    spoil(
        folder, "droppers", swap("3,1,5.0,0.0,\n3,2,15.0,0.0,\n", "3,2,15.0,0.0,\n3,1,5.0,0.0,\n")
    )
    numbered = (folder / "droppers.csv").read_text()
    assert "droppers out of order" in told(folder)
    # Empty in all of the file, in one span, and without the column.
    for old, new in ((r"(?m)^(\d+),\d+,", r"\1,,"), (r"(?m)^3,\d+,", "3,,")):
        (folder / "droppers.csv").write_text(re.sub(old, new, numbered))
        assert edited_line(TEXT, "line.yaml", folder).changed == []
    (folder / "droppers.csv").write_text(re.sub(r"(?m)^(\w+),\w+,", r"\1,", numbered))
    assert edited_line(TEXT, "line.yaml", folder).changed == []


def test_a_typographic_minus_is_read(folder: Path) -> None:
    spoil(folder, "supports", swap("4,5.3,0.0", "4,5.3,\u22120.05"))
    line = loaded(edited_line(TEXT, "line.yaml", folder).text)
    assert line.geometry.stagger_contact_wire is not None
    assert line.geometry.stagger_contact_wire[3] == -0.05


def test_a_typographic_minus_has_a_decimal_comma(folder: Path) -> None:
    file = folder / "supports.csv"
    rows = [f"{n};6;\u22120,05" for n in range(1, 18)]
    head = "support;contact_wire_height [m];stagger_contact_wire [m]"
    file.write_text("\n".join([head, *rows]), "utf-8")
    line = loaded(edited_line(TEXT, "line.yaml", folder).text)
    assert line.geometry.stagger_contact_wire == (-0.05,)


@pytest.mark.parametrize(
    ("sheet", "name"),
    [
        ("point_masses", "pointmass"),
        ("supports", "supports rev B"),
        ("supports", "Supports (old)"),
        ("supports", "Support list of the office"),
        ("tension_lengths", "2024 Tension-Lengths"),
    ],
)
def test_a_renamed_sheet_is_told(folder: Path, sheet: str, name: str) -> None:
    (folder / f"{sheet}.csv").rename(folder / f"{name}.csv")
    assert f"did you mean {sheet}? a name that begins with # is left out" in told(folder)
    (folder / f"{name}.csv").rename(folder / f"# {name}.csv")
    found = edited_line(TEXT, "line.yaml", folder)
    assert found.left_out == []
    assert sheet not in found.read


@pytest.mark.parametrize("name", ["Dropper", "droper", "droppers-2"])
def test_nearly_the_name_of_a_sheet_that_is_there_is_told(folder: Path, name: str) -> None:
    (folder / f"{name}.csv").write_text("span,dropper\n")
    assert "did you mean droppers?" in told(folder)


def test_what_has_the_name_of_a_sheet_that_is_there_is_left_out(folder: Path) -> None:
    (folder / "droppers before the renewal.csv").write_text("x")
    found = edited_line(TEXT, "line.yaml", folder)
    assert found.left_out == ["droppers before the renewal.csv"]
    assert found.read == sorted(SHEETS.keys() - {"hangers"})


def test_droppers_of_a_line_without_a_messenger_wire_are_told(folder: Path) -> None:
    rail = shipped("line")["trolley-bridles"].read_text("utf-8")
    with pytest.raises(ModelError, match="droppers without a messenger wire: got 96 rows"):
        edited_line(rail, "rail.yaml", folder)


def test_a_semicolon_table_with_decimal_commas_is_read(folder: Path) -> None:
    for file in folder.iterdir():
        text = file.read_text("utf-8").replace(",", ";").replace(".", ",")
        file.write_text("\ufeff" + text.replace("\n", "\r\n"), "utf-8")
    assert edited_line(TEXT, "line.yaml", folder).changed == []
    spoil(folder, "spans", swap("7;standard;60,0", "7;standard;60,5"))
    new = loaded(edited_line(TEXT, "line.yaml", folder).text)
    assert [span.length for span in new.span_list()][5:8] == [60.0, 60.5, 60.0]


@pytest.mark.parametrize("separator", ["\t", "|"])
def test_other_separators_are_read(folder: Path, separator: str) -> None:
    for file in folder.iterdir():
        text = file.read_text("utf-8").replace(",", separator)
        file.write_text(f"sep={separator}\n{text}" if separator == "|" else text, "utf-8")
    assert edited_line(TEXT, "line.yaml", folder).changed == []


def test_commas_and_points_in_one_file_say_nothing_for_sure(folder: Path) -> None:
    spoil(folder, "spans", lambda text: text.replace(",", ";").replace("60.0", "60,5", 1))
    assert "got 60,5 in row 2 and 60.0 in row 3, expected one of them" in told(folder)


def test_thousands_are_not_parted(folder: Path) -> None:
    spoil(folder, "curves", lambda text: text.replace(",", ";") + "10;50;1.200,5;left;;\n")
    assert "curves.csv, row 2, column radius: no number" in told(folder)


def test_units_are_converted_exactly(folder: Path) -> None:
    new = "support,Contact wire height (mm),stagger contact-wire [cm],remark\n".replace(
        "remark", "#remark"
    )
    rows = [f"{n},{5301 + n % 2},{-20.1 if n % 2 else 20.1},x" for n in range(1, 18)]
    (folder / "supports.csv").write_text(new + "\n".join(rows))
    line = loaded(edited_line(TEXT, "line.yaml", folder).text)
    assert line.contact_wire_heights()[:2] == [5.302, 5.301]
    assert line.geometry.stagger_contact_wire == (-0.201, 0.201)


def test_lists_of_a_table_are_taken_away_again(folder: Path) -> None:
    empty = (folder / "curves.csv").read_text()
    spoil(folder, "curves", lambda text: text + "100,400,1200,left,60,0.05\n")
    spoil(folder, "supports", lambda text: text.replace("5.3", "5.2", 1))
    bent = edited_line(TEXT, "line.yaml", folder)
    assert bent.changed == [
        "geometry.contact_wire_height",
        "geometry.height_changes",
        "track.curves",
    ]
    assert loaded(bent.text).track.curves[0].cant == 0.05
    (folder / "curves.csv").write_text(empty)
    spoil(folder, "supports", lambda text: text.replace("5.2", "5.3", 1))
    again = edited_line(bent.text, "line.yaml", folder)
    assert content(loaded(again.text)) == content(loaded(TEXT))


@pytest.mark.parametrize(
    ("raw", "what"),
    [
        (b"span,type,length [m]\n1,\xe4,60\n", "which is not UTF-8"),
        (b"PK\3\4\0\0", "binary data"),
        ("span;length [m]\n1;60\n".encode("utf-16"), "not a text file"),
    ],
)
def test_what_is_no_text_is_told(folder: Path, raw: bytes, what: str) -> None:
    (folder / "spans.csv").write_bytes(raw)
    assert what in told(folder)


def test_two_gigabytes_are_refused_unread(folder: Path) -> None:
    with (folder / "spans.csv").open("r+b") as file:
        file.truncate(2_000_000_000)  # a hole: takes no room on the disk
    assert "file too large: got 2000.0 MB, expected at most 5 MB" in told(folder)


@pytest.mark.parametrize("name", ["absent", "absent.csv", "tables.xls", "line.ods"])
def test_places_without_tables_are_told(tmp_path: Path, name: str) -> None:
    assert "expected a workbook that ends in .xlsx, or a folder" in told(tmp_path / name)


def test_an_empty_folder_is_told(tmp_path: Path) -> None:
    assert "expected spans.csv, supports.csv" in told(tmp_path)
