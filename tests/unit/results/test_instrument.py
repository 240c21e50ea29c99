"""Runs as an instrumented pantograph would measure them: signals whose readings are known."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.errors import ModelError, ResultFormatError
from arcless.model import load
from arcless.results import Instrument, Result
from arcless.results.instrument.head import mass_of, strip_shares
from tests.support.synthetic import scenario_data, synthetic_dataset

# The head of the scenario, and a wave of its height.
HEAD_KG, HERTZ, HEIGHT_M = 8.0, 3.0, 0.01
OMEGA = 2.0 * np.pi * HERTZ
# The start of the amplifier's filter, in s: some of its time constants at 50 Hz.
START_S = 0.2


def made(**more: Any) -> Result:
    """Return a run whose head moves as a sine under a constant force."""
    data = scenario_data(**more.pop("scenario", {}))
    dataset = synthetic_dataset(scenario=data, **more)
    time = dataset["time"].values
    dataset["mass_displacement"].values[:, :, -1] = HEIGHT_M * np.sin(OMEGA * time)[:, None]
    # The drawn dataset has two masses, the model of the scenario one.
    dataset["mass_displacement"].values[:, :, 0] = dataset["mass_displacement"].values[:, :, -1]
    return Result(dataset, load(data))


def test_sensors_below_the_strips_miss_their_inertia() -> None:
    found = made().as_measured(Instrument(rate_Hz=500.0))
    late = found.time_s - found.delay_s
    acceleration = -(OMEGA**2) * HEIGHT_M * np.sin(OMEGA * late)
    settled = found.time_s > START_S
    # Of 28 N: the phase of the filter at 3 Hz is that of a delay but for (f/f_c)³ = 1e-5,
    # and the second difference is (π f h)²/3 = 3e-5 too small.
    exact = 100.0 + HEAD_KG * acceleration
    np.testing.assert_allclose(found.force_N[settled], exact[settled], atol=0.01)
    np.testing.assert_allclose(found.acceleration_m_s2[settled], acceleration[settled], atol=1e-3)
    corrected = found.force_N - found.mass_above_kg * found.acceleration_m_s2
    np.testing.assert_allclose(corrected[settled], 100.0, atol=1e-9)  # rounding


def test_part_of_the_head_above_the_sensors_and_the_air_under_it() -> None:
    run = made()
    half = run.as_measured(Instrument(mass_above_kg=4.0, lift_N=7.0))
    whole = run.as_measured(Instrument())
    none = whole.force_N - HEAD_KG * whole.acceleration_m_s2
    np.testing.assert_allclose(half.force_N, none + 4.0 * half.acceleration_m_s2 - 7.0, atol=1e-9)


def test_amplifier_halves_power_at_its_cutoff() -> None:
    run = made(force=lambda t: 100.0 + 10.0 * np.sin(2.0 * np.pi * 20.0 * t))
    found = run.as_measured(Instrument(rate_Hz=500.0, low_pass_Hz=20.0))
    force = (found.force_N - HEAD_KG * found.acceleration_m_s2)[found.time_s > 1.0]
    # Whole waves but one sample of 14 500.
    assert force.std() == pytest.approx(10.0 / 2.0, rel=1e-3)


def test_noise_range_and_resolution() -> None:
    run = made()
    found = run.as_measured(Instrument(force_noise_N=3.0, acceleration_noise_m_s2=0.5, seed=4))
    clean = run.as_measured(Instrument())
    # 6001 samples: the deviation of a deviation is 1/√(2 n) = 0.9 %, four of them.
    assert (found.force_N - clean.force_N).std() == pytest.approx(3.0, rel=0.037)
    noise = found.acceleration_m_s2 - clean.acceleration_m_s2
    assert noise.std() == pytest.approx(0.5, rel=0.037)
    again = run.as_measured(Instrument(force_noise_N=3.0, acceleration_noise_m_s2=0.5, seed=4))
    assert np.array_equal(found.force_N, again.force_N)
    cut = run.as_measured(Instrument(force_max_N=110.0, force_resolution_N=4.0))
    assert cut.force_N.max() == 112.0  # the range's end, at the nearest step
    assert cut.clipped == np.count_nonzero(clean.force_N > 110.0) > 0
    np.testing.assert_array_equal(cut.force_N % 4.0, 0.0)


def test_odometer() -> None:
    found = made().as_measured(Instrument(position_offset_m=5.0, odometer_drift=0.002))
    true = 20.0 * found.time_s
    np.testing.assert_allclose(found.position_m, true + 5.0 + 0.002 * true, atol=1e-9)


def test_strips_hang_below_the_wire_by_the_gap() -> None:
    run = made(gap=lambda t: np.full_like(t, 0.02))
    np.testing.assert_allclose(run.as_measured(Instrument()).height_m, 5.28, atol=1e-12)


def test_file_has_units(tmp_path: Path) -> None:
    made().as_measured(Instrument()).save(tmp_path / "run.csv")
    header = (tmp_path / "run.csv").read_text("utf-8").splitlines()[0]
    assert header == (
        "time [s],position [m],speed [m/s],sensor_force [N],acceleration [m/s2],contact_height [m]"
    )


def test_mean_of_the_strips_of_a_head() -> None:
    head = {"strips": 2, "strip_spacing": 0.5, "half_length": 0.6, "mass": 3, "stiffness": 5000,
            "damping": 10, "roll": {"inertia": 1, "stiffness": 100}}  # fmt: skip
    model = load(scenario_data(pantographs=[
        {"static_force": 60.0, "model": {
            "name": "drawn", "masses": [{"mass": 8, "stiffness": 50, "damping": 1}], "head": head}}
    ])).pantographs[0].model  # fmt: skip
    assert mass_of(model) == 6.0
    assert strip_shares(model).tolist() == [0.0, 0.5, 0.5]


@pytest.mark.parametrize(
    ("asked", "word"),
    [
        ({"rate_Hz": 2000.0}, "recording rate"),
        ({"rate_Hz": 0.0}, "above 0"),
        ({"rate_Hz": float("nan")}, "finite"),
        ({"low_pass_Hz": 600.0}, "half the rate"),
        ({"mass_above_kg": 8.5}, "at most 8 kg"),
        ({"mass_above_kg": -1.0}, "0 or more"),
        ({"force_noise_N": -1.0}, "0 or more"),
        ({"force_min_N": 5.0, "force_max_N": 5.0}, "from < to"),
        ({"odometer_drift": -0.021}, "from -2 % to 2 %"),
        ({"odometer_drift": 0.2}, "that is 20 %, expected .*write 0.2 %"),
        ({"seed": -1}, "whole number"),
    ],
)
def test_what_no_instrument_is(asked: dict[str, Any], word: str) -> None:
    with pytest.raises(ModelError, match=word):
        made().as_measured(Instrument(**asked))


def test_other_pantographs_and_records() -> None:
    run = made(pantographs=("P1", "P2"), scenario={"pantographs": [
        {"static_force": 60.0, "model": {"name": "drawn", "masses": [
            {"mass": 8, "stiffness": 50, "damping": 1}]}, "distance": distance}
        for distance in (0.0, 100.0)
    ]})  # fmt: skip
    behind = run.as_measured(Instrument(), "P2")
    assert behind.position_m[0] == pytest.approx(-100.0)
    assert [one.name for one in behind.columns()][:4] == [
        "time", "P2.position", "speed", "P2.sensor_force",
    ]  # fmt: skip
    with pytest.raises(ModelError, match="one of P1, P2"):
        run.as_measured(Instrument(), "P3")
    with pytest.raises(ResultFormatError, match="not recorded"):
        made_without = synthetic_dataset(without=("mass_displacement",))
        Result(made_without, load(scenario_data())).as_measured(Instrument())
