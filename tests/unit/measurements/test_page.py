"""Page and figures of a measured run: gaps stay open, what is left out is listed."""

from pathlib import Path

import numpy as np
import pytest

from arcless.assess.signals.filter import spectrum, spectrum_of
from arcless.figures.description import Curve, Strip
from arcless.figures.description.thinning import envelope
from arcless.figures.measured import Kept, MeasuredData, figures
from arcless.measurements import Measurement, assess, read, write_report
from arcless.measurements.samples.settled import bands, counted
from tests.support.measured import RATE, SPEED, force, record, times, wave, write

GAP = (210.0, 280.0)  # m


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "run.csv"


def measured(file: Path, columns: dict[str, np.ndarray] | None = None) -> Measurement:
    rows = np.r_[0:1501, 2000:5000]
    columns = record(contact_height=5.3 + wave(1.3, 0.02)(times())) if columns is None else columns
    return read(write(file, {name: values[rows] for name, values in columns.items()}))


def data_of(measurement: Measurement) -> MeasuredData:
    found = assess(measurement)
    kept = [Kept(one, bands(one), counted(one, found.section_m)) for one in measurement.pantographs]
    return MeasuredData(kept, found)


def in_gap(x: np.ndarray) -> np.ndarray:
    return (x > GAP[0] + 1e-9) & (x < GAP[1] - 1e-9)


def test_no_curve_reaches_over_a_gap(file: Path) -> None:
    drawn = figures(data_of(measured(file)))
    for key in ("force", "height", "lead"):
        (figure,) = drawn[key]
        curves = [layer for layer in figure.layers if isinstance(layer, Curve)]
        for curve in curves if key != "lead" else []:
            x, y = np.asarray(curve.x), np.asarray(curve.y)
            assert not np.isfinite(y[in_gap(x)]).any()
            # From one side of the gap to the other there is a point without a number.
            left, right = np.flatnonzero(x <= GAP[0])[-1], np.flatnonzero(x >= GAP[1])[0]
            assert np.isnan(y[left : right + 1]).any(), (key, curve.name)
        assert "nan" not in figure.alt


def test_thinned_curves_stay_open_in_short_gaps(file: Path) -> None:
    # At 4 kHz one sample of 12 is drawn, and one sample of 20 000 is missing.
    time = times(5.0, 4000.0)
    rows = np.delete(np.arange(time.size), 10_003)
    columns = {"time [s]": time[rows], "contact_force [N]": force(time)[rows]}
    data = data_of(read(write(file, columns), speed="252 km/h"))
    assert data.sampled is not None
    assert data.sampled[0].rows.size < 2500
    (figure,) = figures(data)["force"]
    for curve in [layer for layer in figure.layers if isinstance(layer, Curve)]:
        missing = np.flatnonzero(np.isnan(np.asarray(curve.y)))
        assert missing.size == 1, curve.name
        neighbours = np.asarray(curve.x)[missing[0] - 1 : missing[0] + 2]
        assert neighbours == pytest.approx(SPEED * 10_003 / 4000.0, abs=0.25)


def test_left_out_stretches_are_shaded(file: Path) -> None:
    (figure,) = figures(data_of(measured(file)))["force"]
    strips = [one for one in figure.layers if isinstance(one, Strip) and one.colour == "open"]
    edge = 0.2 * SPEED
    # Within a step of 0.14 m, at which samples are.
    ends = [(0.0, edge), (GAP[0] - edge, GAP[1] + edge), (700.0 - edge, 700.0)]
    assert len(strips) == 3
    for strip, (low, high) in zip(strips, ends, strict=True):
        assert (strip.low, strip.high) == pytest.approx((low, high), abs=0.3)
    assert [one.name for one in strips] == ["left out", "", ""]


def test_several_pantographs_and_falling_positions(file: Path) -> None:
    columns = {"time [s]": times(), "P1.position [m]": 900.0 - SPEED * times(),
               "P1.contact_force [N]": force(times()), "P2.position [m]": 850.0 - SPEED * times(),
               "P2.contact_force [N]": force(times()) + 40.0}  # fmt: skip
    columns["P2.contact_force [N]"][100:150] = np.nan
    data = data_of(measured(file, columns))
    assert data.pantographs == ["P1", "P2"]
    drawn = figures(data)
    assert "height" not in drawn
    # Where both ran: 200 to 899.9 m, and 150 to 849.9 m.
    assert data.assessment.section_m == pytest.approx([200.14, 850.0], abs=1e-9)
    assert not any("of the section only" in note for note in data.assessment.notes)
    # The empty cells of P2, at times of 0.2 to 0.3 s, are shaded in its own figure.
    shaded = [[(one.low, one.high) for one in figure.layers if isinstance(one, Strip)]
              for figure in drawn["force"]]  # fmt: skip
    assert len(shaded[0]) == len(shaded[1])
    assert shaded[0] != shaded[1]
    low, high = drawn["force"][1].x.low, drawn["force"][1].x.high
    assert low < 151.0
    assert high > 899.0
    (first, second) = data.assessment.pantographs
    tops = [float(data.record.bands.total[data.record.inside[:, i], i].max()) for i in (0, 1)]
    assert tops == [first.max_force_N, second.max_force_N]
    assert np.all(np.diff(data.position, axis=0) >= 0.0)


def test_the_page_says_what_it_is_about(file: Path) -> None:
    measurement = measured(file)
    write_report(measurement, assess(measurement, supply="AC 25 kV"), file.with_suffix(".html"))
    page = file.with_suffix(".html").read_text("utf-8")
    for text in ("<title>run – Arcless</title>", "A measured run.", "run.csv", "252 km/h",
                 "Left out of the time in the section:", "samples are missing", ">1502<", ">499<",
                 "pieces without a gap", "standard deviation σ"):  # fmt: skip
        assert text in page, text
    for text in ("Model data", "Computation", "certainty of the numbers", "maximum gap", "nan N"):
        assert text not in page, text


def test_a_page_takes_names_as_text(tmp_path: Path) -> None:
    file = tmp_path / "<arc7>&run.csv"
    columns = {"time [s]": times(), "<arc8>x.contact_force [N]": force(times()),
               "speed [m/s]": np.full(5000, SPEED)}  # fmt: skip
    measurement = measured(file, columns)
    write_report(measurement, assess(measurement), tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text("utf-8")
    assert "<arc7>" not in page
    assert "<arc8>" not in page
    assert "&lt;arc7&gt;&amp;run" in page


def test_peaks_survive_next_to_a_gap() -> None:
    values = np.sin(np.arange(10_000) * 0.01)
    values[5000], values[5003] = np.nan, 7.0
    kept = envelope(values, 200)
    assert {5000, 5003} <= set(kept.tolist())
    assert kept.size < 220


def test_a_spectrum_of_pieces_is_that_of_each() -> None:
    signal = force(times(30.0))
    frequency, density = spectrum(signal, RATE)
    pieces = [signal[:6000], signal[6000:6500], signal[7000:]]
    found_frequency, found = spectrum_of(pieces, RATE)
    assert np.array_equal(found_frequency, frequency)
    # Waves that are whole in no window: mean over other windows than those of the whole.
    peaks = [int(np.argmin(np.abs(frequency - f))) for f in (1.3, 7.1, 40.3)]
    assert found[peaks] == pytest.approx(density[peaks], rel=0.1)
    assert np.array_equal(spectrum_of([signal], RATE)[1], density)
    # All pieces shorter than a window of 4 s: one of the longest.
    short, _ = spectrum_of([signal[:500], signal[600:800]], RATE)
    assert short[1] == pytest.approx(1.0, rel=1e-12)
