"""Decimation: few points, but no peak lost."""

import numpy as np
import pytest

from arcless.figures.description.thinning import envelope, every


@pytest.mark.parametrize("count", [0, 1, 2, 99, 100])
def test_short_series_are_kept_whole(count: int) -> None:
    assert envelope(np.zeros(count), 100).tolist() == list(range(count))


@pytest.mark.parametrize("count", [101, 150, 1_000, 12_345, 1_000_000])
@pytest.mark.parametrize("points", [4, 100, 101])
def test_the_number_of_points_is_bounded(count: int, points: int) -> None:
    kept = envelope(np.sin(np.arange(count) * 1.7), points)
    assert kept.size <= points
    assert kept[0] == 0
    assert kept[-1] == count - 1
    assert np.all(np.diff(kept) > 0)


@pytest.mark.parametrize("place", [0, 1, 777, 49_998, 49_999])
def test_a_peak_of_one_sample_survives(place: int) -> None:
    for peak in (-5.0, 5.0):
        values = np.zeros(50_000)
        values[place] = peak
        assert peak in values[envelope(values, 200)]


def test_extremes_of_noise_survive() -> None:
    values = np.random.default_rng(1).normal(size=100_001)
    kept = values[envelope(values, 500)]
    assert kept.max() == values.max()
    assert kept.min() == values.min()


@pytest.mark.parametrize(("count", "points", "kept"), [(0, 5, 0), (1, 5, 1), (7, 5, 5), (5, 7, 5)])
def test_every_keeps_both_ends(count: int, points: int, kept: int) -> None:
    indices = every(count, points)
    assert indices.size == kept
    assert indices.tolist() == sorted(set(indices.tolist()))
    if count:
        assert indices[0] == 0
        assert indices[-1] == (count - 1 if points > 1 else 0)
