"""Errors of pydantic → one `ModelError` that names file, line, field and remedy."""

import re
from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from arcless.errors import ModelError
from arcless.model.fields.document import printed
from arcless.model.fields.part import UNKNOWN_FIELD, Path, nearest
from arcless.model.files.yaml_reader import Origin
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
    # A long list may be wrong in every item: only what is listed is put into words.
    found = [
        (item, _path(item, data, prefix))
        for item in error.errors(include_url=False)
        if not _is_echo(item)
    ]
    found.sort(key=lambda mistake: origin.position(mistake[1]) or (0, 0))
    first, *others = [_explain_one(item, path, origin) for item, path in found[: MAX_LISTED + 1]]
    first.also = tuple(others)
    return first


def _is_echo(item: Any) -> bool:
    """Return whether a list is called too short only because items of it were refused."""
    return item["type"] == "too_short" and bool(len(item["input"]) >= item["ctx"]["min_length"])


def _path(item: Any, data: object, prefix: Path) -> Path:
    """Return the field that a mistake is about."""
    raised = item.get("ctx", {}).get("error")
    inside: Path = raised.field if isinstance(raised, ModelError) else ()
    if item["type"] in {"union_tag_invalid", "union_tag_not_found"}:
        inside = (item["ctx"]["discriminator"].strip("'"),)
    return _plain_provenance((*prefix, *_without_tags(item["loc"], data), *inside))


def _explain_one(item: Any, path: Path, origin: Origin) -> ModelError:
    raised = item.get("ctx", {}).get("error")
    cause = raised if isinstance(raised, ModelError) else _native(item)
    name = printed(path) or "model"
    if cause.what == UNKNOWN_FIELD and len(path) > 1:
        cause.expected = f"a field of {printed(path[:-1])}"
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
        if kind == "union_tag_not_found":
            got = None if isinstance(given, Mapping) else show(given)
            return ModelError("missing field", got=got, expected="the kind")
        known = re.findall(r"'([^']*)'", context["expected_tags"])
        hint = nearest(context["tag"], known)
        return ModelError(
            WRONG_VALUE,
            got=show(context["tag"]),
            expected=" or ".join(known),
            hint=hint,
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
    """Return where a provenance entry stands in the file: next to the value it belongs to."""
    if "provenance" not in path[:-1]:
        return path
    index = path.index("provenance")
    target = path[index + 1 : index + 2]
    parts = tuple(int(p) if p.isdigit() else p for t in target for p in str(t).split("."))
    return (*path[:index], *parts, *path[index + 2 :])
