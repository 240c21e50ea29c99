"""Values that are from memory are named before a report is signed."""

import pytest

from arcless.model import load
from arcless.model.advice.unverified import unverified_data


@pytest.mark.parametrize("name", ["faiveley-cx", "sss-400"])
def test_a_pantograph_from_memory_is_named(name: str) -> None:
    own = load("norway-s25-250").with_(**{"pantographs.0.model": name})
    (text,) = unverified_data(own)
    marks = own.pantographs[0].model.provenance
    count = sum(one.mark == "C" for path, one in marks.items() if path != "head_width")
    assert count >= 8
    told = f"pantograph {name}: {count} values are from memory, unverified (mark C)"
    assert text.startswith(told)
    assert "masses.0.mass" in text
    assert text.endswith(f" and {count - 4} more")


def test_read_data_are_not_named() -> None:
    # Of memory are efficiencies of tensioning devices and the width of the head alone.
    own = load("norway-s25-250")
    assert own.line.provenance["contact_wire.end_efficiency"].mark == "C"
    assert unverified_data(own) == []


def test_a_line_is_named_with_its_fields() -> None:
    (text,) = unverified_data(load("germany-re-200-200"))
    assert text.startswith("line germany-re-200: ")
    assert "contact_wire.tension" in text
    assert "end_efficiency" not in text


def test_one_value() -> None:
    data = load("norway-s25-250").to_dict()
    data["line"]["provenance"]["contact_wire.tension"]["mark"] = "C*"
    assert unverified_data(load(data)) == [
        "line norway-s25: 1 value is from memory, unverified (mark C*): contact_wire.tension"
    ]
