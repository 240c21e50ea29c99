"""The period over the spacing of two pantographs: made-up curves come back, crests and share."""

import numpy as np
import pytest

from arcless.simulate.resonance import spacing_period

SPACINGS = np.arange(30.0, 221.0, 5.0)


def sigma(period: float, crest: float, second: float = 0.0) -> np.ndarray:
    """Return the root of a mean square with a period and a crest in m."""
    turns = 2.0 * np.pi * (SPACINGS - crest) / period
    return np.sqrt(2000.0 + 1500.0 * np.cos(turns) + second * np.cos(2.0 * turns))


@pytest.mark.parametrize(("period", "crest"), [(45.0, 40.0), (71.5, 60.0), (95.0, 20.0)])
def test_a_cosine_comes_back(period: float, crest: float) -> None:
    found = spacing_period(SPACINGS, sigma(period, crest))
    assert found is not None
    # The periods that are tried are 0.5 % apart, and the last crest is three periods away.
    assert found.length == pytest.approx(period, rel=2.5e-3)
    assert found.share > 0.999  # what a period wrong by 0.25 % leaves
    assert abs(found.phase(crest)) < 0.01
    assert abs(found.phase(crest + 1.5 * period)) == pytest.approx(0.5, abs=0.02)
    assert found.frequency(80.0) == pytest.approx(80.0 / period, rel=2.5e-3)
    assert 0.0 <= found.first_worst < found.length


def test_the_share_is_that_of_the_cosine() -> None:
    found = spacing_period(SPACINGS, sigma(71.5, 60.0, second=400.0))
    assert found is not None
    # 1500² of 1500² + 400², as cosines over some periods are nearly orthogonal.
    assert found.share == pytest.approx(1500.0**2 / (1500.0**2 + 400.0**2), abs=0.03)


def test_too_few_or_equal_values_have_none() -> None:
    assert spacing_period(SPACINGS[:7], sigma(71.5, 60.0)[:7]) is None
    assert spacing_period(SPACINGS, np.full(len(SPACINGS), 40.0)) is None
