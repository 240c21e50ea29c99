"""`arcless table` and `arcless new --table`: lines as tables, and tables as lines."""

from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

from arcless.model.own_copy import HEADER
from arcless.model.shipped.library import shipped

Command = Callable[..., Result]


def test_tables_go_out_and_come_in_again(arcless: Command) -> None:
    assert arcless("new", "ridge", "--from", "norway-s25").exit_code == 0
    done = arcless("table", "ridge.yaml", "--to", "ridge")
    assert (done.exit_code, done.stderr) == (0, "")
    assert done.stdout.splitlines()[0] == f"wrote {Path('ridge/spans.csv')}"
    before = Path("ridge.yaml").read_bytes()
    done = arcless("table", "ridge.yaml", "--from", "ridge")
    assert done.stdout == "ridge.yaml: nothing to change, ridge says the same\n"
    assert Path("ridge.yaml").read_bytes() == before
    spans = Path("ridge/spans.csv")
    spans.write_text(spans.read_text().replace("7,standard,60.0", "7,standard,60.5"))
    done = arcless("table", "ridge.yaml", "--from", "ridge")
    assert done.stdout.splitlines() == [
        "changed ridge.yaml: span_types.standard-7, spans",
        "next: arcless check ridge.yaml",
    ]
    assert arcless("check", "ridge.yaml").stdout.endswith("16 spans, 960 m\n")
    # Comments stay, those of types that are not touched among them.
    assert "# the first and the last hang on the stitch wire" in Path("ridge.yaml").read_text()


def test_a_workbook_goes_out_and_comes_in_again(arcless: Command) -> None:
    pytest.importorskip("openpyxl")
    arcless("new", "ridge", "--from", "norway-s25")
    assert arcless("table", "ridge.yaml", "--to", "ridge.xlsx").stdout == "wrote ridge.xlsx\n"
    assert "nothing to change" in arcless("table", "ridge.yaml", "--from", "ridge.xlsx").stdout


def test_the_line_of_a_scenario_is_written(arcless: Command) -> None:
    assert arcless("table", "norway-s25-250", "--to", "one").exit_code == 0
    assert arcless("table", "line/norway-s25", "--to", "other").exit_code == 0
    for file in Path("one").iterdir():
        assert file.read_bytes() == (Path("other") / file.name).read_bytes()


@pytest.mark.parametrize("source", ["norway-s25-250", "norway-s25"])
def test_a_new_model_takes_the_tables(arcless: Command, source: str) -> None:
    arcless("table", "norway-s20b", "--to", "tables")
    done = arcless("new", "mine", "--from", source, "--table", "tables")
    assert (done.exit_code, done.stderr) == (0, "")
    line = Path("mine-line.yaml" if source == "norway-s25-250" else "mine.yaml")
    assert line.read_text().startswith(HEADER)
    arcless("table", line, "--to", "again")
    for file in Path("tables").iterdir():
        assert file.read_bytes() == (Path("again") / file.name).read_bytes()


def test_notes_are_named_on_standard_error(arcless: Command) -> None:
    arcless("new", "ridge", "--from", "norway-s25")
    arcless("table", "ridge.yaml", "--to", "ridge")
    Path("ridge/remarks.csv").write_text("x")
    done = arcless("table", "ridge.yaml", "--from", "ridge")
    assert done.stderr == "warning: left out, as no tables of a line: remarks.csv\n"
    # It is not said that all of the folder says the same.
    assert done.stdout == (
        "ridge.yaml: nothing to change, what was read of ridge says the same: curves, droppers,"
        " inserts, point_masses, spans, supports, tension_lengths\n"
    )
    Path("ridge/remarks.csv").rename("ridge/# remarks.csv")
    done = arcless("table", "ridge.yaml", "--from", "ridge")
    assert (done.stdout, done.stderr) == (
        "ridge.yaml: nothing to change, ridge says the same\n", "",
    )  # fmt: skip


def test_a_workbook_that_exists_is_replaced_only_if_asked(arcless: Command) -> None:
    pytest.importorskip("openpyxl")
    Path("office.xlsx").write_bytes(b"edited")
    done = arcless("table", "norway-s25", "--to", "office.xlsx")
    assert done.exit_code == 2
    assert "office.xlsx: the workbook exists" in done.stderr
    assert "`--overwrite` replaces it" in done.stderr
    assert Path("office.xlsx").read_bytes() == b"edited"
    done = arcless("table", "norway-s25", "--to", "office.xlsx", "--overwrite")
    assert (done.exit_code, done.stdout) == (0, "wrote office.xlsx\n")
    assert Path("office.xlsx").read_bytes() != b"edited"


def test_tables_in_a_folder_are_replaced_only_if_asked(arcless: Command) -> None:
    """Tables of another line go; what is no table of a line stays."""
    arcless("new", "ridge", "--from", "norway-s25")
    arcless("table", "shinkansen-heavy-compound", "--to", "tables")
    Path("tables/Spans.csv").write_text("x")
    Path("tables/remarks.csv").write_text("x")
    Path("tables/hangers.txt").write_text("x")
    before = {path: path.read_bytes() for path in Path("tables").iterdir()}
    done = arcless("table", "ridge.yaml", "--to", "tables")
    assert done.exit_code == 2
    assert "tables: tables of a line are in this folder: got Spans.csv, curves.csv" in done.stderr
    assert {path: path.read_bytes() for path in Path("tables").iterdir()} == before
    done = arcless("table", "ridge.yaml", "--to", "tables", "--overwrite")
    assert done.exit_code == 0
    removed = [line.split(",")[0] for line in done.stdout.splitlines() if "removed" in line]
    assert removed == [
        f"removed {Path('tables/Spans.csv')}",
        f"removed {Path('tables/hangers.csv')}",
    ]
    assert before.keys() - set(Path("tables").iterdir()) == {
        Path("tables/Spans.csv"), Path("tables/hangers.csv"),
    }  # fmt: skip
    assert "nothing to change" in arcless("table", "ridge.yaml", "--from", "tables").stdout


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["table", "norway-s25"], "expected --to TABLES to write tables, or --from TABLES"),
        (["table", "norway-s25", "--to", "a", "--from", "a"], "got --to and --from"),
        (["table", "norway-s25", "--from", "a", "--overwrite"], "got --overwrite with --from"),
        (["table", "norway-s25", "--to", "tables"], "tables of a line are in this folder"),
        (["table", "norway-s25", "--to", "line.csv"], "a line takes several CSV files"),
        (["table", "norway-s25", "--to", "line.ods"], "unknown kind of file"),
        (["table", "norway-s25", "--to", "absent/tables"], "the folder cannot be made"),
        (["table", "dsa-250", "--to", "a"], "got the pantograph dsa-250"),
        (["table", "norway-s2", "--to", "a"], "norway-s2"),
        (["table", "norway-s25", "--from", "tables"], "arcless new my-norway-s25 --from"),
        (["table", "absent.yaml", "--from", "tables"], "no such file"),
        (["table", "scenario.yaml", "--from", "tables"], "its line is norway-s25"),
        (["table", "line.yaml", "--from", "absent"], "absent: no tables"),
        (["table", "line.yaml", "--from", "tables"], "row 4, column length: no number"),
        (["new", "mine", "--from", "norway-s25", "--table", "tables"], "row 4, column length"),
    ],
)  # fmt: skip
def test_bad_input_is_told_and_nothing_is_written(
    arcless: Command, words: list[str], told: str
) -> None:
    Path("line.yaml").write_text(shipped("line")["norway-s25"].read_text("utf-8"), "utf-8")
    text = shipped("scenario")["norway-s25-250"].read_text("utf-8")
    Path("scenario.yaml").write_text(text, "utf-8")
    arcless("table", "norway-s25", "--to", "tables")
    spans = Path("tables/spans.csv")
    spans.write_text(spans.read_text().replace("3,standard,60.0", "3,standard,x"))
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    done = arcless(*words)
    assert done.exit_code == 2
    assert told in done.stderr
    assert {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()} == before


def test_tables_that_are_read_twice_change_nothing_the_second_time(arcless: Command) -> None:
    arcless("new", "ridge", "--from", "norway-s25")
    arcless("table", "ridge.yaml", "--to", "ridge")
    spans = Path("ridge/spans.csv")
    spans.write_text(spans.read_text().replace("7,standard,60.0", "7,standard,60.5"))
    assert "changed" in arcless("table", "ridge.yaml", "--from", "ridge").stdout
    assert "nothing to change" in arcless("table", "ridge.yaml", "--from", "ridge").stdout
    spans.write_text(spans.read_text().replace("7,standard,60.5", "7,standard,61"))
    changed = arcless("table", "ridge.yaml", "--from", "ridge").stdout.splitlines()[0]
    assert changed == "changed ridge.yaml: span_types.standard-7"
