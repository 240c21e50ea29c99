"""Fields of the model file behind what is drawn: a dropper's position, the stagger at a support.

What is dragged in the drawing, or picked there, is one value of the text. A pattern of staggers is
repeated along the line, and a span type is the type of many spans: such a value moves them all.
"""

from collections.abc import Iterator
from typing import TypedDict

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.equilibrium.line_alone import LineAlone
from arcless.errors import ModelError
from arcless.mesh import DropperPlace
from arcless.model import Line, Scenario
from arcless.model.files.yaml_reader import parse
from arcless.model.line.places.dropper_names import parse_name


class Handle(TypedDict):
    """A field of the text, as a dotted path, and the place in m that its value counts from."""

    field: str
    from_m: float


class Handles(TypedDict):
    """Fields of droppers and supports in the order of a geometry; None where there is none."""

    droppers: list[Handle | None]
    supports: list[Handle | None]


def handles(text: str, source: Scenario | LineAlone, found: Equilibrium) -> Handles:
    """Return the fields behind droppers and supports of a line at rest.

    Parameters
    ----------
    text
        The model file; of a scenario that only names its line it has none of these fields.
    source
        What the text says.
    found
        Its line at rest.
    """
    line, is_within, mesh = source.line, isinstance(source, Scenario), found.mesh
    if is_within and not isinstance(parse(text, "scenario")[0].get("line"), dict):
        return {"droppers": [None] * len(mesh.droppers), "supports": [None] * len(mesh.supports)}
    before = "line." if is_within else ""
    places, types = line.support_positions(), _types(line)
    return {
        "droppers": [_of_dropper(one, types, places, before) for one in mesh.droppers],
        "supports": list(_of_supports(line, found, before)),
    }


def _types(line: Line) -> list[str]:
    """Return the name of the type of each span."""
    return [run.type for run in line.spans for _ in range(run.count)]


def _of_dropper(
    dropper: DropperPlace, types: list[str], places: list[float], before: str
) -> Handle | None:
    try:
        name = parse_name(dropper.name)
    except ModelError:  # hangers of an auxiliary wire have other names
        return None
    field = f"{before}span_types.{types[name.span - 1]}.droppers.positions.{name.dropper - 1}"
    return {"field": field, "from_m": places[name.span - 1]}


def _of_supports(line: Line, found: Equilibrium, before: str) -> Iterator[Handle | None]:
    """Yield the stagger at each support; in overlaps and of twin wires it is not the field's."""
    pattern, places = line.geometry.stagger_contact_wire, line.support_positions()
    is_plain = bool(pattern) and not line.has_overlaps and len(found.mesh.contact_wires) == 1
    for support in found.mesh.supports:
        if not is_plain:
            yield None
            continue
        index = places.index(support.x) % len(pattern)
        yield {"field": f"{before}geometry.stagger_contact_wire.{index}", "from_m": 0.0}
