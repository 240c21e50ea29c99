"""Descriptions of fields: unit, limits, words, out of the JSON Schema of model files."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

from arcless.model import json_schema
from arcless.units import KINDS, spell

Schema = dict[str, Any]
# Units as they are printed → as they are named for conversion.
KEYS = {spell(name): name for name in KINDS}
ROOTS = {"line": "Line", "pantograph": "Pantograph", "scenario": "Scenario"}


@dataclass(frozen=True)
class About:
    """A field: what it is, its SI unit as printed, units that may be typed, limits, words."""

    description: str
    unit: str | None
    units: list[str]
    minimum: float | None
    maximum: float | None
    choices: list[str]
    required: bool


@cache
def _schema() -> Schema:
    return json_schema()


@cache
def about(kind: str, path: tuple[str | int, ...]) -> About | None:
    """Return what is known of a field of a kind of model; None where there is no such field."""
    here: list[Schema] = [{"$ref": f"#/$defs/{ROOTS[kind]}"}]
    required = False
    for part in path:
        spread = [choice for schema in here for choice in _choices(schema)]
        own = [schema for schema in spread if part in schema.get("properties", ())]
        required = any(part in schema.get("required", ()) for schema in own)
        here = [found for schema in spread if (found := _inside(schema, part)) is not None]
    if not here:
        return None
    spread = [choice for schema in here for choice in _choices(schema)]
    unit = _first(spread, "unit")
    units = [spell(name) for name in KINDS[KEYS[unit]].units if name] if unit in KEYS else []
    numbers = [one for one in spread if one.get("type") in ("number", "integer")]
    words = [str(word) for one in spread for word in (*one.get("enum", ()), *_constant(one))]
    return About(
        description=_first(here, "description") or "",
        unit=unit,
        units=units,
        minimum=_first(numbers, "minimum", "exclusiveMinimum"),
        maximum=_first(numbers, "maximum", "exclusiveMaximum"),
        choices=[] if numbers or _has_text(spread) else list(dict.fromkeys(words)),
        required=required,
    )


def _choices(schema: Schema, depth: int = 0) -> Iterator[Schema]:
    """Yield all that a schema may be; a value with its source is left out."""
    if "value" in schema.get("properties", ()) or depth > len(_schema()["$defs"]):
        return
    yield schema
    if reference := schema.get("$ref"):
        yield from _choices(_schema()["$defs"][reference.rpartition("/")[2]], depth + 1)
    for one in (*schema.get("anyOf", ()), *schema.get("oneOf", ())):
        yield from _choices(one, depth + 1)


def _inside(schema: Schema, part: str | int) -> Schema | None:
    found = schema.get("items") if isinstance(part, int) else schema.get("properties", {}).get(part)
    if found is None and isinstance(part, str):
        found = schema.get("additionalProperties")
    return found if isinstance(found, dict) else None


def _first(schemas: list[Schema], *names: str) -> Any:
    return next((one[name] for one in schemas for name in names if name in one), None)


def _constant(schema: Schema) -> tuple[Any, ...]:
    return (schema["const"],) if "const" in schema else ()


def _has_text(schemas: list[Schema]) -> bool:
    return any(one.get("type") == "string" and "pattern" not in one and "enum" not in one
               and "const" not in one for one in schemas)  # fmt: skip
