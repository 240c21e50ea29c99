"""The period of σ over the spacing of two pantographs."""

import numpy as np
import pytest
from validation import spacing


def test_a_cosine_is_fitted_with_its_own_period() -> None:
    x = np.array(spacing.SPACINGS, dtype=float)
    for wanted in (55.0, 72.5, 100.0):
        sigma = np.sqrt(900.0 + 500.0 * np.cos(2 * np.pi * x / wanted + 1.0))
        # The periods that are tried are 0.5 % apart.
        assert spacing.period(x, sigma) == pytest.approx(wanted, rel=2.5e-3)
