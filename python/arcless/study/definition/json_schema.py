"""Model files and study files as JSON Schema, for editors."""

from typing import Any

from arcless import model
from arcless.study.definition.study import Study


def json_schema() -> dict[str, Any]:
    """Return one JSON Schema document: a file is a line, a pantograph, a scenario or a study."""
    document = model.json_schema(Study)
    document["title"] = "Arcless model and study files"
    outputs = document["$defs"]["Study"]["properties"]["outputs"]
    bare = {"type": "string"}
    _widen(outputs, bare)
    outputs["anyOf"].append({"type": "array", "items": bare, "minItems": 1})
    return document


def _widen(schema: dict[str, Any], bare: dict[str, Any]) -> None:
    """Let an output also be written as its bare expression."""
    for choice in (schema, *schema.get("anyOf", ())):
        inner = choice.get("additionalProperties")
        if isinstance(inner, dict):
            choice["additionalProperties"] = {"anyOf": [bare, inner]}
