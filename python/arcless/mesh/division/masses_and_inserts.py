"""Masses and inserts on the wires of a system."""

from collections.abc import Iterator

from arcless.mesh.division.systems import WireSystem
from arcless.mesh.division.wire_names import AUXILIARY, MESSENGER
from arcless.model.line.line import Line
from arcless.model.line.parts.components import TensionedWire
from arcless.model.line.parts.masses_and_inserts import Insert


def masses(line: Line, system: WireSystem) -> Iterator[tuple[str, float, float]]:
    """Yield wire, place in m and mass in kg of each point mass; twin wires carry it each."""
    for mass in line.point_masses:
        if line.tension_length_of(mass, mass.position, mass.position) == system.number:
            for wire in _wires(system, mass.wire):
                yield wire, mass.position, mass.mass
    joints = line.contact_wire.joints
    if joints is not None:
        for x in joints.places(line.total_length):
            if system.supports[0] < x < system.supports[-1]:
                for wire in system.contact_wires:
                    yield wire, x, joints.mass


def inserts(line: Line, system: WireSystem, wire: str) -> list[Insert]:
    """Return the inserts of a wire of this system."""
    return [
        insert
        for insert in line.inserts
        if line.tension_length_of(insert, *insert.ends) == system.number
        and wire in _wires(system, insert.wire)
    ]


def places_on_wires(line: Line, system: WireSystem) -> dict[str, list[float]]:
    """Return by wire the places in m at which masses and inserts need a node."""
    found: dict[str, list[float]] = {}
    for wire, x, _ in masses(line, system):
        found.setdefault(wire, []).append(x)
    for wire in (*system.contact_wires, MESSENGER, AUXILIARY):
        for insert in inserts(line, system, wire):
            found.setdefault(wire, []).extend(insert.ends)
    first, last = system.supports[0], system.supports[-1]
    return {wire: [min(max(x, first), last) for x in places] for wire, places in found.items()}


def inserted(wire: TensionedWire, insert: Insert) -> TensionedWire:
    """Return what a piece of wire is where there is an insert; it keeps tension and damping."""
    return wire.model_copy(
        update={
            "mass": insert.mass / insert.length,
            "axial_stiffness": insert.axial_stiffness,
            "bending_stiffness": insert.bending_stiffness,
        }
    )


def _wires(system: WireSystem, field: str) -> list[str]:
    if field == "contact_wire":
        return list(system.contact_wires)
    return [{"messenger_wire": MESSENGER, "auxiliary_wire": AUXILIARY}[field]]
