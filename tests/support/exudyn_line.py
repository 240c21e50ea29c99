"""A line in Exudyn: ANCF cables, droppers that only pull, arms, springs at the supports.

In the plane with two coordinates a place, in space with three. Masses, stiffness and damping come
from the model files. From Arcless come only the division into elements and what its design says
(`exudyn_built`).
"""

from typing import Any

import exudyn as exu
import exudyn.itemInterface as items  # noqa: N813
import numpy as np
from exudyn.advancedUtilities import CreateSymbolicUserFunction
from exudyn.solver import ComputeLinearizedSystem

from arcless.mesh import PLANAR
from arcless.model import Scenario
from arcless.model.line.parts.components import SteadyArmBar
from tests.support.exudyn_built import WIRES, Built

ALONG = 0
Place = tuple[int, int]  # nodes of position and slope; at a hinge one position has two slopes
Coordinates = dict[Place, Any]


class Line:
    """The line of a scenario, as `built`; nodes begin as drawn, or at `start`, at rest.

    Wires that begin at rest have their damping.
    """

    def __init__(self, scenario: Scenario, built: Built, start: Coordinates | None = None) -> None:
        self.container = exu.SystemContainer()  # dies with its systems if nobody keeps it
        self.system = self.container.AddSystem()
        self.scenario, self.built, self.start = scenario, built, start
        self.size = built.mesh.dimension
        self.up = self.size - 1
        node = self.system.AddNode(items.NodePointGround())
        ground = items.MarkerNodeCoordinate(nodeNumber=node, coordinate=0)
        self.ground = self.system.AddMarker(ground)
        self.nodes: dict[Place, Any] = {}
        self.at: dict[int, Any] = {}
        self.cables = {name: self._cables(name) for name in WIRES}
        for held, component in built.mesh.parts["fixed"]:
            self.hold(self.coordinate(self.at[int(held)], int(component)), self.ground)
        self.droppers = [self._dropper(place) for place in built.mesh.droppers]
        self.springs = self._springs()
        self.arms = [self._arm(row) for row in range(len(built.hinge))]
        self._masses()

    def coordinate(self, node: Any, component: int) -> Any:
        """Return a marker of one coordinate."""
        marker = items.MarkerNodeCoordinate(nodeNumber=node, coordinate=component)
        return self.system.AddMarker(marker)

    def position(self, node: Any) -> Any:
        """Return a marker of the place of a node."""
        return self.system.AddMarker(items.MarkerNodePosition(nodeNumber=node))

    def hold(self, marker: Any, other: Any) -> Any:
        """Tie two coordinates."""
        return self.system.AddObject(items.CoordinateConstraint(markerNumbers=[other, marker]))

    def upward(self, force: float) -> list[float]:
        """Return a vector of three numbers that points up."""
        vector = [0.0, 0.0, 0.0]
        vector[self.up] = force
        return vector

    def _node(self, place: Place) -> Any:
        if place in self.nodes:
            return self.nodes[place]
        mesh, (position, slope) = self.built.mesh, place
        # In the plane a mesh has zeros in the third column.
        drawn = [*mesh.positions[position, : self.size], *mesh.slopes[slope, : self.size]]
        begin = drawn if self.start is None else list(self.start[place])
        kind = items.NodePoint2DSlope1 if self.size == PLANAR else items.NodePointSlope1
        node = self.system.AddNode(kind(referenceCoordinates=begin))
        for component in range(self.size) if position in self.at else ():  # a hinge
            other = self.coordinate(self.at[position], component)
            self.hold(self.coordinate(node, component), other)
        self.at.setdefault(position, node)
        self.nodes[place] = node
        return node

    def _cables(self, name: str) -> list[Any]:
        wire, mesh, made = getattr(self.scenario.line, name), self.built.mesh, []
        weight = self.upward(-self.scenario.solver.gravity)
        for row in mesh.wire_rows[name]:
            element = mesh.parts["wires"][row]
            pairs = zip(element["nodes"].tolist(), element["slope_nodes"].tolist(), strict=True)
            places = list(pairs)
            cable = self._cable(wire, row)
            cable.nodeNumbers = [self._node(place) for place in places]
            made.append(self.system.AddObject(cable))
            body = self.system.AddMarker(items.MarkerBodyMass(bodyNumber=made[-1]))
            load = items.LoadMassProportional(markerNumber=body, loadVector=weight)
            self.system.AddLoad(load)
            if self.start is not None:
                ends = [self.start[place] for place in places]
                matrix = rayleigh(self._cable(wire, row), ends, wire.damping)
                damper = items.ObjectGenericODE2(
                    nodeNumbers=cable.nodeNumbers,
                    massMatrix=np.zeros_like(matrix),
                    dampingMatrix=matrix,
                )
                self.system.AddObject(damper)
        return made

    def _cable(self, wire: Any, row: int) -> Any:
        kind = items.ObjectANCFCable2D if self.size == PLANAR else items.ObjectANCFCable
        return kind(
            length=self.built.wire_length[row],
            massPerLength=wire.mass,
            bendingStiffness=wire.bending_stiffness,
            axialStiffness=wire.axial_stiffness,
        )

    def _dropper(self, place: Any) -> Any:
        kind = self.scenario.line.dropper
        spring = items.ObjectConnectorSpringDamper(
            markerNumbers=[self.position(self.at[node]) for node in place.nodes],
            referenceLength=self.built.link_length[place.link],
            stiffness=kind.stiffness,
            damping=kind.damping + kind.rayleigh.beta * kind.stiffness,
        )
        return self.system.AddObject(spring)

    def _arm(self, row: int) -> Any:
        arm, node = self.scenario.line.steady_arm, int(self.built.mesh.parts["struts"][row]["node"])
        assert isinstance(arm, SteadyArmBar)
        hinge = self.system.AddNode(
            items.NodePointGround(referenceCoordinates=list(self.built.hinge[row]))
        )
        bar = items.ObjectConnectorSpringDamper(
            markerNumbers=[self.position(hinge), self.position(self.at[node])],
            referenceLength=arm.length,
            stiffness=arm.axial_stiffness / arm.length,
        )
        return self.system.AddObject(bar)

    def only_pull(self) -> None:
        """Let droppers, spring and damper together, pull and never push."""

        def force(mbs, t, item, elongation, rate, stiffness, damping, preload):  # noqa: PLR0917
            return exu.symbolic.max(0.0, stiffness * elongation + damping * rate)

        for dropper in self.droppers:
            law = CreateSymbolicUserFunction(self.system, force, "springForceUserFunction", dropper)
            self.system.SetObjectParameter(dropper, "springForceUserFunction", law)

    def _springs(self) -> list[Any]:
        line, mesh, made = self.scenario.line, self.built.mesh, []
        on_contact = set(mesh.contact_nodes)
        for row, (place, component) in enumerate(mesh.parts["springs"][["node", "component"]]):
            node = self.at[int(place)]
            part: Any = line.steady_arm if int(place) in on_contact else line.support
            if component == ALONG:
                stiffness, damping = part.longitudinal_stiffness, 0.0
            elif component == self.up:
                stiffness, damping = part.vertical_stiffness, part.vertical_damping
            else:
                stiffness, damping = part.lateral_stiffness or part.vertical_stiffness, 0.0
            here = self.system.GetNode(node)["referenceCoordinates"][component]
            spring = items.CoordinateSpringDamper(
                markerNumbers=[self.ground, self.coordinate(node, int(component))],
                stiffness=stiffness,
                damping=damping,
                offset=self.built.spring_rest[row] - here,
            )
            made.append(self.system.AddObject(spring))
        return made

    def _masses(self) -> None:
        """Put masses on nodes: clamps with half a dropper, arms; what moves and what hangs."""
        line, kind = self.scenario.line, self.scenario.line.dropper
        found: list[tuple[int, float, float, float]] = []  # node, moving, hanging, α
        for place in self.built.mesh.droppers:
            half = 0.5 * kind.mass * self.built.link_length[place.link]
            clamps = (kind.clamp_mass_messenger_wire, kind.clamp_mass_contact_wire)
            for node, clamp in zip(place.nodes, clamps, strict=True):
                found.append((node, clamp + half, clamp + half, kind.rayleigh.alpha))
        for node in self.built.mesh.parts["struts"]["node"]:
            arm = line.steady_arm
            assert isinstance(arm, SteadyArmBar)
            whole = arm.mass * arm.length
            found.append((int(node), whole / 3.0, whole / 2.0, line.contact_wire.damping.alpha))
        assert line.support.mass == 0.0, "no mass moves at a support"
        for node, moving, hanging, alpha in found:
            if moving == 0.0:
                continue
            mass = np.diag([moving] * self.size + [0.0] * self.size)
            load = self.upward(-hanging * self.scenario.solver.gravity)[: self.size]
            lump = items.ObjectGenericODE2(
                nodeNumbers=[self.at[node]],
                massMatrix=mass,
                dampingMatrix=alpha * mass,
                forceVector=load + [0.0] * self.size,
            )
            self.system.AddObject(lump)

    def settle(self) -> Coordinates:
        """Find the equilibrium; return position and slope of every node."""
        self.system.Assemble()
        self.system.SolveStatic(settings(), updateInitialValues=True)
        return self.here()

    def here(self) -> Coordinates:
        """Return position and slope of every node, as they are now."""
        kind = exu.OutputVariableType.Coordinates
        return {
            place: np.array(self.system.GetNodeOutput(node, kind))
            + np.array(self.system.GetNode(node)["referenceCoordinates"])
            for place, node in self.nodes.items()
        }

    def pulls(self, connectors: list[Any]) -> Any:
        """Tension of each dropper or arm in N."""
        kind = exu.OutputVariableType.ForceLocal
        found = [self.system.GetObjectOutput(connector, kind) for connector in connectors]
        return np.array(found).reshape(len(connectors), -1)[:, 0]


def rayleigh(cable: Any, ends: list[Any], damping: Any) -> Any:
    """Return α M + β K of one cable, M and K as Exudyn has them where its ends are."""
    container = exu.SystemContainer()
    system = container.AddSystem()
    kind = items.NodePoint2DSlope1 if len(ends[0]) == 2 * PLANAR else items.NodePointSlope1
    cable.nodeNumbers = [system.AddNode(kind(referenceCoordinates=list(end))) for end in ends]
    system.AddObject(cable)
    system.Assemble()
    mass, stiffness, _ = ComputeLinearizedSystem(system, settings())
    return damping.alpha * mass + damping.beta * stiffness


def settings() -> Any:
    """Sparse, quiet, balanced to 1e-9 of the forces at the start."""
    chosen = exu.SimulationSettings()
    chosen.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    chosen.solution.file.write = False
    for solver in (chosen.staticSolver, chosen.timeIntegration):
        solver.verboseMode = 0
        solver.newton.relativeTolerance = 1e-8
        solver.newton.absoluteTolerance = 1e-6
    return chosen
