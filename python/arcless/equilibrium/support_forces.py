"""Forces of wires on their supports across the track, and heights of the messenger wire there.

A wire with the tension T that comes to a support in the direction y′₋ and leaves it in y′₊ pulls
the support aside by

    F = T (y′₊ − y′₋)

positive to the left: 2 T·2a/L to the middle of the track for a stagger of ±a, and T L/R to the
inside of a curve of radius R. It is read where the model has what holds the wire: from the bar of a
steady arm, or a lateral spring. An arm of kind spring holds the stagger rigidly; there F follows
from the shape of the wire, whose directions are those of the parabolas through its nodes between
the support and the next dropper on either side, without what the wire's stiffness rounds off.
Source: equilibrium of a string; for stagger and curves as Kießling, Puschmann, Schmieder: Contact
Lines for Electric Railways (mark C, the book was not read for this).
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.mesh import SPATIAL, SupportPlace
from arcless.model import Line

Floats = NDArray[np.float64]

ACROSS = 1
# Elements beyond the support, and before the next attachment, that the wire's stiffness bends.
# Elements are longer than √(EI/T), 0.1 m, and the bend fades by 12 to 14 from one to the next.
# After three, the force is that of a bar in the same place within 0.2 % on shipped lines. With
# fewer the direction is that of the bend; with more, none are left before the first dropper, which
# itself bends the wire across the track very little.
BENT_AT_SUPPORT, BENT_AT_DROPPER = 3, 1
# Nodes that a parabola takes: with fewer, the direction is not known.
FEWEST = 3


class SupportForces:
    """Lateral forces of a line at rest on its supports, in N; all None in the plane."""

    def __init__(self, found: Equilibrium, line: Line) -> None:
        self._found, self._line, self._mesh = found, line, found.mesh
        self._points = found.positions
        self._is_spatial = self._mesh.dimension == SPATIAL
        springs = self._mesh.parts["springs"]
        rows = enumerate(zip(springs["node"].tolist(), springs["component"].tolist(), strict=True))
        self._lateral = {node: row for row, (node, component) in rows if component == ACROSS}
        links = self._mesh.parts["links"]["nodes"].ravel().tolist()
        bridles = [n for system in self._mesh.systems for one in system.bridles for n in one.nodes]
        self._attached = {*links, *bridles, *(place.contact_node for place in self._mesh.supports)}

    def of_contact_wire(self, place: SupportPlace) -> float | None:
        """Return the lateral force of the contact wire; None where nothing holds it aside.

        None as well where elements are so long that the wire's direction is not known.
        """
        if not self._is_spatial:
            return None
        if place.steady_arm is not None:
            return self._of_bar(place.steady_arm)
        if place.contact_node in self._lateral:
            return self._of_spring(place.contact_node)
        return self.by_shape(place) if self._is_held(place.contact_node) else None

    def of_messenger_wire(self, place: SupportPlace) -> float | None:
        """Return the lateral force of the messenger wire; None where it is anchored or absent."""
        node = self.messenger_node(place)
        is_held = self._is_spatial and place.messenger_spring is not None and node in self._lateral
        return self._of_spring(node) if node is not None and is_held else None

    def messenger_node(self, place: SupportPlace) -> int | None:
        """Return the node of the messenger wire at a support, at anchors too; None without it."""
        for system in self._mesh.systems:
            for wire in system.contact.values():
                ends = {wire[0]: 0, wire[-1]: -1}
                if system.messenger and place.contact_node in ends:
                    return system.messenger[ends[place.contact_node]]
        if self._line.messenger_wire is None or place.messenger_spring is None:
            return None
        return int(self._mesh.parts["springs"]["node"][place.messenger_spring])

    def by_shape(self, place: SupportPlace) -> float | None:
        """Return T (y′₊ − y′₋) from the shape of the contact wire; see the module."""
        wire = next(wire for wire in self._mesh.contact_wires if place.contact_node in wire)
        index = wire.index(place.contact_node)
        before = self._direction(wire[index::-1])
        behind = self._direction(wire[index:])
        if before is None or behind is None:
            return None
        nodes = self._mesh.elements["nodes"][self._mesh.contact_rows]
        near = (nodes == place.contact_node).any(axis=1)
        tension = self._found.arrays["wire_tension"][self._mesh.contact_rows][near].mean()
        return float(tension * (behind - before))

    def _of_bar(self, row: int) -> float:
        """Return the lateral part of the pull on a bar: away from its hinge."""
        node = int(self._mesh.parts["struts"]["node"][row])
        bar = self._found.arrays["strut_anchor"].reshape(-1, SPATIAL)[row] - self._points[node]
        tension = self._found.arrays["strut_tension"][row]
        return float(-tension * bar[ACROSS] / np.linalg.norm(bar))

    def _of_spring(self, node: int) -> float:
        """Return the force on a lateral spring, which pushes the wire the other way."""
        return float(-self._found.arrays["spring_force"][self._lateral[node]])

    def _is_held(self, node: int) -> bool:
        """Return whether a node cannot move across the track, and is no anchor."""
        fixed = self._mesh.parts["fixed"]
        held = set(fixed["component"][fixed["node"] == node].tolist())
        return held == {ACROSS}

    def _direction(self, nodes: Sequence[int]) -> float | None:
        """Return y′ of a wire at the first of its nodes, from those before the next attachment."""
        end = next((i for i, n in enumerate(nodes) if i and n in self._attached), None)
        if end is None or end - BENT_AT_DROPPER - BENT_AT_SUPPORT + 1 < FEWEST:
            return None
        along = self._points[list(nodes[BENT_AT_SUPPORT : end - BENT_AT_DROPPER + 1])]
        # y = ½ y″ x² + y′ x + y₀, from the support on.
        powers = np.vander(along[:, 0] - self._points[nodes[0], 0], FEWEST)
        return float(np.linalg.lstsq(powers, along[:, ACROSS], rcond=None)[0][1])
