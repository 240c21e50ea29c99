"""Velocity of wires on closed forms: waves that run, waves that stand, errors of differences."""

import numpy as np
import pytest

from arcless.figures.wires.wire_velocity import BLOCK, WireMotion, velocity_grid

C = 120.0  # m/s
ROW_S = 2e-3
NODE_M = 0.5


def motion_of(shape, *, length_m=100.0, duration_s=0.4, row_s=ROW_S, node_m=NODE_M) -> WireMotion:
    """Record u(x, t) of a whole wire."""
    x = np.arange(0.0, length_m + node_m / 2, node_m)
    t = np.arange(0.0, duration_s + row_s / 2, row_s)
    up = shape(x[None, :], t[:, None]).astype(np.float32)
    return WireMotion(t, x, np.zeros(t.size, dtype=np.int64), up)


def pulse(at: np.ndarray, width_m: float = 4.0) -> np.ndarray:
    """A smooth bump of 10 mm."""
    return 0.01 * np.exp(-((at / width_m) ** 2))


def slope_of(grid) -> float:
    """Return m/s along which the velocity is alike, by the best of shifts between rows."""
    rows, columns = grid.values.shape
    values = np.nan_to_num(grid.values)
    dx = (grid.x[1] - grid.x[0]) / columns
    dt = (grid.t[1] - grid.t[0]) / rows
    apart = rows // 4
    first, second = values[rows // 4], values[rows // 4 + apart]
    shifts = np.arange(-columns + 1, columns)
    alike = np.correlate(second, first, mode="full")
    return float(shifts[alike.argmax()] * dx / (apart * dt))


def against(grid) -> float:
    """Return the part of v that does not run to the right over that which does not run to the left.

    v(x − c t) has ∂v/∂t + c ∂v/∂x = 0.
    """
    rows, columns = grid.values.shape
    # Rows without a neighbour at the ends of the record are left out.
    in_time, in_space = np.gradient(
        grid.values[2:-2], (grid.t[1] - grid.t[0]) / rows, (grid.x[1] - grid.x[0]) / columns
    )
    left, right = in_time + C * in_space, in_time - C * in_space
    return float(np.mean(left**2) / np.mean(right**2))


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_travelling_wave_draws_lines_of_the_wave_speed(way: float) -> None:
    motion = motion_of(lambda x, t: pulse(x - 50.0 - way * C * (t - 0.2)))
    grid = velocity_grid([motion], (0.0, 100.0), (0.0, 0.4), 200, 100)
    # One cell of 0.5 m in 100 ms.
    assert slope_of(grid) == pytest.approx(way * C, abs=5.1)
    # Differences over cells of 0.5 m of a pulse 4 m wide and 4 ms of 2 m leave 2 %, squared.
    assert against(grid) ** way < 0.01


def test_a_standing_wave_draws_no_lines() -> None:
    k = 2.0 * np.pi / 25.0
    motion = motion_of(lambda x, t: 0.01 * np.sin(k * x) * np.cos(k * C * t))
    grid = velocity_grid([motion], (0.0, 100.0), (0.0, 0.4), 200, 100)
    # Of the waves to the right and to the left, which it is the sum of, neither is larger.
    assert against(grid) == pytest.approx(1.0, abs=0.02)
    # A node of the wave stays at rest; half a cell beside it is sin(kx) of the largest velocity.
    at_node = grid.values[:, 50]
    largest = 0.01 * k * C
    assert np.nanmax(np.abs(at_node)) <= largest * np.sin(k * NODE_M)


@pytest.mark.parametrize("frequency_Hz", [5.0, 10.0, 20.0, 40.0])
def test_differences_are_too_small_by_a_sixth_of_the_square(frequency_Hz: float) -> None:
    omega = 2.0 * np.pi * frequency_Hz
    motion = motion_of(
        lambda x, t: 0.01 * np.sin(omega * t) + 0.0 * x, length_m=2.0, duration_s=1.0, row_s=5e-3
    )
    grid = velocity_grid([motion], (0.0, 2.0), (0.0, 1.0), 4, 10_000)
    exact = 0.01 * omega
    found = np.nanmax(np.abs(grid.values))
    missing = (omega * 5e-3) ** 2 / 6.0
    # The next term of the series is (ω dt)⁴ / 120; of 20 to 200 rows in a period one is near the
    # largest velocity: within π / 200 rad of it, and the single precision of 10 mm is 6e-8.
    assert 1.0 - found / exact == pytest.approx(missing, abs=(omega * 5e-3) ** 4 / 120.0 + 2e-4)


def test_the_error_falls_with_the_square_of_the_step() -> None:
    omega = 2.0 * np.pi * 8.0
    errors = []
    for row_s in (8e-3, 4e-3, 2e-3):
        motion = motion_of(lambda x, t: np.sin(omega * t) + 0.0 * x, length_m=2.0, duration_s=1.0,
                           row_s=row_s)  # fmt: skip
        times = motion.times[1:-1]
        grid = velocity_grid(
            [motion], (0.0, 2.0), (times[0] - row_s / 2, times[-1] + row_s / 2), 1, 10_000
        )
        exact = omega * np.cos(omega * times)
        errors.append(np.sqrt(np.mean((grid.values[:, 0] - exact) ** 2)))
    # 4 of a method of second order; the fourth-order term is 2 % of the error at 8 ms.
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.03)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.03)


def test_a_window_that_moves_gives_the_same_velocity_as_the_whole_wire() -> None:
    whole = motion_of(lambda x, t: pulse(x - 20.0 - C * t) + 0.002 * np.sin(3.0 * x + 40.0 * t))
    width = 60
    first = np.minimum(np.arange(whole.times.size) // 2, whole.x.size - width)
    up = np.stack([row[at : at + width] for row, at in zip(whole.up, first, strict=True)])
    moving = WireMotion(whole.times, whole.x, first, up)
    asked = ((0.0, 100.0), (0.0, 0.4), 200, 200)
    of_whole, of_moving = (velocity_grid([one], *asked) for one in (whole, moving))
    known = np.isfinite(of_moving.values)
    # A cell holds one node and one row; at the edges of the window a neighbour in time is missing.
    inside = known & np.roll(known, 1, axis=1) & np.roll(known, -1, axis=1)
    assert known.sum() < np.isfinite(of_whole.values).sum()
    assert inside.sum() > 0.9 * known.sum()
    same = np.isclose(of_moving.values[inside], of_whole.values[inside], rtol=1e-6, atol=1e-9)
    assert same.mean() > 0.95


def test_a_cell_has_the_mean_of_what_was_recorded_in_it() -> None:
    motion = motion_of(lambda x, t: 0.3 * t * (1.0 + x), length_m=8.0)
    grid = velocity_grid([motion], (0.0, 8.0), (0.0, 0.4), 2, 1)
    nodes = motion.x
    exact = [0.3 * (1.0 + nodes[(nodes >= low) & (nodes < low + 4.0)].mean()) for low in (0.0, 4.0)]
    # Differences of singles: 2.7 m × 6e-8 over 4 ms.
    np.testing.assert_allclose(grid.values[0], exact, atol=1e-4)


def test_cells_are_never_finer_than_the_record() -> None:
    motion = motion_of(lambda x, t: 0.1 * t + 0.0 * x)
    grid = velocity_grid([motion], (10.0, 20.0), (0.1, 0.2), 5000, 5000)
    assert grid.values.shape == (50, 20)
    assert np.isfinite(grid.values).all()


def test_beyond_the_record_there_is_nothing() -> None:
    motion = motion_of(lambda x, t: 0.1 * t + 0.0 * x)
    grid = velocity_grid([motion], (50.0, 150.0), (0.0, 0.4), 10, 4)
    assert np.isfinite(grid.values[:, :5]).all()
    assert np.isnan(grid.values[:, 6:]).all()


def test_a_long_record_is_gone_through_in_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    motion = motion_of(lambda x, t: pulse(x - 20.0 - C * t))
    asked = ((0.0, 100.0), (0.0, 0.4), 50, 40)
    at_once = velocity_grid([motion], *asked)
    monkeypatch.setattr("arcless.figures.wires.wire_velocity.BLOCK", 1000)
    in_blocks = velocity_grid([motion], *asked)
    assert motion.up.size < BLOCK
    # Sums in another order.
    np.testing.assert_allclose(in_blocks.values, at_once.values, rtol=1e-12, atol=1e-15)


def test_two_wires_side_by_side_have_their_mean() -> None:
    slow, fast = (motion_of(lambda x, t, v=v: v * t + 0.0 * x) for v in (0.1, 0.3))
    grid = velocity_grid([slow, fast], (10.0, 90.0), (0.1, 0.3), 10, 10)
    # Differences of singles of up to 0.12 m: 1.5e-8 m over 4 ms.
    np.testing.assert_allclose(grid.values, 0.2, atol=1e-5)
