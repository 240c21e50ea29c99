"""Names of the fields of a part of a model, from its class alone."""

from functools import cache
from types import UnionType
from typing import Any, Union, get_args, get_origin

from pydantic import BaseModel


@cache
def names_of(
    model: type[BaseModel],
) -> tuple[frozenset[str], list[tuple[str, str]], list[tuple[str, int]]]:
    """Return what keys of a model's data may be called, and what is known of some of them.

    That is: name and alias of those that must be there; name and highest number of items of lists
    and tables. Found once: a table has thousands of rows, a study thousands of scenarios.
    """
    fields = model.model_fields.items()
    needed = [(name, field.alias or name) for name, field in fields if field.is_required()]
    most = [(field.alias or name, _most_items(field)) for name, field in fields]
    longest = [(name, count) for name, count in most if count is not None]
    return (
        frozenset(part for name, field in fields for part in (field.alias or name, name)),
        needed,
        longest,
    )


def _most_items(annotated: Any) -> int | None:
    """Return how many items a list or table may have, of an annotation or a pydantic field."""
    metadata: Any = getattr(annotated, "metadata", None) or getattr(annotated, "__metadata__", ())
    for item in metadata:
        for limit in (item, *getattr(item, "metadata", ())):
            most: int | None = getattr(limit, "max_length", None)
            if most is not None:
                return most
    inner = getattr(annotated, "annotation", None)
    is_union = get_origin(annotated) in {Union, UnionType}
    children = (inner,) if inner is not None else get_args(annotated) if is_union else ()
    return next((count for count in map(_most_items, children) if count is not None), None)
