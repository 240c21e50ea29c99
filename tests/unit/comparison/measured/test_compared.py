"""Test runs laid over a run: offsets, bands and tolerances whose values are known."""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.comparison import Aligning, Comparison, cells, compare
from arcless.comparison.alignment import Alignment
from arcless.comparison.content import comparison_content
from arcless.comparison.measured.acceptance import Tolerance
from arcless.errors import ComparisonError, MeasurementError
from arcless.figures.description import Bars, Curve
from arcless.measurements import read
from tests.support.beside import PERIODIC, along, run, test_run

# An eighth of the shortest wave that passes the filter at 20 m/s, 1 m, refined by a parabola.
PLACE_M = 0.02


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "test run.csv"


def alignment(found: Comparison, side: int = 1) -> Any:
    placed = found.sides[side].placed
    assert placed is not None
    return placed.alignments[0]


def band(found: Comparison, label: str, kind: str = "filtered") -> Any:
    return next(one for one in found.bands if one.label == label and one.kind == kind)


@pytest.mark.parametrize("offset", [-21.0, 0.0, 3.2])
def test_the_same_force_has_no_differences(file: Path, offset: float) -> None:
    found = compare([run(), test_run(file, offset_m=offset)])
    by = alignment(found)
    assert by.offset_m == pytest.approx(-offset, abs=PLACE_M)
    assert by.scale == pytest.approx(1.0, abs=1e-4)
    assert by.correlation == pytest.approx(1.0, abs=1e-4)
    assert not by.ambiguous
    assert found.sides[1].assessment.section_m == pytest.approx([200.0, 400.0])
    for one in found.indicators:
        if one.key in ("mean_force_N", "std_force_N", "std_force_5_20Hz_N", "max_force_N"):
            # Samples of other places, 0.1 m apart, and edges of the section by 0.02 m.
            assert one.differences[1] == pytest.approx(0.0, abs=0.05), one.key
    assert found.warnings == ()
    assert found.names == ("synthetic", "test run (measured)")


def test_bands_are_those_of_the_waves(file: Path) -> None:
    def twice(x: np.ndarray) -> np.ndarray:
        return along(x, ((20.0, 0.02), (12.0, 0.1), (12.0, 0.4)))

    found = compare([run(lambda x: along(x, PERIODIC)), test_run(file, twice)])
    # 8 Hz is in the upper band alone: the low-pass of 5 Hz has (5/8)^12 = 0.4 % of it.
    upper = band(found, "5–20 Hz")
    assert upper.deviations_N == pytest.approx((6.0 / 2**0.5, 12.0 / 2**0.5), rel=5e-3)
    assert upper.percents[1] == pytest.approx(100.0, abs=1.0)
    assert upper.correlations[1] == pytest.approx(1.0, abs=1e-3)
    # 0.4 Hz, and half of the 2 Hz that a cut-off of 2 Hz leaves.
    slow = band(found, "0–2 Hz")
    assert slow.deviations_N[0] == pytest.approx(math.hypot(20.0, 6.0) / 2**0.5, rel=5e-3)
    assert band(found, "0–20 Hz").deviations_N[1] == pytest.approx(
        math.hypot(20.0, 12.0, 12.0) / 2**0.5, rel=2e-3
    )
    # 10^0.9 = 7.94 Hz: windows of 4 s spread a wave of 8 Hz over 1 Hz, of an octave 1.8 Hz wide.
    octave = band(found, "7.94 Hz", "third octave")
    assert octave.deviations_N == pytest.approx((6.0 / 2**0.5, 12.0 / 2**0.5), rel=0.02)
    assert octave.correlations == (None, None)


def test_only_the_section_counts(file: Path) -> None:
    def rough(x: np.ndarray) -> np.ndarray:
        # 10 m, half a second, beyond the section the filter does not see any more.
        return along(x) + np.where((x < 190.0) | (x > 410.0), 40.0 * np.sin(2.5 * x), 0.0)

    found = compare([run(), test_run(file, rough)])
    for label in ("0–20 Hz", "5–20 Hz"):
        own, other = band(found, label).deviations_N
        assert other == pytest.approx(own, rel=0.01)
    octave = band(found, "7.94 Hz", "third octave")
    assert octave.deviations_N[1] == pytest.approx(octave.deviations_N[0], rel=0.01)


def test_the_other_way_round(file: Path) -> None:
    found = compare(
        [test_run(file, offset_m=5.0, end_m=450.0), run(), run(lambda x: along(x) + 10.0)]
    )
    assert alignment(found, 0).offset_m == pytest.approx(-5.0, abs=PLACE_M)
    mean = next(one for one in found.indicators if one.key == "mean_force_N")
    assert mean.differences == pytest.approx((0.0, 0.0, 10.0), abs=0.05)
    assert {(one.run, one.measurement) for one in found.acceptance} == {(1, 0), (2, 0)}


def test_several_test_runs_share_the_part_that_all_have(file: Path, tmp_path: Path) -> None:
    late = test_run(tmp_path / "late.csv", begin_m=250.0, offset_m=-2.0)
    found = compare([run(), test_run(file, offset_m=4.0), late])
    offsets = [alignment(found, side).offset_m for side in (1, 2)]
    assert offsets == pytest.approx([-4.0, 2.0], abs=PLACE_M)
    # The filter begins 0.2 s, 4 m, behind the first sample.
    for one in found.sides:
        assert one.assessment.section_m == pytest.approx([254.0, 400.0], abs=0.15)
    assert any("all are compared from 254.0 to 400.0 m" in text for text in found.warnings)


def test_measurements_alone(file: Path, tmp_path: Path) -> None:
    other = test_run(tmp_path / "other.csv", offset_m=33.0, begin_m=120.0)
    found = compare([test_run(file), other])
    assert alignment(found, 1).offset_m == pytest.approx(-33.0, abs=PLACE_M)
    assert alignment(found, 0).method == "reference"
    assert found.fields == ()
    assert found.acceptance == ()
    assert found.figures["force"]


def test_drift_and_noise(file: Path) -> None:
    found = compare([run(), test_run(file, offset_m=8.0, drift=0.003, noise_N=5.0)])
    by = alignment(found)
    assert by.scale == pytest.approx(1.0 / 1.003, abs=2e-4)
    assert by.on_line(np.array([308.6]))[0] == pytest.approx(300.0, abs=0.1)


def test_ways_to_align(file: Path) -> None:
    noted = test_run(file, offset_m=3.0, noise_N=3.0)
    by_hand = compare([run(), noted], aligning=Aligning(offset_m=-3.0))
    assert alignment(by_hand).method == "given"
    assert alignment(by_hand).correlation > 0.98
    supports = compare([run(), noted], aligning=Aligning("supports"))
    # What 70 m long waves add to the mean of 12 spans of 50 m moves it by some decimetres.
    assert alignment(supports).offset_m == pytest.approx(-3.0, abs=0.6)
    assert alignment(supports).method == "supports"
    none = compare([run(), noted], aligning=Aligning("none"))
    assert (alignment(none).offset_m, alignment(none).scale) == (0.0, 1.0)
    assert alignment(none).correlation < 0.9
    scaled = compare([run(), noted], aligning=Aligning(offset_m=-3.0, scale=1.001))
    assert alignment(scaled).on_line(np.array([503.0]))[0] == pytest.approx(500.4)


def test_heights_align_where_the_force_misses_inertia(file: Path) -> None:
    def late(x: np.ndarray) -> np.ndarray:
        return along(x - 3.0)

    found = compare(
        [run(), test_run(file, late, offset_m=6.0)], aligning=Aligning(channel="height")
    )
    assert alignment(found).offset_m == pytest.approx(-6.0, abs=PLACE_M)
    assert alignment(found).channel == "height"
    by_force = compare([run(), test_run(file, late, offset_m=6.0)])
    assert alignment(by_force).offset_m == pytest.approx(-9.0, abs=PLACE_M)


def test_heights_that_are_missing_do_not_count(file: Path) -> None:
    written = test_run(file, offset_m=6.0)
    rows = written.read_text("utf-8").splitlines()
    for number in [*range(900, 960), 2000]:
        rows[number] = ",".join([*rows[number].split(",")[:-1], ""])
    written.write_text("\n".join(rows) + "\n", "utf-8")
    found = compare([run(), written], aligning=Aligning(channel="height"))
    assert alignment(found).offset_m == pytest.approx(-6.0, abs=PLACE_M)
    bare = "\n".join(row.rpartition(",")[0] for row in rows) + "\n"
    written.write_text(bare, "utf-8")
    with pytest.raises(ComparisonError, match="no heights"):
        compare([run(), written], aligning=Aligning(channel="height"))


def test_what_was_measured_beyond_the_line_is_not_drawn(file: Path) -> None:
    found = compare([run(), test_run(file, begin_m=-2000.0, end_m=3000.0)])
    assert alignment(found).offset_m == pytest.approx(0.0, abs=0.1)
    (figure,) = found.figures["force"]
    for one in figure.layers:
        if isinstance(one, Curve):
            assert -1.0 <= np.nanmin(one.x) < np.nanmax(one.x) <= 601.0


def test_spans_alike_are_told(file: Path) -> None:
    def force(x: np.ndarray) -> np.ndarray:
        return along(x, PERIODIC)

    wide = compare([run(force), test_run(file, force)], aligning=Aligning(search_m=130.0))
    assert alignment(wide).ambiguous
    assert any("the offset is not sure" in text for text in wide.warnings)
    near = compare([run(force), test_run(file, force)])
    assert not alignment(near).ambiguous


def test_a_span_too_far_is_told(file: Path) -> None:
    found = compare([run(), test_run(file, offset_m=60.0)])
    assert alignment(found).beyond_offset_m == pytest.approx(-60.0, abs=0.1)
    assert any("out of the search, fits better" in text for text in found.warnings)


def test_positions_of_no_line_are_searched_everywhere(file: Path) -> None:
    found = compare([run(), test_run(file, offset_m=47_000.0)])
    assert alignment(found).offset_m == pytest.approx(-47_000.0, abs=PLACE_M)


def test_a_train_towards_lower_positions(file: Path) -> None:
    written = test_run(file, falling=True)
    found = compare([run(), written])
    by = alignment(found)
    assert by.falling
    # It begins at 900 m of its own, which is 100 m of the line.
    assert by.offset_m == pytest.approx(-800.0, abs=PLACE_M)
    assert by.on_line(np.array([900.0, 500.0])) == pytest.approx([100.0, 500.0], abs=0.1)
    assert any("its positions fall" in text for text in found.warnings)
    with pytest.raises(ComparisonError, match="positions fall"):
        compare([run(), written], aligning=Aligning("none"))


def test_time_and_speed_alone(file: Path) -> None:
    written = test_run(file)
    lines = [line.split(",") for line in written.read_text("utf-8").splitlines()]
    bare = "\n".join(",".join([row[0], *row[2:]]) for row in lines) + "\n"
    written.write_text(bare, "utf-8")
    found = compare([run(), written])
    assert alignment(found).offset_m == pytest.approx(100.0, abs=PLACE_M)
    assert any("no positions in the file" in text for text in found.warnings)


def test_another_speed_is_told(file: Path) -> None:
    found = compare([run(), test_run(file, speed=24.0)])
    assert any("measured at 86.4 km/h, +20.0 % from 72.0 km/h" in text for text in found.warnings)
    assert alignment(found).offset_m == pytest.approx(0.0, abs=0.1)


def test_samples_that_were_left_out_do_not_count(file: Path) -> None:
    def spoilt(x: np.ndarray) -> np.ndarray:
        return np.where((x > 320.0) & (x < 323.0), 900.0, along(x))

    clean = compare([run(), test_run(file)])
    found = compare([run(), test_run(file, spoilt, kept=lambda x: (x <= 220.0) | (x > 226.0))])
    for name in ("0–20 Hz", "5–20 Hz"):
        own, other = (band(one, name).deviations_N[1] for one in (clean, found))
        # 17 m of 200 m are missing, of a force that is no wave there: σ changes by some per cent.
        assert other == pytest.approx(own, rel=0.06)
    highest = next(one for one in found.indicators if one.key == "max_force_N")
    assert highest.values[1] < 160.0
    assert any("is left out" in text for text in found.warnings)
    (curve,) = [one for one in found.figures["force"][0].layers
                if isinstance(one, Curve) and one.name == "test run (measured)"]  # fmt: skip
    # The gap, and 0.2 s at both of its ends, where the filter makes numbers up.
    inner = curve.y[(curve.x > 216.5) & (curve.x < 229.5)]
    assert np.isnan(inner).all()
    assert np.nanmax(curve.y) < 160.0
    bars = [one for one in found.figures["by_span"][0].layers
            if isinstance(one, Bars) and one.name == "test run (measured)"]  # fmt: skip
    assert bars[0].high.size == 2  # of four spans, those without a gap


def test_spectra_of_a_record_with_gaps_have_the_windows_of_both(file: Path) -> None:
    # Pieces of 45 m, of which 1.85 s count: windows of 4 s have no place.
    found = compare([run(), test_run(file, kept=lambda x: x % 50.0 > 5.0)])
    whole = compare([run(), test_run(file.with_name("whole.csv"))])
    for label in ("2 Hz", "7.94 Hz"):
        octave = band(found, label, "third octave")
        if octave.deviations_N[0] is None:
            # Windows of 1.85 s resolve 0.54 Hz, more than the third octave about 2 Hz is wide.
            assert (label, octave.deviations_N) == ("2 Hz", (None, None))
            assert band(whole, label, "third octave").deviations_N[0] is not None
        else:
            # A wave of 6 N alone in its octave, over whole and broken periods.
            assert octave.deviations_N[1] == pytest.approx(octave.deviations_N[0], rel=0.05)
    assert band(found, "7.94 Hz", "third octave").deviations_N[0] is not None
    for figure in found.figures["spectrum"]:
        curves = [one for one in figure.layers if isinstance(one, Curve)]
        steps = {round(float(one.x[1] - one.x[0]), 2) for one in curves}
        assert len(steps) == 1


def test_odometer_that_jumps_back(file: Path) -> None:
    written = test_run(file)
    rows = written.read_text("utf-8").splitlines()
    for number in range(2000, len(rows)):
        cells = rows[number].split(",")
        cells[1] = repr(float(cells[1]) - 9.0)
        rows[number] = ",".join(cells)
    written.write_text("\n".join(rows) + "\n", "utf-8")
    with pytest.raises(ComparisonError, match="odometer jumps back"):
        compare([run(), written])


def test_what_cannot_be_laid_over_a_run(file: Path) -> None:
    with pytest.raises(ComparisonError, match="constant"):
        compare([run(), read(test_run(file, lambda x: np.full_like(x, 90.0) + 1e-9 * (x % 7)))])
    with pytest.raises(ComparisonError, match="too short"):
        compare([run(), test_run(file, end_m=109.0)])
    # Shorter than the filter needs at its ends.
    with pytest.raises((ComparisonError, MeasurementError)):
        compare([run(), test_run(file, end_m=105.0)])
    with pytest.raises(ComparisonError, match="does not overlap"):
        compare([run(), test_run(file)], aligning=Aligning(offset_m=2000.0))
    with pytest.raises(ComparisonError, match="does not reach"):
        compare([run(), test_run(file, end_m=180.0)])


def test_what_no_alignment_is() -> None:
    for asked, word in (
        ({"method": "eye"}, "one of correlation"), ({"channel": "sway"}, "one of force"),
        ({"search_m": 0.0}, "above 0 m"),
        ({"scale": 0.0}, "above 0"), ({"scale_within": 1.0}, "below 1"),
    ):  # fmt: skip
        with pytest.raises(ComparisonError, match=word):
            Aligning(**asked)


def test_tolerances_are_from_memory_and_decide_nothing(file: Path) -> None:
    found = compare([run(), test_run(file, lambda x: 100.0 + 1.3 * (along(x) - 100.0))])
    rows = {one.key: one for one in found.acceptance}
    sigma = rows["std_force_N"]
    assert sigma.percent == pytest.approx(100.0 * (1.0 / 1.3 - 1.0), abs=0.3)
    assert (sigma.within, sigma.tolerance, sigma.mark) == (False, "± 20 %", "C")
    assert "not read" in (sigma.source or "")
    assert rows["contact_point_range_mm"].within
    assert rows["mean_force_N"].tolerance is None
    assert rows["mean_force_N"].within is None
    assert rows["max_uplift_at_support_mm"].measured is None
    assert rows["max_uplift_at_support_mm"].within is None
    assert all((one.tolerance is None) == (one.mark is None) for one in found.acceptance)


def test_a_tolerance_has_an_end() -> None:
    assert Tolerance(20.0, relative=True).allows(120.0, 100.0)
    assert not Tolerance(20.0, relative=True).allows(120.1, 100.0)
    assert Tolerance(20.0, relative=False).allows(30.0, 50.0)
    assert not Tolerance(20.0, relative=False).allows(29.9, 50.0)


def test_two_pantographs_have_their_own_offsets(file: Path, tmp_path: Path) -> None:
    model = {"name": "drawn", "masses": [{"mass": 8, "stiffness": 50, "damping": 1}]}
    pair = run(pantographs=("P1", "P2"), duration_s=35.0, scenario={"pantographs": [
        {"static_force": 60.0, "model": model, "distance": distance} for distance in (0.0, 100.0)
    ]})  # fmt: skip
    # Both meet the same force at the same time: P2 has that of 100 m further on.
    one = read(test_run(file, offset_m=2.0)).pantographs[0]
    path = test_run(tmp_path / "both.csv", offset_m=2.0)
    rows = path.read_text("utf-8").replace("contact_force", "P1.contact_force").splitlines()
    table = [rows[0] + ",P2.contact_force [N]"]
    table += [
        f"{row},{value!r}" for row, value in zip(rows[1:], map(float, one.force), strict=True)
    ]
    path.write_text("\n".join(table) + "\n", "utf-8")
    found = compare([pair, path])
    placed = found.sides[1].placed
    assert placed is not None
    offsets = [by.offset_m for by in placed.alignments]
    assert offsets[0] == pytest.approx(-2.0, abs=PLACE_M)
    # One odometer for both: what P1 meets at x, P2 meets when it shows x + 98 − 100 m.
    assert len({one.pantograph for one in found.bands}) == 2
    assert len(found.figures["force"]) == 2


def test_plain_values_are_json_and_the_page_stands(file: Path, tmp_path: Path) -> None:
    found = compare([run(), test_run(file, noise_N=2.0)])
    data = json.loads(json.dumps(found.to_dict(), allow_nan=False))
    assert data["format"] == "arcless-comparison/1"
    assert [one["kind"] for one in data["runs"]] == ["run", "measurement"]
    assert data["runs"][0]["alignments"] is None
    assert data["runs"][1]["alignments"][0]["method"] == "correlation"
    assert data["bands"]
    assert data["acceptance"]
    for figures in found.figures.values():
        for one in figures:
            assert one.alt
    for key in ("force", "folded", "by_span", "spectrum", "histogram", "octaves", "height"):
        names = {layer.name for layer in found.figures[key][0].layers}
        assert {"synthetic", "test run (measured)"} <= names, key
    found.write_report(tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text("utf-8")
    for words in ("Simulation against line test", "mark C", "third octave about 7.94 Hz",
                  "Comparison of a run and a measurement of synthetic"):  # fmt: skip
        assert words in text, words


def test_the_placing_names_its_run_and_says_in_words_how_sure_it_is(file: Path) -> None:
    found = compare([test_run(file, offset_m=3.0), run()], names=["line test", "simulated"])
    assert found.names == ("line test", "simulated")
    assert found.placed_on == "simulated"
    assert comparison_content(found, found.figures)["placed_on"] == "simulated"
    by = Alignment("correlation", 0.0, False, 1.0, 1.0, 0.512)
    *_, alike, following = cells.alignment(by)
    assert (alike, following) == ("0.512, poor", "no other place in the search")
    # What was not searched for has no correlation to judge.
    assert cells.alignment(Alignment("given", 0.0, False, 1.0, 1.0))[3:] == ("–", "–")


def test_runs_without_a_measurement_are_placed_on_nothing() -> None:
    assert compare([run(), run(lambda x: along(x, PERIODIC))]).placed_on is None
