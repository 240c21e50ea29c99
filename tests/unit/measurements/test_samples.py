"""Faults of a measured record: each is drawn into a clean one, left out, and told alone."""

from pathlib import Path

import numpy as np
import pytest

from arcless.errors import MeasurementError
from arcless.measurements import MeasuredPantograph, read
from arcless.measurements.samples import left_out as kinds
from arcless.measurements.samples.faults import clipped, codes, frozen, held
from arcless.measurements.samples.pieces import interpolation_loss
from tests.support.measured import RATE, SPEED, force, record, times, wave, write

NAN = float("nan")


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "run.csv"


def measured(file: Path, rows: np.ndarray | None = None, **changed: np.ndarray):
    """Return the pantograph of a record of which some rows are kept."""
    columns = record(**changed)
    if rows is not None:
        columns = {name: values[rows] for name, values in columns.items()}
    [found] = read(write(file, columns)).pantographs
    return found


def told(found: MeasuredPantograph) -> list[tuple[str, int, int, int]]:
    return [(one.kind, one.line, one.last_line, one.samples) for one in found.left_out]


def with_values(channel: np.ndarray, place: slice, value: float) -> np.ndarray:
    changed = channel.copy()
    changed[place] = value
    return changed


def test_a_clean_record_is_one_piece(file: Path) -> None:
    found = measured(file)
    assert (told(found), found.pieces, found.interpolated) == ([], (slice(0, 5000),), False)


# Sample i stands in line i + 2.
def test_missing_rows_are_a_gap_that_nothing_fills(file: Path) -> None:
    rows = np.r_[0:1000, 1001:3000, 3200:5000]
    found = measured(file, rows)
    assert told(found) == [(kinds.GAP, 1001, 1002, 1), (kinds.GAP, 3000, 3001, 200)]
    assert found.pieces == (slice(0, 1000), slice(1000, 2999), slice(2999, 4799))
    assert np.array_equal(found.force, force(times())[rows])
    gap = found.left_out[1]
    assert (gap.begin_s, gap.end_s) == (2999 / RATE, 3200 / RATE)
    assert (gap.begin_m, gap.end_m) == (SPEED * 2999 / RATE, SPEED * 3200 / RATE)


def test_empty_cells_are_left_out(file: Path) -> None:
    lost = with_values(force(times()), slice(70, 80), NAN)
    found = measured(file, contact_force=lost)
    assert told(found) == [(kinds.EMPTY, 72, 81, 10)]
    assert found.pieces == (slice(0, 70), slice(70, 4990))
    assert np.array_equal(found.force, np.delete(force(times()), np.s_[70:80]))


def test_an_empty_clock_is_told_once(file: Path) -> None:
    found = measured(file, time=with_values(times(), slice(70, 72), NAN))
    assert told(found) == [(kinds.EMPTY, 72, 73, 2)]
    assert found.pieces == (slice(0, 70), slice(70, 4998))


def test_a_missing_height_takes_no_force_away(file: Path) -> None:
    height = with_values(5.3 + force(times()) / 1e4, slice(10, 20), NAN)
    found = measured(file, contact_height=height)
    assert told(found) == []
    assert np.count_nonzero(np.isnan(found.height)) == 10


def test_rows_that_are_there_twice_count_once(file: Path) -> None:
    found = measured(file, np.r_[0:1001, 1000:5000])
    assert told(found) == [(kinds.DUPLICATE, 1003, 1003, 1)]
    assert np.array_equal(found.force, force(times()))
    assert found.pieces == (slice(0, 5000),)


def test_a_jump_of_position_divides_the_record(file: Path) -> None:
    position = SPEED * times()
    position[2500:] += 12.0
    found = measured(file, position=position)
    assert told(found) == [(kinds.JUMP, 2501, 2502, 0)]
    assert found.pieces == (slice(0, 2500), slice(2500, 5000))
    # An odometer that counts metres jumps by one, and none of its steps is told.
    assert told(measured(file, position=np.floor(SPEED * times()))) == []


def test_clipped_samples_are_left_out(file: Path) -> None:
    limited = np.minimum(force(times()), 160.0)
    over = force(times()) >= 160.0
    # The 40 Hz wave takes the force to the limit for moments as well, which are clipped no less.
    found = measured(file, contact_force=limited)
    clips = [one for one in found.left_out if one.kind == kinds.CLIPPED]
    assert sum(one.samples for one in clips) == np.count_nonzero(over)
    assert found.force.max() < 160.0
    assert all(one.channel == "contact_force" for one in clips)
    # One or two samples between two clips are no piece.
    short = [one for one in found.left_out if one.kind == kinds.SHORT]
    assert len(clips) + len(short) == len(found.left_out)
    assert {one.samples for one in short} <= {1, 2}
    kept = 5000 - np.count_nonzero(over) - sum(one.samples for one in short)
    assert found.force.size == kept


@pytest.mark.parametrize("code", [-999.0, 999.0, -9999.0, 99999.0, -999.9, 9_990.0])
@pytest.mark.parametrize("count", [1, 6])
def test_a_code_for_no_value_is_left_out(file: Path, code: float, count: int) -> None:
    # Once it would be a force; several times it would be told as the end of the sensor's range.
    coded = with_values(force(times()), slice(2000, 2000 + count), code)
    found = measured(file, contact_force=coded)
    assert told(found) == [(kinds.CODE, 2002, 2001 + count, count)]
    assert np.array_equal(found.force, np.delete(force(times()), np.s_[2000 : 2000 + count]))


def test_a_number_of_nines_among_others_is_a_force() -> None:
    signal = np.array([100.0, 300.0, 120.0, 99.0, 210.0, NAN])
    assert not codes(np.r_[signal, 999.0 * np.ones(0)]).any()
    # 999 N is 699 N above the others, 3.5 times their range; 499 N is no code.
    assert np.flatnonzero(codes(np.r_[signal, 999.0, 499.0])).tolist() == []
    assert np.flatnonzero(codes(np.r_[signal, 999.0])).tolist() == [6]
    # Forces that go up to 800 N may have such a peak.
    assert not codes(np.r_[signal, 800.0, 999.0]).any()
    assert not codes(np.full(5, 999.0)).any()


def test_lost_contact_is_neither_clipped_nor_frozen(file: Path) -> None:
    lost = with_values(force(times()), slice(100, 300), 0.0)
    assert told(measured(file, contact_force=lost)) == []


def test_a_frozen_sensor_is_left_out(file: Path) -> None:
    dead = with_values(force(times()), slice(100, 300), 131.0)
    assert told(measured(file, contact_force=dead)) == [(kinds.FROZEN, 102, 301, 200)]


def test_values_held_by_a_recorder_lower_the_rate(file: Path) -> None:
    slow = np.repeat(force(times()[::5]), 5)
    [found] = (loaded := read(write(file, record(contact_force=slow)))).pantographs
    assert (found.held, told(found)) == (5, [])
    assert found.true_rate_Hz == pytest.approx(100.0, rel=1e-12)
    assert any("held over 5 samples, so the rate is 100 Hz" in note for note in loaded.notes)
    # A resolution of 5 N makes stretches of all lengths, which is no lower rate.
    assert held(5.0 * np.round(force(times()) / 5.0)) == 1


def test_faults_of_single_signals() -> None:
    signal = np.array([5.0, 9, 9, 7, 9, 9, 3, 1, 1, 1, 1, 2, NAN, NAN])
    assert list(np.flatnonzero(np.any(clipped(signal), axis=0))) == [1, 2, 4, 5, 7, 8, 9, 10]
    assert not np.any(clipped(np.array([5.0, 9, 9, 9, 3])))
    assert not np.any(clipped(np.array([NAN])))
    # A resolution of 1 N flattens the top of a slow wave to 60 equal samples, and clips nothing.
    assert not np.any(clipped(np.round(100.0 + wave(0.7, 50.3)(times()))))
    still = np.r_[1.0, np.full(101, 7.0), 2.0]
    # 100 steps of 1 ms last 0.1 s; one more is longer.
    assert not frozen(still, 1e-3).any()
    assert np.count_nonzero(frozen(np.r_[still[:1], still], 0.00101)) == 101


def test_uneven_times_are_interpolated_within_pieces_only(file: Path) -> None:
    rng = np.random.default_rng(1)
    uneven = times() + rng.uniform(-0.2, 0.2, 5000) / RATE
    slow = wave(2.0, 30.0)
    rows = np.r_[0:2000, 2500:5000]
    columns = {"time": uneven, "position": SPEED * uneven, "contact_force": 100.0 + slow(uneven)}
    [found] = (loaded := read(write(file, {
        name: values[rows] for name, values in record(**columns).items()
    }))).pantographs  # fmt: skip
    assert found.interpolated
    assert any("interpolated to 500 Hz, within pieces" in note for note in loaded.notes)
    assert [one.kind for one in found.left_out] == [kinds.GAP]
    for piece in found.pieces:
        steps = np.diff(found.time[piece])
        # Times are some seconds, with 16 digits.
        assert steps == pytest.approx(1.0 / found.rate_Hz, rel=1e-10)
    assert not ((found.time > uneven[1999]) & (found.time < uneven[2500])).any()
    # Linear interpolation of a sine: at most (2πfΔ)²/8 of its amplitude, Δ up to 1.4 steps.
    most = 30.0 * (2.0 * np.pi * 2.0 * 1.4 / RATE) ** 2 / 8.0
    assert np.abs(found.force - 100.0 - slow(found.time)).max() < most


@pytest.mark.parametrize("rate", [512.0, 700.0])
def test_rounded_times_are_equally_spaced_and_missing_samples_seen(file: Path, rate: float) -> None:
    exact = times(10.0, rate)
    rows = np.delete(np.arange(exact.size), [1000, 1001, *range(3000, 3100)])
    columns = {"time [s]": np.round(exact, 3), "contact_force [N]": force(exact)}
    loaded = read(write(file, {k: v[rows] for k, v in columns.items()}), speed="252 km/h")
    [found] = loaded.pantographs
    assert [one.kind for one in found.left_out] == [kinds.GAP, kinds.GAP]
    # Times of both ends of a gap are wrong by half a millisecond, less than a sample together.
    assert [one.samples for one in found.left_out] == pytest.approx([2, 100], abs=1)
    assert not found.interpolated
    # Nothing was interpolated: the very numbers; times are right to half of the last decimal.
    assert np.array_equal(found.force, force(exact[rows]))
    assert np.abs(found.time - exact[rows]).max() < 0.6e-3
    assert any("times are rounded to 1 ms" in note for note in loaded.notes)


def test_loss_by_interpolation_is_that_of_the_formula() -> None:
    # Half way between samples of a wave, and averaged over all places: sinc².
    step, frequency = 1 / 200.0, 20.0
    fine = np.arange(0, 50.0, step / 64)
    coarse = np.arange(0, 50.0 + step, step)
    found = np.interp(fine, coarse, np.sin(2 * np.pi * frequency * coarse))
    amplitude = 2.0 * np.mean(found * np.sin(2 * np.pi * frequency * fine))
    # Sums over 64 places of a step instead of an integral: 1/64² of a loss of 3 %.
    assert interpolation_loss(frequency, step) == pytest.approx(1.0 - amplitude, abs=2e-5)


def test_samples_by_place_at_a_changing_speed(file: Path) -> None:
    place = np.arange(0.0, 400.0, 0.25)
    speed = 60.0 + 0.02 * place
    columns = {
        "position [m]": place, "speed [m/s]": speed, "contact_force [N]": force(place / 60.0),
    }  # fmt: skip
    [found] = read(write(file, columns)).pantographs
    assert (found.clock, told(found), found.interpolated) == ("position", [], True)
    # dt = dx/v with v = 60 + 0.02 x: t = 50 ln(v/60), and the trapezoidal rule adds
    # (Δx)²/12 · [(1/v)′] from end to end, up to (Δx)⁴: 1e-14 of the time.
    slope = 0.02 * (1.0 / speed[0] ** 2 - 1.0 / speed[-1] ** 2)
    exact = 50.0 * np.log(speed[-1] / 60.0) + 0.25**2 / 12.0 * slope
    assert found.last_s == pytest.approx(exact, rel=1e-12)
    missing = np.delete(np.arange(place.size), np.s_[800:810])
    gap = read(write(file, {name: values[missing] for name, values in columns.items()}))
    assert [one.samples for one in gap.pantographs[0].left_out] == [10]


def test_positions_that_turn_need_times(file: Path) -> None:
    place = np.r_[np.arange(0.0, 100.0), np.arange(98.0, 50.0, -1.0)]
    columns = {"position [m]": place, "contact_force [N]": force(place)}
    with pytest.raises(MeasurementError, match=r"run\.csv:102: position goes back: got 98 m after"):
        read(write(file, columns), speed="70 m/s")


def test_a_record_of_nothing_is_refused(file: Path) -> None:
    with pytest.raises(MeasurementError, match="no samples are left: got 5000 × frozen"):
        measured(file, contact_force=np.r_[1.0, np.full(4998, 7.0), 1.0][:5000] * 0 + 7.0)
    with pytest.raises(MeasurementError, match="no samples are left"):
        measured(file, time=np.full(5000, NAN))
