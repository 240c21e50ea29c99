"""The JSON Schema accepts what the loader accepts, as far as a schema can tell."""

import json
import re
from typing import Any

import pytest

from arcless.model.files.yaml_reader import parse, read_text
from arcless.model.shipped.library import FOLDER
from arcless.study import json_schema
from arcless.units import KINDS

SCHEMA = json_schema()  # of models and studies
TYPES: dict[str, Any] = {
    "object": dict,
    "array": list,
    "string": str,
    "number": (int, float),
    "integer": int,
    "boolean": bool,
    "null": type(None),
}


def accepts(schema: dict[str, Any], value: Any) -> bool:
    """Validate with the part of JSON Schema that ours is made of."""
    if "$ref" in schema:
        return accepts(SCHEMA["$defs"][schema["$ref"].rsplit("/", maxsplit=1)[1]], value)
    checks = [
        "anyOf" not in schema or any(accepts(choice, value) for choice in schema["anyOf"]),
        "oneOf" not in schema or sum(accepts(choice, value) for choice in schema["oneOf"]) == 1,
        value in schema.get("enum", [value]),
        value == schema.get("const", value),
    ]
    if "type" in schema:
        is_bool = isinstance(value, bool) and schema["type"] != "boolean"
        checks.append(isinstance(value, TYPES[schema["type"]]) and not is_bool)
    if isinstance(value, str) and "pattern" in schema:
        checks += [re.search(schema["pattern"], value) is not None]
    if isinstance(value, (int, float)):
        checks += [value > schema.get("exclusiveMinimum", float("-inf"))]
        checks += [value >= schema.get("minimum", float("-inf"))]
        checks += [value <= schema.get("maximum", float("inf"))]
    if isinstance(value, dict):
        properties, rest = schema.get("properties", {}), schema.get("additionalProperties", True)
        checks += [set(schema.get("required", ())) <= set(value)]
        for key, item in value.items():
            known = properties.get(key, rest)
            checks.append(known if isinstance(known, bool) else accepts(known, item))
    if isinstance(value, list):
        checks += [len(value) >= schema.get("minItems", 0)]
        items = schema.get("prefixItems", [schema.get("items", {})] * len(value))
        checks += [accepts(item, entry) for item, entry in zip(items, value, strict=False)]
    return all(checks)


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*/*.yaml")), ids=lambda path: path.stem)
def test_shipped_files_are_valid(path: Any) -> None:
    data, _ = parse(read_text(path, path.name), path.name)
    assert accepts(SCHEMA, data)
    assert not accepts(SCHEMA, data | {"nmae": "x"})
    assert not accepts(SCHEMA, {key: item for key, item in data.items() if key != "format"})


def test_a_number_with_a_unit_is_a_number_a_text_or_carries_its_provenance() -> None:
    tension = SCHEMA["$defs"]["Wire"]["properties"]["tension"]
    number, text, wrapped = tension["anyOf"]
    assert (number["type"], text["$ref"]) == ("number", "#/$defs/a-force")
    assert wrapped["type"] == "object"
    assert tension["unit"] == "N"
    assert "a force (N, kN" in SCHEMA["$defs"]["a-force"]["description"]
    assert accepts(tension, 22e3) and accepts(tension, "22 kN") and accepts(tension, "5000 lbf")
    assert accepts(tension, {"value": "22 kN", "mark": "A", "source": "S1"})
    assert not accepts(tension, 0) and not accepts(tension, {"value": "22 kN", "marc": "A"})


@pytest.mark.parametrize("given", ["10 kg", "22 kn", "10,5 kN", "22 000 N", "taut", "", "22 kN m"])
def test_a_text_with_another_unit_is_flagged(given: str) -> None:
    tension = SCHEMA["$defs"]["Wire"]["properties"]["tension"]
    assert not accepts(tension, given)
    assert not accepts(tension, {"value": given, "mark": "A", "source": "S1"})


def test_texts_with_units_are_described_once() -> None:
    """One schema for each kind of amount: written out at each field, they were half of the file."""
    # An area is that of `arcless stress`, responses are columns for `arcless pantograph fit`: no
    # field of a file is one.
    of_options = {"m2", "m/N", "m/s/N", "m/s2/N"}
    kinds = {kind.name.replace(" ", "-") for unit, kind in KINDS.items() if unit not in of_options}
    texts = {name for name, one in SCHEMA["$defs"].items() if one["type"] == "string"}
    assert texts == kinds
    assert json.dumps(SCHEMA).count("number and unit") == 2 * len(kinds)  # and its message


def test_a_word_may_stand_for_a_number() -> None:
    step = SCHEMA["$defs"]["Solver"]["properties"]["time_step"]
    assert {"const": "one element"} in step["anyOf"]
    assert accepts(step, 1e-3) and accepts(step, "1 ms") and accepts(step, "one element")
    assert accepts(step, {"value": "one element", "mark": "A", "source": "S1"})
    assert not accepts(step, 1.0)
    for wire in ("contact", "messenger"):
        element = SCHEMA["$defs"]["Solver"]["properties"][f"{wire}_wire_element"]
        assert element["default"] == "auto"
        assert accepts(element, "auto") and accepts(element, 0.45) and not accepts(element, 21)


def test_every_field_has_a_description() -> None:
    for name, definition in SCHEMA["$defs"].items():
        assert definition["description"], name
        for field, schema in definition.get("properties", {}).items():
            assert schema["description"], f"{name}.{field}"


def test_it_is_plain_json() -> None:
    assert json.loads(json.dumps(SCHEMA, allow_nan=False)) == SCHEMA
