"""The whole assessment on records with known content."""

import json
import math

import numpy as np
import pytest

from arcless.assess import Assessment, Criterion, assess, verdict_of
from arcless.errors import ModelError
from tests.support.synthetic import scenario_data, synthetic_dataset

# The names of the interface; users script against them.
KEYS = {
    "scenario", "version", "speed_m_s", "pantographs", "max_uplift_at_support_mm",
    "slack_droppers_max", "min_dropper_force_N", "energy_residual_relative", "steps",
    "wall_time_s", "real_time_factor", "criteria",
}  # fmt: skip
PANTOGRAPH_KEYS = {
    "name", "mean_force_N", "std_force_N", "std_force_0_5Hz_N", "std_force_5_20Hz_N",
    "max_force_N", "min_force_N", "statistical_max_N", "statistical_min_N",
    "contact_loss_percent", "NQ_percent", "longest_loss_s", "max_gap_mm", "contact_point_range_mm",
    "unfiltered_max_force_N", "unfiltered_min_force_N", "max_lateral_position_mm",
}  # fmt: skip
CRITERION_KEYS = {"name", "value", "limit", "passed", "source"}


def gain(frequency: float, cutoff: float) -> float:
    ratio = math.tan(math.pi * frequency / 1000.0) / math.tan(math.pi * cutoff / 1000.0)
    return 1.0 / (1.0 + ratio**12)


def sine(frequency: float, amplitude: float):
    return lambda t: amplitude * np.sin(2.0 * np.pi * frequency * t)


def test_keys_are_those_of_the_interface() -> None:
    found = assess(synthetic_dataset()).to_dict()
    assert set(found) >= KEYS
    assert set(found["pantographs"][0]) == PANTOGRAPH_KEYS
    assert set(found["criteria"][0]) >= CRITERION_KEYS


# Read back with and without what only some assessments have: coefficients of wear, a part run over.
@pytest.mark.parametrize("section", [None, (100.0, 5000.0)])
def test_plain_values_are_read_back(section: tuple[float, float] | None) -> None:
    found = assess(synthetic_dataset(), section=section)
    assert Assessment.from_dict(found.to_dict()) == found


# 200 m at 20 m/s are 10 s: whole periods of 2, 9 and 50 Hz, so means and σ are exact; the section
# holds both its ends, one sample more than whole periods, hence 1e-3 instead of rounding.
def test_mean_deviation_and_bands_of_three_sines() -> None:
    waves = [sine(2.0, 30.0), sine(9.0, 10.0), sine(50.0, 25.0)]
    dataset = synthetic_dataset(force=lambda t: 120.0 + sum(wave(t) for wave in waves))
    [found] = assess(dataset).pantographs
    low = 30.0 * gain(2.0, 5.0) / math.sqrt(2.0)
    high = math.hypot(
        30.0 * (gain(2.0, 20.0) - gain(2.0, 5.0)), 10.0 * (gain(9.0, 20.0) - gain(9.0, 5.0))
    ) / math.sqrt(2.0)
    # Whole waves: their mean is round-off. The filter's transient at the ends is 5e-5 of them.
    assert found.mean_force_N == pytest.approx(120.0, abs=1e-9)
    assert found.std_force_0_5Hz_N == pytest.approx(low, rel=1e-3)
    assert found.std_force_5_20Hz_N == pytest.approx(high, rel=1e-3)
    assert found.std_force_N == pytest.approx(math.hypot(low, high), rel=1e-3)
    assert found.statistical_max_N == found.mean_force_N + 3.0 * found.std_force_N
    assert found.statistical_min_N == found.mean_force_N - 3.0 * found.std_force_N


def test_a_sine_above_the_band_vanishes_and_shows_only_unfiltered() -> None:
    [found] = assess(synthetic_dataset(force=lambda t: 100.0 + sine(50.0, 40.0)(t))).pantographs
    assert found.std_force_N < 40.0 * gain(50.0, 20.0) + 1e-6
    assert found.unfiltered_max_force_N == pytest.approx(140.0)
    assert found.unfiltered_min_force_N == pytest.approx(60.0)
    # What the filter leaves of 40 N at 2.5 times its cut-off is 6e-4 N.
    assert found.max_force_N == pytest.approx(100.0, abs=1e-2)


# The force is one constant inside the section and another one outside: assessing the right part
# in the wrong order (cut, then filter) would give exactly 0; filtering first blurs the border.
def test_the_whole_record_is_filtered_before_the_section_is_cut() -> None:
    step = lambda t: np.where((t >= 10.0) & (t <= 20.0), 100.0, 300.0)  # noqa: E731
    [found] = assess(synthetic_dataset(force=step)).pantographs
    assert found.max_force_N > 150.0
    assert found.unfiltered_max_force_N == 100.0
    inner = assess(synthetic_dataset(force=step), section=(220.0, 380.0)).pantographs[0]
    assert inner.mean_force_N == pytest.approx(100.0, abs=1e-6)


def test_what_the_filter_makes_up_at_the_ends_stays_outside() -> None:
    wave = synthetic_dataset(force=lambda t: 100.0 + 50.0 * np.cos(2.0 * np.pi * 3.0 * t))
    assert assess(wave).notes == []
    *_, note = assess(wave, section=(0.0, 400.0)).notes
    assert "makes numbers up" in note


def test_each_pantograph_has_its_own_time_in_the_section() -> None:
    ramp = synthetic_dataset(pantographs=("P1", "P2"), distance_m=100.0, force=lambda t: 100.0 + t)
    first, second = assess(ramp).pantographs
    # P1 is inside from 10 to 20 s, P2 100 m behind at 20 m/s, five seconds later.
    assert first.mean_force_N == pytest.approx(115.0, abs=1e-6)
    assert second.mean_force_N == pytest.approx(120.0, abs=1e-6)


def lost(begin: float, end: float):
    # Half a step of margin: the drawn times are multiples of 1 ms up to rounding.
    return lambda t: np.where((t > begin - 5e-4) & (t < end - 5e-4), 0.0, 100.0)


def test_loss_is_counted_in_time_and_on_the_unfiltered_force() -> None:
    [found] = assess(synthetic_dataset(force=lost(12.0, 12.02))).pantographs
    samples = 10_001  # both ends of the section are inside
    assert found.contact_loss_percent == pytest.approx(100.0 * 20 / samples, rel=1e-12)
    assert found.longest_loss_s == pytest.approx(0.020, rel=1e-9)
    assert found.unfiltered_min_force_N == 0.0


@pytest.mark.parametrize(("lasts", "counts"), [(0.005, False), (0.006, True)])
def test_arcs_count_from_5_ms_on(lasts: float, counts: bool) -> None:
    [found] = assess(synthetic_dataset(force=lost(12.0, 12.0 + lasts))).pantographs
    # Counts over a count: round-off, here and below.
    assert found.contact_loss_percent == pytest.approx(1e5 * lasts / 10_001, rel=1e-9)
    assert found.NQ_percent == (found.contact_loss_percent if counts else 0.0)


def test_of_an_arc_over_the_border_the_whole_decides_and_the_part_inside_counts() -> None:
    [found] = assess(synthetic_dataset(force=lost(9.9, 10.002))).pantographs
    # Counts times a step, and over a count: round-off.
    assert found.longest_loss_s == pytest.approx(0.002, rel=1e-9)
    assert found.NQ_percent == pytest.approx(100.0 * 2 / 10_001, rel=1e-12)


def criterion(found: Assessment, name: str) -> Criterion:
    return next(each for each in found.criteria if each.name == name)


def test_the_wave_speed_is_that_of_the_wire_as_computed() -> None:
    # 20 m/s under 10 kN on 1 kg/m, 100 m/s: 0.2; heated, the run says 25 m/s, and that counts.
    assert criterion(assess(synthetic_dataset()), "wave_speed_use").value == 0.2
    slack = assess(synthetic_dataset(attrs={"wave_speed_m_s": 25.0}))
    assert criterion(slack, "wave_speed_use").value == 0.8
    assert criterion(slack, "wave_speed_use").fails


def test_an_older_result_of_a_line_as_built_does_not_know_its_wave_speed() -> None:
    heated = scenario_data(as_built={"temperature_difference": 30.0})
    found = criterion(assess(synthetic_dataset(scenario=heated)), "wave_speed_use")
    assert (found.value, found.passed) == (None, None)
    assert "older" in (found.reason or "")


def lateral(y: float, **pantograph: object) -> Assessment:
    data = scenario_data()
    placement = data["pantographs"][0]
    sway = pantograph.pop("sway", 0.0)
    given = {**placement, "sway": sway, "model": {**placement["model"], **pantograph}}
    drawn = synthetic_dataset(scenario={**data, "pantographs": [given]})
    inside = (drawn["position"].values >= 300.0) & (drawn["position"].values <= 301.0)
    drawn["contact_lateral"].values[inside] = y
    return assess(drawn)


def test_lateral_position_is_the_largest_in_the_section_with_the_sway() -> None:
    found = lateral(-0.35, head_width=1.6, sway=0.1)
    assert found.pantographs[0].max_lateral_position_mm == pytest.approx(450.0)
    judged = criterion(found, "lateral_position")
    assert (judged.limit, judged.mark, judged.fails) == (400.0, "A", True)
    wide = criterion(lateral(-0.35, head_width=1.95, sway=0.1), "lateral_position")
    assert (wide.limit, wide.passed) == (550.0, True)


def test_a_range_that_is_given_counts_for_the_width() -> None:
    judged = criterion(lateral(0.35, head_width=1.6, lateral_range=0.3), "lateral_position")
    assert (judged.limit, judged.fails) == (300.0, True)


def test_a_width_from_memory_decides_nothing() -> None:
    marked = {"head_width": {"mark": "C", "given": "1600 mm"}}
    judged = criterion(lateral(0.5, head_width=1.6, provenance=marked), "lateral_position")
    assert (judged.passed, judged.mark, judged.fails) == (False, "C", False)


def test_a_planar_run_has_no_lateral_position() -> None:
    found = lateral(0.0, head_width=1.6)
    assert found.pantographs[0].max_lateral_position_mm is None
    assert "planar" in (criterion(found, "lateral_position").reason or "")


def test_a_supply_that_nobody_gave_is_told() -> None:
    assert assess(synthetic_dataset()).notes == []
    silent = assess(synthetic_dataset(scenario=scenario_data(line__design={"uplift_space": 0.1})))
    assert silent.supply == "AC 25 kV"
    assert [note for note in silent.notes if "line.design.supply is not given" in note]
    assert criterion(silent, "mean_force").mark == "assumed"


def test_a_loss_over_the_border_counts_with_its_part_inside() -> None:
    [found] = assess(synthetic_dataset(force=lost(9.9, 10.03))).pantographs
    # A count times a step: round-off.
    assert found.longest_loss_s == pytest.approx(0.030, rel=1e-9)


def test_a_loss_outside_the_section_does_not_count() -> None:
    [found] = assess(synthetic_dataset(force=lost(5.0, 6.0))).pantographs
    assert found.contact_loss_percent == 0.0
    assert found.longest_loss_s == 0.0


def test_percentages_are_by_time_when_the_speed_changes() -> None:
    # Half the distance at 20 m/s, half at 40 m/s: a loss all along the fast half is a third.
    dataset = synthetic_dataset(force=lambda t: np.where(t > 15.0, 0.0, 100.0))
    time = dataset["time"].values
    x = np.where(time <= 15.0, 20.0 * time, 300.0 + 40.0 * (time - 15.0))
    dataset["position"].values[:, 0] = x
    [found] = assess(dataset).pantographs
    # The step at the border may fall on either side of one of the 5 000 records there.
    assert found.contact_loss_percent == pytest.approx(100.0 / 3.0, rel=1e-3)


def test_gap_and_height_are_millimetres_inside_the_section() -> None:
    dataset = synthetic_dataset(
        gap=lambda t: np.where(t < 5.0, 0.5, np.where(np.abs(t - 15.0) < 0.01, 0.012, 0.0)),
        height=lambda t: 5.3 + np.where(t < 5.0, 0.4, 0.02) * np.sin(2.0 * np.pi * t),
    )
    [found] = assess(dataset).pantographs
    assert found.max_gap_mm == pytest.approx(12.0)
    # The tops of the wave fall on records: round-off of heights of 5 m.
    assert found.contact_point_range_mm == pytest.approx(40.0, rel=1e-9)


def test_line_numbers_come_from_places_inside_the_section() -> None:
    dataset = synthetic_dataset()
    dataset["support_uplift_max"].values[:] = 0.001 * np.arange(13)  # supports every 50 m
    dataset["dropper_force_min"].values[:] = np.abs(dataset["dropper_x"].values - 300.0)
    found = assess(dataset)
    assert found.max_uplift_at_support_mm == pytest.approx(8.0)  # at 400 m
    assert found.min_dropper_force_N == pytest.approx(5.0)
    assert assess(dataset, section=(210.0, 240.0)).max_uplift_at_support_mm is None


def test_speed_and_wave_speed_come_from_run_and_line() -> None:
    found = assess(synthetic_dataset())
    # Round-off of a division.
    assert found.speed_m_s == pytest.approx(20.0, rel=1e-12)
    [use] = [c for c in found.criteria if c.name == "wave_speed_use"]
    assert use.value == pytest.approx(0.2, rel=1e-12)  # √(10 kN / 1 kg/m) = 100 m/s


def test_design_space_decides_the_uplift_criterion() -> None:
    def uplift(**design):
        data = scenario_data(line__design={"uplift_space": None, **design})
        found = assess(synthetic_dataset(scenario=data)).criteria
        return next(c for c in found if c.name == "uplift_space")

    assert uplift(uplift_space=0.08).passed is True  # 2 × 40 mm
    assert uplift(uplift_space=0.0799).passed is False
    assert uplift(uplift_space=0.06, uplift_limited=True).passed is True
    assert uplift().passed is None


def test_passed_ignores_what_could_not_be_judged() -> None:
    data = scenario_data(line__design={"uplift_space": None})
    calm = synthetic_dataset(scenario=data, force=lambda t: np.full_like(t, 80.0))
    found = assess(calm)
    assert None in {c.passed for c in found.criteria}
    assert found.passed
    assert not assess(synthetic_dataset(force=lambda t: np.full_like(t, 500.0))).passed


@pytest.mark.parametrize(
    "dataset",
    [
        synthetic_dataset(),
        synthetic_dataset(force=np.zeros_like),
        synthetic_dataset(without=("support_uplift_max", "dropper_force_min")),
        synthetic_dataset(attrs={"energy_residual_relative": None, "slack_droppers_max": None}),
    ],
    ids=["usual", "never in contact", "no extremes", "no ledger"],
)
def test_json_never_holds_a_nan(dataset) -> None:
    text = assess(dataset).to_json()
    assert "NaN" not in text
    assert "Infinity" not in text
    assert json.loads(text) == assess(dataset).to_dict()


def test_what_is_missing_is_null_and_noted() -> None:
    dataset = synthetic_dataset(
        without=("support_uplift_max",), attrs={"energy_residual_relative": None}
    )
    found = assess(dataset)
    assert found.max_uplift_at_support_mm is None
    assert found.energy_residual_relative is None
    assert any("max_uplift_at_support_mm" in note for note in found.notes)


@pytest.mark.parametrize("kinematics", ["linearised", "updated"])
def test_advice_on_the_energy_ledger_is_advice_that_the_model_accepts(kinematics: str) -> None:
    changes = {"solver__kinematics": kinematics}
    dataset = synthetic_dataset(
        scenario=scenario_data(**changes), attrs={"energy_residual_relative": None}
    )
    advice = any("`output.energy: always`" in note for note in assess(dataset).notes)
    # With updated kinematics the model refuses it.
    accepted = True
    try:
        scenario_data(**changes, output__energy="always")
    except ModelError:
        accepted = False
    assert advice is accepted


def test_a_coarse_record_is_noted() -> None:
    [note] = assess(synthetic_dataset(step_s=0.01)).notes
    assert "100 Hz" in note


def test_a_section_that_is_only_partly_travelled_is_noted() -> None:
    notes = assess(synthetic_dataset(), section=(400.0, 900.0)).notes
    assert any("400 to 600 m" in note for note in notes)


@pytest.mark.parametrize(
    "section", [(700.0, 900.0), (-50.0, -10.0), (300.0, 300.0), (400.0, 200.0), (math.nan, 1.0)]
)
def test_a_section_that_cannot_be_is_refused(section) -> None:
    with pytest.raises(ModelError, match="analysis section"):
        assess(synthetic_dataset(), section=section)


def test_another_low_pass_changes_what_is_kept() -> None:
    dataset = synthetic_dataset(force=lambda t: 100.0 + sine(9.0, 10.0)(t))
    narrow = assess(dataset, low_pass_Hz=6.0).pantographs[0]
    wide = assess(dataset).pantographs[0]
    # The section holds whole waves; the filter's transients at its ends leave 5e-5.
    assert narrow.std_force_N == pytest.approx(10.0 * gain(9.0, 6.0) / math.sqrt(2.0), rel=1e-3)
    assert wide.std_force_N == pytest.approx(10.0 * gain(9.0, 20.0) / math.sqrt(2.0), rel=1e-3)


def test_a_low_pass_below_the_band_split_leaves_nothing_in_the_upper_band() -> None:
    dataset = synthetic_dataset(force=lambda t: 100.0 + sine(2.0, 10.0)(t))
    assert assess(dataset, low_pass_Hz=4.0).pantographs[0].std_force_5_20Hz_N == 0.0


@pytest.mark.parametrize("frequency", [0.0, -1.0, 1e-100, 1e-4, 1e6, math.nan, math.inf])
def test_a_low_pass_that_cannot_be_is_refused(frequency: float) -> None:
    with pytest.raises(ModelError, match="low-pass"):
        assess(synthetic_dataset(), low_pass_Hz=frequency)


def test_the_dataset_stays_as_it_was() -> None:
    dataset = synthetic_dataset()
    before = dataset.copy(deep=True)
    assess(dataset)
    assert dataset.identical(before)


def test_a_filtered_force_below_zero_is_explained() -> None:
    """The low-pass undershoots where contact is lost; forces themselves cannot be negative."""
    found = assess(synthetic_dataset(force=lambda t: 100.0 * (np.abs(t - 15.0) > 0.1)))
    (note,) = [note for note in found.notes if "undershoot" in note]
    lowest = found.pantographs[0].min_force_N
    assert lowest < 0.0 == found.pantographs[0].unfiltered_min_force_N
    assert f"of pantograph P1, {lowest:.1f} N, is an undershoot" in note
    calm = assess(synthetic_dataset(force=lambda t: 100.0 + 10.0 * np.sin(t)))
    assert not any("undershoot" in note for note in calm.notes)


def test_a_section_beyond_the_run_says_what_was_run_over() -> None:
    whole = synthetic_dataset()
    assert assess(whole).ran_over_m is None
    found = assess(whole, section=(100.0, 5000.0))
    end = float(whole["position"].values[-1].max())
    assert found.ran_over_m == [100.0, end]
    assert f"of which 100.0 m to {end:.1f} m" in found.section_words
    assert any("ran over" in note for note in found.notes)


def test_deviations_over_less_than_two_spans_are_not_judged() -> None:
    """Spans of 50 m, from 0 on; 50 N about 85 N miss limits that σ has a part in."""
    dataset = synthetic_dataset(force=lambda t: 85.0 + sine(1.0, 50.0)(t))
    deviations = {"standard_deviation", "statistical_max", "statistical_min"}

    def verdicts(section: tuple[float, float]) -> dict[str, str]:
        told = assess(dataset, section=section).to_dict()["criteria"]
        return {one["name"]: verdict_of(one) for one in told}

    whole = verdicts((200.0, 300.0))
    assert whole["standard_deviation"] == "not met"
    # Two spans from the middle of one to the middle of another, and an end typed a millimetre off.
    assert verdicts((225.0, 325.0)) == verdicts((200.001, 300.0)) == whole
    short = verdicts((200.0, 299.0))
    assert {short[name] for name in deviations} == {"not judged"}
    assert {name: one for name, one in short.items() if name not in deviations} == {
        name: one for name, one in whole.items() if name not in deviations
    }
    found = assess(dataset, section=(200.0, 299.0))
    sigma = next(one for one in found.criteria if one.name == "standard_deviation")
    assert sigma.reason is not None
    assert sigma.reason.startswith("too short: 1.98 spans, and fewer than 2 ")
    assert sigma.value == pytest.approx(50.0 / math.sqrt(2.0), rel=0.02)  # 4.95 periods of 1 s
    # What could be compared and is not judged is not met: no limit is missed, and none is praised.
    assert found.passed
    assert found.headline.state == "open"
    assert found.headline.text.startswith("Not judged: ")
    assert any("99 m, 1.98 spans, " in note for note in found.notes)


def test_a_run_that_stops_within_two_spans_is_not_judged_by_its_deviation() -> None:
    dataset = synthetic_dataset(duration_s=14.0)
    (sigma,) = (one for one in assess(dataset).criteria if one.name == "standard_deviation")
    assert sigma.passed is None  # it ran from 200 to 280 m
    # At the last sample before the end of the second span both were run over.
    whole = assess(synthetic_dataset(duration_s=14.999, section=(200.0, 300.0)))
    (sigma,) = (one for one in whole.criteria if one.name == "standard_deviation")
    assert sigma.passed


def test_a_record_without_supports_is_judged_by_whatever_it_holds() -> None:
    bare = synthetic_dataset(without=("support_x",), section=(200.0, 210.0))
    (sigma,) = (one for one in assess(bare).criteria if one.name == "standard_deviation")
    assert sigma.passed


def test_a_section_of_some_metres_is_doubted() -> None:
    assert any("those of one place" in note
               for note in assess(synthetic_dataset(), section=(100.0, 110.0)).notes)  # fmt: skip
