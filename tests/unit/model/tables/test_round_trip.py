"""Line → tables → line and back: nothing is lost, with either kind of file, over either line."""

import json
from pathlib import Path

import pytest

import arcless
from arcless.equilibrium.line_alone import ALONE
from arcless.mesh import build_mesh
from arcless.model import Line
from arcless.model.line.parts.masses_and_inserts import Insert, LumpedMass
from arcless.model.line.parts.tension_lengths import TensionLength
from arcless.model.line.parts.track import Curve
from arcless.model.shipped.library import shipped
from arcless.model.table_edit import edited_line
from arcless.model.tables.files import read_tables, write_tables
from arcless.model.tables.of_line import tables_of
from arcless.model.tables.sheets import LISTS, SHEETS, Sheet
from tests.support.line_tables import content, loaded, other_text
from tests.support.random_lines import KINDS, data_of

NAMES = list(shipped("line"))


@pytest.fixture(params=["line.xlsx", "tables"])
def place(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """Return where tables go: a workbook, or a folder."""
    if request.param == "line.xlsx":
        pytest.importorskip("openpyxl")
    return tmp_path / request.param


def check_round_trip(line: Line, place: Path) -> None:
    """Lay the tables of a line over another one, and compare what both are."""
    tables = tables_of(line)
    write_tables(place, tables)
    new = loaded(edited_line(other_text(line), "other.yaml", place).text)
    assert content(new) == content(line)
    again = tables_of(new)
    assert list(again) == list(tables)
    for name, columns in tables.items():
        for column, other in zip(columns, again[name], strict=True):
            assert (other.header, list(other.values)) == (column.header, list(column.values))


@pytest.mark.parametrize("name", NAMES)
def test_shipped_lines_stay_as_they_are(name: str, place: Path) -> None:
    text = shipped("line")[name].read_text("utf-8")
    write_tables(place, tables_of(arcless.load_line(name)))
    found = edited_line(text, name, place)
    assert (found.changed, found.left_out) == ([], [])
    assert found.text == text


@pytest.mark.parametrize("name", NAMES)
def test_shipped_lines_are_found_again_over_another_line(name: str, place: Path) -> None:
    check_round_trip(arcless.load_line(name), place)


@pytest.mark.parametrize("seed", range(2 * len(KINDS)))
def test_random_lines_are_found_again_over_another_line(seed: int, place: Path) -> None:
    check_round_trip(arcless.load(data_of(seed)).line, place)


@pytest.mark.parametrize("name", ["norway-s25", "ac-simple-overlap", "shinkansen-heavy-compound"])
def test_the_mesh_is_the_same_bit_for_bit(name: str, tmp_path: Path) -> None:
    line = arcless.load_line(name)
    write_tables(tmp_path / "t", tables_of(line))
    new = loaded(edited_line(other_text(line), "other.yaml", tmp_path / "t").text)
    one, other = (build_mesh(each, ALONE, {}) for each in (line, new))
    assert one.positions.tobytes() == other.positions.tobytes()
    for part, found in one.parts.items():
        for column in found.dtype.names:
            assert found[column].tobytes() == other.parts[part][column].tobytes(), (part, column)


def test_files_are_the_same_the_second_time(tmp_path: Path) -> None:
    line = arcless.load(data_of(4)).line
    write_tables(tmp_path / "one", tables_of(line))
    new = loaded(edited_line(other_text(line), "x", tmp_path / "one").text)
    write_tables(tmp_path / "two", tables_of(new))
    for file in (tmp_path / "one").iterdir():
        assert file.read_bytes() == (tmp_path / "two" / file.name).read_bytes()


def test_every_kind_of_row_is_among_the_lines_tried() -> None:
    lines = [arcless.load_line(name) for name in NAMES]
    lines += [arcless.load(data_of(seed)).line for seed in range(2 * len(KINDS))]
    filled = {
        name for line in lines for name, columns in tables_of(line).items() if columns[0].values
    }
    # No line has an insert: `test_what_no_shipped_line_has_is_found_again` has one.
    assert filled == SHEETS.keys() - {"inserts"}


def test_what_no_shipped_line_has_is_found_again(place: Path) -> None:
    data = arcless.load_line("ac-simple-55").to_dict()
    insert = {"position": 210.5, "length": 1.2, "mass": 8.0, "axial_stiffness": 2e7}
    insert |= {"bending_stiffness": 1 / 3, "name": "section, insulator", "wire": "messenger_wire"}
    data["inserts"] = [insert]
    data["geometry"]["height_changes"] = [
        {"from_support": 3, "to_support": 6, "height": 5.1},
        {"from_support": 8, "to_support": 9, "height": 5.4},
    ]
    name, kind = next(iter(data["span_types"].items()))
    positions = kind["droppers"]["positions"]
    built = {
        "positions": positions,
        "lengths": [1.1 + 0.01 * place for place in range(len(positions))],
    }
    data["span_types"]["as built"] = {"length": kind["length"], "droppers": built}
    data["span_types"]["bare"] = {"length": 20.0, "droppers": {"positions": []}}
    data["spans"] = [{"type": name, "count": 8}, {"type": "as built"}, {"type": "bare"}]
    check_round_trip(arcless.load_line(data), place)


@pytest.mark.parametrize(
    ("sheet", "part"),
    [
        (LISTS["tension_lengths"], TensionLength),
        (LISTS["track.curves"], Curve),
        (LISTS["point_masses"], LumpedMass),
        (LISTS["inserts"], Insert),
    ],
)
def test_lists_have_all_fields_of_their_parts(sheet: Sheet, part: type[TensionLength]) -> None:
    assert set(sheet.by_name) == set(part.field_names())


def test_two_thousand_different_spans_are_read(tmp_path: Path) -> None:
    data = arcless.load_line("ac-simple-55").to_dict()
    del data["provenance"]
    line = json.dumps({key: value for key, value in data.items() if value is not None})
    folder = tmp_path / "t"
    write_tables(folder, tables_of(arcless.load_line("ac-simple-55")))
    count = 2000
    spans = [f"{n},,{50 + 0.001 * n:.3f}" for n in range(1, count + 1)]
    droppers = [f"{n},{k},{10 * k}," for n in range(1, count + 1) for k in (1, 2, 3, 4)]
    supports = [
        f"{n},{5.3 + 0.00001 * (n % 7):.5f},{0.2 * (-1) ** n + n * 1e-6:.6f}"
        for n in range(1, count + 2)
    ]
    for name, head, rows in (
        ("spans", "span,type,length [m]", spans),
        ("droppers", "span,dropper,position [m],presag [m]", droppers),
        ("supports", "support,contact_wire_height [m],stagger_contact_wire [m]", supports),
    ):
        (folder / f"{name}.csv").write_text("\n".join([head, *rows]))
    found = loaded(edited_line(line, "line", folder).text)
    assert len(found.span_list()) == count
    tables, _ = read_tables(folder)
    assert found.contact_wire_heights() == tables["supports"].columns["contact_wire_height"]
