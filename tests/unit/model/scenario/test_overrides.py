"""Changes by dotted path, as of `--set` and `Scenario.with_`."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load, load_line, parse_override

SCENARIO = load("en50318-ac-simple-320-planar")


@pytest.mark.parametrize(
    ("text", "path", "value"),
    [
        ("line.contact_wire.tension=24 kN", "line.contact_wire.tension", "24 kN"),
        ("speed = 300 km/h", "speed", "300 km/h"),
        ("solver.time_step=2e-3", "solver.time_step", 2e-3),
        ("solver.time_step=one element", "solver.time_step", "one element"),
        ('solver.time_step="one element"', "solver.time_step", "one element"),
        ("output.line_every=10", "output.line_every", 10),
        ("output.droppers=false", "output.droppers", False),
        ("travel.end=null", "travel.end", None),
        ("analysis.spans=[5, 8]", "analysis.spans", [5, 8]),
        ("output.points=[10 m, 20.5]", "output.points", ["10 m", 20.5]),
        ("solver.scheme={name: hht, alpha: -0.1}", "solver.scheme", {"name": "hht", "alpha": -0.1}),
        ('name="a=b"', "name", "a=b"),
        ("name=a: b # c", "name", "a: b # c"),
    ],
)
def test_parse_override(text: str, path: str, value: object) -> None:
    assert parse_override(text) == (path, value)


@pytest.mark.parametrize("text", ["speed", "=3", "speed=", "", "a=[1", "a={b: 1"])
def test_parse_override_refuses(text: str) -> None:
    with pytest.raises(ModelError):
        parse_override(text)


def test_a_changed_copy() -> None:
    changed = SCENARIO.with_(speed="300 km/h", **{"line.contact_wire.tension": "24 kN"})
    assert changed.speed == 300 / 3.6
    assert changed.line.contact_wire.tension == 24000
    assert SCENARIO.line.contact_wire.tension == 22000
    assert changed.line.messenger_wire == SCENARIO.line.messenger_wire


def test_what_is_given_stays_as_it_is() -> None:
    travel = {"start": "60 m", "end": "500 m"}
    changed = SCENARIO.with_(**{"travel": travel, "travel.end": "400 m"})
    assert changed.travel_range() == (60.0, 400.0)
    assert travel == {"start": "60 m", "end": "500 m"}


def test_no_change_is_equality() -> None:
    assert SCENARIO.with_() == SCENARIO


@pytest.mark.parametrize(
    "path", ["pantographs.0.model.masses.2.mass", "pantographs.0.masses.2.mass"]
)
def test_list_items_and_the_short_way_into_a_pantograph(path: str) -> None:
    assert SCENARIO.with_(**{path: "8 kg"}).pantographs[0].model.masses[2].mass == 8


def test_line_and_pantograph_by_name() -> None:
    changed = SCENARIO.with_(line="ac-simple-55-3d", **{"pantographs.0.model": "dsa-380"})
    assert changed.line == load_line("ac-simple-55-3d")
    assert changed.pantographs[0].model.name == "dsa-380"


def test_another_line_and_a_change_inside_it() -> None:
    changes = {"line": "ac-simple-55-3d", "line.contact_wire.tension": "24 kN"}
    changed = SCENARIO.with_(**changes)
    assert changed.line.name == "ac-simple-55-3d"
    assert changed.line.contact_wire.tension == 24000


def test_a_scheme_by_name() -> None:
    assert SCENARIO.with_(**{"solver.scheme": "trapezoidal"}).solver.scheme.name == "trapezoidal"


@pytest.mark.parametrize(
    ("changes", "gone"),
    [
        ({"pantographs.0.static_force": "90 N"}, "pantographs.0.mean_force"),
        ({"speed_profile": {"time": [0, 5], "speed": [10, 90]}}, "speed"),
        ({"analysis.from": "300 m", "analysis.to": "500 m"}, "analysis.spans"),
        (
            {"line.span_types.standard.droppers.lengths": [1.0] * 9},
            "line.span_types.standard.droppers.presag",
        ),
    ],
)
def test_what_excludes_another_replaces_it(changes: dict[str, Any], gone: str) -> None:
    value: Any = SCENARIO.with_(**changes).to_dict()
    for part in gone.split("."):
        value = value[int(part)] if part.isdigit() else value[part]
    assert value is None


def test_both_of_two_exclusive_fields_are_refused() -> None:
    with pytest.raises(ModelError, match="both static_force and mean_force given"):
        SCENARIO.with_(**{"pantographs.0.static_force": "90 N", "pantographs.0.mean_force": "90 N"})


def test_provenance_stays_with_what_was_not_touched() -> None:
    changed = SCENARIO.with_(**{"line.contact_wire.tension": "24 kN"})
    assert changed.line.provenance["contact_wire.mass"].source == "S1, S2"
    tension = changed.line.provenance["contact_wire.tension"]
    assert (tension.mark, tension.note, tension.given) == (None, "set for this run", "24 kN")
    assert changed.provenance == SCENARIO.provenance


def test_a_change_inside_a_group_overrides_the_mark_of_the_group() -> None:
    changed = SCENARIO.with_(**{"line.contact_wire.damping.alpha": 0.02})
    alpha = changed.line.origin_of("contact_wire.damping.alpha")
    beta = changed.line.origin_of("contact_wire.damping.beta")
    assert alpha is not None and alpha.mark is None
    assert beta is not None and beta.mark == "C"


def test_a_change_may_bring_its_provenance() -> None:
    value = {"value": "24 kN", "mark": "assumed", "note": "what if"}
    changed = SCENARIO.with_(**{"line.contact_wire.tension": value})
    assert changed.line.provenance["contact_wire.tension"].note == "what if"
    assert changed.line.provenance["contact_wire.tension"].given == "24 kN"


@pytest.mark.parametrize(
    "changes",
    [
        {"speed": "300 km/h"},
        {"pantographs.0.masses.1.mass": 7.5, "analysis.low_pass": "10 Hz"},
        {"line.contact_wire.tension": "24 kN", "pantographs.0.static_force": "150 N"},
        {"as_built.missing_droppers": ["span 3 dropper 2"], "name": "broken"},
    ],
)
def test_what_no_change_reaches_is_taken_over(changes: dict[str, Any]) -> None:
    changed = SCENARIO.with_(**changes)
    # As a scenario is that is read again as a whole.
    assert changed.to_dict() == type(SCENARIO).model_validate(changed.to_dict()).to_dict()
    for group in ("line", "as_built", "solver", "analysis", "pantographs"):
        is_reached = any(path.startswith(group) for path in changes)
        assert (getattr(changed, group) is getattr(SCENARIO, group)) != is_reached or (
            group == "pantographs"  # a tuple of the same placements
            and not is_reached
            and changed.pantographs[0] is SCENARIO.pantographs[0]
        )


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        ("line.contact_wir.tension", 1, "hint: did you mean contact_wire?"),
        ("sped", 1, "hint: did you mean speed?"),
        ("", 1, "unknown field"),
        ("pantographs.1.mean_force", 1, "expected a number from 0 to 0"),
        ("pantographs.first.mean_force", 1, "expected a number from 0 to 0"),
        ("speed_profile.time", [0, 1], "set speed_profile as a whole"),
        ("speed.value", 1, "not a group of fields"),
        ("line.contact_wire.tension", "24 kg", "kg is the unit of a mass"),
        ("line.contact_wire.tension", float("nan"), "finite"),
        ("line", "ac-simple-56", "did you mean ac-simple-55?"),
        ("line", 7, "the name of a shipped line"),
        ("line.steady_arm.length", 1, "known: kind, vertical_stiffness"),
        ("solver.scheme", "hth", "did you mean hht?"),
    ],
)
def test_refused(path: str, value: object, message: str) -> None:
    with pytest.raises(ModelError) as caught:
        SCENARIO.with_(**{path: value})
    assert message in str(caught.value)
    assert path.split(".", maxsplit=1)[0] in str(caught.value)
