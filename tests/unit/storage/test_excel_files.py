"""Workbooks: texts are no formulas, numbers keep every bit."""

from pathlib import Path

import pytest

from arcless.storage.csv_files import Column
from arcless.storage.excel_files import write_excel

openpyxl = pytest.importorskip("openpyxl")


def test_a_name_is_no_formula(tmp_path: Path) -> None:
    write_excel(tmp_path / "x.xlsx", {"s": [Column("=1+1", "", ["=2+2", "a\x07b"])]})
    sheet = openpyxl.load_workbook(tmp_path / "x.xlsx")["s"]
    assert [sheet[f"A{row}"].data_type for row in (1, 2)] == ["s", "s"]
    assert sheet["A3"].value == "a?b"


def test_numbers_keep_every_bit(tmp_path: Path) -> None:
    values = [0.1 + 0.2, 1 / 3, -2 / 3e7, 49.809999999999995, 1e22, 5e-324, 60.0, 7]
    write_excel(tmp_path / "x.xlsx", {"s": [Column("x", "m", values)]})
    sheet = openpyxl.load_workbook(tmp_path / "x.xlsx")["s"]
    assert [row[0] for row in sheet.values][1:] == values
    # As numbers, which a spreadsheet program computes with.
    assert {sheet[f"A{row}"].data_type for row in range(2, 10)} == {"n"}
