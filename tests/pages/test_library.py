"""The library page lists models as they are."""

import numpy as np
import pytest

from arcless.model.shipped.library import shipped as known
from tests.support.pages import cells, from_docs, table

shipped = from_docs("shipped")


def test_rows_are_models() -> None:
    rows = {row[0] for row in cells(table("library", "lines"))}
    models = {row[0] for row in cells(table("library", "pantographs"))}
    assert rows == set(known("line"))
    assert models == set(known("pantograph"))


@pytest.mark.parametrize("name", ["norway-s25", "shinkansen-heavy-compound", "conductor-rail-1"])
def test_numbers_are_the_models(name: str) -> None:
    row = next(row for row in cells(table("library", "lines")) if row[0] == name)
    found = shipped.at_rest(name)
    e = 1e3 * np.array(found.elasticity_m_per_N)
    assert float(row[6]) == pytest.approx(e[0], rel=0.01)  # three digits
    assert float(row[7]) == pytest.approx(e[len(e) // 2], rel=0.01)
    marks = [entry.mark for entry in found.scenario.line.provenance.values()]
    # Read or computed from what was read; second-hand; from memory; assumed.
    groups = ({"A", "A'", "D"}, {"B"}, {"C", "C*"}, {"assumed"})
    assert row[8:] == [str(sum(m in group for m in marks)) for group in groups]
