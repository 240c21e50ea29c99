"""A study that was begun, opened in Python: its table as a data frame, its status as a card."""

from pathlib import Path
from xml.etree import ElementTree

import pyarrow.parquet
import pytest

import arcless
from arcless.errors import StudyError
from tests.support.studies import study, written

HEADERS = ["tension [N]", "force [N]", "sigma [N]", "ratio"]


def test_its_rows_are_those_of_its_table(tmp_path: Path) -> None:
    folder = tmp_path / "grid"
    arcless.study.run(study(), folder)
    opened = arcless.study.open(folder)
    made = opened.to_dataframe()
    assert list(made.columns)[:4] == HEADERS
    assert list(made.index) == [1, 2, 3, 4, 5, 6]
    kept = pyarrow.parquet.read_table(opened.table).to_pydict()
    assert made["sigma [N]"].dropna().tolist() == [one for one in kept["sigma"] if one is not None]
    assert made["tension [N]"].tolist() == kept["tension"]
    assert made.attrs["units"]["sigma [N]"] == "N"
    assert repr(opened) == f"<StudyFolder small: {folder}>"


def test_its_status_is_a_card(tmp_path: Path) -> None:
    arcless.study.run(study(), tmp_path)
    found = arcless.study.status(study(), tmp_path)
    assert found.sentence == "4 of 6 done, 2 invalid, 0 failed, 0 missing; not being computed"
    shown = "".join(ElementTree.fromstring(found._repr_html_()).itertext())
    assert found.sentence in shown
    assert next(iter(found.errors)) in shown


def test_a_study_that_was_not_begun_is_told(tmp_path: Path) -> None:
    for source in (tmp_path, written(tmp_path)):
        with pytest.raises(StudyError, match="no study was begun here"):
            arcless.study.open(source)
