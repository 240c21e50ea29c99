"""A line in Exudyn: planar ANCF cables, droppers that only pull, springs at the supports.

Masses, stiffness and damping come from the model files. From Arcless come only the division into
elements and what its design says of lengths: of wires and droppers, and the rests of the springs.
"""

from typing import Any

import exudyn as exu
import exudyn.itemInterface as items  # noqa: N813
import numpy as np
from exudyn.advancedUtilities import CreateSymbolicUserFunction
from exudyn.solver import ComputeLinearizedSystem
from scipy.sparse import csr_matrix

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Scenario

ALONG, UP = 0, 1
Place = tuple[int, int]  # nodes of position and slope; at a hinge one position has two slopes
Coordinates = dict[Place, Any]


def same_wire(tension: float, stiffness: float) -> float:
    """Length of a wire with N = EA (λ−1) over that with N = EA ½ (λ²−1) λ, equal when taut."""
    stretch = 1.0 + tension / stiffness
    for _ in range(5):  # Newton, from a start that is off by 1e-6
        force = 0.5 * stiffness * (stretch**2 - 1.0) * stretch
        stretch -= (force - tension) / (stiffness * (1.5 * stretch**2 - 0.5))
    return stretch / (1.0 + tension / stiffness)


class Line:
    """The line of a scenario, `cut` as Arcless designed it; nodes begin as drawn or at `start`."""

    def __init__(
        self, scenario: Scenario, cut: Equilibrium, start: Coordinates | None = None
    ) -> None:
        self.container = exu.SystemContainer()  # dies with its systems if nobody keeps it
        self.system = self.container.AddSystem()
        self.scenario, self.cut, self.start = scenario, cut, start
        node = self.system.AddNode(items.NodePointGround())
        ground = items.MarkerNodeCoordinate(nodeNumber=node, coordinate=0)
        self.ground = self.system.AddMarker(ground)
        self.nodes: dict[Place, Any] = {}
        self.at: dict[int, Any] = {}
        wires = ("contact_wire", "messenger_wire")
        self.cables = {name: self._cables(name) for name in wires}
        self.droppers = [self._dropper(place) for place in cut.mesh.droppers]
        self.springs = self._springs()
        for held, component in cut.mesh.parts["fixed"]:
            self.hold(self.coordinate(self.at[int(held)], int(component)), self.ground)

    def coordinate(self, node: Any, component: int) -> Any:
        """Return a marker of one coordinate."""
        marker = items.MarkerNodeCoordinate(nodeNumber=node, coordinate=component)
        return self.system.AddMarker(marker)

    def hold(self, marker: Any, other: Any) -> Any:
        """Tie two coordinates."""
        return self.system.AddObject(items.CoordinateConstraint(markerNumbers=[other, marker]))

    def _node(self, place: Place) -> Any:
        if place in self.nodes:
            return self.nodes[place]
        mesh, (position, slope) = self.cut.mesh, place
        drawn = [*mesh.positions[position, :2], *mesh.slopes[slope, :2]]
        begin = drawn if self.start is None else list(self.start[place])
        node = self.system.AddNode(items.NodePoint2DSlope1(referenceCoordinates=begin))
        for component in (ALONG, UP) if position in self.at else ():  # a hinge
            other = self.coordinate(self.at[position], component)
            self.hold(self.coordinate(node, component), other)
        self.at.setdefault(position, node)
        self.nodes[place] = node
        return node

    def _cables(self, name: str) -> list[Any]:
        wire, mesh, made = getattr(self.scenario.line, name), self.cut.mesh, []
        shorter = same_wire(wire.tension, wire.axial_stiffness)
        for row in mesh.wire_rows[name]:
            element = mesh.parts["wires"][row]
            a, b = element["nodes"].tolist()
            slope_a, slope_b = element["slope_nodes"].tolist()
            cable = items.ObjectANCFCable2D(
                length=shorter * self.cut.arrays["wire_rest_length"][row],
                massPerLength=wire.mass,
                bendingStiffness=wire.bending_stiffness,
                axialStiffness=wire.axial_stiffness,
                nodeNumbers=[self._node((a, slope_a)), self._node((b, slope_b))],
            )
            made.append(self.system.AddObject(cable))
            body = self.system.AddMarker(items.MarkerBodyMass(bodyNumber=made[-1]))
            weight = [0.0, -self.scenario.solver.gravity, 0.0]
            load = items.LoadMassProportional(markerNumber=body, loadVector=weight)
            self.system.AddLoad(load)
        return made

    def _dropper(self, place: Any) -> Any:
        kind = self.scenario.line.dropper
        ends = [items.MarkerNodePosition(nodeNumber=self.at[node]) for node in place.nodes]
        spring = items.ObjectConnectorSpringDamper(
            markerNumbers=[self.system.AddMarker(end) for end in ends],
            referenceLength=self.cut.arrays["link_rest_length"][place.link],
            stiffness=kind.stiffness,
            damping=kind.damping + kind.rayleigh.beta * kind.stiffness,
        )
        return self.system.AddObject(spring)

    def only_pull(self) -> None:
        """Let droppers, spring and damper together, pull and never push."""

        def force(mbs, t, item, elongation, rate, stiffness, damping, preload):  # noqa: PLR0917
            return exu.symbolic.max(0.0, stiffness * elongation + damping * rate)

        for dropper in self.droppers:
            law = CreateSymbolicUserFunction(self.system, force, "springForceUserFunction", dropper)
            self.system.SetObjectParameter(dropper, "springForceUserFunction", law)

    def _springs(self) -> list[Any]:
        line, mesh, made = self.scenario.line, self.cut.mesh, []
        on_contact = set(mesh.contact_nodes)
        for row, (place, component) in enumerate(mesh.parts["springs"][["node", "component"]]):
            node = self.at[int(place)]
            part = line.steady_arm if int(place) in on_contact else line.support
            along = component == ALONG
            here = self.system.GetNode(node)["referenceCoordinates"][component]
            spring = items.CoordinateSpringDamper(
                markerNumbers=[self.ground, self.coordinate(node, int(component))],
                stiffness=part.longitudinal_stiffness if along else part.vertical_stiffness,
                offset=self.cut.arrays["spring_rest"][row] - here,
            )
            made.append(self.system.AddObject(spring))
        return made

    def settle(self) -> Coordinates:
        """Find the equilibrium; return position and slope of every node."""
        self.system.Assemble()
        self.system.SolveStatic(settings(), updateInitialValues=True)
        kind = exu.OutputVariableType.Coordinates
        return {
            place: np.array(self.system.GetNodeOutput(node, kind))
            + np.array(self.system.GetNode(node)["referenceCoordinates"])
            for place, node in self.nodes.items()
        }

    def dropper_forces(self) -> Any:
        """Tension of each dropper in N."""
        kind = exu.OutputVariableType.ForceLocal
        found = [self.system.GetObjectOutput(dropper, kind) for dropper in self.droppers]
        return np.array(found).reshape(len(self.droppers), -1)[:, 0]


def rayleigh(scenario: Scenario, cut: Equilibrium, start: Coordinates) -> Any:
    """Return α M + β K of the wires alone, M and K as Exudyn has them at rest."""
    line = Line(scenario, cut, start)
    for connector in line.droppers + line.springs:
        line.system.SetObjectParameter(connector, "activeConnector", False)
    line.system.Assemble()
    mass, stiffness, _ = ComputeLinearizedSystem(line.system, settings())
    contact, messenger = scenario.line.contact_wire, scenario.line.messenger_wire
    assert contact.damping == messenger.damping, "one α and one β for both wires"
    matrix = contact.damping.alpha * mass + contact.damping.beta * stiffness
    matrix[np.abs(matrix) < 1e-12 * np.abs(matrix).max()] = 0.0  # of numerical differentiation
    return csr_matrix(matrix)


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
