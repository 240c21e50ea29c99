"""Curves in a line file: what they are, what is refused, and what deserves a word."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.errors import ModelError
from arcless.model import load, load_line, scenario_warnings
from arcless.model.files.yaml_reader import parse
from arcless.model.line.parts.track import Curve, Track

Data = dict[str, Any]
CURVE: Data = {
    "from": 100, "to": 300, "radius": 800, "side": "left", "transition": 40, "cant": "120 mm",
}  # fmt: skip


def bent(data: Data, *curves: Data, stagger: list[float] | None = None) -> Data:
    line = load_line(data["line"]).to_dict()
    line["track"] = {"curves": list(curves)}
    line["geometry"]["stagger_contact_wire"] = stagger or [0.0]
    return {**data, "line": line}


def refusal(data: Data) -> str:
    with pytest.raises(ModelError) as caught:
        load(data)
    return str(caught.value)


def track(**changes: Any) -> Track:
    return Track.model_validate({"curves": [{**CURVE, **changes}]})


def test_the_track_turns_by_the_integral_of_its_curvature() -> None:
    curve = Curve.model_validate(CURVE)
    x = np.linspace(80, 320, 24_001)
    ramp = np.interp(x, [100, 140, 260, 300], [0, 1, 1, 0])
    steps = np.concatenate([[0], np.cumsum((ramp[1:] + ramp[:-1]) / 2 * np.diff(x) / 800)])
    # The trapezoidal rule is exact for straight pieces; corners of the ramp are among the points.
    np.testing.assert_allclose([curve.turned(v) for v in x], steps, rtol=0, atol=1e-12)
    sharp = Curve.model_validate({**CURVE, "transition": 0, "cant": 0})
    assert sharp.turned(200) == pytest.approx(100 / 800, rel=1e-12)


def test_cant_swings_the_axis_towards_the_inside() -> None:
    """δ = h c / e = 5.3 · 0.12 / 1.5 = 0.424 m, on a transition of 40 m."""
    height = 5.3
    with_cant, without = track(), track(cant=0)
    x = np.linspace(100, 140, 400, endpoint=False) + 0.05
    swing = [with_cant.direction(v, height) - without.direction(v, height) for v in x]
    # A mean of 400 equal numbers: round-off.
    assert np.mean(swing) * 40 == pytest.approx(0.424, rel=1e-12)
    assert with_cant.direction(200, height) == without.direction(200, height)
    right = track(side="right")
    assert [right.direction(v, height) for v in x] == [-with_cant.direction(v, height) for v in x]


def test_curves_add_up_along_the_track() -> None:
    """A reverse curve: 60 m less ramps of 20 m at 400 m to the left, then as much to the right."""
    one = {"from": 0, "to": 60, "radius": 400, "side": "left", "transition": 20}
    both = Track.model_validate({"curves": [one, {**one, "from": 60, "to": 140, "side": "right"}]})
    assert both.direction(-5, 5.3) == 0.0
    # Exact integrals of straight pieces: round-off.
    assert both.direction(60, 5.3) == pytest.approx(40 / 400, rel=1e-12)
    assert both.direction(500, 5.3) == pytest.approx(40 / 400 - 60 / 400, rel=1e-12)
    assert both.bends(130, 200) and not both.bends(140, 200)
    assert Track.model_validate(both.model_dump(by_alias=True)) == both


def test_a_span_lies_aside_as_its_track_turns() -> None:
    circle = Track.model_validate(
        {"curves": [{"from": 0, "to": 500, "radius": 500, "side": "left"}]}
    )
    offsets = circle.offsets(100, 150, 5.3)
    # L²/8R in the middle, to the inside; the midpoint rule is exact for a straight θ.
    assert offsets[32] == pytest.approx(50**2 / (8 * 500), rel=1e-12)
    assert abs(offsets[0]) + abs(offsets[-1]) < 1e-12
    # A canted ramp alone, the axis kinks by κ in the middle of a span: a triangle κL/4, to the
    # outside: the wire goes straight on while the axis swings in.
    kink = Track.model_validate({"curves": [{**CURVE, "radius": 1e6}]})
    slope = 5.3 * 0.12 / 1.5 / 40
    # The radius itself adds less than L²/8R = 0.3 mm.
    assert kink.offsets(75, 125, 5.3)[32] == pytest.approx(slope * 50 / 4, abs=3e-4)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"to": 100}, "curves.0.to: empty curve: got 100 m to 100 m"),
        ({"transition": 101}, "curves.0.transition: transitions longer than the curve: got two of"),
        ({"transition": 0}, "curves.0.transition: cant without transition: got 0.12 m"),
        (
            {"radius": 0},
            "curves.0.radius: got 0, expected a length (m, mm, cm, km, in, ft, yd, chain, mi), at"
            " least 20 m",
        ),
        ({"radius": "800 kg"}, "kg is the unit of a mass"),
        ({"side": "inside"}, "curves.0.side"),
        ({"cant": "120 m"}, "curves.0.cant: got"),
    ],
)
def test_curves_that_cannot_be_are_refused(data: Data, changes: Data, message: str) -> None:
    assert message in refusal(bent(data, {**CURVE, **changes}))


def test_curves_stand_one_behind_the_other(data: Data) -> None:
    message = refusal(bent(data, CURVE, {**CURVE, "from": 290, "to": 500}))
    assert "curves.1.from: curves overlap or are out of order: got a start at 290 m" in message


def test_a_curve_too_tight_for_the_stagger_names_place_and_numbers(data: Data) -> None:
    """L²/8R with 55 m and 350 m is 1.08 m."""
    tight = {"from": 0, "to": 5000, "radius": 350, "side": "right"}
    message = refusal(bent(data, tight))
    assert "a curve tighter than the stagger allows: got the contact wire 1.08 m aside" in message
    assert "in span 1, 1.08 m of it by the curve" in message
    scenario = load(bent(data, tight, stagger=[0.4]))
    words = [text for text in scenario_warnings(scenario) if "track.curves" in text]
    assert words == [
        "line.track.curves: the contact wire at rest lies 0.68 m aside at 27.5 m, in span 1;"
        " the head of pantograph P1 allows 0.55 m"
    ]
    wide = load(bent(data, {**tight, "radius": 1500}))
    assert not [text for text in scenario_warnings(wide) if "track" in text]


def test_a_curve_needs_arms(data: Data, refused: Callable[..., str]) -> None:
    line = bent(data, CURVE)["line"] | {"steady_arm": {"kind": "none"}}
    assert "nothing holds the contact wire in a curve" in refusal({**data, "line": line})


def test_a_line_in_a_curve_is_spatial(data: Data) -> None:
    assert load(bent(data, CURVE)).line.is_spatial
    assert not load(data).line.is_spatial


def test_the_example_of_the_guide_loads() -> None:
    page = (Path(__file__).parents[4] / "docs/guide/track.md").read_text("utf-8")
    text = re.findall(r"```yaml\n(geometry:.*?)```", page, re.DOTALL)[0]
    given, _ = parse(text, "track.md")
    changes = {f"line.geometry.{name}": value for name, value in given["geometry"].items()}
    base = load("en50318-ac-simple-275").with_(speed="160 km/h")
    scenario = base.with_(**changes, **{"line.track": given["track"]})
    assert len(scenario.line.geometry.stagger_contact_wire) == len(scenario.line.span_list()) + 1
    assert not [t for t in scenario_warnings(scenario) if "geometry" in t or "track" in t]
