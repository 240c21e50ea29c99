"""Attributes of a dataset as plain Python values."""

import json
from collections.abc import Mapping
from typing import Any

from arcless.dataset.plain_dataset import Dataset
from arcless.dataset.schema import ATTRIBUTES


def metadata(dataset: Dataset) -> dict[str, Any]:
    """Return the attributes as plain Python values, JSON text decoded.

    Attributes that the table knows and the dataset lacks are ``None``.
    """
    return decoded(dataset.attrs)


def decoded(attrs: Mapping[str, Any]) -> dict[str, Any]:
    """Return attributes as they are stored as plain Python values; see `metadata`."""
    return {name: _decoded(name, attrs.get(name)) for name in ATTRIBUTES}


def _decoded(name: str, value: Any) -> Any:
    if value is None:
        return None
    kind = ATTRIBUTES[name].kind
    if kind == "json":
        return json.loads(value)
    return {"integer": int, "number": float, "text": str}[kind](value)
