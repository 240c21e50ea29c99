"""Tables of the page theory/line: numbers by what it states, and by other readings of a file.

A reading changes the mesh of a line before its statics, and nothing else.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any
from unittest.mock import patch

import numpy as np
from scipy.interpolate import CubicHermiteSpline, PchipInterpolator
from validation.runs import table

import arcless
from arcless.equilibrium import equilibrium
from arcless.equilibrium.equilibrium import Equilibrium
from arcless.mesh import Mesh, build_mesh
from arcless.mesh.division.smooth_curves import smooth
from arcless.mesh.division.systems import wire_systems
from arcless.mesh.tables.columns import COLUMNS, HELD, UNLOADED

Change = Callable[[Mesh], Mesh]
Curve = Callable[[Any, Any, Any], Any]

OVERLAP, GERMAN = "ac-simple-overlap-275", "germany-re-330-300"
PLANAR, BRIDLES = "en50318-ac-simple-320-planar", "trolley-bridles-60"
PAIR = "ac-simple-320-two-pantographs"


def as_stated(mesh: Mesh) -> Mesh:
    return mesh


@contextmanager
def read(change: Change) -> Iterator[None]:
    """Change every mesh before its statics."""

    def changed(*given: Any) -> Mesh:
        return change(build_mesh(*given))

    with patch.object(equilibrium, "build_mesh", changed):
        yield


def with_tables(mesh: Mesh, **tables: Any) -> Mesh:
    return replace(mesh, parts={**mesh.parts, **tables})


def raised_by(curve: Curve) -> Change:
    """Another curve for the raise of the contact wires in an overlap."""
    systems = wire_systems(arcless.load(OVERLAP).line, {})

    def change(mesh: Mesh) -> Mesh:
        positions = mesh.positions.copy()
        for system, own in zip(mesh.systems, systems, strict=True):
            nodes = [node for wire in system.contact.values() for node in wire]
            given = (own.supports, own.rises, positions[nodes, 0])
            positions[nodes, 2] += curve(*given) - smooth(*given)
        return replace(mesh, positions=positions)

    return change


def along_the_chord(places: Any, values: Any, x: Any) -> Any:
    """The curve with the slopes of the chords at the two anchors."""
    slopes = PchipInterpolator(places, values).derivative()(places)
    slopes[[0, -1]] = (np.diff(values) / np.diff(places))[[0, -1]]
    return CubicHermiteSpline(places, values, slopes)(x)


def held_at_supports(mesh: Mesh) -> Mesh:
    """The contact wire of arms given as springs held at its nominal height at the supports."""
    springs, nodes = mesh.parts["springs"].copy(), [place.contact_node for place in mesh.supports]
    up = springs["component"] == mesh.dimension - 1
    arms = up & np.isin(springs["node"], nodes) & (springs["mode"] == UNLOADED)
    springs["mode"][arms] = HELD
    return with_tables(mesh, springs=springs)


def per_stretched_metre(mesh: Mesh) -> Mesh:
    kind = "wires" if len(mesh.parts["wires"]) else "segments"
    wires = mesh.parts[kind].copy()
    wires["mass"] /= 1.0 + wires["design_tension"] / wires["axial_stiffness"]
    return with_tables(mesh, **{kind: wires})


def bridles_that_run_through(mesh: Mesh) -> Mesh:
    """Chains of bridles that bend in the middle as elsewhere."""
    wire = arcless.load(BRIDLES).line.bridle
    assert wire is not None
    bends = np.zeros(len(mesh.bridles), COLUMNS["bends"])
    for bend, bridle in zip(bends, mesh.bridles, strict=True):
        middle = len(bridle.rows) // 2
        bend["segments"] = bridle.rows[middle - 1 : middle + 1]
        bend["bending_stiffness"], bend["beta"] = wire.bending_stiffness, wire.damping.beta
    return with_tables(mesh, bends=np.concatenate([mesh.parts["bends"], bends]))


@dataclass(frozen=True)
class Reading:
    """Another reading, and the scenario whose line it is tried on."""

    name: str
    scenario: str
    change: Change


READINGS = [
    Reading("raise: three points give the slope at the anchor", OVERLAP,
            raised_by(lambda x, y, at: PchipInterpolator(x, y)(at))),
    Reading("raise: the chord gives the slope at the anchor", OVERLAP, raised_by(along_the_chord)),
    Reading("contact wire held at its height at supports", PLANAR, held_at_supports),
    Reading("contact wire held at its height at supports", GERMAN, held_at_supports),
    Reading("masses per stretched metre", PLANAR, per_stretched_metre),
    Reading("bridles that do not turn in the middle", BRIDLES, bridles_that_run_through),
]  # fmt: skip


def found(reading: Reading, change: Change) -> Equilibrium:
    with read(change):
        return equilibrium.find(arcless.load(reading.scenario))


def held_nodes(line: Equilibrium) -> list[int]:
    """Lower clamps of droppers, supports, and clamps of bridles."""
    clamps = [node for bridle in line.mesh.bridles for node in bridle.nodes[:: len(bridle.rows)]]
    supports = [support.contact_node for support in line.mesh.supports]
    return [dropper.nodes[1] for dropper in line.mesh.droppers] + supports + clamps


def statics_table() -> str:
    rows = []
    for reading in READINGS:
        ours, other = (found(reading, change) for change in (as_stated, reading.change))
        nodes = held_nodes(ours)
        apart = np.abs(other.positions[nodes, 2] - ours.positions[nodes, 2]).max()
        force = "–"
        if ours.mesh.droppers:
            forces, others = (line.of_droppers("link_tension") for line in (ours, other))
            most = int(np.abs(others - forces).argmax())
            changed = 1e2 * (others[most] / forces[most] - 1.0)
            force = f"{forces[most]:.0f} N, {changed:+.1f} %".replace("-", "−")
        line = arcless.load(reading.scenario).line.name
        rows.append((reading.name, line, f"{1e3 * apart:.1f}", force))
    head = ("other reading", "line", "heights differ by, mm", "dropper force, and its change")
    return table(head, rows)


def undamped_clamps(mesh: Mesh) -> Mesh:
    masses = mesh.parts["masses"].copy()
    masses["alpha"] = 0.0
    return with_tables(mesh, masses=masses)


def undamped_tension(mesh: Mesh) -> Mesh:
    """Wires without β: what it takes from stretching and bending is hardly felt across a wire."""
    tables: dict[str, Any] = {}
    for kind in ("wires", "segments", "bends"):
        tables[kind] = mesh.parts[kind].copy()
        tables[kind]["beta"] = 0.0
    return with_tables(mesh, **tables)


DAMPING: dict[str, Change] = {
    "as stated": as_stated,
    "masses of clamps without α": undamped_clamps,
    "β not on the stiffness of tension": undamped_tension,
}


def damping_table() -> str:
    rows = []
    for name, change in DAMPING.items():
        with read(change):
            result = arcless.run(arcless.load(PAIR))
        numbers = ((own.std_force_N, own.min_force_N) for own in result.assessment.pantographs)
        forces = (f"{number:.1f}" for own in numbers for number in own)
        rows.append((name, *(text.replace("-", "−") for text in forces)))
    head = ("damping", "leading: σ N", "min N", "trailing: σ N", "min N")
    return table(head, rows)


QUICK = {"line": {"readings": statics_table}}
SLOW = {"line": {"damping-readings": damping_table}}
