"""Findings of the search in the loader, each written down."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load_line

NAMED = {"catalogue": "BzII 120", "tension": "20 kN"}


def line(**fields: Any) -> dict[str, Any]:
    return load_line("ac-simple-55").to_dict() | fields


@pytest.mark.parametrize("field", ["provenance", "sources"])
@pytest.mark.parametrize("value", [5, 0.5, "text", "", [], ["a"], False])
@pytest.mark.parametrize("by_name", [True, False])
def test_provenance_that_is_no_mapping(field: str, value: Any, by_name: bool) -> None:
    """A value was unpacked to take in the provenance of other values."""
    wire = load_line("ac-simple-55").to_dict()["contact_wire"]
    wire = NAMED if by_name else wire | {"mass": {"value": "1.3 kg/m", "note": "x"}}
    with pytest.raises(ModelError, match=rf"{field}: got .*, expected a mapping"):
        load_line(line(contact_wire=wire, **{field: value}))


@pytest.mark.parametrize(
    ("name", "part"), [("trolley-bridles", "bridle"), ("germany-re-200", "stitch_wire")]
)
@pytest.mark.parametrize("length", [5e-324, 1e-12, 1e-3])
def test_clamps_at_one_place(name: str, part: str, length: float) -> None:
    """Clamps nearer than points are told apart were one point, and the mesh a Python error."""
    data = load_line(name).to_dict()
    data[part]["length"] = length
    with pytest.raises(ModelError, match=r"length.*expected.* 0\.1 m"):
        load_line(data)
