"""The low-pass and the spectrum are those of SciPy, which is slow to import."""

import numpy as np
import pytest
from scipy.signal import butter, sosfiltfilt, welch

from arcless.assess.signals import butterworth, filter

RATES = [200.0, 1000.0, 1.0 / 0.0015, 4321.0]
CUTOFFS = [0.3, 5.0, 20.0, 90.0]
SIGNAL = np.random.default_rng(1).normal(170.0, 50.0, 3000)


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("cutoff", CUTOFFS)
def test_sections_are_those_of_scipy(rate: float, cutoff: float) -> None:
    own = butterworth.sections(filter.ORDER, cutoff, rate)
    peer = butter(filter.ORDER, cutoff, fs=rate, output="sos")
    # The same operations: equal to the bit where they were compared; libraries may round apart.
    np.testing.assert_allclose(own, peer[:, [0, 1, 2, 4, 5]], rtol=1e-14)


@pytest.mark.parametrize("extension", [0, 1, 150, 2999])
def test_both_ways_is_that_of_scipy(extension: int) -> None:
    own = butterworth.both_ways(butterworth.sections(6, 20.0, 1000.0), SIGNAL, extension)
    peer = sosfiltfilt(butter(6, 20.0, fs=1000.0, output="sos"), SIGNAL, padlen=extension)
    # Where the compiler fuses no multiplication with an addition there is no difference at all;
    # else rounding, of which poles near the unit circle make 1e6 times more.
    np.testing.assert_allclose(own, peer, rtol=1e-9)


@pytest.mark.parametrize("size", [4, 5, 1000, 2999, 3000])
def test_spectrum_is_that_of_scipy(size: int) -> None:
    signal, length = SIGNAL[:size], min(size, 1000)
    frequency, density = filter.spectrum(signal, 1000.0, 1.0)
    peer = welch(signal, fs=1000.0, nperseg=length, detrend="constant")
    # One division each, of the number of a line by the length.
    np.testing.assert_allclose(frequency, peer[0], rtol=1e-14)
    # Rounding of the transform; what is zero by symmetry is so to 1e-16 of the variance.
    np.testing.assert_allclose(density, peer[1], rtol=1e-10, atol=1e-16 * np.var(signal))


def test_no_library_of_linear_algebra_decides_the_last_bits(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Its kernels, and so its rounding, are those of a processor; the golden digests found that."""

    def refuse(*_: object) -> None:
        raise AssertionError("called")

    for name in ("solve", "inv", "lstsq"):
        monkeypatch.setattr(np.linalg, name, refuse)
    signal = np.linspace(0.0, 1.0, 200)
    assert butterworth.both_ways(butterworth.sections(6, 20.0, 1000.0), signal, 50).shape == (200,)
