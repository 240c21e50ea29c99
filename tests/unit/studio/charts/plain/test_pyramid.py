"""Pyramids: no extreme is lost, no sample is made up, gaps stay, whatever the range."""

import numpy as np
from hypothesis import example, given
from hypothesis import strategies as st

from arcless.studio.charts.plain.pyramid import FACTOR, LEAST_BUCKETS, Pyramid


@st.composite
def asked(draw: st.DrawFn) -> tuple[np.ndarray, int, int, int]:
    """Return a series with gaps and a spike, a range of it, and a number of points."""
    count = draw(st.integers(1, 6000))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    values = random.normal(size=count)
    values[draw(st.integers(0, count - 1))] = draw(st.sampled_from([1e9, -1e9, 0.0]))
    for begin in draw(st.lists(st.integers(0, count - 1), max_size=3)):
        values[begin : begin + draw(st.integers(1, 200))] = np.nan
    begin = draw(st.integers(0, count - 1))
    return values, begin, draw(st.integers(begin + 1, count)), draw(st.integers(2, 900))


LONG = np.arange(10_000.0)


def bucket_size(begin: int, end: int, count: int, levels: int) -> int:
    """Return the samples of a bucket of the coarsest level that is fine enough for an answer."""
    level = 0
    while level < levels and end - begin >= FACTOR ** (level + 1) * count:
        level += 1
    return FACTOR**level


@given(asked())
@example((LONG, 0, LONG.size, 2))
@example((LONG, 4097, 9999, 16))
@example((np.full(1000, np.nan), 0, 1000, 100))
def test_extremes_of_a_range_are_never_lost(given_: tuple[np.ndarray, int, int, int]) -> None:
    values, begin, end, points = given_
    kept = Pyramid.of(values).samples(begin, end, points)
    known = values[begin:end][~np.isnan(values[begin:end])]
    found = values[kept]
    if known.size:
        assert np.nanmax(found) >= known.max()
        assert np.nanmin(found) <= known.min()
    # Rising, each once: they are drawn in this sequence.
    assert np.all(np.diff(kept) > 0)


@given(asked())
def test_every_bucket_keeps_its_extremes(given_: tuple[np.ndarray, int, int, int]) -> None:
    values, begin, end, points = given_
    pyramid = Pyramid.of(values)
    low, high = pyramid.buckets(begin, end, points)
    assert low.size == high.size <= points
    size = bucket_size(begin, end, points, len(pyramid.levels))
    first, last = begin // size, -(-end // size)
    together = max(1, -(-(last - first) // points))
    for number, (lowest, highest) in enumerate(zip(low, high, strict=True)):
        start = (first + number * together) * size
        bucket = values[start : min(start + together * size, last * size)]
        known = bucket[~np.isnan(bucket)]
        if known.size:
            assert values[lowest] == known.min()
            assert values[highest] == known.max()
        else:
            assert np.isnan(values[lowest])


@given(asked())
def test_few_samples_besides_gaps(given_: tuple[np.ndarray, int, int, int]) -> None:
    values, begin, end, points = given_
    pyramid = Pyramid.of(values)
    kept = pyramid.samples(begin, end, points)
    assert kept.size <= points + pyramid.gaps.size


def test_a_gap_of_one_sample_stays_a_gap() -> None:
    values = np.zeros(5000)
    values[2345] = np.nan
    kept = Pyramid.of(values).samples(0, values.size, 100)
    assert np.isnan(values[kept]).sum() == 1


def test_a_short_range_is_kept_whole() -> None:
    values = np.random.default_rng(0).normal(size=100_000)
    kept = Pyramid.of(values).samples(50_000, 50_400, 400)
    np.testing.assert_array_equal(kept, np.arange(50_000, 50_400))


def test_memory_is_two_sevenths_of_singles() -> None:
    values = np.zeros(FACTOR**7)
    pyramid = Pyramid.of(values)
    # Two indices of 4 bytes for 1/8 + 1/64 + … = 1/7 of the samples, down to the last level.
    assert pyramid.bytes <= 8 * values.size / 7
    assert pyramid.levels[-1][0].size <= LEAST_BUCKETS
