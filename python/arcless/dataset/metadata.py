"""Attributes of a dataset as plain Python values."""

import json
from typing import Any

from arcless.dataset.plain_dataset import Dataset
from arcless.dataset.schema import ATTRIBUTES


def metadata(dataset: Dataset) -> dict[str, Any]:
    """Return the attributes as plain Python values, JSON text decoded.

    Attributes that the table knows and the dataset lacks are ``None``.
    """
    return {name: _decoded(name, dataset.attrs.get(name)) for name in ATTRIBUTES}


def _decoded(name: str, value: Any) -> Any:
    if value is None:
        return None
    kind = ATTRIBUTES[name].kind
    if kind == "json":
        return json.loads(value)
    return {"integer": int, "number": float, "text": str}[kind](value)
