"""Contact force from sensors below the strips, on a head whose motion is known in closed form.

A head of mass m stands on a spring k_s, the sensor, whose foot moves by u = U sin ωt, and presses
from below on a wire of stiffness k_w. With z upwards, m z″ = k_s (u − z) − k_w z, so

    z = U k_s/(k_s + k_w − m ω²) sin ωt,    F_s = k_s (u − z),    F_c = k_w z
"""

from pathlib import Path

import numpy as np
import pytest

from arcless.errors import MeasurementError, ModelError
from arcless.measurements import Head, assess, read
from arcless.measurements.samples.inertia import contact_force
from tests.support.measured import SPEED, force, record, times, write

MASS, SENSOR, WIRE, AMPLITUDE = 8.0, 2e5, 4e3, 0.01


def moved(frequency: float, time: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return sensor force in N, acceleration in m/s², and contact force in N."""
    omega = 2.0 * np.pi * frequency
    u = AMPLITUDE * np.sin(omega * time)
    z = u * SENSOR / (SENSOR + WIRE - MASS * omega**2)
    return SENSOR * (u - z), -(omega**2) * z, WIRE * z


@pytest.mark.parametrize("frequency", [0.5, 3.0, 8.0, 20.0])
def test_the_force_of_a_moving_head(frequency: float) -> None:
    sensor, acceleration, expected = moved(frequency, times())
    found = contact_force([0.3 * sensor, 0.7 * sensor], acceleration, head=Head(MASS))
    # Forces of up to 4e3 N are differences of 1e6 N/m times 10 mm: 16 digits of 2e3 N.
    assert found == pytest.approx(expected, abs=1e-9)
    down = contact_force([sensor], -acceleration, head=Head(MASS, acceleration_down=True))
    assert down == pytest.approx(expected, abs=1e-9)
    # Without the correction a head at 8 Hz shows a force that is wrong by 2e3 N/m times 10 mm.
    error = np.abs(contact_force([sensor]) - expected).max()
    assert error == pytest.approx(MASS * np.abs(acceleration).max(), rel=1e-9)


def test_a_head_lifted_without_contact_presses_on_nothing() -> None:
    lifted = np.array([0.0, 5.0, -5.0])
    assert contact_force([MASS * lifted], lifted, head=Head(MASS)) == pytest.approx(0.0, abs=1e-12)


def test_lift_is_added_constant_or_by_the_speed_squared() -> None:
    still, speed = np.zeros(3), np.array([0.0, 10.0, 20.0])
    constant = contact_force([np.full(3, 90.0)], still, speed, Head(MASS, lift=7.0))
    assert list(constant) == [97.0, 97.0, 97.0]
    square = contact_force([np.full(3, 90.0)], still, speed, Head(MASS, 0.0, 0.02))
    assert square == pytest.approx([90.0, 92.0, 98.0], rel=1e-12)


def test_heads_from_amounts_with_units() -> None:
    assert Head.of("800 g") == Head(0.8)
    assert Head.of("8 kg", "7 N") == Head(8.0, 7.0)
    assert Head.of(8.0, "0.02 N/(m/s)2", acceleration_down=True) == Head(8.0, 0.0, 0.02, True)
    with pytest.raises(ModelError, match="more than 0"):
        Head.of("0 kg")
    with pytest.raises(ModelError, match=r"expected a force .* or an aerodynamic coefficient"):
        Head.of("8 kg", "7 kg")
    with pytest.raises(ModelError, match="expected a mass"):
        Head.of("8 N")


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "run.csv"


def sensors(**changed: np.ndarray) -> dict[str, np.ndarray]:
    """Return a record of two sensors and two accelerations below a force that is known."""
    acceleration = 3.0 * np.sin(2.0 * np.pi * 6.0 * times())
    below = force(times()) + MASS * acceleration
    columns = {
        "sensor_force_1": 0.4 * below,
        "sensor_force_2": 0.6 * below,
        "acceleration_1": acceleration + 0.5,
        "acceleration_2": acceleration - 0.5,
    }
    found = record(**columns | changed)
    del found["contact_force [N]"]
    return found


def test_a_file_of_sensors_gives_the_contact_force(file: Path) -> None:
    loaded = read(write(file, sensors()), head=Head(MASS))
    # Sums of four products.
    assert loaded.pantographs[0].force == pytest.approx(force(times()), rel=1e-12)
    assert loaded.notes[-1] == (
        "contact force of pantograph P1: sum of 2 sensors below the strips; the inertia of 8 kg "
        "above the sensors is taken off"
    )


def test_without_a_mass_it_is_said_that_nothing_is_corrected(file: Path) -> None:
    loaded = read(write(file, sensors()))
    assert "not corrected for the inertia" in loaded.notes[-1]
    expected = force(times()) + MASS * 3.0 * np.sin(2.0 * np.pi * 6.0 * times())
    assert loaded.pantographs[0].force == pytest.approx(expected, rel=1e-12)


def test_without_a_mass_no_force_is_judged(file: Path) -> None:
    write(file, sensors())
    bare = assess(read(file), supply="AC 25 kV")
    of_force = [one for one in bare.criteria if one.pantograph == "P1"]
    judged = {one.name: one for one in of_force if one.value is not None}
    assert {"mean_force", "standard_deviation"} <= set(judged)
    assert all(one.passed is None and not one.fails for one in judged.values())
    assert all("--head-mass" in (one.reason or "") for one in judged.values())
    corrected = assess(read(file, head=Head(MASS)), supply="AC 25 kV")
    sigma = next(one for one in corrected.criteria if one.name == "standard_deviation")
    assert sigma.passed is not None


def test_heights_are_not_differentiated(file: Path) -> None:
    columns = sensors(contact_height=5.3 + 0.0 * times())
    columns = {name: v for name, v in columns.items() if not name.startswith("acceleration")}
    with pytest.raises(MeasurementError, match=r"no acceleration.*heights are not differentiated"):
        read(write(file, columns), head=Head(MASS))


def test_gravity_in_the_acceleration_is_refused(file: Path) -> None:
    columns = sensors(acceleration_1=9.81 + 0.0 * times() + np.sin(times()))
    with pytest.raises(
        MeasurementError, match=r"acceleration_1.*mean acceleration.*got 9\.\d+ m/s²"
    ):
        read(write(file, columns), head=Head(MASS))


def test_a_contact_force_is_not_corrected_again(file: Path) -> None:
    columns = record(acceleration_1=np.sin(times()))
    with pytest.raises(MeasurementError, match="which is the contact force already"):
        read(write(file, columns), head=Head(MASS))
    assert "not used: acceleration_1" in read(write(file, columns)).notes[-1]


def test_a_clipped_sensor_takes_its_samples_from_the_sum(file: Path) -> None:
    columns = sensors()
    clipped = np.minimum(columns["sensor_force_1 [N]"], 70.0)
    columns["sensor_force_1 [N]"] = clipped
    [found] = read(write(file, columns), head=Head(MASS)).pantographs
    assert {one.channel for one in found.left_out} <= {"sensor_force_1 [N]", ""}
    good = SPEED * times()[clipped < 70.0]
    assert found.force.size > 0.9 * good.size
    # Of what is below the limit, only pieces of one or two samples are left out as well.
    assert np.isin(found.position, good).all()
