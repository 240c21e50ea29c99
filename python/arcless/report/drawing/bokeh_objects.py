"""Objects that Bokeh's script in a page reads: names, attributes, and columns of numbers.

Bokeh's own classes would write the same, but take longer than a run to import, make and check. The
script knows the defaults of all attributes, so only what differs from them is written. Tests read
every kind of page with Bokeh's classes, which know each object and attribute.
"""

import sys
import zlib
from base64 import b64encode
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

# Types that the script has arrays for; others are written as lists.
_ARRAYS = frozenset(map(np.dtype, ("float32", "float64", "int32")))
# Measured: the next levels take longer than they save in a page.
_COMPRESSION, _GZIP = 2, 31
# Values that JSON has no numbers for, in Python's words and in the script's.
_NO_NUMBERS = {"+inf": "+inf", "-inf": "-inf", "+nan": "nan"}


class Model:
    """An object of the script.

    Parameters
    ----------
    kind
        Its name there.
    **attributes
        What is not its default. They are attributes here as well, and more may be set.
    """

    __slots__ = ("__dict__", "kind")

    def __init__(self, kind: str, **attributes: Any) -> None:
        self.kind = kind
        self.__dict__.update(attributes)

    if TYPE_CHECKING:  # a kind's attributes are the script's to know

        def __setattr__(self, name: str, value: Any) -> None: ...

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"{self.kind} was given no {name}")


@dataclass(frozen=True)
class Field:
    """Reference to a column of the source, a value for each thing drawn; a transform colours it."""

    name: str
    transform: Model | None = None


@dataclass(frozen=True)
class Value:
    """Constant value, where a name could be that of a column."""

    value: Any


def columns(data: Mapping[str, Any]) -> Model:
    """Return columns of equal length, as figures and tables draw from."""
    return Model("ColumnDataSource", data=dict(data))


def document(roots: Iterable[Model]) -> tuple[list[Any], list[str]]:
    """Return the document that the script draws, ready for JSON, and a name for each root."""
    known: dict[int, str] = {}
    written = [_written(root, known) for root in roots]
    return written, [one["id"] for one in written]


def _written(value: Any, known: dict[int, str]) -> Any:
    """Return a value as JSON has it; an object that was written is a reference from then on."""
    found = value
    match value:
        case Model():
            found = _object(value, known)
        case np.ndarray() if value.dtype in _ARRAYS:
            found = _array(value)
        case np.ndarray():
            found = _written(value.tolist(), known)
        case np.generic():
            found = _written(value.item(), known)
        case float() if not np.isfinite(value):
            found = {"type": "number", "value": _NO_NUMBERS[f"{value:+}"]}
        case list() | tuple():
            found = [_written(item, known) for item in value]
        case dict():
            entries = [[key, _written(item, known)] for key, item in value.items()]
            found = {"type": "map", "entries": entries}
        case Field(name, transform):
            found = {"type": "field", "field": name}
            if transform is not None:
                found["transform"] = _written(transform, known)
        case Value(same):
            found = {"type": "value", "value": same}
    return found


def _object(model: Model, known: dict[int, str]) -> dict[str, Any]:
    if id(model) in known:
        return {"id": known[id(model)]}
    name = known[id(model)] = f"p{len(known) + 1}"
    attributes = {key: _written(value, known) for key, value in vars(model).items()}
    return {"type": "object", "name": model.kind, "id": name, "attributes": attributes}


def _array(values: Any) -> dict[str, Any]:
    data = zlib.compress(values.tobytes(), _COMPRESSION, _GZIP)
    return {
        "type": "ndarray",
        "array": {"type": "bytes", "data": b64encode(data).decode("ascii")},
        "shape": list(values.shape),
        "dtype": values.dtype.name,
        "order": sys.byteorder,
    }
