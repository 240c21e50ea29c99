"""Tables as CSV files."""

import csv
import math
from pathlib import Path

import numpy as np
import pytest

from arcless.errors import OutputError
from arcless.storage import csv_files
from arcless.storage.csv_files import Column, write_csv, write_csv_files


def test_numbers_are_read_with_the_same_bits(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(csv_files, "ROWS_AT_ONCE", 7)  # several portions, the last not full
    values = np.random.default_rng(1).normal(size=100) * 10.0 ** np.arange(-50, 50)
    write_csv(tmp_path / "x.csv", [Column("force", "N", values)])
    head, *rows = (tmp_path / "x.csv").read_text("utf-8").splitlines()
    assert head == "force [N]"
    assert np.array_equal([float(row) for row in rows], values)


def test_what_is_no_number_is_an_empty_cell(tmp_path: Path) -> None:
    columns = [
        Column("a", "m", [1.0, None, math.nan]),
        Column("b", "m", [None, math.nan, 2.04], decimals=1),
        Column("c", "", [1, 2, 3]),
    ]
    write_csv(tmp_path / "x.csv", columns)
    assert (tmp_path / "x.csv").read_bytes() == b"a [m],b [m],c\n1.0,,1\n,,2\n,2.0,3\n"


def test_names_with_commas_quotes_and_line_ends_are_read_back(tmp_path: Path) -> None:
    names = ['a,b "c"', "zwei\nZeilen", "überholt"]
    write_csv(tmp_path / "x.csv", [Column("name, which", "", names), Column("n", "", [1, 2, 3])])
    with (tmp_path / "x.csv").open(encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    assert head == ["name, which", "n"]
    assert [row[0] for row in rows] == names


def test_columns_of_unequal_length_leave_the_old_file(tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text("old")
    with pytest.raises(ValueError, match="zip"):
        write_csv(tmp_path / "x.csv", [Column("a", "", [1, 2]), Column("b", "", [1])])
    assert (tmp_path / "x.csv").read_text() == "old"
    assert len(list(tmp_path.iterdir())) == 1


def test_a_folder_that_is_missing_is_told(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="cannot be written"):
        write_csv(tmp_path / "absent" / "x.csv", [Column("a", "", [1])])


def test_several_files_are_replaced_together_or_not_at_all(tmp_path: Path) -> None:
    good, bad = [Column("x", "m", [1.0])], [Column("x", "m", [object()])]
    files = [tmp_path / f"{number}.csv" for number in range(8)]
    write_csv_files(dict.fromkeys(files, good))
    assert {file.read_text() for file in files} == {"x [m]\n1.0\n"}
    with pytest.raises(OutputError):
        write_csv_files({files[0]: [Column("y", "m", [2.0])], tmp_path / "absent/9.csv": bad})
    assert {file.read_text() for file in files} == {"x [m]\n1.0\n"}
    assert sorted(tmp_path.iterdir()) == files
