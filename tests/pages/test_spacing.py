"""What the page lines concludes from its tables of two pantographs."""

import re

import numpy as np

from tests.support.pages import cells, from_docs, table

spacing = from_docs("spacing")


def printed(name: str) -> list[list[str]]:
    return cells(table("lines", name))


def test_the_trailing_pantograph_is_the_worse_one_nearly_everywhere() -> None:
    rows = printed("leading")
    assert len(rows) == len(spacing.CASES)
    for row in rows:
        at, of = (int(word) for word in re.findall(r"\d+", row[4]))
        assert at >= 0.85 * of


def test_the_period_is_that_of_the_first_band_and_not_of_the_span() -> None:
    for case, row in zip(spacing.CASES, printed("period"), strict=True):
        low, high = spacing.first_band(case)
        # The fit is to half a metre in some seventy.
        assert 0.98 * low < float(row[2]) < 1.02 * high
        period, span, wave = float(row[1]), float(row[4]), float(row[5])
        assert abs(period / span - 1) > 0.15 and abs(period / wave - 1) > 0.08


def test_a_cosine_is_fitted_with_its_own_period() -> None:
    x = np.array(spacing.SPACINGS, dtype=float)
    for wanted in (55.0, 72.5, 100.0):
        sigma = np.sqrt(900.0 + 500.0 * np.cos(2 * np.pi * x / wanted + 1.0))
        assert spacing.period(x, sigma) == wanted  # on the grid of the search


def test_published_spacings_are_no_general_rule() -> None:
    """The study's worst (90 m, 150 m) and best (200 m, 210 m) are the other way round somewhere."""
    rows = {row[0]: [float(cell) for cell in row[1:]] for row in printed("spacing")[1:]}
    for case in range(3):
        worst = min(rows["90 m"][case], rows["150 m"][case])
        best = max(rows["200 m"][case], rows["210 m"][case])
        assert worst < best
