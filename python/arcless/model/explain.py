"""What pydantic found wrong → one `ModelError` that names file, line, field and remedy."""

import re
from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from arcless.errors import ModelError
from arcless.model.documents import dotted
from arcless.model.fields import Path, nearest
from arcless.model.reader import Origin
from arcless.units import WRONG_VALUE, show

MAX_LISTED = 20


def explain(error: ValidationError, data: object, origin: Origin, prefix: Path = ()) -> ModelError:
    """Return the first mistake in file order, with the further ones in `also`.

    Parameters
    ----------
    error : ValidationError
        What pydantic raised.
    data : object
        The data that were validated.
    origin : Origin
        File and positions of the data.
    prefix : tuple of str or int
        Path of the data inside the file.
    """
    items = [item for item in error.errors() if not _is_echo(item)]
    found = [_explain_one(item, data, origin, prefix) for item in items]
    found.sort(key=lambda mistake: origin.position(mistake.field) or (0, 0))
    first, *others = found
    first.also = tuple(others[:MAX_LISTED])
    return first


def _is_echo(item: Any) -> bool:
    """Whether a list is called too short only because items of it were refused."""
    return item["type"] == "too_short" and bool(len(item["input"]) >= item["ctx"]["min_length"])


def _explain_one(item: Any, data: object, origin: Origin, prefix: Path) -> ModelError:
    below = _without_tags(item["loc"], data)
    raised = item.get("ctx", {}).get("error")
    cause = raised if isinstance(raised, ModelError) else _native(item)
    path = _plain_provenance((*prefix, *below, *cause.field))
    name = dotted(path) or "model"
    return ModelError(
        name if cause.what == WRONG_VALUE else f"{name}: {cause.what}",
        where=origin.where(path),
        got=cause.got,
        expected=cause.expected,
        hint=cause.hint,
        field=path,
    )


def _native(item: Any) -> ModelError:
    """Translate a mistake that pydantic words itself."""
    kind, context, given = item["type"], item.get("ctx", {}), item["input"]
    if kind in {"literal_error", "enum"}:
        # Words in quotes, in double ones where they have an apostrophe.
        known = [
            "".join(word) for word in re.findall(r"'([^']*)'|\"([^\"]*)\"", context["expected"])
        ]
        hint = nearest(given, known) if isinstance(given, str) else None
        expected = " or ".join(known)
        return ModelError(WRONG_VALUE, got=show(given), expected=expected, hint=hint)
    if kind in {"union_tag_invalid", "union_tag_not_found"}:
        field = (context["discriminator"].strip("'"),)
        if kind == "union_tag_not_found":
            got = None if isinstance(given, Mapping) else show(given)
            return ModelError("missing field", got=got, expected="the kind", field=field)
        known = re.findall(r"'([^']*)'", context["expected_tags"])
        hint = nearest(context["tag"], known)
        return ModelError(
            WRONG_VALUE,
            got=show(context["tag"]),
            expected=" or ".join(known),
            hint=hint,
            field=field,
        )
    if kind in {"too_short", "too_long", "missing"}:
        limit = context.get("min_length", context.get("max_length"))
        word = {"too_short": "at least", "too_long": "at most"}.get(kind)
        expected = f"{word} {limit} items" if word else "a value here, too"
        return ModelError(WRONG_VALUE, got=show(given), expected=expected)
    expected = re.sub(r"^(Input|Value|String|Tuple|Dictionary) should (be|have) ", "", item["msg"])
    hint = "write it in quotes" if kind == "string_type" and not isinstance(given, dict) else None
    return ModelError(WRONG_VALUE, got=show(given), expected=_words(expected), hint=hint)


def _words(expected: str) -> str:
    for theirs, ours in (
        ("a valid string", "a text"),
        ("a valid integer", "a whole number"),
        ("a valid boolean", "true or false"),
        ("a valid tuple", "a list"),
        ("a valid list", "a list"),
        ("a valid dictionary", "a mapping"),
    ):
        expected = expected.replace(theirs, ours)
    return expected


def _without_tags(location: Path, data: object) -> Path:
    """Drop the union tags that pydantic puts into locations: they are no fields."""
    path: list[str | int] = []
    for part in location:
        if isinstance(data, Mapping):
            is_tag = part not in data and part in (data.get("kind"), data.get("name"))
            if is_tag:
                continue
            data = data.get(part)
        elif isinstance(data, (list, tuple)) and isinstance(part, int) and part < len(data):
            data = data[part]
        else:
            data = getattr(data, str(part), None)
        path.append(part)
    return tuple(path)


def _plain_provenance(path: Path) -> Path:
    """Return where a provenance entry stands in the file: beside the value it belongs to."""
    if "provenance" not in path[:-1]:
        return path
    index = path.index("provenance")
    target = path[index + 1 : index + 2]
    parts = tuple(int(p) if p.isdigit() else p for t in target for p in str(t).split("."))
    return (*path[:index], *parts, *path[index + 2 :])
