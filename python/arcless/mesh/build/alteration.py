"""The line as built and in the weather → changes of the designed structure, as arrays.

What the arrays of the core are, one entry for each row of the table of wires (or segments), of the
links, of the bends, of the springs or of the struts:

============== ==================================================== =============
length_factor  factor on the rest length of each wire or segment
axial_factor   factor on EA
bending_factor factor on EI of each wire, or of each bend
mass           mass per metre of rest length, in place of the old   kg/m
load           steady force per metre of rest length (n × 3)        N/m
link_factor    factor on the rest length of each link
link_offset    added to that                                        m
spring_offset  added to the rest coordinate of each spring          m
strut_offset   added to the height of each strut's ground point     m
end_force      force along the track on each free end, None: held   N
removed        rows of the links that are gone
============== ==================================================== =============
"""

from collections.abc import Mapping
from dataclasses import replace
from math import cos, pi, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.mesh.tables.mesh_types import Floats, Mesh
from arcless.model.as_built.as_built import AsBuilt
from arcless.model.line.line import Line
from arcless.model.line.parts.components import TensionedWire
from arcless.model.line.places.dropper_names import DropperName, droppers_called, parse_name
from arcless.model.line.places.support_names import supports_called


def alteration(mesh: Mesh, line: Line, built: AsBuilt) -> dict[str, Any]:
    """Return the changes of a designed line as the core takes them; see above."""
    elements = mesh.elements
    is_contact = np.zeros(len(elements), dtype=bool)
    is_contact[mesh.contact_rows] = True
    ends = mesh.positions[elements["nodes"], 0]
    mass_loss, axial, bending = _worn(ends, is_contact, built)
    longer, coats = np.ones(len(elements)), np.zeros(len(elements))
    for name, rows in mesh.wire_rows.items():
        wire: TensionedWire | None = getattr(line, name)
        if wire is None:
            continue
        longer[rows] += built.temperature_difference * wire.thermal_expansion
        coats[rows] = getattr(built.ice, name)
    # A wire that grows longer does not grow heavier.
    bare = elements["mass"] * (1.0 - mass_loss) / longer
    return {
        "length_factor": longer.tolist(),
        "axial_factor": axial.tolist(),
        "bending_factor": _of_bends(mesh, bending).tolist(),
        "mass": (bare + coats).tolist(),
        "load": _loads(mesh, line, built),
        **_of_links(mesh, line, built),
        **_of_supports(mesh, line, built),
        "end_force": end_forces(mesh),
    }


def end_forces(mesh: Mesh, slipping: Mapping[int, float] | None = None) -> list[float | None]:
    """Return the force along the track on each end in N, None where the end holds still.

    `slipping` gives the tension in N of devices with friction that have moved, by row.
    """
    ends, moved = mesh.parts["ends"], slipping or {}
    free = [
        float(force) if released else None
        for force, released in zip(ends["force"], ends["released"], strict=True)
    ]
    for end in mesh.ends:
        if end.row in moved:
            free[end.row] = end.outward * moved[end.row]
    return free


def diameters(mesh: Mesh, line: Line, built: AsBuilt) -> Floats:
    """Return the diameter in m that each wire or segment turns to the wind, ice included."""
    found = np.zeros(len(mesh.elements))
    for name, rows in mesh.wire_rows.items():
        wire: TensionedWire | None = getattr(line, name)
        if wire is not None:
            found[rows] = built.ice.diameter(wire.diameter or 0.0, getattr(built.ice, name))
    return found


def _loads(mesh: Mesh, line: Line, built: AsBuilt) -> Floats:
    """Return the force per metre of rest length on each wire or segment (n × 3) in N/m."""
    thickness = diameters(mesh, line, built)
    load = np.zeros((len(thickness), 3))
    for diameter in np.unique(thickness):
        load[thickness == diameter, 1:] = built.wind.force(float(diameter))
    return load


def without(mesh: Mesh, removed: list[int]) -> Mesh:
    """Return the mesh without the given rows of its links; its droppers' rows follow."""
    kept = np.ones(len(mesh.parts["links"]), dtype=bool)
    kept[removed] = False
    row = np.cumsum(kept) - 1
    droppers = [
        replace(dropper, link=int(row[dropper.link]))
        for dropper in mesh.droppers
        if kept[dropper.link]
    ]
    links = mesh.parts["links"][kept]
    return replace(mesh, droppers=droppers, parts={**mesh.parts, "links": links})


def worn_bending(fraction: float) -> float:
    """Return what is left of the bending stiffness of a round wire worn flat from below.

    Parameters
    ----------
    fraction
        Share of the section that is lost, below 1.

    Notes
    -----
    The flat cuts a segment of half angle φ off the circle: φ − sin φ cos φ = π times the fraction.
    With S = ⅔ sin³φ its first moment about the centre, what is left has the second moment
    π/4 − (φ − sin φ cos φ)/4 − ½ sin³φ cos φ − S²/A about its own centre, for radius 1.
    """
    low, high = 0.0, pi
    for _ in range(60):  # halves π down to rounding
        phi = 0.5 * (low + high)
        low, high = (phi, high) if phi - sin(phi) * cos(phi) < pi * fraction else (low, phi)
    first = 2.0 / 3.0 * sin(phi) ** 3
    left = pi * (1.0 - fraction)
    second = 0.25 * left - 0.5 * sin(phi) ** 3 * cos(phi) - first**2 / left
    return second / (0.25 * pi)


def _worn(
    ends: Floats, is_contact: NDArray[np.bool_], built: AsBuilt
) -> tuple[Floats, Floats, Floats]:
    """Return share of mass lost, factor on EA and factor on EI of each element.

    An element that is worn in part carries one tension all along: its flexibilities add up.
    """
    lost, stretch, bend = (np.zeros(len(ends)) for _ in range(3))
    length = ends[:, 1] - ends[:, 0]
    for worn in built.contact_wire_wear:
        overlap = np.minimum(ends[:, 1], worn.to) - np.maximum(ends[:, 0], worn.from_)
        share = np.where(is_contact, np.clip(overlap / length, 0.0, 1.0), 0.0)
        lost += share * worn.fraction
        stretch += share * (1.0 / (1.0 - worn.fraction) - 1.0)
        bend += share * (1.0 / worn_bending(worn.fraction) - 1.0)
    return lost, 1.0 / (1.0 + stretch), 1.0 / (1.0 + bend)


def _of_bends(mesh: Mesh, bending: Floats) -> Floats:
    """Return the factor on EI of each cubic element, or of each bend of chains.

    Half of the flexibility of a bend lies in either segment.
    """
    if len(mesh.parts["wires"]):
        return bending
    return np.asarray(1.0 / np.mean(1.0 / bending[mesh.parts["bends"]["segments"]], axis=1))


def _of_links(mesh: Mesh, line: Line, built: AsBuilt) -> dict[str, Any]:
    count = len(mesh.parts["links"])
    factor, offset = np.ones(count), np.zeros(count)
    rows = {dropper.name: dropper.link for dropper in mesh.droppers}
    for dropper in mesh.droppers:
        is_hanger = line.hanger is not None and dropper.wires[0] == "auxiliary wire"
        kind = line.hanger if is_hanger and line.hanger is not None else line.dropper
        assert kind is not None
        factor[dropper.link] += built.temperature_difference * kind.thermal_expansion

    def row(name: DropperName) -> int:
        return rows[str(droppers_called(line, name)[0])]

    for error in built.dropper_length_errors:
        offset[row(error.name)] = error.length_error
    return {
        "link_factor": factor.tolist(),
        "link_offset": offset.tolist(),
        "removed": sorted(row(parse_name(name)) for name in built.missing_droppers),
    }


def _of_supports(mesh: Mesh, line: Line, built: AsBuilt) -> dict[str, Any]:
    """Return by how much each spring and strut stands higher than drawn, in m."""
    springs, struts = mesh.parts["springs"], mesh.parts["struts"]
    higher, arms = np.zeros(len(springs)), np.zeros(len(struts))
    for error in built.support_height_errors:
        name = str(supports_called(line, error.name)[0])
        for place in mesh.supports:
            if place.name not in {name, f"{name} wire 1", f"{name} wire 2"}:
                continue
            held = {place.contact_node}
            if place.messenger_spring is not None:
                held.add(int(springs["node"][place.messenger_spring]))
            upright = springs["component"] == mesh.dimension - 1
            higher[upright & np.isin(springs["node"], list(held))] = error.height_error
            if place.steady_arm is not None:
                arms[place.steady_arm] = error.height_error
    return {"spring_offset": higher.tolist(), "strut_offset": arms.tolist()}
