"""A line as it is built, for Exudyn: division into cables, lengths, heights and hinges of a design.

A design may have been made with other elements, or with chains. What a design says to those who
build is the length of each wire between the places where something holds it; between two of them
the cables are equally long.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.mesh import Mesh
from arcless.model import Scenario

WIRES = ("contact_wire", "messenger_wire")


def same_wire(tension: float, stiffness: float) -> float:
    """Length of a wire with N = EA (λ−1) over that with N = EA ½ (λ²−1) λ, equal when taut."""
    stretch = 1.0 + tension / stiffness
    for _ in range(5):  # Newton, from a start that is off by 1e-6
        force = 0.5 * stiffness * (stretch**2 - 1.0) * stretch
        stretch -= (force - tension) / (stiffness * (1.5 * stretch**2 - 0.5))
    return stretch / (1.0 + tension / stiffness)


@dataclass(frozen=True)
class Built:
    """Division and design of a line.

    Attributes
    ----------
    mesh : division into cables, by the product's cubic elements
    wire_length : unstretched length of each cable, m, for N = EA (λ − 1)
    link_length : unstretched length of each dropper, m
    spring_rest : coordinate of the wire at which a spring to ground is free of force, m
    hinge : place of the hinge of each steady arm, m
    """

    mesh: Mesh
    wire_length: Any
    link_length: Any
    spring_rest: Any
    hinge: Any

    @classmethod
    def of(
        cls, scenario: Scenario, design: Equilibrium, division: Equilibrium | None = None
    ) -> "Built":
        """Build a design with its own elements, or with those of another division of the line."""
        mesh = design.mesh if division is None else division.mesh
        length = np.array((division or design).arrays["wire_rest_length"])
        for name in WIRES:
            wire = getattr(scenario.line, name)
            # A chain has Exudyn's law.
            shorter = 1.0 if len(design.mesh.parts["segments"]) else same_wire(
                wire.tension, wire.axial_stiffness
            )  # fmt: skip
            if division is None:
                length[mesh.wire_rows[name]] *= shorter
                continue
            pairs = zip(_pieces(design.mesh, name), _pieces(mesh, name), strict=True)
            for given, rows in pairs:
                whole = shorter * design.arrays["wire_rest_length"][given].sum()
                length[rows] *= whole / length[rows].sum()
        arrays, arms = design.arrays, len(design.mesh.parts["struts"])
        hinges = arrays["strut_anchor"].reshape(arms, mesh.dimension)
        return cls(mesh, length, arrays["link_rest_length"], arrays["spring_rest"], hinges)


def _pieces(mesh: Mesh, name: str) -> Iterator[Sequence[int]]:
    """Yield the rows of a wire between two places where droppers, arms or springs hold it."""
    parts = mesh.parts
    held = {int(node) for node in parts["links"]["nodes"].ravel()}
    held |= {int(node) for part in ("springs", "struts", "fixed") for node in parts[part]["node"]}
    rows: list[int] = []
    for row in mesh.wire_rows[name]:
        rows.append(row)
        if int(mesh.elements["nodes"][row][1]) in held:
            yield rows
            rows = []
    assert not rows, "a wire ends where something holds it"
