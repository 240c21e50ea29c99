"""Base class of all parts of a model: units, provenance, and refusal of unknown fields.

A value in a file is a number in SI, a text with its unit, or a mapping that also says where the
value comes from: ``{value: 22 kN, mark: A, source: S1, note: "…"}``; see `documents`.
"""

import re
from collections.abc import Mapping, Sequence, Sized
from difflib import get_close_matches
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    model_validator,
)
from pydantic_core import core_schema

from arcless.errors import ModelError
from arcless.model.fields.field_names import names_of
from arcless.model.fields.missing_units import meant_unit
from arcless.units import (
    DECIMAL_POINT,
    MAX_TEXT,
    WRONG_VALUE,
    accepted,
    pattern,
    plain,
    show,
    spell,
    to_si,
)

Path = tuple[str | int, ...]
UNKNOWN_FIELD = "unknown field"
# So many names are listed whole where a name is unknown; of more, the first ones.
FEW = 10
Mark = Literal["A", "A'", "B", "C", "C*", "D", "assumed"]


class Unit:
    """Annotation of a number: its SI unit and the bounds it must keep.

    Parameters
    ----------
    unit : str
        SI unit, a key of `arcless.units.KINDS`.
    above, minimum, below, maximum : float, optional
        Bounds in that unit; `above` and `below` exclude the bound itself.
    words : tuple of str, optional
        Words that may stand for a number; they are kept as they are.
    """

    def __init__(
        self,
        unit: str,
        *,
        above: float | None = None,
        minimum: float | None = None,
        below: float | None = None,
        maximum: float | None = None,
        words: tuple[str, ...] = (),
    ) -> None:
        self.unit, self.words = unit, words
        self.above, self.minimum = above, minimum
        self.below, self.maximum = below, maximum

    @property
    def label(self) -> str:
        """The unit as printed, e.g. ``N m²``."""
        return spell(self.unit)

    @property
    def bounds(self) -> str:
        """The bounds in words; empty when there are none."""
        words = ("above", "at least", "below", "at most")
        values = (self.above, self.minimum, self.below, self.maximum)
        suffix = "" if self.unit == "1" else f" {self.label}"
        kept = [
            f"{word} {value:g}{suffix}"
            for word, value in zip(words, values, strict=True)
            if value is not None
        ]
        return " and ".join(kept)

    @property
    def expected(self) -> str:
        """Accepted values: kind, units, bounds and words."""
        words = [f"or {show(word)}" for word in self.words]
        return ", ".join(filter(None, [accepted(self.unit), self.bounds, *words]))

    def validate(self, value: object) -> float | str:
        """Return `value` in SI or as the word it is, or raise what is wrong with it."""
        if isinstance(value, str) and value.strip() in self.words:
            return value.strip()
        try:
            number = to_si(value, self.unit)
        except ModelError as error:
            if self.words:
                error.expected = self.expected
            raise
        if not self._holds(number):
            hint = meant_unit(value, self.unit, self._holds)
            raise ModelError(WRONG_VALUE, got=show(value), expected=self.expected, hint=hint)
        return number

    def _holds(self, number: float) -> bool:
        """Return whether a number in SI keeps the bounds."""
        return (
            (self.above is None or number > self.above)
            and (self.minimum is None or number >= self.minimum)
            and (self.below is None or number < self.below)
            and (self.maximum is None or number <= self.maximum)
        )

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_before_validator_function(self.validate, handler(source))

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        keys = ("exclusiveMinimum", "minimum", "exclusiveMaximum", "maximum")
        values = (self.above, self.minimum, self.below, self.maximum)
        bounds = {key: value for key, value in zip(keys, values, strict=True) if value is not None}
        number = ({"type": "number"} if self.words else handler(schema)) | bounds
        wanted = f"number and unit: {accepted(self.unit)}"
        text = {"type": "string", "description": wanted, "pattern": pattern(self.unit)}
        text["patternErrorMessage"] = f"expected a {wanted}"  # of editors: else they show pattern
        plain = [number, text, *({"const": word} for word in self.words)]
        return {"anyOf": [*plain, wrapped_schema(plain)], "unit": self.label}


def _printed(text: str) -> str:
    """Refuse a name of several lines: names are printed, and become names of files."""
    if re.search("[\t\n]", text):
        raise ModelError(WRONG_VALUE, got=show(text), expected="a name in one line, without tabs")
    return text


Name = Annotated[str, AfterValidator(_printed)]
Lengths = tuple[Annotated[float, Unit("m", minimum=-1e6, maximum=1e6)], ...]


def wrapped_schema(values: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the JSON Schema of a value given with its provenance."""
    return {
        "type": "object",
        "properties": {
            "value": values[0] if len(values) == 1 else {"anyOf": values},
            "mark": {"enum": list(get_args(Mark))},
            "source": {"type": "string"},
            "note": {"type": "string"},
        },
        "required": ["value"],
        "additionalProperties": False,
    }


def nearest(name: str, known: Sequence[str]) -> str:
    """Return the hint for an unknown name: the nearest known one, or all of them, if few."""
    # No name of ours is longer; to look for a long text among many takes seconds.
    close = get_close_matches(name, known, n=1) if len(name) <= MAX_TEXT else []
    if close:
        return f"did you mean {plain(close[0])}?"
    shown = [plain(one) for one in (known if len(known) <= FEW else known[: FEW - 2])]
    more = f" and {len(known) - len(shown)} more" if len(shown) < len(known) else ""
    return f"known: {', '.join(shown)}{more}"


def after_comma(name: object, data: Mapping[Any, Any]) -> str | None:
    """Return the hint for a field that is what stands behind a decimal comma, or None.

    In braces ``tension: 10,5 kN`` is two fields, `tension` and `5 kN`, the second without a value.
    """
    names = list(data)
    place = names.index(name)
    before = data[names[place - 1]] if place else None
    is_rest = isinstance(name, str) and name[:1].isdigit() and data[name] is None
    if not is_rest or isinstance(before, bool) or not isinstance(before, int):
        return None
    number = f"{before}.{plain(str(name))}"
    return f"{DECIMAL_POINT}: {names[place - 1]}: {number}"


# Characters of the fields that a prompt shows of a part.
LONGEST_REPR = 150
# Steps of reading a file, which are no use to a user of what was read.
_OF_READING = frozenset({"card_parts", "field_names", "in_words", "prepare", "remember"})
_OF_PYDANTIC = frozenset(name for name in dir(BaseModel) if not name.startswith("_"))


class Part(BaseModel):
    """Base of every piece of a model: frozen, finite, and without unknown fields."""

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        allow_inf_nan=False,
        populate_by_name=True,
        defer_build=True,  # halves the import time; validators are built at first use
    )

    def __dir__(self) -> list[str]:
        """Return the names to complete: fields and methods of the model, not those of pydantic."""
        fields = type(self).model_fields
        hidden = _OF_PYDANTIC | _OF_READING
        return [name for name in super().__dir__() if name in fields or name not in hidden]

    def __repr__(self) -> str:
        """Return the fields that were given, in a line that is never long."""
        given = [name for name in type(self).model_fields if name in self.model_fields_set]
        fields = ", ".join(f"{name}={getattr(self, name)!r}" for name in given)
        fields = fields if len(fields) <= LONGEST_REPR else f"{fields[:LONGEST_REPR]}…"
        return f"{type(self).__name__}({fields})"

    def __str__(self) -> str:
        return repr(self)

    if not TYPE_CHECKING:

        def __setattr__(self, name: str, value: Any) -> None:
            """Refuse: models never change; what they found out about themselves may be kept."""
            if not name.startswith("_"):
                raise self._unchangeable(name)
            super().__setattr__(name, value)

        def __delattr__(self, name: str) -> None:
            """Refuse: models never change."""
            raise self._unchangeable(name)

    def _unchangeable(self, name: str) -> ModelError:
        kind = type(self).__name__
        hint = 'with_(speed="300 km/h"), of a scenario, returns a changed copy'
        expected = "a model that stays as it is"
        return ModelError(f"{kind} cannot be changed", got=show(name), expected=expected, hint=hint)

    @model_validator(mode="before")
    @classmethod
    def _check_names(cls, data: object) -> object:
        if isinstance(data, BaseModel):
            return data
        if not isinstance(data, Mapping):
            expected = f"a mapping with {', '.join(cls.field_names())}"
            raise ModelError("not a mapping", got=show(data), expected=expected)
        taken, needed, longest = names_of(cls)
        for key in data:
            if key not in taken:
                raise ModelError(
                    UNKNOWN_FIELD,
                    got=show(key),
                    expected=f"a field of the {cls.__name__.lower()}",
                    hint=after_comma(key, data) or nearest(str(key), cls.field_names()),
                    field=(key if isinstance(key, int) else str(key),),
                )
        for name, alias in needed:
            if name not in data and alias not in data:
                raise ModelError("missing field", expected=cls._expected(name), field=(alias,))
        for name, most in longest:
            # Refused before thousands of items are read, each with a mistake of its own.
            if name in data and isinstance(data[name], Sized) and len(data[name]) > most:
                got = show(data[name])
                raise ModelError(
                    WRONG_VALUE, got=got, expected=f"at most {most} items", field=(name,)
                )
        return data

    @classmethod
    def field_names(cls) -> list[str]:
        """Return the names of the fields as they are written in files."""
        return [field.alias or name for name, field in cls.model_fields.items()]

    @classmethod
    def _expected(cls, name: str) -> str:
        unit = find_unit(cls.model_fields[name])
        text = (cls.model_fields[name].description or name).rstrip(".")
        return text if unit is None else f"{text}: {unit.expected}"

    @classmethod
    def __pydantic_init_subclass__(cls, **kwargs: Any) -> None:
        """Put the unit of each field into its metadata, where results and reports look it up."""
        super().__pydantic_init_subclass__(**kwargs)
        for field in cls.model_fields.values():
            unit = find_unit(field)
            if unit is not None:
                field.json_schema_extra = {"unit": unit.label}


def find_unit(annotated: Any) -> Unit | None:
    """Return the first `Unit` in an annotation or a pydantic field, also inside a list."""
    metadata: Any = getattr(annotated, "metadata", None) or getattr(annotated, "__metadata__", ())
    for item in metadata:
        if isinstance(item, Unit):
            return item
    inner = getattr(annotated, "annotation", None)
    children = get_args(annotated) if inner is None else (inner,)
    for child in children:
        unit = find_unit(child)
        if unit is not None:
            return unit
    return None
