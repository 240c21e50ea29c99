"""Wires by name: what they give a line, and what is said when the name is wrong."""

from math import pi
from pathlib import Path

import pytest

from arcless.errors import ModelError
from arcless.model import Line, load, load_line
from arcless.model.shipped.library import shipped
from arcless.model.shipped.wire_catalogue import GIVES, catalogue, entry_text
from tests.support.line_types import stitched_data

NAMED = {"catalogue": "CuAg AC-120", "tension": "15 kN"}


def line_of(**wire: object) -> Line:
    return load_line({**stitched_data(), "contact_wire": wire})


def test_a_name_gives_the_values_with_their_marks_and_sources() -> None:
    line, entry = line_of(**NAMED), catalogue().wires["CuAg AC-120"]
    assert all(getattr(line.contact_wire, key) == getattr(entry, key) for key in GIVES)
    origin = line.origin_of("contact_wire.mass")
    assert origin is not None
    # 10.7 N/m over 9.81 m/s²; the keys are kept apart from those of the line itself.
    assert (origin.mark, origin.source, origin.given) == ("D", "wires S12, wires S22", "1.091 kg/m")
    assert "Bane NOR" in line.sources["wires S12"]


def test_a_value_beside_the_name_is_kept() -> None:
    wire = line_of(**NAMED, mass={"value": "1.2 kg/m", "mark": "assumed", "note": "with ice"})
    assert wire.contact_wire.mass == 1.2
    assert wire.origin_of("contact_wire.mass").note == "with ice"  # type: ignore[union-attr]
    assert wire.contact_wire.axial_stiffness == 14.4e6


def test_a_line_with_named_wires_round_trips() -> None:
    line = load_line("norway-s25")
    assert load_line(line.to_dict()) == line


def test_another_name_for_one_run_takes_the_values_along() -> None:
    changed = load("norway-s25-250").with_(**{"line.contact_wire.catalogue": "CTMH-150"})
    wire, entry = changed.line.contact_wire, catalogue().wires["CTMH-150"]
    assert (wire.mass, wire.axial_stiffness) == (entry.mass, entry.axial_stiffness) == (1.35, 18e6)
    assert wire.diameter is None  # that of the other wire is not kept
    assert changed.line.origin_of("contact_wire.mass").source == "wires S8"  # type: ignore[union-attr]
    heavier = changed.with_(**{"line.contact_wire.mass": 1.5})
    assert heavier.line.contact_wire.mass == 1.5


def test_an_unknown_wire_is_named_with_its_place_and_the_nearest(tmp_path: Path) -> None:
    text = shipped("line")["norway-s25"].read_text("utf-8")
    file = tmp_path / "mine.yaml"
    file.write_text(text.replace("value: BzII 70", "value: BzII 7O"), "utf-8")
    with pytest.raises(ModelError) as caught:
        load_line(file)
    message = str(caught.value)
    number = 1 + text[: text.index("BzII 70")].count("\n")
    assert message.startswith(f"{file}:{number}: messenger_wire.catalogue: unknown wire")
    assert 'got "BzII 7O"' in message and "did you mean BzII 70?" in message


def test_every_wire_of_the_catalogue_is_a_contact_wire_or_a_strand() -> None:
    words = [wire.description.lower() for wire in catalogue().wires.values()]
    assert all(("contact wire" in text) != ("strand" in text) for text in words)


@pytest.mark.parametrize(
    ("field", "name", "told"),
    [
        # Nearest of all names are the contact wires CTMH-120 and Cu AC-100.
        ("messenger_wire", "CTMH-12O", "did you mean JTMH-120?"),
        ("messenger_wire", "CuAC-100", "known: BzII 50, BzII 70"),
        ("stitch_wire", "bronze", "known: BzII 50, BzII 70"),
        ("contact_wire", "TMH-120", "did you mean CTMH-120?"),
        ("contact_wire", "Ri 100", "known: Cu AC-100, CuAg AC-120"),
    ],
)
def test_the_hint_names_wires_of_the_kind(field: str, name: str, told: str) -> None:
    data = stitched_data()
    data[field] = {"catalogue": name, "tension": "15 kN"}
    with pytest.raises(ModelError, match=f"{field}.catalogue: unknown wire") as caught:
        load_line(data)
    assert told in str(caught.value)


@pytest.mark.parametrize("name", [12, ["CuAg AC-120"]])
def test_a_name_that_is_no_text_is_refused(name: object) -> None:
    with pytest.raises(ModelError, match=r"contact_wire"):
        line_of(catalogue=name, tension="15 kN", mass=1, axial_stiffness=1e7, bending_stiffness=100)


def test_without_name_and_values_the_first_missing_value_is_named() -> None:
    with pytest.raises(ModelError, match=r"contact_wire.mass: missing field"):
        line_of(tension="15 kN")


@pytest.mark.parametrize("name", catalogue().wires)
def test_a_catalogue_wire_is_a_metal_bar_or_a_strand(name: str) -> None:
    wire, book = catalogue().wires[name], catalogue()
    light = name.startswith("AlSt")  # aluminium on steel, 95 of 150 mm² of 2700 and 7800 kg/m³
    density = (95 * 2700 + 55 * 7800) / 150 if light else 8900
    # E/ρ = EA/m: copper and its alloys 100 to 130 GPa over 8900 kg/m³, steel strand 160 over 7850,
    # straight aluminium and steel 70 over 2700 and 200 over 7800; 5 % for lay and tolerance.
    stiffest = 70e9 / 2700 if light else 160e9 / 7850
    assert 0.95 * 100e9 / 8900 < wire.axial_stiffness / wire.mass < 1.05 * stiffest
    # A solid round bar is the stiffest: EI = E A²/4π = (EA)²/(4π E), least for the stiffest metal.
    assert wire.bending_stiffness < 1.05 * wire.axial_stiffness**2 / (4 * pi * 100e9)
    if wire.diameter is not None:
        # Round wires fill their circle, strands three quarters of it; grooves take 5 to 15 %.
        area = pi * wire.diameter**2 / 4
        assert 0.70 < wire.mass / density / area < 1.06
    for key in GIVES:
        origin = book.origin_of(f"wires.{name}.{key}")
        assert getattr(wire, key) is None or (origin is not None and origin.mark)
        if origin is not None and origin.mark in {"A", "B", "D"}:
            assert origin.source
        if origin is not None and origin.mark == "assumed":
            assert origin.note


def test_every_source_of_the_catalogue_is_used() -> None:
    book = catalogue()
    assert set(book.sources) == {k for o in book.provenance.values() for k in o.source_keys}


def test_an_entry_is_shown_as_it_stands() -> None:
    import yaml

    for name, wire in catalogue().wires.items():
        text = entry_text(name)
        assert text is not None
        (shown,) = yaml.safe_load(text).items()
        assert shown[0] == name
        assert shown[1]["description"] == wire.description
        assert set(shown[1]) <= {"description", *GIVES}
    hc = entry_text("HC150")
    assert hc is not None and "catalogue: HC150" in hc and "# S13: " in hc
    assert entry_text("HC") is None
