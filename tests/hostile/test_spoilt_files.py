"""Spoilt files give a model error that says in which file, and mostly in which line; or a model."""

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from arcless.errors import ModelError
from arcless.model import load, load_any
from arcless.model.shipped.library import FOLDER
from tests.support.hostile import searching, spoilt_text

FILES = sorted(FOLDER.glob("*/*.yaml"))
# What is wrong with a file as a whole, or missing in it, has no line.
WHOLE = (
    *("no such file", "empty file", "not a text file", "not valid YAML", "cannot be read"),
    *("missing field", "format: "),
)

TABLES = {
    "errors.csv": "span, dropper, length_error mm\n3, 1, 5\n4, 2, -7.5\n",
    "heights.csv": "position m, height m\n0, 5.3\n55, 5.31\n",
    "gusts.csv": "time s, speed m/s\n0, 5\n100, 7\n",
    "roof.csv": "position [m], displacement [mm]\n-100, 0\n200, 3\n5000, 0\n",
    "spring.csv": "elongation mm, force N\n-10, -100\n0, 0\n10, 100\n",
}
SCENARIO = """\
format: arcless-scenario/1
name: with tables
line: ac-simple-55-3d
pantographs:
  - model: pantograph.yaml
    roof_motion: {file: roof.csv}
speed: 50
as_built:
  dropper_length_errors: errors.csv
"""
PANTOGRAPH = """\
format: arcless-pantograph/1
name: with a table
static_force: 80 N
masses:
  - {mass: 10 kg, stiffness: 0, damping: 50 N s/m}
  - {mass: 8 kg, damping: 50 N s/m, stiffness_table: {file: spring.csv}}
"""


def check(path: Path) -> None:
    """Load a file that may be spoilt."""
    try:
        model = load_any(path)
    except ModelError as error:
        assert error.exit_code == 2
        message = str(error)
        assert message.isprintable() or "\n" in message
        place = message.partition(": ")[0]
        assert str(path.parent) in place or "unknown " in message, message
        if not any(words in message for words in WHOLE):
            assert ":" in place.removeprefix(str(path.parent)), message
    else:
        assert load_any(json.loads(json.dumps(model.to_dict(), allow_nan=False))) == model


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with tables and with what refers to them."""
    found = tmp_path_factory.mktemp("spoilt")
    for name, text in TABLES.items():
        (found / name).write_text(text, encoding="utf-8")
    (found / "scenario.yaml").write_text(SCENARIO, encoding="utf-8")
    (found / "pantograph.yaml").write_text(PANTOGRAPH, encoding="utf-8")
    return found


@searching(150)
@given(data=st.data())
def test_spoilt_model_files(data: Any, folder: Path) -> None:
    text = data.draw(st.sampled_from(FILES)).read_bytes()
    path = folder / "spoilt.yaml"
    path.write_bytes(data.draw(spoilt_text(text)))
    check(path)


def test_the_tables_are_sound(folder: Path) -> None:
    scenario = load(folder / "scenario.yaml")
    assert len(scenario.as_built.dropper_length_errors) == 2
    assert scenario.pantographs[0].roof_motion is not None
    assert scenario.pantographs[0].model.masses[1].stiffness_table is not None


@searching(60)
@given(data=st.data())
def test_spoilt_tables(data: Any, folder: Path) -> None:
    again = folder / "again"
    shutil.copytree(folder, again, dirs_exist_ok=True, ignore=shutil.ignore_patterns("again"))
    name = data.draw(st.sampled_from(["errors.csv", "roof.csv", "spring.csv"]))
    (again / name).write_bytes(data.draw(spoilt_text(TABLES[name].encode())))
    check(again / "scenario.yaml")


@searching(30)
@given(data=st.data())
def test_spoilt_wind_and_heights(data: Any, folder: Path) -> None:
    """The file that a section names stands where its error says."""
    field, name = data.draw(
        st.sampled_from([("gusts", "gusts.csv"), ("measured_heights", "heights.csv")])
    )
    (folder / name).write_bytes(data.draw(spoilt_text(TABLES[name].encode())))
    text = SCENARIO.replace("dropper_length_errors: errors.csv", f"{field}: {name}")
    (folder / "wind.yaml").write_text(text, encoding="utf-8")
    check(folder / "wind.yaml")
