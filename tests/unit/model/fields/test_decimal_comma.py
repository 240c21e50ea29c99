"""A decimal comma is refused wherever it stands, and the message says so."""

from collections.abc import Callable

import pytest

from tests.unit.model.conftest import LINE

WIRE = LINE[LINE.index("contact_wire:") : LINE.index("messenger_wire:")]
NAMED = "contact_wire: {catalogue: Cu AC-100, tension: 10.5 kN}\n"
HINT = "hint: write the decimal point as a point"


@pytest.mark.parametrize(
    ("wire", "messages"),
    [
        (
            "{catalogue: Cu AC-100, tension: 10,5 kN}",
            ['got "5 kN", expected a field of contact_wire', f"{HINT}: tension: 10.5 kN"],
        ),
        ("{tension: 10,5 kN, catalogue: Cu AC-100}", [f"{HINT}: tension: 10.5 kN"]),
        ("{catalogue: Cu AC-100, tension: 10,5}", [f"{HINT}: tension: 10.5"]),
        ("{catalogue: Cu AC-100, tension: '10,5 kN'}", ['got "10,5 kN"', HINT]),
        (
            "{catalogue: Cu AC-100, tension: {value: 10,5 kN, mark: A}}",
            ["unknown field next to a value", f"{HINT}: value: 10.5 kN"],
        ),
        ("{mass: 1,35 kg/m, tension: 10 kN}", [f"{HINT}: mass: 1.35 kg/m"]),
        ("{catalogue: Cu AC-100, tension: 10 kN, bogus: null}", ['got "bogus"']),
        ("{catalogue: Cu AC-100, tension: 10 kN, 5 kN}", ['got "5 kN"']),
    ],
)
def test_in_braces(refused: Callable[..., str], wire: str, messages: list[str]) -> None:
    message = refused(WIRE, f"contact_wire: {wire}\n")
    assert "line.yaml:3: contact_wire." in message
    for part in messages:
        assert part in message


def test_in_a_list_of_positions(refused: Callable[..., str]) -> None:
    message = refused(
        "positions: [10, 20, 35, 45]",
        "positions: [5, 17,5, 30, 42,5, 55]\n      presag: [0, 1 mm, 2 mm, 1 mm, 0]",
    )
    assert "positions.2: droppers out of order: got 5 m after 17 m" in message
    assert f"{HINT}: 17.5" in message


def test_a_field_of_the_catalogue_may_be_left_to_it(refused: Callable[..., str]) -> None:
    wire = "contact_wire: {catalogue: Cu AC-100, mass: null, tension: 10 kN, bogus: 1}\n"
    assert 'got "bogus"' in refused(WIRE, wire)
