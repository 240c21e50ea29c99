"""The model files as JSON Schema, for editors."""

from typing import Any

from pydantic.json_schema import models_json_schema

from arcless.model.fields.document import Document, Provenance
from arcless.model.fields.part import wrapped_schema
from arcless.model.line.line import Line
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.scenario.scenario import Scenario
from arcless.model.shipped.wire_catalogue import GIVES
from arcless.model.variants.variant_files import Variant
from arcless.units import KINDS, pattern

_PLAIN = {"name", "description", "sources", "provenance", "line", "model", "scenario"}
_LABELS = {"title", "description", "default", "unit"}
# Pattern of a text with a unit → name of its schema.
_AMOUNTS = {pattern(unit): kind.name.replace(" ", "-") for unit, kind in KINDS.items()}
DIALECT = "https://json-schema.org/draft/2020-12/schema"


def json_schema(*others: type[Document]) -> dict[str, Any]:
    """Return one JSON Schema document: the three formats, variants of scenarios, and others.

    A file is valid when it is one of them. Numbers with a unit are shown as a number, a text, or a
    mapping that carries the provenance of the value.
    """
    models: tuple[type[Document], ...] = (Line, Pantograph, Scenario, Variant, *others)
    references, document = models_json_schema(
        [(model, "validation") for model in models], by_alias=True
    )
    definitions = document["$defs"]
    for model in models:
        definition = definitions[model.__name__]
        definition["required"] = sorted({*definition.get("required", ()), "format"})
    for definition in definitions.values():
        for field in definition.get("properties", {}).values():
            if field.pop("reference", None) is not None:
                field["anyOf"] = [{"type": "string"}, {"$ref": field.pop("$ref")}]
            if field.pop("or_file", None) is not None:
                field["anyOf"].insert(0, {"type": "string", "description": "file"})
            if field.pop("table", None) is not None:
                keys = [key for key in ("type", "items", "maxItems", "anyOf") if key in field]
                rows = {key: field.pop(key) for key in keys}
                field["anyOf"] = [{"type": "string", "description": "CSV file"}, rows]
        if "catalogue" in definition.get("properties", {}):
            _accept_named_wire(definition)
    _accept_number_of_starts(definitions)
    scheme = definitions["Solver"]["properties"]["scheme"]
    names = sorted(scheme["discriminator"]["mapping"])
    choices = {key: scheme.pop(key) for key in ("discriminator", "oneOf")}
    scheme["anyOf"] = [{"enum": names}, choices]
    for name, definition in definitions.items():
        if name not in (Provenance.__name__, Variant.__name__):
            _accept_provenance(definition.get("properties", {}))
    amounts: dict[str, dict[str, Any]] = {}
    _name_amounts(definitions, amounts)
    return {
        "$schema": DIALECT,
        "title": "Arcless model files",
        "oneOf": [references[(model, "validation")] for model in models],
        "$defs": definitions | amounts,
    }


def _name_amounts(schema: Any, amounts: dict[str, dict[str, Any]]) -> None:
    """Refer to texts with a unit by their kind, such as ``a-force``: hundreds are the same."""
    for key, part in schema.items() if isinstance(schema, dict) else enumerate(schema):
        if isinstance(part, dict) and part.get("pattern") in _AMOUNTS:
            name = _AMOUNTS[part["pattern"]]
            amounts[name] = part
            schema[key] = {"$ref": f"#/$defs/{name}"}
        elif isinstance(part, dict | list):
            _name_amounts(part, amounts)


def _accept_named_wire(definition: dict[str, Any]) -> None:
    """Ask a wire for its own values, or for the name of a wire that has them."""
    own = [name for name in definition["required"] if name in GIVES]
    definition["required"] = [name for name in definition["required"] if name not in GIVES]
    definition["anyOf"] = [{"required": own}, {"required": ["catalogue"]}]


def _accept_number_of_starts(definitions: dict[str, Any]) -> None:
    """Let certainty be the number of starts alone."""
    starts = definitions["Certainty"]["properties"]["starts"]
    number = {key: starts[key] for key in ("type", "minimum", "maximum")}
    field = definitions["Scenario"]["properties"]["certainty"]
    field["anyOf"] = [number, *field["anyOf"]]


def _accept_provenance(properties: dict[str, Any]) -> None:
    """Let every field that is not a name also be written with its provenance."""
    for name, field in properties.items():
        if name in _PLAIN or "const" in field or _has_wrapper(field):
            continue
        labels = {key: value for key, value in field.items() if key in _LABELS}
        plain = {key: value for key, value in field.items() if key not in _LABELS}
        properties[name] = {**labels, "anyOf": [plain, wrapped_schema([plain])]}


def _has_wrapper(field: dict[str, Any]) -> bool:
    if "value" in field.get("properties", {}):
        return True
    return any(_has_wrapper(choice) for choice in field.get("anyOf", ()))
