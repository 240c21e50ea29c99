"""Fits of measured receptances: orders, kinds of damping, what is known, and what is refused."""

from math import isfinite

import numpy as np
import pytest

from arcless.errors import FitError, MeasurementError
from arcless.pantograph import receptance as fits
from arcless.pantograph.receptance import tables
from arcless.pantograph.receptance.chain import Chain
from tests.support.receptances import FREQUENCIES, measured, noisy

FEW = FREQUENCIES[::3]


def modally_damped(noise: float = 0.0) -> fits.MeasuredReceptance:
    """Return three masses whose dampers are those of the modes: 80, 3 and 3 %."""
    from arcless.pantograph.receptance import start

    mass, stiffness = np.array([6.0, 9.0, 7.5]), np.array([160.0, 15500.0, 7000.0])
    half = np.diag(1.0 / np.sqrt(mass))
    parts = Chain(mass, stiffness, np.zeros(3)).matrices
    squares, vectors = np.linalg.eigh(half @ parts.stiffness @ half)
    modes = start.Modes(np.sqrt(squares), (half @ vectors)[-1], np.array([0.8, 0.03, 0.03]))
    chain = start.of_modes(modes, "full")
    return fits.of_arrays(FEW, noisy(chain.receptance(FEW), noise, 3), name="modal")


def test_the_list_of_orders_tells_the_right_one() -> None:
    found = fits.orders(measured("en50318-2002", 0.01, frequency=FEW), 3)
    assert [(one.chain.order, one.chain.kind) for one in found] == [
        (1, "joints"), (2, "joints"), (2, "full"), (3, "joints"), (3, "full"),
    ]  # fmt: skip
    best = min(found, key=lambda one: one.information)
    assert (best.chain.order, best.chain.kind) == (2, "joints")
    # Each order contains the one below, a full matrix the dampers in joints.
    assert all(one.cost <= found[place].cost for one, place in zip(found[1:], [0, 1, 1, 3]))  # noqa: B905
    rows = tables.order_rows(found)
    assert rows[1][-1] == "0"
    assert {len(row) for row in rows} == {len(tables.ORDERS)}


def test_dampers_of_modes_need_a_full_matrix() -> None:
    data = modally_damped(0.01)
    joints, full = (fits.fit(data, 3, damping=kind) for kind in ("joints", "full"))
    assert full.misfit < 0.011  # the noise, and a tenth for the spread of 166 numbers
    assert joints.misfit > 3 * full.misfit
    assert any("alike" in text for text in fits.remarks(joints))
    # Masses and springs of a full matrix are one set out of many; head and modes are known.
    known = {(one.kind, one.place): isfinite(one.sure) for one in full.parameters}
    assert known["mass", 3]
    assert not known["mass", 1]
    assert all(isfinite(mode.frequency_sure_Hz) for mode in full.modes)
    assert any("other masses and springs" in text for text in fits.remarks(full))
    again = fits.pantograph(full, "full").matrices
    assert again is not None
    np.testing.assert_allclose(again.damping, full.chain.matrices.damping, rtol=1e-9)  # digits


def test_a_free_frame_is_a_mode_of_0_hz() -> None:
    one = fits.fit(measured("two-mass-study", frequency=FEW), 2)
    assert [mode.frequency_Hz == 0.0 for mode in one.modes] == [True, False]
    assert "0 Hz, the frame is free" in fits.text(one, "free")


def test_what_a_user_should_know() -> None:
    short = measured("ac-simple", 0.05, frequency=FREQUENCIES[:150])
    words = " ".join(fits.remarks(fits.fit(short, 3)))
    assert "the data end at 15.1 Hz" in words
    stiff = Chain(np.array([6.0, 9.0, 2.0]), np.array([160.0, 7000.0, 6e4]), np.array([90.0, 5, 5]))
    above = fits.of_arrays(FREQUENCIES, noisy(stiff.receptance(FREQUENCIES), 0.01, 1))
    assert "the model has a mode at" in " ".join(fits.remarks(fits.fit(above, 3)))
    soft = fits.fit(measured("faiveley-cx", 0.05), 3)
    assert "cannot be distinguished from none" in " ".join(fits.remarks(soft))
    assert not fits.remarks(fits.fit(measured("ac-simple"), 3))


def test_a_mass_that_is_not_there_stays_one_that_can_be_stepped() -> None:
    flexible = 1.0 / (1.0 / measured("en50318-2002").values) + 1e-5
    data = fits.of_arrays(FREQUENCIES, flexible, name="strip on a spring")
    one = fits.fit(data, 3)
    assert one.chain.mass.min() >= 0.05 * (1 - 1e-9)
    assert any("bounds of the search" in text for text in fits.remarks(one))


def test_errors_of_the_data_weigh_and_judge() -> None:
    f = FEW
    clean = measured("ac-simple", frequency=f).values
    noise = np.where(f < 5.0, 0.005, 0.1)
    data = fits.of_arrays(f, noisy(clean, 1.0, 2) * noise + clean * (1 - noise),
                          relative_error=noise)  # fmt: skip
    weighted = fits.fit(data, 3)
    plain = fits.fit(fits.of_arrays(f, data.values), 3)
    low = f < 5.0
    for one, other in ((weighted, plain),):
        assert np.sum(np.abs(one.residual[low]) ** 2) < np.sum(np.abs(other.residual[low]) ** 2)
    assert weighted.over_noise == pytest.approx(1.0, abs=0.2)  # 166 numbers: 5 %
    assert plain.over_noise is None
    spoilt = fits.of_arrays(f, data.values, relative_error=noise / 3.0)
    assert any("times the errors" in text for text in fits.remarks(fits.fit(spoilt, 3)))


def test_what_is_refused() -> None:
    data = measured("ac-simple", frequency=FREQUENCIES[::25])
    assert data.frequency.size == 10
    with pytest.raises(MeasurementError, match="9 parameters, from 10 frequencies") as caught:
        fits.fit(data, 3)
    assert "at least 14 frequencies" in str(caught.value)
    for order in (0, 9):
        with pytest.raises(MeasurementError, match="1 to 8 masses"):
            fits.fit(data, order)
    with pytest.raises(MeasurementError, match="joints or full"):
        fits.fit(data, 2, damping="none")  # type: ignore[arg-type]
    assert max(one.chain.order for one in fits.orders(data, 4)) == 2


def test_a_fit_that_misses_is_none() -> None:
    data = measured("ac-simple", frequency=FEW)
    with pytest.raises(FitError, match=r"the fit misses the data: got a misfit of 37\.\d %") as one:
        fits.fit(data, 1)
    assert "use one mass more" in str(one.value)
    assert fits.fit(data, 1, largest_misfit="50 %").misfit > 0.3
    radians = fits.of_arrays(FEW, np.abs(data.values) * np.exp(1j * np.radians(
        np.angle(data.values))))  # fmt: skip
    with pytest.raises(FitError, match="are they radians"):
        fits.fit(radians, 1)


def test_plain_values_and_the_file() -> None:
    one = fits.fit(measured("en50318-2002", 0.01, frequency=FEW), 2)
    found = fits.to_dict(one)
    assert found["mass_kg"] == one.chain.matrices.mass.tolist()
    assert found["modes"][-1]["damping_ratio"] == pytest.approx(0.068, abs=0.002)  # its noise
    text = fits.text(one, "head \"of\" a 'bench'", static_force=70.0)
    assert "static_force: 70 N" in text
    model = fits.pantograph(one, "bench", static_force=70.0)
    assert model.static_force == 70.0
    assert "masses.0.mass" in model.provenance
    assert fits.text(one, "bench") == fits.text(
        fits.fit(measured("en50318-2002", 0.01, frequency=FEW), 2), "bench"
    )
