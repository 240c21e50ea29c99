"""Values as they were typed, kept with a model: ``22 kN`` where the model has 22000.0.

They are no part of a model: two models that differ only in them are equal. A field that nothing
typed for has its default.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from pydantic import BaseModel

# Values as given, by dotted path: the text where that holds more than the value, else None.
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
