"""Random valid models survive every way there and back, in whatever spelling they were given.

dict → Scenario → dict → file (JSON, YAML) → Scenario: all equal, to the last bit.
"""

import json
from pathlib import Path
from typing import Any

import yaml
from hypothesis import given

from arcless.model import load, scenario_warnings
from arcless.model.scenario.scenario import Scenario
from tests.support.hostile import numbers_in, searching
from tests.support.valid_models import scenarios


class Quoting(yaml.SafeDumper):
    """Texts in quotes: what PyYAML takes for a text when it stands bare may be a number here."""


Quoting.add_representer(
    str, lambda dumper, text: dumper.represent_scalar("tag:yaml.org,2002:str", text, style='"')
)


def again(scenario: Scenario, folder: Path) -> list[Scenario]:
    """Return one scenario, loaded from its plain data, from JSON and from YAML."""
    data = scenario.to_dict()
    text = json.dumps(data, allow_nan=False)
    (folder / "again.json").write_text(text, encoding="utf-8")
    written = yaml.dump(data, Dumper=Quoting, allow_unicode=True, width=10**6)
    (folder / "again.yaml").write_text(written, encoding="utf-8")
    return [load(data), load(folder / "again.json"), load(folder / "again.yaml")]


@searching(20)
@given(data=scenarios())
def test_valid_models_survive(data: dict[str, Any], tmp_path_factory: Any) -> None:
    folder = tmp_path_factory.getbasetemp()
    scenario = load(data)
    for same in again(scenario, folder):
        assert same == scenario
        assert same.to_dict() == scenario.to_dict()
    assert all(abs(number) < float("inf") for number in numbers_in(scenario.to_dict()))
    assert all(isinstance(text, str) for text in scenario_warnings(scenario))
    assert scenario.with_(name=scenario.name) is not scenario
