"""A small line, pantograph and scenario as plain data, and a way to write them into files."""

from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load_any

LINE = """\
format: arcless-line/1
name: small
contact_wire:
  mass: 1.35 kg/m
  axial_stiffness: 15 MN
  bending_stiffness: 195 N m²
  tension: 22 kN
messenger_wire:
  mass: 1.08 kg/m
  axial_stiffness: 11.6 MN
  bending_stiffness: 131.7 N m²
  tension: 16 kN
dropper:
  stiffness: 200 kN/m
support:
  vertical_stiffness: 500 kN/m
steady_arm:
  kind: spring
  vertical_stiffness: 267 N/m
geometry:
  contact_wire_height: 5.3 m
  encumbrance: 1.2 m
span_types:
  standard:
    length: 55 m
    droppers:
      positions: [10, 20, 35, 45]
spans:
  - {type: standard, count: 8}
"""

SCENARIO = """\
format: arcless-scenario/1
name: small
line: line.yaml
pantographs:
  - model: dsa-380
speed: 200 km/h
"""


@pytest.fixture
def files(tmp_path: Path) -> Path:
    (tmp_path / "line.yaml").write_text(LINE, encoding="utf-8")
    (tmp_path / "scenario.yaml").write_text(SCENARIO, encoding="utf-8")
    return tmp_path


@pytest.fixture
def refused(files: Path) -> Callable[..., str]:
    """Replace a text in one of the files, load that file, and return the message."""

    def check(old: str, new: str, name: str = "line.yaml") -> str:
        path = files / name
        text = path.read_text(encoding="utf-8")
        assert text.count(old) >= 1
        path.write_text(text.replace(old, new, 1), encoding="utf-8")
        with pytest.raises(ModelError) as caught:
            load_any(path)
        assert caught.value.exit_code == 2
        return str(caught.value).replace(f"{files}/", "")

    return check


@pytest.fixture
def data() -> dict[str, Any]:
    """A whole scenario as plain data, free to be changed."""
    return deepcopy(DATA)


DATA: dict[str, Any] = {
    "name": "small",
    "line": "ac-simple-55",
    "pantographs": [{"model": "dsa-380"}],
    "speed": "200 km/h",
}
