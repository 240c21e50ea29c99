"""A steady arm that holds the wire like a mast is told."""

from typing import Any

import pytest

from arcless.model import line_warnings, load_line


@pytest.mark.parametrize(("stiffness", "told"), [("3 kN/m", False), ("10 MN/m", True)])
def test_an_arm_as_stiff_as_a_mast_is_told(stiffness: str, told: bool) -> None:
    data: dict[str, Any] = load_line("ac-simple-55").to_dict()
    data["steady_arm"]["vertical_stiffness"] = stiffness
    found = [text for text in line_warnings(load_line(data)) if "steady_arm" in text]
    assert [text.partition(":")[0] for text in found] == (
        ["line.steady_arm.vertical_stiffness"] if told else []
    )
