"""The JSON Schema of study files; that of model files has its own tests."""

import json

from arcless.study import json_schema

SCHEMA = json_schema()
STUDY = SCHEMA["$defs"]["Study"]


def test_a_study_is_one_of_the_formats() -> None:
    assert {"$ref": "#/$defs/Study"} in SCHEMA["oneOf"]
    assert set(STUDY["required"]) == {
        "format", "name", "scenario", "variables", "design", "outputs",
    }  # fmt: skip
    assert json.loads(json.dumps(SCHEMA, allow_nan=False)) == SCHEMA


def test_every_field_has_a_description() -> None:
    for name, definition in SCHEMA["$defs"].items():
        assert definition["description"], name
        for field, schema in definition.get("properties", {}).items():
            assert schema["description"], f"{name}.{field}"


def test_outputs_may_be_written_short() -> None:
    forms = STUDY["properties"]["outputs"]["anyOf"]
    assert {"type": "array", "items": {"type": "string"}, "minItems": 1} in forms
    mapping = forms[0]["additionalProperties"]["anyOf"]
    assert mapping == [{"type": "string"}, {"$ref": "#/$defs/StudyOutput"}]


def test_a_scenario_may_be_named() -> None:
    kinds = STUDY["properties"]["scenario"]["anyOf"]
    assert kinds == [{"type": "string"}, {"$ref": "#/$defs/Scenario"}]
