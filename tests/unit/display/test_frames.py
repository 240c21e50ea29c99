"""Data frames from columns."""

import numpy as np
import pytest

from arcless.display.frames import frame
from arcless.errors import OutputError
from arcless.storage.csv_files import Column

TABLES = {
    "times": lambda: [
        Column("time", "s", np.array([0.0, 0.1])),
        Column("force", "N", [None, None]),
        Column("place", "", ["a", "b"]),
    ]
}


def test_columns_have_their_units() -> None:
    made = frame(TABLES, "times")
    assert list(made.columns) == ["time [s]", "force [N]", "place"]
    assert made.attrs["units"] == {"time [s]": "s", "force [N]": "N", "place": ""}
    assert list(made.index) == [0, 1]


def test_an_index_is_a_column() -> None:
    made = frame(TABLES, "times", "time")
    assert made.index.name == "time [s]"
    assert list(made.columns) == ["force [N]", "place"]


def test_what_is_nowhere_known_is_still_a_number() -> None:
    assert frame(TABLES, "times")["force [N]"].isna().all()
    assert frame(TABLES, "times")["force [N]"].dtype == float


def test_an_unknown_table_is_refused() -> None:
    with pytest.raises(OutputError, match='unknown table: got "droppers", expected `times`'):
        frame(TABLES, "droppers")
