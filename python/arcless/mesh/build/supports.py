"""Supports of the wires of a system → rows of the tables."""

from typing import TypeAlias

from arcless.mesh.division.chain import Chains
from arcless.mesh.division.wire_names import BRIDLE, CONTACT
from arcless.mesh.division.wires import Stations
from arcless.mesh.tables.columns import HELD, UNLOADED
from arcless.mesh.tables.context import Kit
from arcless.mesh.tables.mesh_types import SupportPlace
from arcless.model.line.parts.components import MessengerSupport, NoSteadyArm, SteadyArmBar
from arcless.model.line.parts.contact_supports import ContactSupport

# Rows of the vertical and of the lateral spring of a support.
_Springs: TypeAlias = tuple[int | None, int | None]
_NOTHING: _Springs = (None, None)


class Holding:
    """Adds the supports and steady arms of one system."""

    def __init__(self, kit: Kit, places: Stations, chains: Chains) -> None:
        self.kit, self.chains, self.system = kit, chains, places.system
        self.line, self.parts = kit.line, kit.parts

    def build(self) -> list[SupportPlace]:
        """Add everything; at the first and the last support the wires are anchored."""
        chains, system = self.chains, self.system
        last = len(system.supports) - 1
        found = []
        for index, x in enumerate(system.supports):
            inside = 0 < index < last
            messenger = chains.messenger
            held = self._hold_messenger(messenger.at(x)) if inside and messenger else _NOTHING
            for name, contact in chains.contacts.items():
                node = contact.at(x)
                arm = self._hold_contact_wire(node, name, index) if inside else None
                which = self._name(index, name)
                if inside and messenger is None:
                    held = self._hold_alone(chains.of(BRIDLE, x).at(x) if chains.bridles else node)
                vertical, lateral = held
                found.append(SupportPlace(which, x, node, vertical, arm, lateral))
            if inside and chains.auxiliary is not None and self.kit.spatial:
                # A pull-off keeps its lateral position; it hangs on droppers alone.
                self.parts.fix(chains.auxiliary.at(x), 1)
        return found

    def _name(self, index: int, contact_wire: str) -> str:
        """Return the name of a support; two contact wires have an arm each."""
        name = self.system.named(f"support {self.system.first + index}")
        return name + contact_wire.removeprefix(CONTACT).replace(" ", " wire ")

    def _hold_alone(self, node: int) -> _Springs:
        """Hold a contact wire without messenger wire, or its bridle, at a support."""
        assert self.line.contact_support is not None
        return self._hold(node, self.line.contact_support)

    def _hold_messenger(self, node: int) -> _Springs:
        support = self.line.support
        assert support is not None
        rows = self._hold(node, support)
        if support.longitudinal_stiffness > 0.0:
            self.parts.add_spring(node, 0, UNLOADED, stiffness=support.longitudinal_stiffness)
        return rows

    def _hold(self, node: int, support: ContactSupport | MessengerSupport) -> _Springs:
        """Hold a node up, and across in space; return the rows of both springs."""
        vertical = self.parts.add_spring(
            node,
            self.kit.up,
            HELD,
            stiffness=support.vertical_stiffness,
            viscosity=support.vertical_damping,
        )
        across = None
        if self.kit.spatial:
            lateral = support.lateral_stiffness or support.vertical_stiffness
            across = self.parts.add_spring(node, 1, HELD, stiffness=lateral)
        self.parts.add_mass(node, support.mass)
        return vertical, across

    def _hold_contact_wire(self, node: int, name: str, index: int) -> int | None:
        arm = self.line.steady_arm
        if isinstance(arm, SteadyArmBar):
            return self.parts.add_steady_arm(arm, node, self._pull_side(name, index))
        if isinstance(arm, NoSteadyArm):
            return None
        if arm.vertical_stiffness > 0.0:
            # A support that holds the wire at a measured height, and else carries nothing at rest.
            mode = HELD if self.system.measured else UNLOADED
            self.parts.add_spring(
                node,
                self.kit.up,
                mode,
                stiffness=arm.vertical_stiffness,
                viscosity=arm.vertical_damping,
            )
        self.parts.add_mass(node, arm.mass)
        if self.kit.spatial:
            # An arm known only by its vertical stiffness holds the stagger rigidly.
            self.parts.fix(node, 1)
        return None

    def _pull_side(self, name: str, index: int) -> float:
        """Side the arm pulls to: outwards of the bend that stagger and curve make, in tension."""
        before, here, after = self.system.stagger_of(name)[index - 1 : index + 2]
        x0, x1, x2 = self.system.supports[index - 1 : index + 2]
        bend = (here - before) / (x1 - x0) - (after - here) / (x2 - x1)
        track, height = self.line.track, self.line.geometry.contact_wire_height
        if track.curves:
            bend -= track.mean_direction(x1, x2, height) - track.mean_direction(x0, x1, height)
        return -1.0 if bend < 0.0 else 1.0
