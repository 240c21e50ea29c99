"""Alignment of signals whose offset is known: with noise, gaps, drift, and lines that repeat."""

import math

import numpy as np
import pytest

from arcless.comparison.alignment import Search, Trace, aligned
from arcless.comparison.alignment.alignment import told_apart
from arcless.comparison.alignment.correlation import correlations, spectrum_of, vertex
from arcless.comparison.alignment.folding import repeated
from arcless.errors import ComparisonError

SPAN_M, SPANS, WAVE_M = 50.0, 12, 4.0
X = np.arange(0.0, SPAN_M * SPANS, 0.1)
SUPPORTS = SPAN_M * np.arange(SPANS + 1)


def periodic(x: np.ndarray) -> np.ndarray:
    """Return a force in N that repeats at every support: its first four orders."""
    turn = 2.0 * np.pi * x / SPAN_M
    return 100.0 + 20.0 * np.cos(turn) + 8.0 * np.sin(2 * turn) + 6.0 * np.cos(4 * turn + 1.0)


def band_noise(seed: int, x: np.ndarray) -> np.ndarray:
    """Return noise of deviation 1 whose waves are longer than `WAVE_M`, over places in m."""
    random = np.random.default_rng(seed)
    waves = np.arange(1, int(1000.0 / WAVE_M))
    phases = random.uniform(0.0, 2.0 * np.pi, waves.size)
    angles = 2.0 * np.pi * np.outer(x, waves) / 1000.0 + phases
    return math.sqrt(2.0 / waves.size) * np.cos(angles).sum(axis=1)


def trace(x: np.ndarray, values: np.ndarray, valid: np.ndarray | None = None) -> Trace:
    return Trace(x, values, np.ones(x.size, bool) if valid is None else valid, WAVE_M)


# Places of a test run on the line, at another spacing than those of the run.
RUN = np.arange(80.0, 480.0, 0.37)


@pytest.mark.parametrize("offset", [-23.4, 0.0, 3.2, 24.9])
def test_offset_of_a_line_without_repetition(offset: float) -> None:
    force = 100.0 + 20.0 * band_noise(1, X)
    measured = trace(RUN - offset, 100.0 + 20.0 * band_noise(1, RUN))
    found = aligned(trace(X, force), measured, Search())
    # A parabola through steps of an eighth of the shortest wave.
    assert found.offset_m == pytest.approx(offset, abs=WAVE_M / 100.0)
    assert found.correlation == pytest.approx(1.0, abs=2e-3)
    assert not found.ambiguous
    assert found.overlap_m == pytest.approx((80.0, 480.0), abs=0.4)
    np.testing.assert_allclose(found.on_line(measured.position_m), RUN, atol=WAVE_M / 100.0)


def test_a_better_place_beyond_the_search_is_told_where_the_place_is_poor() -> None:
    force = 100.0 + 20.0 * band_noise(1, X)
    # Half noise: the true place, 60 m away, has a correlation of 0.7, chance places have less.
    noisy = band_noise(1, RUN) + 1.2 * band_noise(9, RUN)
    measured = trace(RUN - 60.0, 100.0 + 20.0 * noisy)
    found = aligned(trace(X, force), measured, Search(-25.0, 25.0))
    assert found.correlation is not None
    assert found.correlation < 0.5
    assert found.beyond_offset_m == pytest.approx(60.0, abs=WAVE_M / 10.0)


@pytest.mark.parametrize("drift", [-0.004, 0.001, 0.0047])
def test_drift_of_the_odometer(drift: float) -> None:
    force = 100.0 + 20.0 * band_noise(2, X)
    shown = 5.0 + (RUN - RUN[0]) * (1.0 + drift)
    measured = trace(shown, 100.0 + 20.0 * band_noise(2, RUN))
    found = aligned(trace(X, force), measured, Search(scale_within=0.005))
    assert found.scale == pytest.approx(1.0 / (1.0 + drift), abs=1e-4)  # 4 cm over the 400 m
    np.testing.assert_allclose(found.on_line(shown), RUN, atol=0.05)
    stiff = aligned(trace(X, force), measured, Search())
    assert stiff.scale == 1.0


def test_spans_that_are_alike_are_ambiguous() -> None:
    measured = trace(RUN - 3.0, periodic(RUN))
    anywhere = aligned(trace(X, periodic(X)), measured, Search())
    assert anywhere.ambiguous
    assert anywhere.next_offset_m is not None
    apart = (anywhere.offset_m - anywhere.next_offset_m) / SPAN_M
    assert apart == pytest.approx(round(apart), abs=1e-3)
    near = aligned(trace(X, periodic(X)), measured, Search(-25.0, 25.0))
    assert near.offset_m == pytest.approx(3.0, abs=0.02)
    assert not near.ambiguous
    assert near.beyond_offset_m is None


def test_a_better_place_out_of_the_search_is_told() -> None:
    force = periodic(X) + 5.0 * band_noise(3, X)
    measured = trace(RUN - 60.0, periodic(RUN) + 5.0 * band_noise(3, RUN))
    found = aligned(trace(X, force), measured, Search(-25.0, 25.0))
    assert found.offset_m == pytest.approx(10.0, abs=1.0)  # one span too little
    assert found.beyond_offset_m == pytest.approx(60.0, abs=0.05)
    assert found.beyond_correlation is not None
    assert found.correlation is not None
    assert found.beyond_correlation > found.correlation


def test_samples_that_do_not_count_change_nothing() -> None:
    force = 100.0 + 20.0 * band_noise(4, X)
    values, valid = 100.0 + 20.0 * band_noise(4, RUN), np.ones(RUN.size, bool)
    valid[200:260] = valid[700:710] = False
    values[~valid] = 1e4
    found = aligned(trace(X, force), trace(RUN - 7.0, values, valid), Search())
    assert found.offset_m == pytest.approx(7.0, abs=WAVE_M / 100.0)


def test_correlation_is_that_of_the_sums_written_out() -> None:
    random = np.random.default_rng(5)
    a, b = random.standard_normal(40) + 3.0, random.standard_normal(25) - 2.0
    known_a, known_b = random.random(40) > 0.2, random.random(25) > 0.2
    shifts, r, count = correlations(
        spectrum_of(a, known_a, 128), spectrum_of(b, known_b, 128), 128
    )  # fmt: skip
    for shift, found, n in zip(shifts, r, count, strict=True):
        pairs = [(a[i], b[i - shift]) for i in range(40)
                 if 0 <= i - shift < 25 and known_a[i] and known_b[i - shift]]  # fmt: skip
        assert n == len(pairs)
        if len(pairs) > 2:
            assert found == pytest.approx(np.corrcoef(np.array(pairs).T)[0, 1], abs=1e-9)


@pytest.mark.parametrize("seed", range(10))
def test_noise_as_large_as_the_signal_finds_the_place_or_says_that_it_is_not_sure(
    seed: int,
) -> None:
    random = np.random.default_rng(100 + seed)
    offset, noise = random.uniform(-20.0, 20.0), band_noise(200 + seed, RUN)
    values = periodic(RUN) + 15.8 * noise  # the deviation of the signal
    found = aligned(trace(X, periodic(X)), trace(RUN - offset, values), Search(-25.0, 25.0))
    # Of a wave of 12 m and noise of its size over 400 m, r has a maximum some dm wide.
    assert found.offset_m == pytest.approx(offset, abs=1.0)


def test_supports_alone() -> None:
    line = trace(X, periodic(X) + 4.0 * band_noise(6, X))
    template = repeated(line, SUPPORTS)
    # The mean of 12 spans has 1/√12 of what is not common to them, 4 N.
    np.testing.assert_allclose(template.values, periodic(X), atol=4.0 * 4.0 / math.sqrt(12.0))
    found = aligned(template, trace(RUN + 9.0, periodic(RUN)), Search(-25.0, 25.0), "supports")
    # 1.2 N of noise on slopes of 3.1 N/m, over 25 half waves of 2 m in a span: 0.08 m, and three
    # times that.
    assert found.offset_m == pytest.approx(-9.0, abs=0.24)
    assert found.method == "supports"
    with pytest.raises(ComparisonError, match="too few whole spans"):
        repeated(trace(X[:900], periodic(X[:900])), SUPPORTS)


def test_what_cannot_be_aligned() -> None:
    line = trace(X, periodic(X))
    with pytest.raises(ComparisonError, match="measurement is constant"):
        aligned(line, trace(RUN, np.full(RUN.size, 80.0)), Search())
    with pytest.raises(ComparisonError, match="too short"):
        aligned(line, trace(RUN[:50], periodic(RUN[:50])), Search())
    with pytest.raises(ComparisonError, match="no maximum"):
        aligned(line, trace(RUN, periodic(RUN)), Search(5000.0, 6000.0))


def test_vertex_of_a_parabola() -> None:
    assert vertex(-0.81, -0.01, -1.21) == pytest.approx((-0.1, 0.0))
    assert vertex(1.0, 2.0, 3.0) == (0.0, 2.0)


def test_two_correlations_are_told_apart_by_their_samples() -> None:
    # atanh 0.8 − atanh 0.7 = 0.2313: 1.645 deviations at n = 3 + 2 (1.645/0.2313)² = 104.2.
    assert not told_apart(0.8, 0.7, 104.0)
    assert told_apart(0.8, 0.7, 105.0)
    assert not told_apart(0.9, 0.1, 3.0)
