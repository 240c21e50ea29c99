"""The base of the three file formats, and the provenance of their values.

The form ``{value: 22 kN, mark: A, source: S1, note: "…"}`` is taken apart when a document (line,
pantograph, scenario) is validated; the provenance is kept next to the plain data.
"""

import re
from collections.abc import Callable, Mapping
from functools import cached_property
from typing import Any, Self

from pydantic import Field, ModelWrapValidatorHandler, model_validator

from arcless.errors import ModelError
from arcless.model.fields.as_typed import Given, given_in
from arcless.model.fields.part import Mark, Name, Part, Path, after_comma, nearest
from arcless.units import plain, show

MARKS: dict[str, str] = {
    "A": "read in the named source",
    "A'": "read in the named source, which took it from elsewhere",
    "B": "quoted by the named source from another one that was not read",
    "C": "from memory, not found in a readable source",
    "C*": "from memory; a quick computation agrees with it",
    "D": "computed from other data",
    "assumed": "chosen for this model; the note says why",
}
# The keys of a value that says where it comes from.
WRAPPED_IN = ("value", "mark", "source", "note")
MAX_DEPTH = 40
# Control characters except line breaks and tabs, and marks that turn the direction of writing.
_STEERING = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]"
)
FIRST_PRINTED = 0xA0
# Of `sources` and `provenance`: the section, an entry of it, a field of that.
MOST_LEVELS = 3
# Of a table with thousands of rows, a note of where it comes from needs no copy.
MAX_WRITTEN = 2000


class Provenance(Part):
    """Where a value comes from."""

    mark: Mark | None = Field(default=None, description="A, A', B, C, C*, D or assumed.")
    source: str | None = Field(default=None, description="Keys of sources, with commas.")
    note: str | None = Field(default=None, description="Why assumed, how computed, what is odd.")
    given: str = Field(default="", description="The value as it was written.")

    @property
    def source_keys(self) -> list[str]:
        """The keys of sources that are named."""
        return [key for part in (self.source or "").split(",") if (key := part.strip())]


class Document(Part):
    """Base of the three file formats: a name, a description, sources and provenance."""

    name: Name = Field(description="Short name, used in lists and in file names.", min_length=1)
    description: str = Field(default="", description="What it is, in a sentence.")
    sources: dict[str, str] = Field(
        default_factory=dict, description="Citation of each source key used below."
    )
    provenance: dict[str, Provenance] = Field(
        default_factory=dict, description="Origin of each value, by dotted path of its field."
    )

    @model_validator(mode="before")
    @classmethod
    def _take_provenance(cls, data: object) -> object:
        if not isinstance(data, Mapping):
            return data
        found: dict[str, Any] = {}
        for name in ("sources", "provenance"):
            _check_texts(data.get(name), (name,))
        plain = {
            key: value if key in {"sources", "provenance"} else unwrap(value, (key,), found.update)
            for key, value in data.items()
        }
        given = plain.get("provenance")
        # Anything that is no mapping is left for its own field to refuse.
        if found and (given is None or isinstance(given, Mapping)):
            plain["provenance"] = {**(given or {}), **found}
        return cls.prepare(plain)

    @classmethod
    def prepare(cls, data: dict[str, Any]) -> dict[str, Any]:
        """Return the plain data with what a document fills in by itself."""
        return data

    @model_validator(mode="wrap")
    @classmethod
    def _keep_given(cls, data: object, make: ModelWrapValidatorHandler[Self]) -> Self:
        made = make(data)
        if isinstance(data, Mapping):
            made.remember(given_in(data))
        return made

    @cached_property
    def given(self) -> Given | None:
        """Values as given, by dotted path, with their text where there was one; None: not known.

        It is kept outside the data: it plays no part in whether two documents are equal.
        """
        return None

    def remember(self, given: Given | None) -> None:
        """Keep what was given for this document; None: it is not known."""
        self.__dict__["given"] = given

    def as_typed(self, path: str) -> str | None:
        """Return a value as it was typed, ``22 kN``; None where a number was given, or nothing.

        Parameters
        ----------
        path
            Dotted path of the field, items of lists numbered from 0.
        """
        text = (self.given or {}).get(path)
        origin = self.provenance.get(path)
        return text or (origin.given or None if origin is not None else None)

    def is_given(self, path: str) -> bool | None:
        """Return whether a field, or the group it is in, was given; None where that is unknown."""
        if path in self.provenance:
            return True
        if self.given is None:
            return None
        parts = path.split(".")
        return any(".".join(parts[:count]) in self.given for count in range(len(parts), 0, -1))

    def origin_of(self, path: str) -> Provenance | None:
        """Return the provenance of a field by dotted path: its own, or that of its group."""
        parts = path.split(".")
        for count in range(len(parts), 0, -1):
            entry = self.provenance.get(".".join(parts[:count]))
            if entry is not None:
                return entry
        return None

    def __repr__(self) -> str:
        about = "; ".join(self.in_words())
        return f"<{type(self).__name__} {plain(self.name)}{': ' if about else ''}{about}>"

    def in_words(self) -> list[str]:
        """Return what it is, in a few words each, for a prompt."""
        return []

    def to_dict(self) -> dict[str, Any]:
        """Return plain data (SI, provenance included) from which loading makes an equal model."""
        return self.model_dump(mode="json", by_alias=True)

    @model_validator(mode="after")
    def _check_sources(self) -> "Document":
        for path, entry in self.provenance.items():
            for key in entry.source_keys:
                if key not in self.sources:
                    raise ModelError(
                        "unknown source",
                        got=show(key),
                        expected="a key of sources",
                        hint=nearest(key, list(self.sources)) if self.sources else "add sources:",
                        field=("provenance", path, "source"),
                    )
        return self


def unwrap(value: Any, path: Path, keep: Callable[[dict[str, Any]], None]) -> Any:
    """Return `value` without its provenance mappings; hand each of those to `keep`.

    A nested document keeps its own provenance, so it is left as it is.
    """
    if len(path) > MAX_DEPTH:
        raise ModelError("nested too deep", expected=f"at most {MAX_DEPTH} levels", field=path[:1])
    if isinstance(value, str):
        _check_characters(value, path)
    if isinstance(value, Mapping):
        for key in value:
            _check_characters(str(key), path)
        if "format" in value:
            return value
        if "value" in value:
            _check_wrapper(value, path)
            entry = {key: item for key, item in value.items() if key != "value"}
            keep({dotted(path): {**entry, "given": written(value["value"])}})
            return unwrap(value["value"], path, keep)
        return {key: unwrap(item, (*path, key), keep) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [unwrap(item, (*path, index), keep) for index, item in enumerate(value)]
    return value


def _check_texts(value: object, path: Path) -> None:
    """Check the texts of `sources` or `provenance`, two levels deep; more is refused elsewhere."""
    items = value.items() if isinstance(value, Mapping) and len(path) < MOST_LEVELS else ()
    for key, item in items:
        _check_characters(str(key), path)
        _check_texts(item, (*path, str(key)))
    if isinstance(value, str):
        _check_characters(value, path)


def _check_characters(text: str, path: Path) -> None:
    """Refuse what steers a terminal or turns the direction of writing, in names as in texts."""
    found = _STEERING.search(text)
    if found is not None:
        code = f"U+{ord(found.group()):04X}"
        kind = (
            "a control character" if ord(found.group()) < FIRST_PRINTED else "a mark of direction"
        )
        raise ModelError(
            "character that does not print",
            got=f"{kind}, {code}, in {show(text)}",
            expected="characters that print",
            field=path,
        )


def _check_wrapper(value: Mapping[str, Any], path: Path) -> None:
    for key in value:
        if key not in WRAPPED_IN:
            raise ModelError(
                "unknown field next to a value",
                got=show(key),
                expected=", ".join(WRAPPED_IN),
                hint=after_comma(key, value) or "write a note that contains a comma in quotes",
                field=(*path, key),
            )


def dotted(path: Path) -> str:
    """Return the dotted form of a field path: ``("masses", 2, "mass")`` → ``masses.2.mass``."""
    return ".".join(str(part) for part in path)


def printed(path: Path) -> str:
    """Return a field path for a message: names come from a file, and may hold anything."""
    return ".".join(plain(str(part)) for part in path)


def written(value: object) -> str:
    """Return a value as it stood in the file, in one line; of long lists and tables the start."""
    text = _in_line(value)
    return text if len(text) <= MAX_WRITTEN else f"{text[:MAX_WRITTEN]}…"


def _in_line(value: object) -> str:
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(_in_line(item) for item in value)}]"
    if isinstance(value, Mapping):
        return f"{{{', '.join(f'{key}: {_in_line(item)}' for key, item in value.items())}}}"
    return str(value)
