"""Samples near the ends of pieces, of pieces that are shorter than what does not count too."""

from pathlib import Path

import numpy as np

from arcless.measurements import read
from arcless.measurements.samples.settled import settled
from tests.support.measured import record, write


def test_a_first_piece_shorter_than_the_ends_marks_nothing(tmp_path: Path) -> None:
    rows = np.ones(5000, bool)
    rows[20:60] = False
    columns = {name: values[rows] for name, values in record().items()}
    [one] = read(write(tmp_path / "run.csv", columns)).pantographs
    assert [piece.stop - piece.start for piece in one.pieces] == [20, 4940]
    far = settled(one, 0.2)  # 100 samples at each end
    assert not far[:120].any()
    assert far[120:-100].all()
    assert not far[-100:].any()
