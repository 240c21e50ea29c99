"""A pantograph under a line in Exudyn: two masses that fly along the track, a moving contact.

The contact is a spring that only pushes, from the upper mass to the point of the wire that stands
above it. Every cable has such a spring; before each step the right one is switched on.
"""

from dataclasses import dataclass, field
from typing import Any

import exudyn as exu
import exudyn.itemInterface as items  # noqa: N813
import numpy as np

from arcless.assess.signals.filter import low_pass
from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Scenario
from tests.support.exudyn_line import ALONG, UP, Line, rayleigh, settings


@dataclass
class Record:
    """Contact force in N and uplift of the supports in m, at the start and after each step."""

    force: Any
    uplift: Any


@dataclass
class Wire:
    """The contact wire at rest: ends of its cables (x, z, slopes), their lengths in m."""

    left: Any
    right: Any
    length: Any

    def locate(self, x: float) -> tuple[int, float]:
        """Cable above x and its own coordinate there; it is straight to 1e-5 of its length."""
        row = int(np.searchsorted(self.left[:, 0], x, side="right")) - 1
        share = (x - self.left[row, 0]) / (self.right[row, 0] - self.left[row, 0])
        return row, float(share * self.length[row])


@dataclass
class Run:
    """Steps of `step` s, `steps` of them, from static equilibrium under the force at the start."""

    scenario: Scenario
    cut: Equilibrium
    steps: int
    step: float
    masses: list[Any] = field(default_factory=list)
    springs: list[Any] = field(default_factory=list)
    markers: list[Any] = field(default_factory=list)

    def record(self) -> Record:
        """Build, settle and step."""
        begin = Line(self.scenario, self.cut).settle()
        self.line = Line(self.scenario, self.cut, begin)
        self.line.only_pull()
        self.system, nodes = self.line.system, list(self.line.nodes.values())
        damping = exu.MatrixContainer()
        damping.SetWithSparseMatrix(rayleigh(self.scenario, self.cut, begin))
        self.system.AddObject(items.ObjectGenericODE2(nodeNumbers=nodes, dampingMatrix=damping))
        self.wire = self._wire(begin)
        self._pantograph()
        self._contacts()
        self._settle()
        return self._step()

    def _wire(self, begin: Any) -> Wire:
        mesh = self.cut.mesh
        wires = mesh.parts["wires"][mesh.wire_rows["contact_wire"]]
        ends = [(*a.tolist(), *b.tolist()) for a, b in wires[["nodes", "slope_nodes"]]]
        length = [self.system.GetObject(c)["length"] for c in self.line.cables["contact_wire"]]
        left = np.array([begin[a, slope] for a, _, slope, _ in ends])
        return Wire(left, np.array([begin[b, slope] for _, b, _, slope in ends]), length)

    def _pantograph(self) -> None:
        placed, (x, _) = self.scenario.pantographs[0], self.scenario.travel_range()
        row, _ = self.wire.locate(x)
        # A little into the wire: a spring that touches without force has no stiffness.
        height = self.wire.left[row, 1] + placed.static_force / self.scenario.contact.stiffness
        for part in placed.model.masses:
            node = items.NodePoint2D(
                referenceCoordinates=[x, height], initialVelocities=[self.scenario.speed, 0.0]
            )
            self.masses.append(self.system.AddNode(node))
            body = items.ObjectMassPoint2D(mass=part.mass, nodeNumber=self.masses[-1])
            self.system.AddObject(body)
        base, head = placed.model.masses
        ends = [items.MarkerNodePosition(nodeNumber=node) for node in self.masses]
        self.head = [self.system.AddMarker(end) for end in ends]
        between = items.CartesianSpringDamper(
            markerNumbers=self.head,
            stiffness=[0.0, head.stiffness, 0.0],
            damping=[0.0, head.damping, 0.0],
        )
        self.system.AddObject(between)
        lower = self.line.coordinate(self.masses[0], UP)
        # Its spring is at rest where the run begins; until then there is none.
        frame = items.CoordinateSpringDamper(
            markerNumbers=[self.line.ground, lower], damping=base.damping
        )
        self.frame = self.system.AddObject(frame)
        push = items.LoadCoordinate(markerNumber=lower, load=placed.static_force)
        self.system.AddLoad(push)

    def _contacts(self) -> None:
        stiffness = self.scenario.contact.stiffness

        def push(mbs, t, item, apart, velocity, k, d, offset):  # noqa: PLR0917
            return [0.0, stiffness * min(0.0, apart[1]), 0.0]

        for cable in self.line.cables["contact_wire"]:
            marker = items.MarkerBodyPosition(bodyNumber=cable, localPosition=[0.0, 0.0, 0.0])
            self.markers.append(self.system.AddMarker(marker))
            spring = items.CartesianSpringDamper(
                markerNumbers=[self.head[-1], self.markers[-1]],
                springForceUserFunction=push,
                activeConnector=False,
            )
            self.springs.append(self.system.AddObject(spring))

    def _touch(self, x: float) -> None:
        row, place = self.wire.locate(x)
        self.system.SetObjectParameter(self.springs[self.touched], "activeConnector", False)
        self.system.SetObjectParameter(self.springs[row], "activeConnector", True)
        self.system.SetMarkerParameter(self.markers[row], "localPosition", [place, 0.0, 0.0])
        self.touched = row

    def _settle(self) -> None:
        self.touched = 0
        self._touch(self.scenario.travel_range()[0])
        ground = self.line.ground
        held = [self.line.hold(self.line.coordinate(m, ALONG), ground) for m in self.masses]
        self.system.Assemble()
        self.system.SolveStatic(settings(), updateInitialValues=True)
        for constraint in held:
            self.system.SetObjectParameter(constraint, "activeConnector", False)
        lifted = self.system.GetNodeOutput(self.masses[0], exu.OutputVariableType.Displacement)
        base = self.scenario.pantographs[0].model.masses[0]
        self.system.SetObjectParameter(self.frame, "stiffness", base.stiffness)
        self.system.SetObjectParameter(self.frame, "offset", lifted[1])

    def _step(self) -> Record:
        supports = [self.line.at[place.contact_node] for place in self.cut.mesh.supports]
        record = Record(np.zeros(self.steps + 1), np.zeros((self.steps + 1, len(supports))))
        x, speed = self.scenario.travel_range()[0], self.scenario.speed
        kind = exu.OutputVariableType

        def before(mbs, t):  # t is the end of the step already
            self._touch(x + speed * t)
            return True

        def after(mbs, t):
            now = round(t / self.step)
            force = mbs.GetObjectOutput(self.springs[self.touched], kind.Force)
            record.force[now] = -force[1]
            record.uplift[now] = [mbs.GetNodeOutput(s, kind.Displacement)[1] for s in supports]
            return True

        self.system.SetPreStepUserFunction(before)
        self.system.SetPostStepUserFunction(after)
        chosen = settings()
        chosen.timeIntegration.numberOfSteps = self.steps
        chosen.timeIntegration.endTime = self.steps * self.step
        radius = self.scenario.stepping.scheme.spectral_radius
        chosen.timeIntegration.generalizedAlpha.spectralRadius = radius
        self.system.SolveDynamic(chosen, solverType=exu.DynamicSolverType.GeneralizedAlpha)
        return record


def filtered(time: Any, force: Any, cutoff: float = 20.0) -> Any:
    """Filtered force in spans 5 and 6 of the reference case at 250 km/h, N."""
    x = 60.0 + 250.0 / 3.6 * time
    return low_pass(force, 1e3, cutoff)[(x >= 240.0) & (x <= 360.0)]


def statistics(time: Any, force: Any) -> dict[str, float]:
    """Return what is assessed there, N."""
    slow, whole = filtered(time, force, 5.0), filtered(time, force)
    return {
        "mean force": whole.mean(), "standard deviation": whole.std(),
        "standard deviation, 0 to 5 Hz": slow.std(), "maximum": whole.max(),
        "minimum": whole.min(),
    }  # fmt: skip
