"""The shipped models: they load, and every number in them says where it comes from."""

import math
from collections.abc import Iterator
from typing import Any

import pytest

from arcless.model import library, load, load_any, load_line, load_pantograph, scenario_warnings
from arcless.model.fields.document import dotted, unwrap
from arcless.model.files.yaml_reader import parse, read_text
from arcless.model.shipped.library import FOLDER, shipped

# Studies say what is varied, not what things are: tests/unit/study/definition/test_shipped.py.
FILES = sorted(set(FOLDER.glob("*/*.yaml")) - set(shipped("study").values()))
REQUIRED_SCENARIOS = {
    "en50318-ac-simple-275-planar",
    "en50318-ac-simple-320-planar",
    "en50318-2002-250",
    "en50318-2002-300",
    "praks-180",
    "praks-250",
    "praks-340",
    "praks-360",
}
# Lines with damping from where they were published.
KNOWN = ("ac-simple", "en50318", "praks", "conductor-rail")
# The published method damps: that is a property to be told, not a mistake in the file.
# The worked example of the paper has no damping in its wires.
UNDAMPED = "line: no wire has damping"
WARNED = {
    "praks-180": [
        UNDAMPED,
        "solver.scheme: backward differences with a step of 5 ms damp 20 Hz by 28.4%",
    ],
    "praks-250": [
        UNDAMPED,
        "solver.scheme: backward differences with a step of 3.6 ms damp 20 Hz by 21.4%",
    ],
    "praks-340": [
        UNDAMPED,
        "solver.scheme: backward differences with a step of 2.65 ms damp 20 Hz by 16.1%",
    ],
    "praks-360": [
        "speed: 360 km/h is 74% of the wave speed 487 km/h; EN 50119 allows 70%",
        UNDAMPED,
        "solver.scheme: backward differences with a step of 2.5 ms damp 20 Hz by 15.3%",
    ],
}


def numbers(value: Any, path: tuple[str | int, ...] = ()) -> Iterator[str]:
    """Yield the path of every number, also of those written with a unit."""
    if isinstance(value, dict):
        for key, item in value.items():
            yield from numbers(item, (*path, key))
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from numbers(item, (*path, index))
    elif isinstance(value, (int, float)) or (
        isinstance(value, str) and value[:1].lstrip("+-").isdigit()
    ):
        yield dotted(path)


def test_no_file_is_left_out_of_these_tests() -> None:
    assert len(FILES) == sum(entry.kind not in ("wire", "study") for entry in library())
    assert len(shipped("line")) >= 14 and len(shipped("pantograph")) >= 10
    assert {entry.name for entry in library() if entry.kind == "scenario"} >= REQUIRED_SCENARIOS


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_loads_and_every_number_has_a_mark(path: Any) -> None:
    model = load_any(path)
    assert model.name == path.stem
    assert model.description
    data, _ = parse(read_text(path, path.name), path.name)
    plain = unwrap({k: v for k, v in data.items() if k != "sources"}, (), lambda entry: None)
    texts = {"format", "name", "description", "line"}
    for field in numbers({key: item for key, item in plain.items() if key not in texts}):
        origin = model.origin_of(field)
        assert origin is not None, f"{field} has no provenance"
        assert origin.mark is not None, f"{field} has no mark"
        if origin.mark in {"A", "B", "D"}:
            assert origin.source, f"{field} has mark {origin.mark} but no source"
        if origin.mark == "assumed":
            assert origin.note, f"{field} is assumed without a reason"


@pytest.mark.parametrize("name", shipped("line"))
def test_a_line_fits_on_a_page(name: str) -> None:
    # Sixty lines, the wires of the catalogue not counted.
    assert len(shipped("line")[name].read_text("utf-8").splitlines()) < 60


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_every_source_is_used(path: Any) -> None:
    model = load_any(path)
    used = {
        key.strip()
        for entry in model.provenance.values()
        for key in (entry.source or "").split(",")
    }
    assert set(model.sources) <= used


@pytest.mark.parametrize("name", shipped("scenario"))
def test_shipped_scenarios_give_no_warning_but_what_the_published_method_deserves(
    name: str,
) -> None:
    warnings = scenario_warnings(load(name))
    for warning, start in zip(warnings, WARNED.get(name, []), strict=True):
        assert warning.startswith(start)


def test_ac_simple_numbers() -> None:
    scenario = load("en50318-ac-simple-320-planar")
    line = scenario.line
    # Wave speed of 460 km/h: reference arithmetic, given to the whole km/h.
    assert line.wave_speed * 3.6 == pytest.approx(460, abs=0.5)
    assert line.total_length == 20 * 55
    assert not line.is_spatial
    assert load_line("ac-simple-55-3d").is_spatial
    assert scenario.speed is not None
    kmh = scenario.speed * 3.6
    # Given to 0.1 N.
    assert scenario.pantographs[0].mean_force == pytest.approx(0.00097 * kmh**2 + 70, abs=0.05)
    assert scenario.analysis_range() == (275, 825)


def test_steady_arms_of_the_spatial_line_lift_their_share_of_the_wire() -> None:
    line = load_line("ac-simple-55-3d")
    assert line.steady_arm.kind == "arm"
    wire, stagger = line.contact_wire, line.geometry.stagger_contact_wire
    radial = 2 * wire.tension * abs(stagger[0] - stagger[1]) / 55
    lift = radial * math.tan(line.steady_arm.slope)
    weight = wire.mass * 9.81 * 4.5
    # The wire hangs on the arm between the two nearest droppers, half of it each way: the arm must
    # lift (positive slope), and about as much as half of those 9 m weigh.
    assert lift == pytest.approx(weight, rel=0.1)


def test_pre_sag_of_spain_is_the_published_share_of_the_span() -> None:
    span = load_line("spain-ca-220-25kv").span_types["standard"]
    deepest = max(span.droppers.presag or ())
    # 0.4 per mille of 60 m, at mid-span between the two middle droppers: 2 % below the middle.
    assert deepest == pytest.approx(0.4e-3 * 60, rel=0.03)


@pytest.mark.parametrize(
    ("name", "head_first"),
    [
        ("en50318-2002", [7.2, 15.0]),
        ("ac-simple", [7.5, 9.0, 6.0]),
        ("dsa-380", [7.12, 6.0, 5.8]),
        ("praks", [16.0, 45.0]),
    ],
)
def test_masses_stand_from_base_to_head(name: str, head_first: list[float]) -> None:
    assert [mass.mass for mass in reversed(load_pantograph(name).masses)] == head_first


@pytest.mark.parametrize("name", [name for name in shipped("line") if not name.startswith(KNOWN)])
def test_real_lines_have_the_least_damping_that_was_measured(name: str) -> None:
    line = load_line(name)
    for field in ("contact_wire", "messenger_wire", "auxiliary_wire", "stitch_wire", "bridle"):
        wire = getattr(line, field)
        if wire is not None:
            omega = 2.0 * math.pi * 1.4  # of the measurement, rad/s
            share = wire.damping.alpha / (2.0 * omega) + wire.damping.beta * omega / 2.0
            # α is given to two digits.
            assert share == pytest.approx(0.01, rel=0.02)
            assert line.provenance[f"{field}.damping"].mark == "assumed"
