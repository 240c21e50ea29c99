"""Measurements whose statistics are known: clean ones, and ones with faults."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

from arcless.assess.signals.loss_of_contact import arcing_percent, longest_loss_s
from arcless.errors import MeasurementError, ModelError
from arcless.measurements import Measurement, assess, read
from arcless.measurements.samples.settled import bands, settled
from tests.support.measured import RATE, SPEED, force, record, times, wave, write
from tests.unit.assess.test_assessment import CRITERION_KEYS, KEYS, PANTOGRAPH_KEYS

NAN = float("nan")


def gain(frequency: float, cutoff: float) -> float:
    ratio = math.tan(math.pi * frequency / RATE) / math.tan(math.pi * cutoff / RATE)
    return 1.0 / (1.0 + ratio**12)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "run.csv"


def measured(file: Path, rows: np.ndarray | None = None, **changed: np.ndarray) -> Measurement:
    columns = record(**changed)
    if rows is not None:
        columns = {name: values[rows] for name, values in columns.items()}
    return read(write(file, columns))


# From 70 to 630 m are 8 s: whole periods of 2, 9 and 50 Hz, one sample more than 4000.
WAVES = [wave(2.0, 30.0), wave(9.0, 10.0), wave(50.0, 25.0)]
INSIDE = (70.0, 630.0)
LOW = 30.0 * gain(2.0, 5.0) / math.sqrt(2.0)
HIGH = math.hypot(
    30.0 * (gain(2.0, 20.0) - gain(2.0, 5.0)), 10.0 * (gain(9.0, 20.0) - gain(9.0, 5.0))
) / math.sqrt(2.0)  # fmt: skip


def three_waves() -> np.ndarray:
    return 120.0 + sum(one(times()) for one in WAVES)


def test_statistics_of_three_waves(file: Path) -> None:
    found = assess(measured(file, contact_force=three_waves()), section=INSIDE)
    [p] = found.pantographs
    # One sample too many of 4000, at the mean: 3e-4. The filter's transients are 5e-5.
    assert p.mean_force_N == pytest.approx(120.0, rel=1e-4)
    assert p.std_force_0_5Hz_N == pytest.approx(LOW, rel=1e-3)
    assert p.std_force_5_20Hz_N == pytest.approx(HIGH, rel=1e-3)
    assert p.std_force_N == pytest.approx(math.hypot(LOW, HIGH), rel=1e-3)
    assert p.statistical_max_N == p.mean_force_N + 3.0 * p.std_force_N
    assert found.speed_m_s == pytest.approx(SPEED, rel=1e-9)
    assert (p.max_gap_mm, p.contact_point_range_mm, found.steps) == (None, None, None)
    assert "nothing in the section is left out" in " ".join(found.notes)


def test_a_gap_takes_its_time_and_the_ends_of_pieces_away(file: Path) -> None:
    # 2 s are missing, four periods of the slowest wave; 0.2 s at four ends are left out, too.
    rows = np.r_[0:2000, 3000:5000]
    found = assess(measured(file, rows, contact_force=three_waves()))
    [told] = found.measurement["pantographs"]
    assert (told["pieces"], found.measurement["edge_s"]) == (2, 0.2)
    # Of 10 s, 2 s and 4 × 0.2 s; a step or two of 2 ms less.
    assert told["left_out_percent"] == pytest.approx(28.0, abs=0.05)
    [p] = found.pantographs
    # 3.6 s are 7.2 periods of 2 Hz: what is left over moves the mean by 30/(2π·7.2) N at most.
    assert p.mean_force_N == pytest.approx(120.0, abs=0.7)
    assert p.std_force_N == pytest.approx(math.hypot(LOW, HIGH), rel=0.03)


def test_a_piece_is_filtered_alone(file: Path) -> None:
    jumped = three_waves()
    jumped[2500:] += 500.0
    position = SPEED * times()
    position[2500:] += 5.0
    [p] = measured(file, contact_force=jumped, position=position).pantographs
    found = bands(p)
    whole = bands(measured(file, contact_force=three_waves()).pantographs[0]).total
    far = settled(p, 0.2)
    # Nothing of the other piece's 500 N comes over: 0.2 % of σ, as the module says, and the
    # rounding of a filter of numbers of 600 N.
    expected = whole + np.where(np.arange(5000) < 2500, 0.0, 500.0)
    assert np.abs(found.total - expected)[far].max() < 2e-3 * math.hypot(LOW, HIGH)
    assert np.abs(found.total - expected)[~far].max() > 0.5


def test_losses_end_where_their_piece_does(file: Path) -> None:
    lost = force(times())
    lost[2498:2502] = 0.0
    whole = assess(measured(file, contact_force=lost)).pantographs[0]
    assert whole.longest_loss_s == pytest.approx(0.008, rel=1e-9)
    # 8 ms count as an arc; two times 4 ms do not. Away from the ends of pieces they are not seen.
    assert whole.NQ_percent == pytest.approx(100.0 * 4 / 4800, rel=1e-9)
    inside = np.ones(5000, bool)
    assert arcing_percent(lost, inside, 1 / RATE, [2500]) == 0.0
    assert longest_loss_s(lost, 1 / RATE, inside, [2500]) == pytest.approx(0.004, rel=1e-9)
    assert longest_loss_s(lost, 1 / RATE, inside, [2400]) == pytest.approx(0.008, rel=1e-9)


def test_keys_are_those_of_a_run(file: Path) -> None:
    told = assess(measured(file)).to_dict()
    assert set(told) >= KEYS
    assert set(told["pantographs"][0]) == PANTOGRAPH_KEYS
    assert set(told["criteria"][0]) >= CRITERION_KEYS
    assert "NaN" not in json.dumps(told, allow_nan=False)


def test_limits_of_a_supply_decide_only_where_it_is_given(file: Path) -> None:
    # σ of 0.3 F_m is beyond by far: 40 N on 100 N.
    strong = 100.0 + wave(2.0, 60.0)(times())
    found = assess(measured(file, contact_force=strong), supply="DC 3 kV")
    by_name = {one.name: one for one in found.criteria}
    assert by_name["statistical_max"].mark == "A"
    assert by_name["standard_deviation"].fails
    assert not found.passed
    weak = assess(measured(file, contact_force=strong))
    marks = {one.name: one.mark for one in weak.criteria}
    assert marks["statistical_max"] == marks["mean_force"] == "assumed"
    assert "the supply is not given" in " ".join(weak.notes)
    with pytest.raises(MeasurementError, match='supply: got "AC 25kV", expected AC 25 kV, AC 15'):
        assess(measured(file), supply="AC 25kV")


def test_what_was_not_measured_is_not_judged(file: Path) -> None:
    by_name = {one.name: one for one in assess(measured(file), supply="AC 25 kV").criteria}
    for name in ("uplift_space", "lateral_position", "wave_speed_use"):
        assert (by_name[name].value, by_name[name].passed) == (None, None)
        assert by_name[name].reason == "the file has no column for it"


def _verdicts(file: Path, signal: np.ndarray) -> dict[str, bool | None]:
    found = assess(measured(file, contact_force=signal), supply="AC 25 kV", section=INSIDE)
    return {one.name: one.passed for one in found.criteria}


def _peaks(every_s: float) -> np.ndarray:
    """Return half waves of 300 N and 0.2 s, the first one a second before the first period ends."""
    phase = (times() + 1.0) % every_s
    return np.where(phase < 0.2, 300.0 * np.sin(np.pi * phase / 0.2), 0.0)


def test_clipped_peaks_never_meet_a_limit(file: Path) -> None:
    true = 105.0 + wave(7.1, 10.0)(times()) + _peaks(2.0)
    names = ("standard_deviation", "statistical_min")
    assert [_verdicts(file, true)[name] for name in names] == [False, False]
    upper = _verdicts(file, np.minimum(true, 220.0))
    for name in (*names, "mean_force", "statistical_max"):
        assert upper[name] is None, name
    assert upper["contact_loss"] is True
    found = assess(read(file), supply="AC 25 kV", section=INSIDE)
    [told] = found.measurement["pantographs"]
    [doubt] = told["doubts"]
    assert "contact_force was at the upper end of its range in 4 places" in doubt
    assert "its maximum is at least 220 N" in doubt
    assert doubt in found.notes
    assert {(one["end"], one["rail"]) for one in told["left_out"]} == {("upper", 220.0)}
    # Behind the section the peaks say nothing about it.
    alone = assess(read(file), supply="AC 25 kV", section=(230.0, 340.0))
    assert alone.measurement["pantographs"][0]["doubts"] == []


def test_a_force_clipped_below_may_have_been_a_loss(file: Path) -> None:
    signal = 105.0 + wave(7.1, 9.0)(times()) - 0.3 * _peaks(4.0)
    assert _verdicts(file, signal)["contact_loss"] is True
    lower = _verdicts(file, np.maximum(signal, 50.0))
    for name in ("contact_loss", "standard_deviation", "statistical_min", "statistical_max"):
        assert lower[name] is None, name


def test_verdicts_that_a_bound_gives_stand(file: Path) -> None:
    # The true mean is larger than one that is too large already.
    signal = 160.0 + wave(7.1, 9.0)(times()) + _peaks(4.0)
    assert _verdicts(file, np.minimum(signal, 220.0))["mean_force"] is False


@pytest.mark.parametrize(
    ("factor", "text"),
    [(-1.0, "100 % of the contact forces are below zero"), (1000.0, "is beyond the 10 to 1000 N"),
     (0.01, "is beyond the 10 to 1000 N")],
)  # fmt: skip
def test_forces_that_no_pantograph_has_are_not_judged(file: Path, factor: float, text: str) -> None:
    found = assess(measured(file, contact_force=factor * force(times())), supply="AC 25 kV")
    assert {one.passed for one in found.criteria} == {None}
    [doubt] = found.measurement["pantographs"][0]["doubts"]
    assert text in doubt
    assert doubt in found.notes


def test_single_empty_cells_are_counted_by_place(file: Path) -> None:
    signal = force(times())
    signal[::50] = NAN
    expected = r"empty cell in 100 places \(100 samples\).*costs 0.4 s more.*fill single empty"
    with pytest.raises(MeasurementError, match=expected):
        assess(measured(file, contact_force=signal))


def test_uplift_and_height_are_read(file: Path) -> None:
    height = 5.3 + wave(0.5, 0.02)(times())
    height[100:200] = NAN
    uplift = 0.03 + wave(0.5, 0.02)(times())
    found = assess(measured(file, contact_height=height, uplift=uplift), section=INSIDE)
    # Whole periods: the sample nearest to the top is 1e-3 s away, 5e-6 of the amplitude.
    assert found.pantographs[0].contact_point_range_mm == pytest.approx(40.0, rel=1e-5)
    assert found.max_uplift_at_support_mm == pytest.approx(50.0, rel=1e-5)
    assert next(one for one in found.criteria if one.name == "uplift_space").value is not None
    whole = assess(measured(file, contact_height=height))
    assert any("of the heights are missing" in note for note in whole.notes)


def test_too_little_left_is_refused(file: Path) -> None:
    rows = np.r_[0:1200, 3700:5000]
    with pytest.raises(
        MeasurementError, match=r"too little is left.*at least 50 %.*gap in 1 place \(2500 "
    ):
        assess(measured(file, rows))
    # Pieces of 0.4 s or less have nothing between their ends.
    short = np.flatnonzero(np.arange(5000) % 200 != 0)
    with pytest.raises(MeasurementError, match=r"got 0\.0 % of the time"):
        assess(measured(file, short))
    with pytest.raises(MeasurementError, match=r"got no sample.*the record goes from 0 to 699"):
        assess(measured(file), section=(900.0, 1000.0))
    with pytest.raises(ModelError, match="from < to"):
        assess(measured(file), section=(300.0, 200.0))


def test_a_record_that_is_too_coarse(file: Path) -> None:
    rows = np.arange(0, 5000, 10)
    coarse = measured(file, rows)
    found = assess(coarse)
    [note] = [one for one in found.notes if "EN 50317 requires" in one]
    assert "sampled at 50 Hz, every 1.40 m" in note
    assert "above 30 Hz is folded below 20 Hz" in note
    with pytest.raises(MeasurementError, match=r"too few samples for the low-pass.*got 50 samples"):
        assess(coarse, low_pass_Hz=25.0)
    assert not any("EN 50317 requires" in one for one in assess(measured(file)).notes)


def test_each_fault_is_in_the_notes(file: Path) -> None:
    signal = force(times())
    signal[1000:1010] = NAN
    signal[3000:3100] = 131.0
    notes = assess(measured(file, np.delete(np.arange(5000), [2000, 2001]), contact_force=signal))
    told = [note for note in notes.notes if "left out because" in note]
    assert told == [
        "pantograph P1, left out because the cell is empty or no number: line 1002 at 140.0 m, "
        "10 samples",
        "pantograph P1, left out because samples are missing: line 2001 at 279.9 m, 2 samples",
        "pantograph P1, left out because the value does not change: line 3000 at 420.0 m, "
        "100 samples",
    ]


def test_only_what_touches_the_section_is_in_the_notes(file: Path) -> None:
    signal = force(times())
    signal[1000:1010] = NAN
    signal[3000:3010] = NAN
    rows = np.delete(np.arange(5000), [2000, 2001])
    notes = assess(measured(file, rows, contact_force=signal), section=(300.0, 650.0)).notes
    [told] = [note for note in notes if "left out because" in note]
    assert "line 3000 at 420.0 m, 10 samples" in told
    assert any("at the ends of 2 pieces" in note for note in notes)


def test_a_changing_speed_is_told(file: Path) -> None:
    columns = record(speed=np.linspace(60.0, 80.0, 5000))
    del columns["position [m]"]
    found = assess(read(write(file, columns)))
    assert any("went from 217 to 287 km/h" in note for note in found.notes)
    assert found.speed_m_s == pytest.approx(70.0, rel=1e-3)


def test_falling_positions_are_the_same_run(file: Path) -> None:
    up = assess(measured(file), section=INSIDE)
    down = measured(file, position=700.0 - SPEED * times())
    found = assess(down, section=(700.0 - INSIDE[1], 700.0 - INSIDE[0]))
    assert found.pantographs == up.pantographs
