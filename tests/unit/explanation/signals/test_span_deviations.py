"""Whole spans of a section, and the deviation in each."""

import numpy as np

from arcless.explanation.signals.span_deviations import deviations, whole_spans


def test_spans_must_be_whole() -> None:
    supports = np.array([0.0, 50.0, 110.0, 160.0])
    assert whole_spans(supports, (10.0, 160.0), (0.0, 200.0)) == [
        (2, 50.0, 110.0),
        (3, 110.0, 160.0),
    ]
    assert whole_spans(supports, (0.0, 160.0), (0.0, 120.0)) == [(1, 0.0, 50.0), (2, 50.0, 110.0)]
    assert whole_spans(supports, (60.0, 100.0), (0.0, 200.0)) == []


def test_each_span_has_its_own_deviation() -> None:
    x = np.linspace(0.0, 100.0, 10_000, endpoint=False)
    force = np.where(x < 50.0, 3.0, 7.0) * np.sin(2.0 * np.pi * x / 50.0)
    found = deviations(x, force, [(1, 0.0, 50.0), (2, 50.0, 100.0)])
    np.testing.assert_allclose(found, np.array([3.0, 7.0]) / np.sqrt(2.0), rtol=1e-9)  # rounding
