"""Pages of the JSON Schema: one for each type of model and study files, and one for all units."""

import json
from collections.abc import Iterator
from typing import Any

from website.commands import escaped

from arcless.study import json_schema

PAGE = "reference/schemas.md"
FOLDER = "reference/schemas"
# The alternative of a value with its provenance, which nearly every field has.
WITH_PROVENANCE = {"value", "mark", "source", "note"}
# A longer default would spread the table; the JSON below has it.
LONGEST_DEFAULT = 60
LIMITS = {"minimum": "≥", "exclusiveMinimum": ">", "maximum": "≤", "exclusiveMaximum": "<"}

Schema = dict[str, Any]


def pages() -> dict[str, str]:
    """Return the pages of all types, and the list of them for the page on schemas."""
    whole = json_schema()
    types = {name: one for name, one in whole["$defs"].items() if "properties" in one}
    units = {name: one for name, one in whole["$defs"].items() if name not in types}
    roots = [_name(one["$ref"]) for one in whole["oneOf"]]
    made = {f"{FOLDER}/{name}.md": _page(name, one) for name, one in types.items()}
    made[f"{FOLDER}/units.md"] = _units(units)
    others = sorted(set(types) - set(roots))
    tables = [
        ("Files", roots, "A file is one of these types; its field `format` says which."),
        ("Types of fields", others, ""),
    ]
    parts = [_listed(title, names, types, words) for title, names, words in tables]
    parts.append("## Units\n\n- [Units](schemas/units.md): how a value with a unit is spelled\n")
    parts.append(_contents([*roots, *others, "units"]))
    return made | {PAGE: "\n".join(parts)}


def _listed(title: str, names: list[str], types: dict[str, Schema], words: str) -> str:
    rows = [
        f"- [{name}](schemas/{name}.md): {escaped(types[name].get('description', ''))}"
        for name in names
    ]
    return "\n".join([f"## {title}\n", f"{words}\n", *rows, ""])


def _contents(names: list[str]) -> str:
    entries = [f"schemas/{name}" for name in names]
    return "\n".join(["```{toctree}", ":hidden:", "", *entries, "```", ""])


def _page(name: str, schema: Schema) -> str:
    required = set(schema.get("required", ()))
    rows = []
    for field, one in schema["properties"].items():
        default = "required" if field in required else _default(one)
        words = escaped(one.get("description", ""))
        rows.append(f"| `{field}` | {_kind(one)} | {default} | {words} |")
    return "\n".join(
        [
            f"# {name}\n",
            f"{escaped(schema.get('description', ''))}\n",
            "| field | value | default | meaning |",
            "|---|---|---|---|",
            *rows,
            "",
            "## JSON Schema\n",
            f"```json\n{json.dumps(schema, indent=1, ensure_ascii=False)}\n```\n",
        ]
    )


def _units(units: dict[str, Schema]) -> str:
    parts = ["# Units\n", "A number without a unit is in SI units. Text has a unit:\n"]
    for name, one in units.items():
        words = escaped(one.get("description", ""))
        title = name.replace("-", " ")
        parts += [f"## {title}\n", f"{words}\n"] if words else [f"## {title}\n"]
        parts.append(f"```json\n{json.dumps(one, indent=1, ensure_ascii=False)}\n```\n")
    return "\n".join(parts)


def _default(schema: Schema) -> str:
    if "default" not in schema:
        return ""
    value = json.dumps(schema["default"], ensure_ascii=False)
    return f"`{value}`" if len(value) <= LONGEST_DEFAULT else "see below"


def _kind(schema: Schema) -> str:
    """Return in words what a field takes."""
    kinds = list(dict.fromkeys(_kinds(schema)))
    if unit := schema.get("unit"):
        kinds = [kind.replace("number", f"number of {unit}") for kind in kinds]
    return " or ".join(kinds)


def _kinds(schema: Schema) -> Iterator[str]:
    """Yield each alternative, without that of a value with its provenance."""
    if "$ref" in schema:
        name = _name(schema["$ref"])
        is_unit = name[0].islower()
        page = f"units.md#{name.lower()}" if is_unit else f"{name}.md"
        yield f"[{name.replace('-', ' ') if is_unit else name}]({page})"
    elif set(schema.get("properties", ())) == WITH_PROVENANCE:
        return
    elif either := schema.get("anyOf") or schema.get("oneOf"):
        for one in either:
            yield from _kinds(one)
    elif "enum" in schema or "const" in schema:
        values = schema.get("enum", [schema.get("const")])
        yield from (f"`{json.dumps(value, ensure_ascii=False).strip(chr(34))}`" for value in values)
    elif schema.get("type") == "array":
        items = schema.get("items") or {}
        each = " or ".join(dict.fromkeys(_kinds(items))) if items else "values"
        yield f"list of {each}"
    elif schema.get("type") == "object":
        more = schema.get("additionalProperties")
        of = " or ".join(dict.fromkeys(_kinds(more))) if isinstance(more, dict) and more else ""
        yield f"table of {of}" if of else "table"
    elif schema.get("type") != "null":
        limits = [f"{sign} {schema[key]:g}" for key, sign in LIMITS.items() if key in schema]
        kind = schema.get("type", "any value")
        yield f"{kind} ({', '.join(limits)})" if limits else kind


def _name(reference: str) -> str:
    return reference.rpartition("/")[2]
