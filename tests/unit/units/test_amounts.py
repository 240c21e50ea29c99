"""Numbers with units: what is understood, and how the rest is refused."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from arcless.errors import ModelError
from arcless.units import KINDS, accepted, show, spell, to_si

finite = st.floats(allow_nan=False, allow_infinity=False, min_value=-1e12, max_value=1e12)


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("22 kN", "N", 22000),
        ("22kN", "N", 22000),
        ("-1.5e3 N", "N", -1500),
        ("1.35 kg/m", "kg/m", 1.35),
        ("55 mm", "m", 0.055),
        ("165 g", "kg", 0.165),
        ("50 kN/m", "N/m", 50e3),
        ("100 N s/m", "N s/m", 100),
        ("100 Ns/m", "N s/m", 100),
        ("100 N·s/m", "N s/m", 100),
        ("100 N*s/m", "N s/m", 100),
        ("195 N m2", "N m2", 195),
        ("195 N m²", "N m2", 195),
        ("195 N·m²", "N m2", 195),
        ("195 N m^2", "N m2", 195),
        ("300 km/h", "m/s", 300 / 3.6),
        ("2 ms", "s", 0.002),
        ("10 deg", "rad", math.radians(10)),
        ("-10°", "rad", math.radians(-10)),
        ("20 Hz", "Hz", 20),
        ("9.81 m/s²", "m/s2", 9.81),
        ("0.0125 1/s", "1/s", 0.0125),
        ("1.7e-5 1/K", "1/K", 1.7e-5),
        ("0.5 N/(m/s)^2", "N/(m/s)2", 0.5),
        ("0.00095 N/(km/h)^2", "N/(m/s)2", 0.00095 * 3.6**2),
        ("0.00095 N/(km/h)²", "N/(m/s)2", 0.00095 * 3.6**2),
        ("0.3", "1", 0.3),
        (".5 m", "m", 0.5),
        ("125 mph", "m/s", 55.88),
        ("1500 kgf", "N", 14709.975),
        ("1.5 tf", "N", 14709.975),
        ("1500 kp", "N", 14709.975),
        ("1000 daN", "N", 1e4),
        ("2000 lbf", "N", 8896.443230521),
        ("5 kgf/mm", "N/m", 49033.25),
        ("1 kN/mm", "N/m", 1e6),
        ("100 lbf/in", "N/m", 17512.683524647638),
        ("4 ft", "m", 1.2192),
        ("6 inch", "m", 0.1524),
        ("40 chain", "m", 804.672),
        ("2 mile", "m", 3218.688),
        ("8 lbs", "kg", 3.62873896),
        ("25 ‰", "1", 0.025),
        ("7 %", "1", 0.07),
        ("17e-6/K", "1/K", 17e-6),
        ("9e-6 1/°F", "1/K", 16.2e-6),
        ("30 kgf/mm²", "Pa", 294199500),
        (22000, "N", 22000),
    ],
)
def test_understood(text: object, unit: str, value: float) -> None:
    # Correctly rounded once; the expected value itself may be one rounding away.
    assert to_si(text, unit) == pytest.approx(value, rel=1e-15, abs=0)


@pytest.mark.parametrize(
    ("text", "unit", "hint"),
    [
        ("22 kg", "N", "kg is the unit of a mass: did you mean kgf?"),
        ("2000 lbs", "N", "lbs is the unit of a mass: did you mean lbf?"),
        ("2 t", "N", "t is the unit of a mass: did you mean tf?"),
        ("12 kgf", "kg", "kgf is the unit of a force: did you mean kg?"),
        ("1.1 kgf/m", "kg/m", "kgf/m is the unit of a stiffness: did you mean kg/m?"),
        ("5 kg/mm", "N/m", "did you mean kgf/mm?"),
        ("100 lb/in", "N/m", "did you mean lbf/in?"),
        ("2 tons", "kg", "write t, tf, kg or lb"),
        ("20 °C", "K", "a difference is in K"),
        ("4 ft 8.5 in", "m", "one number with one unit"),
        ("5' 6\"", "m", "one number with one unit"),
        ("3 1/2 in", "m", "one number with one unit"),
        ("60 MPH", "m/s", "did you mean mph?"),
        ("22 kn", "N", "did you mean kN?"),
        ("22 furlong", "m", 'unknown unit "furlong"'),
        ("22,000 N", "N", "22000"),
        ("22 000 N", "N", "22000"),
        ("22'000 N", "N", "22000"),
        ("22_000 N", "N", "22000"),
        ("22,5 kN", "N", "decimal point"),
        ("nan", "N", "finite"),
        (".inf N", "N", "finite"),
        ("-infinity", "N", "finite"),
        ("kN", "N", "write a number"),
        ("", "N", "write a number"),
        ("5 m s", "s", "did you mean ms?"),
        ("0x10", "N", "unknown unit"),
        ("5 s", "1", "s is the unit of a time"),
    ],
)
def test_refused_with_the_units_that_would_do(text: str, unit: str, hint: str) -> None:
    with pytest.raises(ModelError) as caught:
        to_si(text, unit)
    assert hint in str(caught.value)
    assert caught.value.expected == accepted(unit)
    assert caught.value.got == f'"{text}"'


@pytest.mark.parametrize(
    "value", [True, None, [1], {}, 1j, b"1", math.nan, math.inf, 10**400, "1e999"]
)
def test_refused_values(value: object) -> None:
    with pytest.raises(ModelError):
        to_si(value, "N")


@given(value=finite)
def test_a_number_is_si(value: float) -> None:
    for unit in KINDS:
        assert to_si(value, unit) == value


@given(value=finite, data=st.data())
def test_every_unit_of_every_kind(value: float, data: st.DataObject) -> None:
    unit = data.draw(st.sampled_from(sorted(KINDS)))
    name = data.draw(st.sampled_from(sorted(KINDS[unit].units)))
    factor = float(KINDS[unit].units[name])
    for spelled in (name, spell(name)):
        # Two roundings of the expected value against one of ours.
        assert to_si(f"{value!r} {spelled}", unit) == pytest.approx(value * factor, rel=1e-15)


@given(text=st.text(max_size=30), unit=st.sampled_from(sorted(KINDS)))
def test_any_text_gives_a_finite_number_or_a_model_error(text: str, unit: str) -> None:
    try:
        assert math.isfinite(to_si(text, unit))
    except ModelError as error:
        assert error.expected is not None


def test_a_long_value_is_cut_and_made_printable() -> None:
    assert len(show("x" * 10_000)) < 100
    assert show("a\x1b[2Jb") == '"a?[2Jb"'
