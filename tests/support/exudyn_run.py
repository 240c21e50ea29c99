"""Pantographs under a line in Exudyn: masses that fly along the track, contacts that move.

A contact is a spring that only pushes, from the uppermost mass to the point of the wire that stands
above it. Every cable has such a spring for each pantograph; before each step the right ones are
switched on.
"""

from dataclasses import dataclass, field
from typing import Any

import exudyn as exu
import exudyn.itemInterface as items  # noqa: N813
import numpy as np

from arcless.assess.signals.filter import low_pass
from arcless.model import Scenario
from tests.support.exudyn_built import Built
from tests.support.exudyn_line import Line, settings
from tests.support.exudyn_wire import ContactWire


@dataclass
class Record:
    """Contact forces in N and uplift of the supports in m, at the start and after each step.

    Columns of the forces are pantographs, of the uplift supports.
    """

    force: Any
    uplift: Any


@dataclass
class Collector:
    """A pantograph in a system of Exudyn.

    Attributes
    ----------
    placed : pantograph of the scenario
    start : where it stands at the start, m
    masses : nodes, from base to head
    frame : spring and damper between the base and the roof
    springs : contact springs, one for each cable of the contact wire
    markers : points of the cables that they push
    touched : cable of the spring that is switched on
    """

    placed: Any
    start: float
    masses: list[Any] = field(default_factory=list)
    frame: Any = None
    springs: list[Any] = field(default_factory=list)
    markers: list[Any] = field(default_factory=list)
    touched: int = 0


@dataclass
class Run:
    """Steps of `step` s, `steps` of them, from static equilibrium under the forces at the start."""

    scenario: Scenario
    built: Built
    steps: int
    step: float
    collectors: list[Collector] = field(default_factory=list)

    def record(self) -> Record:
        """Build, settle and step."""
        rest = Line(self.scenario, self.built).settle()
        self.line = Line(self.scenario, self.built, rest)
        self.line.only_pull()
        self.system = self.line.system
        self.wire = ContactWire.of(self.line, rest)
        x, _ = self.scenario.travel_range()
        for placed in self.scenario.pantographs:
            one = Collector(placed, x - placed.distance)
            self.collectors.append(one)
            self._contacts(one, self._masses(one))
        self._settle()
        return self._step()

    def _masses(self, one: Collector) -> Any:
        """Stack masses, springs and dampers; return a marker of the head."""
        stiffness, force = self.scenario.contact.stiffness, one.placed.static_force
        place = [one.start, 0.0, 0.0]
        # A little into the wire: a spring that touches without force has no stiffness.
        place[self.line.up] = self.wire.height(one.start, self.line.up) + force / stiffness
        parts = one.placed.model.masses
        for part in parts:
            node = items.NodePoint(
                referenceCoordinates=place, initialVelocities=[self.scenario.speed, 0.0, 0.0]
            )
            one.masses.append(self.system.AddNode(node))
            self.system.AddObject(items.ObjectMassPoint(mass=part.mass, nodeNumber=one.masses[-1]))
        ends = [self.line.position(node) for node in one.masses]
        for lower, upper, part in zip(ends, ends[1:], parts[1:], strict=False):
            between = items.CartesianSpringDamper(
                markerNumbers=[lower, upper],
                stiffness=self.line.upward(part.stiffness),
                damping=self.line.upward(part.damping),
            )
            self.system.AddObject(between)
        base = self.line.coordinate(one.masses[0], self.line.up)
        # Its spring is at rest where the run begins; until then there is none.
        frame = items.CoordinateSpringDamper(
            markerNumbers=[self.line.ground, base], damping=parts[0].damping
        )
        one.frame = self.system.AddObject(frame)
        self.system.AddLoad(items.LoadCoordinate(markerNumber=base, load=force))
        return ends[-1]

    def _contacts(self, one: Collector, head: Any) -> None:
        stiffness, up = self.scenario.contact.stiffness, self.line.up

        def push(mbs, t, item, apart, velocity, k, d, offset):  # noqa: PLR0917
            return self.line.upward(stiffness * min(0.0, apart[up]))

        for cable in self.line.cables["contact_wire"]:
            marker = items.MarkerBodyPosition(bodyNumber=cable, localPosition=[0.0, 0.0, 0.0])
            one.markers.append(self.system.AddMarker(marker))
            spring = items.CartesianSpringDamper(
                markerNumbers=[head, one.markers[-1]],
                springForceUserFunction=push,
                activeConnector=False,
            )
            one.springs.append(self.system.AddObject(spring))

    def _touch(self, one: Collector, x: float) -> None:
        row, place = self.wire.locate(x)
        self.system.SetObjectParameter(one.springs[one.touched], "activeConnector", False)
        self.system.SetObjectParameter(one.springs[row], "activeConnector", True)
        self.system.SetMarkerParameter(one.markers[row], "localPosition", [place, 0.0, 0.0])
        one.touched = row

    def _settle(self) -> None:
        held = []
        across = [c for c in range(3) if c != self.line.up]
        for one in self.collectors:
            self._touch(one, one.start)
            for node in one.masses:
                markers = [self.line.coordinate(node, component) for component in across]
                held += [self.line.hold(marker, self.line.ground) for marker in markers]
        self.system.Assemble()
        self.system.SolveStatic(settings(), updateInitialValues=True)
        for constraint in held:
            self.system.SetObjectParameter(constraint, "activeConnector", False)
        for one in self.collectors:
            lifted = self.system.GetNodeOutput(one.masses[0], exu.OutputVariableType.Displacement)
            base = one.placed.model.masses[0]
            self.system.SetObjectParameter(one.frame, "stiffness", base.stiffness)
            self.system.SetObjectParameter(one.frame, "offset", lifted[self.line.up])

    def _step(self) -> Record:
        supports = [self.line.at[place.contact_node] for place in self.built.mesh.supports]
        count = self.steps + 1
        record = Record(
            np.zeros((count, len(self.collectors))), np.zeros((count, len(supports)))
        )  # fmt: skip
        kind, up = exu.OutputVariableType, self.line.up

        def before(mbs, t):  # t is the end of the step already
            for one in self.collectors:
                self._touch(one, one.start + self.scenario.speed * t)
            return True

        def after(mbs, t):
            now = round(t / self.step)
            for column, one in enumerate(self.collectors):
                force = mbs.GetObjectOutput(one.springs[one.touched], kind.Force)
                record.force[now, column] = -force[up]
            record.uplift[now] = [mbs.GetNodeOutput(s, kind.Displacement)[up] for s in supports]
            return True

        self.system.SetPreStepUserFunction(before)
        self.system.SetPostStepUserFunction(after)
        self._march()
        return record

    def _march(self) -> None:
        chosen = settings()
        chosen.timeIntegration.numberOfSteps = self.steps
        chosen.timeIntegration.endTime = self.steps * self.step
        radius = self.scenario.stepping.scheme.spectral_radius
        chosen.timeIntegration.generalizedAlpha.spectralRadius = radius
        self.system.SolveDynamic(chosen, solverType=exu.DynamicSolverType.GeneralizedAlpha)


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
