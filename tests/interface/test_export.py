"""`arcless export`: a run as CSV, Excel, MATLAB and Parquet, and what is refused."""

import csv
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from typer.testing import Result

import arcless as package
from arcless.errors import OutputError
from arcless.results.export import files, tables
from tests.support.small import small
from tests.support.studies import filled

Command = Callable[..., Result]
# Statistics of the exported columns are sums in another order than those of the assessment.
SUMS = 1e-9


def read(path: Path) -> dict[str, list[str]]:
    with path.open(encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    return dict(zip(head, map(list, zip(*rows, strict=True)), strict=True))


def test_csv_holds_the_channels_with_units_and_every_bit(arcless: Command, finished: Path) -> None:
    done = arcless("export", finished, "--to", "run.csv")
    assert (done.exit_code, done.stdout) == (0, "wrote run.csv\n")
    found, data = read(Path("run.csv")), package.open(finished).dataset
    assert np.array_equal(np.float64(found["time [s]"]), data["time"])
    for key, unit in (("position", "m"), ("contact_force", "N"), ("contact_height", "m")):
        assert np.array_equal(np.float64(found[f"P1.{key} [{unit}]"]), data[key][:, 0]), key
    assert "P1.mass_2.displacement [m]" in found


def test_recorded_motion_is_left_out_with_a_word(
    arcless: Command, finished: Path, tmp_path: Path
) -> None:
    assert "motion" not in arcless("export", finished, "--to", "plain.csv").stderr
    package.run(small().with_(output={"motion": True})).save(tmp_path / "result.nc")
    for name in ("run.csv", "run.mat"):
        done = arcless("export", tmp_path / "result.nc", "--to", name)
        assert (done.exit_code, done.stdout) == (0, f"wrote {name}\n")
        assert "motion of the wires is not exported: result.nc has it" in done.stderr
    assert "motion" not in Path("run.csv").read_text("utf-8").splitlines()[0]


def test_the_filtered_force_has_the_statistics_of_the_assessment(
    arcless: Command, finished: Path
) -> None:
    arcless("export", finished, "--to", "run.csv")
    found, assessment = read(Path("run.csv")), package.open(finished).assessment
    position = np.float64(found["P1.position [m]"])
    force = np.float64(found["P1.contact_force_filtered [N]"])
    begin, end = assessment.section_m
    inside = force[(position >= begin) & (position <= end)]
    told = assessment.pantographs[0]
    assert inside.mean() == pytest.approx(told.mean_force_N, rel=SUMS)
    assert inside.max() == pytest.approx(told.max_force_N, rel=SUMS)
    assert inside.min() == pytest.approx(told.min_force_N, rel=SUMS)


def test_parquet_has_the_same_columns_as_csv(arcless: Command, finished: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    assert arcless("export", finished, "--to", "run.parquet").exit_code == 0
    arcless("export", finished, "--to", "run.csv")
    found, table = read(Path("run.csv")), parquet.read_table("run.parquet")
    assert table.column_names == list(found)
    for name, values in found.items():
        assert np.array_equal(table[name].to_numpy(), np.float64(values)), name
    assert table.schema.field("P1.contact_force [N]").metadata == {b"units": b"N"}
    assert table.schema.metadata[b"scenario"] == b"short"


def test_matlab_has_names_it_takes_and_headers(arcless: Command, finished: Path) -> None:
    from scipy.io import loadmat

    assert arcless("export", finished, "--to", "run.mat").exit_code == 0
    found = loadmat("run.mat", simplify_cells=True)
    data, channels = package.open(finished).dataset, found["contact_channels"]
    assert np.array_equal(channels["P1_contact_force"], data["contact_force"][:, 0])
    assert "P1.contact_force [N]" in channels["headers"].tolist()
    assert found["droppers"]["dropper"].tolist() == data["dropper"].values.tolist()
    assert np.array_equal(found["droppers"]["dropper_length"], data["dropper_length"])
    assert np.array_equal(found["supports"]["support_x"], data["support_x"])
    assert found["scenario"] == "short"


def test_matlab_names_are_told_apart() -> None:
    columns = [tables.Column(name, "N", [1.0]) for name in ("a b", "a-b", "1", "headers", "ä")]
    made = files._struct(columns)
    assert list(made) == ["a_b", "a_b_2", "x1", "headers_2", "x_", "headers"]
    long = files._struct([tables.Column("a" * 70 + end, "", [1.0]) for end in "bc"])
    assert [len(name) for name in long] == [63, 63, 7]


def test_excel_has_a_sheet_for_each_table(arcless: Command, finished: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    assert arcless("export", finished, "--to", "run.xlsx").exit_code == 0
    book = openpyxl.load_workbook("run.xlsx")
    assert book.sheetnames == [
        "assessment",
        "criteria",
        "contact channels",
        "droppers",
        "supports",
        "support channels",
    ]
    result = package.open(finished)
    rows = {row[0]: row for row in book["assessment"].values}
    told = result.assessment.pantographs[0]
    assert rows["key"] == ("key", "quantity", "unit", "pantograph P1", "run")
    assert rows["std_force_N"][1:3] == ("standard deviation σ", "N")
    # Numbers of a sheet have 16 digits.
    assert rows["std_force_N"][3] == pytest.approx(told.std_force_N, rel=1e-15)
    names = [row[0] for row in book["criteria"].values][1:]
    assert names == [criterion.name for criterion in result.assessment.criteria]
    assert book["contact channels"].max_row == 1 + result.dataset.sizes["time"]
    assert book["droppers"].max_row == 1 + result.dataset.sizes["dropper"]
    assert book["supports"]["A2"].value == str(result.dataset["support"].values[0])


def test_a_run_that_stopped_before_its_section_is_exported(arcless: Command, short: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    arcless("run", short, "--until", "70 m", "--quiet", "--out", "part")
    assert arcless("export", "part", "--to", "part.csv").exit_code == 0
    assert arcless("export", "part", "--to", "part.xlsx").exit_code == 0
    sheet = openpyxl.load_workbook("part.xlsx")["assessment"]
    assert sheet["A1"].value == "not assessed"
    assert "analysis section" in sheet["A2"].value


def test_two_pantographs_have_columns_of_their_own(tmp_path: Path) -> None:
    run = package.run(package.load("ac-simple-320-two-pantographs"), until="320 m")
    run.export(tmp_path / "run.csv")
    found = read(tmp_path / "run.csv")
    for index, name in enumerate(run.dataset["pantograph"].values):
        force = np.float64(found[f"{name}.contact_force [N]"])
        assert np.array_equal(force, run.dataset["contact_force"][:, index])
        assert f"{name}.contact_force_filtered [N]" in found


def test_single_contacts_have_columns_and_empty_cells_without_a_wire(tmp_path: Path) -> None:
    run = package.run(package.load("spain-ca-160-3kv-160"), until="120 m")
    run.export(tmp_path / "run.csv")
    found, contacts = read(tmp_path / "run.csv"), run.dataset["contact"].values
    assert len(contacts) == 2
    for index, name in enumerate(contacts):
        for key, unit in (("wire_contact_force", "N"), ("wire_contact_lateral", "m")):
            read_back = [float(cell or "nan") for cell in found[f"{name}.{key} [{unit}]"]]
            assert np.array_equal(read_back, run.dataset[key][:, index], equal_nan=True)


def test_a_file_that_exists_is_replaced_whole(arcless: Command, finished: Path) -> None:
    Path("run.csv").write_text("old")
    assert arcless("export", finished, "--to", "run.csv").exit_code == 0
    assert Path("run.csv").read_text("utf-8").startswith("time [s],speed [m/s],P1.position [m],")
    assert [path.name for path in Path().iterdir()] == ["run.csv"]


@pytest.mark.parametrize(
    ("to", "words"),
    [
        ("run.txt", 'unknown kind of file: got ".txt", expected a name that ends in .csv, .xlsx'),
        ("run", "got a name without an ending"),
        ("absent/run.csv", "no folder"),
    ],
)
def test_a_place_is_refused_before_anything_is_read(arcless: Command, to: str, words: str) -> None:
    done = arcless("export", "no-run", "--to", to)
    assert done.exit_code == 2
    assert words in done.stderr


def test_what_is_no_run_is_refused(arcless: Command, finished: Path) -> None:
    Path("text.nc").write_text("no result")
    Path("sweep").mkdir()
    Path("sweep/study.json").write_bytes(b"")
    for source, words in (
        ("text.nc", "text.nc"),
        ("absent", "absent"),
        ("sweep", "sweep/study.json"),
        ("speed-sweep", "this is a shipped study: `arcless study run speed-sweep`"),
    ):
        done = arcless("export", source, "--to", "run.csv")
        assert done.exit_code == 2, source
        assert words in done.stderr, source
        assert not Path("run.csv").exists()


def test_a_damaged_result_leaves_the_old_file(arcless: Command, finished: Path) -> None:
    shutil.copy(finished / "result.nc", "cut.nc")
    content = Path("cut.nc").read_bytes()
    Path("cut.nc").write_bytes(content[: len(content) // 2])
    Path("run.csv").write_text("old")
    assert arcless("export", "cut.nc", "--to", "run.csv").exit_code == 2
    assert Path("run.csv").read_text() == "old"


@pytest.mark.parametrize(("ending", "extra"), [("xlsx", "excel"), ("parquet", "study")])
def test_a_missing_package_is_named_with_its_extra(
    ending: str, extra: str, finished: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(files, "find_spec", lambda _name: None)
    with pytest.raises(OutputError, match=rf"pip install 'arcless\[{extra}\]'"):
        package.open(finished).export(tmp_path / f"run.{ending}")


def test_a_sheet_takes_no_more_rows_than_excel_has(
    finished: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("openpyxl")
    monkeypatch.setattr(files, "MOST_ROWS", 100)
    with pytest.raises(OutputError, match="expected 100 rows at most"):
        package.open(finished).export(tmp_path / "run.xlsx")


def test_the_table_of_a_study(arcless: Command, tmp_path: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    filled(tmp_path / "here")
    frame = package.study.open(tmp_path / "here").to_dataframe().reset_index()
    for source in ("here", "here/journal.db"):
        assert arcless("export", source, "--to", "table.csv").exit_code == 0
    assert arcless("export", "here", "--to", "table.xlsx").exit_code == 0
    found = read(Path("table.csv"))
    head, *rows = openpyxl.load_workbook("table.xlsx")["variants"].values
    assert list(found) == list(head) == list(frame.columns)
    assert len(rows) == len(frame) > 1
    number = next(name for name in found if name.startswith("sigma"))
    assert np.array_equal(np.float64(found[number]), frame[number])
    assert [row[head.index(number)] for row in rows] == list(frame[number])


@pytest.mark.parametrize("to", ["table.mat", "table.parquet"])
def test_a_study_is_a_table_of_texts_and_numbers(arcless: Command, tmp_path: Path, to: str) -> None:
    filled(tmp_path / "here")
    done = arcless("export", "here", "--to", to)
    assert done.exit_code == 2
    assert "expected a name that ends in .csv, .xlsx; hint: table.parquet" in done.stderr
    assert not Path(to).exists()
