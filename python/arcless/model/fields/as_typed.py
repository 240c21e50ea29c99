"""Values as they were typed, kept beside a model: ``22 kN`` where the model has 22000.0.

They are no part of a model: two that are equal but for them are equal. A field that nothing was
typed for has its default.
"""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from pydantic import BaseModel

if TYPE_CHECKING:
    from arcless.model.fields.document import Document
    from arcless.model.scenario.scenario import Scenario

# What was given, by dotted path: its text where that holds more than the value, else None.
Given = dict[str, str | None]

# Of longer lists and texts it is only kept that they were given.
MOST_ITEMS = 200
LONGEST = 80


def given_in(data: Mapping[str, Any]) -> Given:
    """Return what plain data give: texts as typed, None for numbers, words and long lists."""
    return dict(_leaves(data, ""))


def _leaves(value: Any, path: str) -> Iterator[tuple[str, str | None]]:
    if isinstance(value, BaseModel):
        return  # it keeps its own
    if isinstance(value, Mapping):
        if "value" in value and "format" not in value:
            yield from _leaves(value["value"], path)
            return
        for key, item in value.items():
            yield from _leaves(item, f"{path}.{key}" if path else str(key))
        return
    if isinstance(value, list | tuple):
        if not any(isinstance(item, Mapping | BaseModel) for item in value):
            yield path, None
        if len(value) > MOST_ITEMS and path:
            yield path, None
            return
        for index, item in enumerate(value):
            yield from _leaves(item, f"{path}.{index}")
        return
    if value is not None:
        is_text = isinstance(value, str) and len(value) <= LONGEST
        yield path, value if is_text else None


def within(path: str, groups: set[str]) -> bool:
    """Return whether a dotted path is one of some, or lies below one of them."""
    parts = path.split(".")
    return any(".".join(parts[:count]) in groups for count in range(1, len(parts) + 1))


def documents_of(scenario: "Scenario") -> "dict[str, Document]":
    """Return a scenario, its line and its pantographs by their dotted paths in it."""
    found: dict[str, Document] = {"": scenario, "line": scenario.line}
    for index, placement in enumerate(scenario.pantographs):
        found[f"pantographs.{index}.model"] = placement.model
    return found


def typed_in(scenario: "Scenario") -> dict[str, Given]:
    """Return what was typed for a scenario, its line and its pantographs, as plain data."""
    documents = documents_of(scenario).items()
    return {path: dict(one.given) for path, one in documents if one.given is not None}


def restore(scenario: "Scenario", typed: object) -> None:
    """Take what `typed_in` gave for a scenario that was read again; None: nothing is known."""
    known = typed if isinstance(typed, Mapping) else {}
    for path, document in documents_of(scenario).items():
        one = known.get(path)
        keep(document, dict(one) if isinstance(one, Mapping) else None)


def keep(document: "Document", given: Given | None) -> None:
    """Say what was given for a document; None: it is not known."""
    document.__dict__["given"] = given


def carry(
    before: "Scenario", now: "Scenario", changed: set[str], named: "Mapping[str, Document]"
) -> None:
    """Keep what was typed for a scenario for its changed copy.

    Parameters
    ----------
    before, now
        The scenario, and its copy from data where everything stands as a number.
    changed
        Dotted paths of what was changed or taken back.
    named
        Models that took the place of others, by their paths.
    """
    old = documents_of(before)
    for path, document in documents_of(now).items():
        if document is old.get(path) or (path and within(path, changed) and path not in named):
            continue
        base = named.get(path, old.get(path))
        start = f"{path}." if path else ""
        inside = {one.removeprefix(start) for one in changed if one.startswith(start)}
        if base is None or base.given is None:
            keep(document, None)
            continue
        fresh = document.given or {}
        stays = {one: text for one, text in base.given.items() if not within(one, inside)}
        new = {one: text for one, text in fresh.items() if within(one, inside)}
        keep(document, stays | new)
