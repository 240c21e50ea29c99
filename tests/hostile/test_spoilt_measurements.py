"""Spoilt records of test runs are read, or refused with the file; and no number is made up."""

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from arcless.errors import ArclessError, MeasurementError
from arcless.measurements import Head, assess, read, write_report
from tests.support.hostile import HOSTILE, searching, spoilt_text
from tests.support.measured import force, times

# Short enough to be spoilt byte by byte, long enough to be assessed: 3 s at 100 Hz.
TIME = times(3.0, 100.0)
HEADS = {
    "force": "time [s],position [m],contact_force [N],contact_height [mm]",
    "sensors": "time [s],speed [km/h],sensor_force_1 [N],acceleration [m/s2]",
    "by place": "position [m];speed [km/h];P1.contact_force [N];P2.contact_force [N]",
}


def record(kind: str) -> list[list[str]]:
    load = force(TIME)
    columns = {
        "force": (TIME, 70 * TIME, load, 5300 + load / 10),
        "sensors": (TIME, 250 + 0 * TIME, load, np.sin(40 * TIME)),
        "by place": (70 * TIME, 250 + np.sin(TIME), load, load[::-1]),
    }[kind]
    return [[f"{value:.3f}" for value in row] for row in zip(*columns, strict=True)]


def text(kind: str, rows: list[list[str]]) -> bytes:
    delimiter = ";" if ";" in HEADS[kind] else ","
    lines = [HEADS[kind], *(delimiter.join(row) for row in rows)]
    return ("\n".join(lines) + "\n").encode("utf-8", "surrogatepass")


def check(path: Path, head: Head | None) -> None:
    """Read and assess a file that may be spoilt; a warning of a library is a fault."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            measured = read(path, speed="250 km/h", head=head)
            for one in measured.pantographs:
                assert np.isfinite(one.force).all()
                assert (np.diff(one.time) > 0.0).all()
                assert sum(piece.stop - piece.start for piece in one.pieces) == one.force.size
            found = assess(measured)
        except ArclessError as error:
            message = str(error)
            assert error.exit_code == 2
            assert message.isprintable(), message
            assert isinstance(error, MeasurementError), message
            assert str(path) in message, message
        else:
            found.to_json()
            write_report(measured, found, path.with_suffix(".html"))


@searching(150)
@given(data=st.data())
def test_spoilt_bytes(data: Any, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.getbasetemp() / "spoilt.csv"
    kind = data.draw(st.sampled_from(sorted(HEADS)))
    path.write_bytes(data.draw(spoilt_text(text(kind, record(kind)))))
    check(path, data.draw(st.sampled_from([None, Head(8.0)])))


@searching(150)
@given(data=st.data())
def test_spoilt_cells_and_rows(data: Any, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.getbasetemp() / "cells.csv"
    kind = data.draw(st.sampled_from(sorted(HEADS)))
    rows = record(kind)
    for _ in range(data.draw(st.integers(1, 6))):
        row = data.draw(st.integers(0, len(rows) - 1))
        what = data.draw(st.sampled_from(["cell", "same", "gone", "twice", "moved"]))
        if what == "gone":
            del rows[row : row + data.draw(st.integers(1, 40))]
            rows = rows or record(kind)
        elif what == "twice":
            rows.insert(row, rows[row])
        elif what == "moved":
            rows.append(rows.pop(row))
        else:
            column = data.draw(st.integers(0, 3))
            cell = str(data.draw(HOSTILE)).replace("\n", " ")
            for one in rows[row : row + (30 if what == "same" else 1)]:
                one[column] = cell
    path.write_bytes(text(kind, rows))
    check(path, data.draw(st.sampled_from([None, Head(8.0)])))
