"""Common fields of a model file: as typed, in SI, and what they are."""

from collections.abc import Iterator, Sequence
from typing import Any

from arcless.errors import ModelError
from arcless.model import Scenario
from arcless.model.files.yaml_reader import parse
from arcless.model.variants.variant_files import is_variant
from arcless.studio.model_text.about import ROOTS, about
from arcless.studio.model_text.form_field import told, value_of
from arcless.studio.model_text.places import Place, places
from arcless.studio.model_text.variant_form import TRAIN, variant_groups
from arcless.studio.project.kinds import kind_of

Path = tuple[str | int, ...]
STEADY_ARM = "steady_arm"
# Titles of the groups of a line, the part that they are of, and its common fields.
WIRE = ("catalogue", "tension", "mass", "bending_stiffness", "axial_stiffness")
LINE = (
    ("Contact wire", "contact_wire", WIRE),
    ("Messenger wire", "messenger_wire", WIRE),
    ("Auxiliary wire", "auxiliary_wire", WIRE),
    ("Stitch wires", "stitch_wire", ("length", "tension", "mass")),
    ("Geometry", "geometry", ("contact_wire_height", "encumbrance", "stagger_contact_wire",
                              "stagger_messenger_wire")),
    ("Droppers", "dropper", ("stiffness", "mass", "clamp_mass_contact_wire",
                             "clamp_mass_messenger_wire")),
    ("Supports", "support", ("vertical_stiffness", "vertical_damping", "mass")),
    ("Steady arms", STEADY_ARM, ("kind", "length", "slope", "vertical_stiffness")),
)  # fmt: skip
# Fields that stand in place of others: offered where they are given.
EXCLUSIVE = ("presag", "lengths", "static_force", "mean_force")
# Lists of a span type with one value for each dropper.
DROPPERS, OF_DROPPERS = "droppers", ("positions", "presag", "lengths")
MASS = ("mass", "stiffness", "damping")


def form(text: str, label: str, scenario: Scenario | None = None) -> dict[str, Any]:
    """Return groups of fields; none of a text that is no YAML, or no model.

    Parameters
    ----------
    text
        The text of a line, a pantograph or a scenario.
    label
        Path of the file in the project.
    scenario
        Of the text, where it is a variant of another one: what it leaves as it is there.
    """
    kind = kind_of(text)
    if kind not in ROOTS:
        return {"groups": []}
    try:
        data, _ = parse(text, label)
        found = places(text, label)
    except ModelError:  # the check says what is wrong
        return {"groups": []}
    if kind == "scenario" and is_variant(data):
        return {"groups": variant_groups(data, found, scenario)}
    groups = []
    for title, paths in _groups(kind, data):
        own = [_field(kind, path, data, found) for path in paths]
        groups.append({"title": title, "fields": [one for one in own if one is not None]})
    return {"groups": [group for group in groups if group["fields"]]}


def _groups(kind: str, data: dict[str, Any]) -> Iterator[tuple[str, list[Path]]]:
    if kind == "line":
        yield from _line(data, ())
    elif kind == "pantograph":
        masses = _at(data, ("masses",))
        for index in range(len(masses) if isinstance(masses, list) else 0):
            yield f"Mass {index + 1}", [("masses", index, name) for name in MASS]
    else:
        is_within = isinstance(data.get("line"), dict)
        yield "Run", [*([] if is_within else [("line",)]), ("speed",)]
        trains = _at(data, ("pantographs",))
        for index in range(len(trains) if isinstance(trains, list) else 0):
            yield f"Pantograph {index + 1}", [("pantographs", index, name) for name in TRAIN]
        if isinstance(line := data.get("line"), dict):
            yield from _line(line, ("line",))


def _line(line: dict[str, Any], before: Path) -> Iterator[tuple[str, list[Path]]]:
    for title, part, names in LINE:
        if isinstance(_at(line, (part,)), dict):
            yield title, [(*before, part, name) for name in names]
    yield "Spans", [(*before, "spans")]
    types = _at(line, ("span_types",))
    for name in types if isinstance(types, dict) else ():
        own = (*before, "span_types", name)
        droppers = [(*own, DROPPERS, key) for key in OF_DROPPERS]
        yield f"Span type {name}", [(*own, "length"), *droppers]


def _at(data: Any, path: Sequence[str | int]) -> Any:
    """Return what is typed at a path, None where nothing is; a value without its source."""
    for part in path:
        data = value_of(data)
        is_there = (isinstance(data, dict) and part in data) or (
            isinstance(data, list) and isinstance(part, int) and part < len(data)
        )
        data = data[part] if is_there else None
    return value_of(data)


def _field(
    kind: str, path: Path, data: dict[str, Any], found: dict[str, Place]
) -> dict[str, Any] | None:
    known, typed = about(kind, path), _at(data, path)
    if known is None or isinstance(typed, dict):
        return None
    # A field that is not given is offered where a number can be typed, and no other excludes it.
    if typed is None and (known.unit is None or path[-1] in EXCLUSIVE or STEADY_ARM in path):
        return None
    field = ".".join(map(str, path))
    is_of_droppers = path[-2:-1] == (DROPPERS,) and path[-1] in OF_DROPPERS
    together = ".".join(map(str, path[:-1])) if is_of_droppers else None
    return told(field, str(path[-1]), typed, known, found.get(field), together=together)
