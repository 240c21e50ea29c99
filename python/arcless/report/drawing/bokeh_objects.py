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

from arcless.figures.description.tokens import colour

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


@dataclass(frozen=True)
class Token:
    """Colour by its meaning: written as it is in light pages, and listed for the others."""

    name: str


class Columns(Model):
    """Columns of equal length, as figures and tables draw from."""

    __slots__ = ("_known",)

    def __init__(self, data: Mapping[str, Any] | None = None) -> None:
        super().__init__("ColumnDataSource", data=dict(data or {}))
        # The values are kept with their names, so that no others have the same identity.
        self._known: dict[int, tuple[str, Any]] = {}

    def name_of(self, values: Any) -> str:
        """Return the name of the column with these values, which is added where there is none."""
        if id(values) not in self._known:
            name = f"c{len(self._known)}"
            self.data[name] = values
            self._known[id(values)] = name, values
        return self._known[id(values)][0]


@dataclass(frozen=True)
class Document:
    """Objects that the script draws, ready for JSON.

    Attributes
    ----------
    roots
        The objects, with all that belongs to them.
    names
        Name of each root.
    colours
        Token → names of objects and attributes that have its colour.
    """

    roots: list[Any]
    names: list[str]
    colours: dict[str, list[list[str]]]
    known: "_Known"

    def name_of(self, model: Model) -> str:
        """Return the name of an object that was written."""
        return self.known.names[id(model)]

    def has(self, model: Model) -> bool:
        """Return whether an object was written."""
        return id(model) in self.known.names


class _Known:
    """Names of the objects that were written, and where tokens are."""

    def __init__(self) -> None:
        self.names: dict[int, str] = {}
        self.colours: dict[str, list[list[str]]] = {}


def document(roots: Iterable[Model]) -> Document:
    """Return the document of some objects."""
    known = _Known()
    written = [_written(root, known) for root in roots]
    return Document(written, [one["id"] for one in written], known.colours, known)


def _written(value: Any, known: _Known) -> Any:
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
        case Token(name):
            found = colour(name)
        case Value(same):
            found = {"type": "value", "value": same}
    return found


def _object(model: Model, known: _Known) -> dict[str, Any]:
    if id(model) in known.names:
        return {"id": known.names[id(model)]}
    name = known.names[id(model)] = f"p{len(known.names) + 1}"
    attributes = {}
    for key, value in vars(model).items():
        if isinstance(value, Token):
            known.colours.setdefault(value.name, []).append([name, key])
        attributes[key] = _written(value, known)
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
