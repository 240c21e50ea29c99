"""A campaign of test runs whose truth is known: a simulated run, and it measured.

Sensors below the strips, 200 samples a second behind a low-pass of 50 Hz, an odometer that is wrong
by metres. The force corrected for inertia, as EN 50317 asks (from memory, mark C), has the numbers
of the run again; without the correction the error is that of the mass above the sensors.
"""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.assess.signals.filter import low_pass
from arcless.comparison import Aligning, Comparison, compare
from arcless.measurements import Head, read
from arcless.results import Instrument, Result
from arcless.results.instrument.head import head_acceleration, mass_of

RATE_HZ = 1000.0
# As slow as EN 50317 allows, from memory: errors of sampling are the largest that a test run has.
SLOW_HZ = 200.0


@pytest.fixture(scope="module")
def run() -> Result:
    return arcless.run(arcless.load("en50318-ac-simple-320-planar"))


def inside(run: Result) -> np.ndarray:
    x = run.latest["position"].values[:, 0]
    begin, end = run.assessment.section_m
    return (x >= begin) & (x <= end)


def measured(run: Result, folder: Path, *, corrected: bool = True, **sensors: Any) -> Comparison:
    """Return the comparison of the run with its own measurement."""
    readings = run.as_measured(Instrument(**{"rate_Hz": SLOW_HZ} | sensors))
    readings.save(folder / "campaign.csv")
    head = Head(readings.mass_above_kg) if corrected else None
    return compare([run, read(folder / "campaign.csv", head=head)])


def errors(found: Comparison) -> dict[str, float]:
    return {one.key: one.differences[1] for one in found.indicators
            if one.differences[1] is not None}  # fmt: skip


def test_acceleration_is_that_of_the_equation_of_motion(run: Result) -> None:
    data = run.latest
    head, frame = run.scenario.pantographs[0].model.masses[-1], -2
    z = data["mass_displacement"].values[:, 0]
    step = 1.0 / RATE_HZ
    velocity = np.gradient(z, step, axis=0)
    spring = head.stiffness * (z[:, frame] - z[:, -1])
    damper = head.damping * (velocity[:, frame] - velocity[:, -1])
    force = data["contact_force"].values[:, 0]
    # The start of the run is at rest: forces that do not change are counted from there.
    other = spring + damper - (force - force[inside(run)].mean())
    other -= other[inside(run)].mean()
    found = mass_of(run.scenario.pantographs[0].model) * head_acceleration(
        data, 0, run.scenario.pantographs[0].model
    )
    ours, theirs = (low_pass(one, RATE_HZ, 50.0)[inside(run)] for one in (found, other))
    assert ours.std() > 30.0
    # At 50 Hz the second difference is (π f h)²/3 = 0.8 % too small, the first one (2π f h)²/6 =
    # 1.6 %, of which the damper has a third: 1 % of the deviation is above what they add up to.
    assert (ours - ours.mean() - theirs).std() < 0.01 * ours.std()


def test_without_noise_the_numbers_are_those_of_the_run(run: Result, tmp_path: Path) -> None:
    found = measured(run, tmp_path, position_offset_m=13.2, odometer_drift=0.002)
    by = errors(found)
    # The amplifier takes 0.03 % off a wave of 20 Hz (f/f_c to the 8th, halved), nothing below.
    for key in ("mean_force_N", "std_force_N", "std_force_0_5Hz_N", "std_force_5_20Hz_N"):
        assert by[key] == pytest.approx(0.0, abs=0.1), key
    # Samples 5 ms apart miss the top of a wave of 20 Hz by (π f Δt)²/2 = 5 % of it at most, and of
    # it the peaks, 130 N above the mean, have some tenths.
    assert by["max_force_N"] == pytest.approx(0.0, abs=2.0)
    assert by["min_force_N"] == pytest.approx(0.0, abs=2.0)
    # Samples 0.44 m apart, of heights that change by 0.05 m in 27 m.
    assert by["contact_point_range_mm"] == pytest.approx(0.0, abs=1.0)


def test_position_is_found_but_for_the_delay_of_the_amplifier(run: Result, tmp_path: Path) -> None:
    found = measured(run, tmp_path, position_offset_m=13.2, odometer_drift=0.002)
    placed = found.sides[1].placed
    assert placed is not None
    (by,) = placed.alignments
    delay_m = (
        run.as_measured(Instrument(rate_Hz=SLOW_HZ)).delay_s * found.sides[0].assessment.speed_m_s
    )
    first = float(run.latest["position"].values[0, 0])
    for true in (first, 550.0, 1000.0):
        shown = true + 13.2 + 0.002 * (true - first)
        # The parabola finds the maximum within a hundredth of the shortest wave, 4.4 m, and the
        # steps of the scale an end within another one.
        assert by.on_line(np.array([shown]))[0] == pytest.approx(true - delay_m, abs=0.09)
    assert not by.ambiguous


@pytest.mark.parametrize("low_pass_Hz", [125.0, 400.0])
def test_a_run_lies_on_itself_without_the_mass_above_the_sensors(
    run: Result, tmp_path: Path, low_pass_Hz: float
) -> None:
    """Sensor forces that miss the inertia lag by metres; heights do not."""
    sensors = {"rate_Hz": 500.0, "low_pass_Hz": low_pass_Hz}
    found = measured(run, tmp_path, corrected=False, **sensors)
    placed = found.sides[1].placed
    assert placed is not None
    (by,) = placed.alignments
    speed = found.sides[0].assessment.speed_m_s
    # Where a value is written down, the train is further by what the amplifier delays.
    delay_m = run.as_measured(Instrument(**sensors)).delay_s * speed
    spacing_m = speed / 500.0
    first = float(run.latest["position"].values[0, 0])
    for place in (first, 550.0, 1000.0):
        # Nothing is between two samples but a straight line: their distance is the resolution.
        assert by.on_line(np.array([place]))[0] == pytest.approx(place - delay_m, abs=spacing_m)
    assert by.channel == "height"
    assert not by.ambiguous
    by_force = compare([run, tmp_path / "campaign.csv"], aligning=Aligning(channel="force"))
    (wrong,) = by_force.sides[1].placed.alignments  # type: ignore[union-attr]
    assert wrong.on_line(np.array([550.0]))[0] < 550.0 - 2.0
    assert any("misses the inertia" in text for text in by_force.warnings)
    assert not any("misses the inertia" in text for text in found.warnings)


@pytest.mark.parametrize("seed", range(3))
def test_noise_adds_its_power(run: Result, tmp_path: Path, seed: int) -> None:
    force, acceleration = 5.0, 1.0
    found = measured(
        run, tmp_path, force_noise_N=force, acceleration_noise_m_s2=acceleration,
        force_resolution_N=1.0, position_offset_m=-8.0, seed=seed,
    )  # fmt: skip
    by = errors(found)
    sigma = found.sides[0].assessment.pantographs[0].std_force_N
    # White up to 100 Hz, of which the filter keeps 20: of both sensors, and of rounding to 1 N.
    mass = run.as_measured(Instrument()).mass_above_kg
    noise = math.sqrt(0.2) * math.hypot(force, mass * acceleration, 1.0 / math.sqrt(12.0))
    # 6.2 s have 250 independent samples of a band of 20 Hz. Noise and force are not correlated but
    # by chance: σ is off by noise²/2σ, and by noise/√250; three times that.
    assert by["std_force_N"] == pytest.approx(
        noise**2 / (2.0 * sigma), abs=3.0 * noise / math.sqrt(250.0)
    )
    assert by["mean_force_N"] == pytest.approx(0.0, abs=3.0 * noise / math.sqrt(250.0))
    # A peak has the noise of its sample: four deviations among 250 samples.
    assert by["max_force_N"] == pytest.approx(0.0, abs=4.0 * noise)
    assert by["min_force_N"] == pytest.approx(0.0, abs=4.0 * noise)


@pytest.mark.parametrize("share", [0.5, 1.0])
def test_without_correction_the_error_is_that_of_the_mass(
    run: Result, tmp_path: Path, share: float
) -> None:
    model = run.scenario.pantographs[0].model
    mass = share * (mass_of(model) or 0.0)
    found = measured(run, tmp_path, corrected=False, mass_above_kg=mass)
    # F_s = F_c + m z̈ of the run itself, behind the filter of the assessment.
    force = run.latest["contact_force"].values[:, 0]
    sensed = low_pass(force + mass * head_acceleration(run.latest, 0, model), RATE_HZ, 20.0)
    expected = (
        float(sensed[inside(run)].std()) - found.sides[0].assessment.pantographs[0].std_force_N
    )
    assert errors(found)["std_force_N"] == pytest.approx(expected, abs=0.3)
    # A quarter of σ and more: the inertia of the strips is no small correction.
    assert expected < -0.25 * found.sides[0].assessment.pantographs[0].std_force_N
    assert any("not corrected for the inertia" in text for text in found.warnings)


def test_the_whole_strips_leave_the_force_of_their_suspension(run: Result) -> None:
    """F_s is then what spring and damper below the strips carry, without any acceleration."""
    data = run.latest
    head = run.scenario.pantographs[0].model.masses[-1]
    z = data["mass_displacement"].values[:, 0]
    velocity = np.gradient(z, 1.0 / RATE_HZ, axis=0)
    carried = head.stiffness * (z[:, -2] - z[:, -1]) + head.damping * (
        velocity[:, -2] - velocity[:, -1]
    )
    carried = low_pass(carried, RATE_HZ, 20.0)[inside(run)].std()
    readings = run.as_measured(Instrument(rate_Hz=RATE_HZ, low_pass_Hz=250.0))
    sensed = low_pass(readings.force_N, RATE_HZ, 20.0)[inside(run)].std()
    assert sensed == pytest.approx(float(carried), rel=2e-3)
