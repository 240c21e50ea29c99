"""The shipped catalogue of wires, which line files may name instead of writing them out."""

from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

from pydantic import Field

from arcless.errors import ModelError
from arcless.model.fields.document import Document
from arcless.model.fields.part import Part, Unit, nearest
from arcless.model.files.yaml_reader import parse, read_text
from arcless.model.line.parts.components import TensionedWire
from arcless.units import show

FILE = Path(__file__).resolve().parent.parent.parent / "models" / "wires.yaml"
# Source keys of the catalogue get this before them in a line, which has keys of its own.
PREFIX = "wires "


class CatalogueWire(Part):
    """Properties of a wire that do not depend on its tension."""

    description: str = Field(description="Material, section and where it is used.")
    mass: Annotated[float, Unit("kg/m", above=0)] = Field(description="Mass per metre.")
    axial_stiffness: Annotated[float, Unit("N", above=0)] = Field(description="Axial stiffness EA.")
    bending_stiffness: Annotated[float, Unit("N m2", minimum=0)] = Field(
        description="Bending stiffness EI."
    )
    diameter: Annotated[float, Unit("m", above=0, maximum=0.2)] | None = Field(
        default=None, description="Diameter of the bare wire."
    )


class Catalogue(Document):
    """The wires by name."""

    format: Literal["arcless-wires/1"] = Field(description="Format, version.")
    wires: dict[str, CatalogueWire] = Field(description="Wires by name.", min_length=1)


# Fields that a catalogue entry can give a wire of a line.
GIVES = tuple(name for name in CatalogueWire.model_fields if name != "description")


@cache
def catalogue() -> Catalogue:
    """Return the shipped catalogue."""
    data, _ = parse(read_text(FILE, FILE.name), FILE.name)
    return Catalogue.model_validate(data)


def entry_text(name: str) -> str | None:
    """Return the entry of a wire as it stands in the catalogue, with its sources; None without."""
    wire = catalogue().wires.get(name)
    if wire is None:
        return None
    lines = read_text(FILE, FILE.name).splitlines()
    begin = lines.index(f"  {name}:")
    others = (k for k in range(begin + 1, len(lines)) if not lines[k].startswith("    "))
    entry = [line[2:] for line in lines[begin : next(others, len(lines))]]
    book = catalogue()
    cited = {key for part in GIVES if (found := book.provenance.get(f"wires.{name}.{part}"))
             for key in found.source_keys}  # fmt: skip
    sources = [f"# {key}: {book.sources[key]}" for key in book.sources if key in cited]
    head = f"# Wire of the catalogue: a line takes it by `catalogue: {name}`, with a tension."
    return "\n".join([head, *entry, *sources]) + "\n"


def with_catalogue(line: type[Document], data: dict[str, Any]) -> dict[str, Any]:
    """Return the data of a line with what the wires it names have; values given in it stay."""
    filled = dict(data)
    for name in _wire_fields(line):
        wire = data.get(name)
        if not isinstance(wire, Mapping) or not isinstance(wire.get("catalogue"), str):
            continue
        # `mass: null` asks for the catalogue's value; what is no field is left to be refused.
        given = {key: value for key, value in wire.items() if value is not None or key not in GIVES}
        missing = [key for key in GIVES if key not in given]
        entry = _entry(name, wire["catalogue"])
        values = {key: getattr(entry, key) for key in missing if getattr(entry, key) is not None}
        filled[name] = {**given, **values}
        _add_provenance(filled, name, wire["catalogue"], list(values))
    return filled


def _wire_fields(line: type[Document]) -> Iterator[str]:
    """Yield the names of the fields of a line that hold a wire."""
    for name, field in line.model_fields.items():
        kinds = get_args(field.annotation) or (field.annotation,)
        if any(isinstance(kind, type) and issubclass(kind, TensionedWire) for kind in kinds):
            yield name


def _entry(field: str, name: str) -> CatalogueWire:
    known = catalogue().wires
    if name not in known:
        raise ModelError(
            "unknown wire",
            got=show(name),
            expected="the name of a wire in the catalogue, or mass, axial_stiffness and "
            "bending_stiffness in its place",
            hint=nearest(name, _fitting(field)),
            field=(field, "catalogue"),
        )
    return known[name]


def _fitting(field: str) -> list[str]:
    """Return the wires that a field may mean: contact wires there, strands elsewhere."""
    wanted = "contact wire" if field == "contact_wire" else "strand"
    wires = catalogue().wires
    return [name for name, wire in wires.items() if wanted in wire.description.lower()]


def _add_provenance(data: dict[str, Any], field: str, wire: str, keys: list[str]) -> None:
    """Say of each value from the catalogue where the catalogue has it from."""
    book = catalogue()
    given = [data.get(name) for name in ("provenance", "sources")]
    if not all(one is None or isinstance(one, Mapping) for one in given):
        return  # their own fields refuse that
    known, sources = (dict(one or {}) for one in given)
    for key in keys:
        origin = book.provenance[f"wires.{wire}.{key}"]
        cited = origin.source_keys
        sources |= {f"{PREFIX}{part}": book.sources[part] for part in cited}
        entry = origin.model_dump(exclude_none=True)
        if cited:
            entry["source"] = ", ".join(f"{PREFIX}{part}" for part in cited)
        known[f"{field}.{key}"] = entry
    data["provenance"], data["sources"] = known, sources
