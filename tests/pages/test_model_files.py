"""The files that pages show load, and run as they say."""

import re
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.errors import ModelError
from arcless.model import (
    Pantograph,
    Scenario,
    line_warnings,
    load,
    load_any,
    load_line,
    scenario_warnings,
)
from arcless.model.files.yaml_reader import parse
from arcless.model.line.parts.components import Rayleigh, TensionedWire, Wire
from arcless.model.shipped.library import shipped
from tests.support import fmus
from tests.support.line_types import compound_data, stitched_data

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGE = (DOCS / "reference/model-files.md").read_text(encoding="utf-8")


def test_the_worked_example_loads(tmp_path: Path) -> None:
    blocks = re.findall(r"```yaml\n# (\S+\.yaml)\n(.*?)```", PAGE, re.DOTALL)
    assert [name for name, _ in blocks] == ["my-line.yaml", "my-scenario.yaml"]
    for name, text in blocks:
        (tmp_path / name).write_text(text, encoding="utf-8")
    scenario = load(tmp_path / "my-scenario.yaml")
    assert scenario_warnings(scenario) == []
    assert scenario.line.provenance["contact_wire.tension"].mark == "A"
    found = arcless.run(scenario).assessment
    assert [c.name for c in found.criteria if c.passed is False] == []
    assert found.notes == []


@pytest.mark.parametrize("page", sorted(DOCS.rglob("*.md")), ids=lambda page: page.stem)
def test_scenarios_of_the_pages_give_no_warning(page: Path, tmp_path: Path) -> None:
    """Each file of a page is written down, so that one may name another."""
    blocks = re.findall(
        r"```\w+\n# (\S+\.(?:yaml|csv|py))\b[^\n]*\n(.*?)```", page.read_text("utf-8"), re.DOTALL
    )
    for name, text in blocks:
        (tmp_path / name).write_text(text, encoding="utf-8")
    for name, text in blocks:
        if "format: arcless-scenario/1" in text:
            assert scenario_warnings(load(tmp_path / name)) == []


@pytest.mark.parametrize("name", [path.stem for path in shipped("line").values()])
def test_shipped_lines_give_no_warning(name: str) -> None:
    told = line_warnings(load_line(name))
    # The worked example of the paper has no damping.
    assert [text[:30] for text in told] == ["line: no wire has damping (con"] * (name == "praks")


def test_the_line_types_of_the_guide_load() -> None:
    text = (DOCS / "guide/line-types.md").read_text(encoding="utf-8")
    stitched, compound, _ = (
        parse(t, "guide")[0] for t in re.findall(r"```yaml\n(.*?)```", text, re.S)
    )
    ours, shipped = load_line(stitched_data(**stitched)), load_line("norway-s25")
    assert _plain(ours.stitch_wire) == _plain(shipped.stitch_wire)
    shipped = load_line("shinkansen-heavy-compound")
    ours = load_line(compound_data(**compound, spans=[{"type": "standard", "count": 3}]))
    assert ours.span_types["standard"] == shipped.span_types["standard"]
    assert _plain(ours.auxiliary_wire) == _plain(shipped.auxiliary_wire)


def _plain(wire: TensionedWire | None) -> TensionedWire:
    """The guide leaves damping and ends out."""
    assert wire is not None
    ends = {name: None for name in Wire.model_fields if name.startswith("end")}
    own = {name: value for name, value in ends.items() if name in type(wire).model_fields}
    return wire.model_copy(update={"damping": Rayleigh(), **own})


def test_the_scenario_of_the_guide_to_control_loads(tmp_path: Path) -> None:
    page = (ROOT / "docs/guide/control.md").read_text(encoding="utf-8")
    ((name, text),) = re.findall(r"```yaml\n# (\S+)\n(.*?)```", page, re.DOTALL)
    (tmp_path / name).write_text(text, encoding="utf-8")
    scenario = load_any(tmp_path / name)
    assert isinstance(scenario, Scenario)
    controller = scenario.pantographs[0].controller
    assert controller is not None
    assert controller.pid is not None
    assert (controller.rate_limit, controller.pid.derivative) == (5000.0, 0.05)


def test_the_model_of_the_guide_to_fmus_loads(tmp_path: Path) -> None:
    page = (ROOT / "docs/guide/pantograph-fmu.md").read_text(encoding="utf-8")
    ((name, text),) = re.findall(r"```yaml\n# (\S+\.yaml)\n(.*?)```", page, re.DOTALL)
    # With the line of the name, by which the lines of the messages count.
    (tmp_path / name).write_text(f"# {name}\n{text}", encoding="utf-8")
    names = {"contact_force": "Fc", "strip_height": "z_strip", "static_force": "F_static"}
    names["hardening"] = "k_head"
    platforms = ("linux64", "darwin64", "win64")
    fmus.undescribed(tmp_path, fmus.description(names=names), platforms)
    found = load_any(tmp_path / name)
    assert isinstance(found, Pantograph)
    assert found.fmu is not None
    assert found.fmu.parameters == {"k_head": 7000.0}
    wrong: list[dict[str, Any]] = [
        {"causalities": {"contact_force": "output"}},
        {"units": {"strip_height": "deg"}},
    ]
    told = []
    for fault in wrong:
        fmus.undescribed(tmp_path, fmus.description(names=names, **fault), platforms)
        with pytest.raises(ModelError) as caught:
            load_any(tmp_path / name)
        told.append(str(caught.value))
    fmus.undescribed(tmp_path, fmus.description(names=names), ("win64",))
    with pytest.raises(ModelError) as caught:
        load_any(tmp_path / name)
    told.append(str(caught.value))
    for message in told:
        assert message.replace(f"{tmp_path}/", "") in page


def test_the_models_of_the_pantograph_guide_load(tmp_path: Path) -> None:
    page = (ROOT / "docs/guide/pantographs.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```(?:yaml|csv)\n# (\S+)\n(.*?)```", page, re.DOTALL)
    names = [name for name, _ in blocks]
    assert names == [
        "four.yaml", "reduced.yaml", "lifted.yaml", "shaken.yaml", "roof.csv", "stopped.yaml",
        "progressive.yaml", "dry.yaml", "general.yaml",
    ]  # fmt: skip
    for name, text in blocks:
        (tmp_path / name).write_text(text, encoding="utf-8")
    models = {name: load_any(tmp_path / name) for name in names if name.endswith(".yaml")}
    four = models["four.yaml"]
    assert isinstance(four, Scenario)
    assert len(four.pantographs) == 4
    assert not scenario_warnings(four)
