"""Comparisons of results that were written down, not computed: every number is known."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.comparison import compare
from arcless.comparison.cells import difference, signed
from arcless.comparison.fields import changed_fields
from arcless.comparison.indicators import indicators
from arcless.comparison.page import html
from arcless.comparison.paper import document
from arcless.comparison.subjects.runs import Slot
from arcless.errors import ComparisonError
from arcless.figures.description import Bars, Curve, Figure
from arcless.model import load
from arcless.results import Result
from tests.support.beside import test_run as measured_run
from tests.support.synthetic import scenario_data, synthetic_dataset

# The mean of whole waves, filtered: what is left is rounding of 1e5 samples and the filter's edges.
CLOSE = 1e-3


def wave(mean: float, amplitude: float, hertz: float = 1.0) -> Any:
    """Return a force in N: a sine about a mean; in 10 s of section there are whole waves."""
    return lambda t: mean + amplitude * np.sin(2.0 * np.pi * hertz * t)


def made(mean: float = 100.0, amplitude: float = 10.0, hertz: float = 1.0, **more: Any) -> Result:
    """Return a result with a known force, of a scenario with changes."""
    changes = more.pop("scenario", {})
    data = scenario_data(**changes)
    dataset = synthetic_dataset(force=wave(mean, amplitude, hertz), scenario=data, **more)
    return Result(dataset, load(data))


def of(comparison: arcless.Comparison, key: str) -> Any:
    return next(one for one in comparison.indicators if one.key == key)


def test_differences_are_those_of_the_signals() -> None:
    found = compare([made(100.0, 10.0), made(110.0, 15.0), made(90.0, 5.0)])
    mean, sigma = of(found, "mean_force_N"), of(found, "std_force_N")
    assert mean.values == pytest.approx((100.0, 110.0, 90.0), rel=CLOSE)
    assert mean.differences == pytest.approx((0.0, 10.0, -10.0), abs=100 * CLOSE)
    assert mean.percents == pytest.approx((0.0, 10.0, -10.0), abs=100 * CLOSE)
    # σ of a sine is its amplitude over √2; the low-pass takes 1e-6 of a wave of 1 Hz.
    assert sigma.differences == pytest.approx((0.0, 5.0 / 2**0.5, -5.0 / 2**0.5), abs=0.01)
    assert of(found, "NQ_percent").percents == (None, None, None)
    assert (mean.label, mean.unit) == ("mean contact force F_m", "N")


def test_fields_that_differ_are_named_with_their_units() -> None:
    found = compare([
        made(), made(scenario={"line__contact_wire__tension": "11 kN", "speed": "80 km/h"})
    ])  # fmt: skip
    fields = {one.path: one for one in found.fields}
    assert set(fields) == {"speed", "line.contact_wire.tension"}
    assert fields["line.contact_wire.tension"].values[1] == "11\u202f000 N"


def test_values_are_shown_as_typed() -> None:
    one = load(scenario_data()).with_(speed="72 km/h")
    other = one.with_(speed="80 km/h")
    (field,) = changed_fields([one, other])
    assert (field.path, field.values) == ("speed", ("72 km/h", "80 km/h"))


def test_equal_content_under_other_names_and_units_is_equal() -> None:
    one = load(scenario_data())
    same = one.with_(speed="72 km/h")  # 20 m/s
    renamed = load(scenario_data(
        name="other", description="other", line__name="another line", line__sources={"S1": "x"},
    ))  # fmt: skip
    assert changed_fields([one, same, renamed]) == []


def test_a_pantographs_own_field_has_its_path() -> None:
    one, other = load(scenario_data()), scenario_data()
    other["pantographs"][0]["model"]["masses"][0]["mass"] = 9.0
    (field,) = changed_fields([one, load(other)])
    assert field.path == "pantographs.0.model.masses.0.mass"
    assert field.values == ("8 kg", "9 kg")


def test_runs_may_stand_one_by_one() -> None:
    one, other = made(100.0), made(110.0)
    assert compare(one, other).to_dict() == compare([one, other]).to_dict()


def test_runs_are_called_by_the_one_field_that_differs() -> None:
    found = compare([made(), made(scenario={"line__contact_wire__tension": "11 kN"})])
    assert found.names == ("tension 10 kN", "tension 11\u202f000 N")
    assert compare([made(), made()]).names == ("1: synthetic", "2: synthetic")
    two = {"name": "second", "speed": 21.0, "line__contact_wire__tension": "11 kN"}
    assert compare([made(), made(scenario=two)]).names == ("synthetic", "second")


def test_files_are_called_by_their_folders(tmp_path: Path) -> None:
    for name in ("before", "after"):
        (tmp_path / name).mkdir()
        made().save(tmp_path / name / "result.nc")
    found = arcless.compare([tmp_path / "before", str(tmp_path / "after" / "result.nc")])
    assert found.names == ("before", "after")
    assert found.to_dict()["runs"][1]["file"] == str(tmp_path / "after" / "result.nc")


def test_long_names_are_whole_once_and_short_in_heads(tmp_path: Path) -> None:
    import hashlib

    names = [f"norway-s25-250-speed=200_km-h,line.contact_wire.tension={t}_kN" for t in (15, 16)]
    folders = [tmp_path / name for name in names]
    for place, folder in enumerate(folders):
        folder.mkdir()
        made(100.0 + place).save(folder / "result.nc")
    found = arcless.compare(folders)
    assert found.names == ("run 1", "run 2")
    assert found.full_names == tuple(names)
    page, cover = html(found, found.figures), document(found, found.figures).identity
    for place, (folder, data) in enumerate(zip(folders, found.to_dict()["runs"], strict=True)):
        digest = hashlib.sha256((folder / "result.nc").read_bytes()).hexdigest()[:12]
        assert (data["name"], data["full_name"]) == (f"run {place + 1}", names[place])
        assert (data["file"], data["digest"]) == (str(folder / "result.nc"), digest)
        assert cover[place] == (f"Run {place + 1}", f"{folder / 'result.nc'}; SHA-256 {digest}")
        assert page.replace("<wbr>", "").count(f">{folder / 'result.nc'}<") == 1
        assert page.count(digest) == 1


def test_a_measurement_has_the_name_of_its_file_beside_runs_that_are_numbered(
    tmp_path: Path,
) -> None:
    run = made(scenario={"name": "a scenario with a name that no column has room for"})
    found = compare([run, measured_run(tmp_path / "site 2024-05-12 northbound.csv")])
    assert found.names == ("run 1", "site 2024-05-12 northbound (measured)")
    long = "site 2024-05-12 northbound with the second instrument, run 3"
    assert compare([run, measured_run(tmp_path / f"{long}.csv")]).names == ("run 1", "measured 2")


def test_a_long_name_that_no_file_says_is_told() -> None:
    long = "a scenario with a name that no column has room for"
    two = {"speed": 21.0, "line__contact_wire__tension": "11 kN"}
    found = compare([made(scenario={"name": long}), made(scenario={"name": "short", **two})])
    assert found.names == ("run 1", "run 2")
    assert [one["digest"] for one in found.to_dict()["runs"]] == [None, None]
    assert long in html(found, found.figures)
    assert document(found, found.figures).identity[0] == ("Run 1", f"{long}; in memory, no file")


def test_pantographs_match_by_name_then_by_order() -> None:
    two = made(pantographs=("P2", "P1"))
    found = compare([made(), two])
    assert [(one.name, one.places) for one in found.pantographs] == [
        ("P1", (0, 1)), ("P2", (None, 0)),
    ]  # fmt: skip
    assert found.by_name
    assert any("numbers of pantographs" in text for text in found.warnings)
    other = compare([made(), made(pantographs=("front", "rear"))])
    assert [one.name for one in other.pantographs] == ["P1 / front", "rear"]
    assert other.to_dict()["matched_by"] == "order"
    assert any("matched by order (P1 / front, rear)" in text for text in other.warnings)
    rear = [one for one in other.indicators if one.pantograph == "rear"]
    assert all(one.values[0] is None and one.differences == (None, None) for one in rear)


@pytest.mark.parametrize(
    ("other", "word"),
    [
        ({"section": (250.0, 450.0)}, "sections differ"),
        ({"scenario": {"analysis__low_pass": 15.0}}, "filters differ"),
        ({"attrs": {"arcless_version": "0.0.1"}}, "versions"),
        ({"scenario": {"solver__dimension": "spatial"}}, "spatial"),
        ({"scenario": {"line__design__supply": "DC 3 kV"}}, "supplies"),
        ({"attrs": {"time_step_s": 5e-4}}, "time steps"),
    ],
)
def test_what_makes_runs_less_comparable_is_said(other: dict[str, Any], word: str) -> None:
    assert not compare([made(), made()]).warnings
    (text,) = compare([made(), made(**other)]).warnings
    assert word in text


def test_verdicts_stand_side_by_side() -> None:
    found = compare([made(90.0, 5.0), made(90.0, 60.0)])
    sigma = next(one for one in found.criteria if one.name == "standard_deviation")
    assert sigma.verdicts[0] == "met"
    assert sigma.verdicts[1] is not None
    assert sigma.verdicts[1].startswith("not met")


def layers_of(figure: Figure, kind: type, name: str) -> list[Any]:
    return [one for one in figure.layers if isinstance(one, kind) and one.name == name]


def test_overlays_show_each_run_in_its_colour() -> None:
    # 0.4 waves a second at 20 m/s are 50 m long, as the spans are; 0.8 are 25 m.
    found = compare([made(100.0, 10.0, 0.4), made(100.0, 20.0, 0.8)])
    first, second = found.names
    (force,) = found.figures["force"]
    for name, colour in ((first, "series_1"), (second, "series_2")):
        (curve,) = layers_of(force, Curve, name)
        assert curve.colour == colour
    (folded,) = found.figures["folded"]
    (curve,) = layers_of(folded, Curve, first)
    # The span begins where the sine does: the mean of equal spans is the wave itself.
    exact = 100.0 + 10.0 * np.sin(2.0 * np.pi * curve.x / 50.0)
    np.testing.assert_allclose(curve.y, exact, atol=0.05)  # samples 20 mm apart
    (bars,) = layers_of(found.figures["by_span"][0], Bars, second)
    np.testing.assert_allclose(bars.high, 20.0 / 2**0.5, rtol=CLOSE)
    (waves,) = found.figures["wavelengths"]
    assert "so that spans and droppers appear at their lengths" in waves.caption
    for name, length in ((first, 50.0), (second, 25.0)):
        (curve,) = layers_of(waves, Curve, name)
        # Windows of 4 s resolve 0.25 Hz: lengths of 80, 40, 26.7 and 20 m.
        assert abs(20.0 / curve.x[curve.y.argmax()] - 20.0 / length) <= 0.2
    assert all(one.alt for figures in found.figures.values() for one in figures)


def test_power_by_wavelength_is_that_by_frequency() -> None:
    found = compare([made(100.0, 10.0, 1.0), made(100.0, 20.0, 1.0)])
    (by_frequency,), (by_length,) = found.figures["spectrum"], found.figures["wavelengths"]
    for name in found.names:
        (one,), (other,) = (layers_of(f, Curve, name) for f in (by_frequency, by_length))
        number = 1.0 / other.x[::-1]
        power = np.trapezoid(other.y[::-1], number)
        assert power == pytest.approx(np.trapezoid(one.y, one.x), rel=1e-9)  # rounding


def test_runs_without_droppers_are_named() -> None:
    bare = made(without=("dropper_x", "dropper_force_min", "dropper_force_max"))
    (figure,) = compare([made(), bare]).figures["droppers"]
    assert "Without droppers: 2: synthetic" in figure.caption


def test_other_supports_are_said() -> None:
    (figure,) = compare([made(), made(duration_s=35.0)]).figures["uplift"]
    assert "differ in length and supports" in figure.caption


def test_plain_values_are_json() -> None:
    data = compare([made(), made(110.0)]).to_dict()
    assert json.loads(json.dumps(data, allow_nan=False))["format"] == "arcless-comparison/1"


def test_page_has_names_as_text(tmp_path: Path) -> None:
    bad = "<img src=x onerror=hacked()>"
    found = compare([made(), made(scenario={"name": bad, "speed": 21.0, "line__name": bad})])
    found.write_report(tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text("utf-8")
    assert bad not in text
    assert "&lt;img src=x" in text


def test_a_run_is_compared_with_others() -> None:
    run = made()
    for runs, word in (([], "at least two"), ([run], "at least two"), ([run, run], "twice")):
        with pytest.raises(ComparisonError, match=word):
            compare(runs)
    with pytest.raises(ComparisonError, match="at least two"):
        compare("runs/one")


def test_a_run_that_stopped_early_is_refused() -> None:
    state = {"position_m": 100.0, "step": 5, "time_s": 5.0}
    stopped = made(attrs={"state": state})
    with pytest.raises(ComparisonError, match="resume"):
        compare([made(), stopped])


def test_more_runs_than_colours_have_tables_only() -> None:
    found = compare([made() for _ in range(7)])
    assert len(of(found, "std_force_N").values) == 7
    with pytest.raises(ComparisonError, match="at most 6"):
        _ = found.figures


@pytest.mark.parametrize(
    ("value", "text"), [(0.04, "0.0"), (-0.04, "0.0"), (1.25, "+1.2"), (-3.0, "−3.0"), (None, "–")]
)
def test_differences_have_their_sign(value: float | None, text: str) -> None:
    assert signed(value, 1) == text


def sure(result: Result, spread: float | None, discretisation: float | None) -> Any:
    """Return the assessment with a certainty of its mean force, as `--certainty` adds it."""
    assessed = result.assessment
    known = {"mean_force_N": {"spread": spread, "discretisation": discretisation}}
    return replace(
        assessed, pantographs=[replace(one, certainty=known) for one in assessed.pantographs]
    )


@pytest.mark.parametrize(
    ("shift", "text"),
    [
        # u = √(3² + 4²) + 1 + 0.5 = 6.5.
        (6.0, "+6.0 ± 6.5 (too close to tell)"),
        (7.0, "+7.0 ± 6.5 (+7.0\u00a0%)"),
        (-7.0, "−7.0 ± 6.5 (−7.0\u00a0%)"),
    ],
)
def test_a_difference_within_its_uncertainty_is_too_close_to_tell(shift: float, text: str) -> None:
    first, other = sure(made(100.0), 3.0, 1.0), sure(made(100.0 + shift), 4.0, 0.5)
    found = indicators([first, other], [Slot("P1", (0, 0))])
    mean = next(one for one in found if one.key == "mean_force_N")
    assert mean.difference_uncertainties == (None, pytest.approx(6.5))
    assert difference(mean, 1) == text


def test_equal_numbers_without_uncertainty_are_equal() -> None:
    first, other = sure(made(), 0.0, 0.0), sure(made(), 0.0, 0.0)
    mean = indicators([first, other], [Slot("P1", (0, 0))])[0]
    assert not mean.too_close_to_tell(1)
    assert difference(mean, 1) == "0.0 (0.0\u00a0%)"


def test_without_the_certainty_of_both_runs_a_difference_has_none() -> None:
    first, other = sure(made(100.0), 3.0, 1.0), made(101.0).assessment
    mean = indicators([first, other], [Slot("P1", (0, 0))])[0]
    assert mean.key == "mean_force_N"
    assert mean.difference_uncertainties == (None, None)
    assert difference(mean, 1) == "+1.0 (+1.0\u00a0%)"
