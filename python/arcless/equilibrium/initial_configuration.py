"""The initial configuration of a line: droppers, supports, elasticity, sag, as built."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from arcless.equilibrium import equilibrium, wires_at_rest
from arcless.equilibrium.line_alone import LineAlone
from arcless.equilibrium.support_forces import SupportForces
from arcless.mesh import SPATIAL, StitchPlace
from arcless.model import Line, Scenario
from arcless.model.load import check_kind

Progress = Callable[[float, str], None]


@dataclass(frozen=True)
class InitialConfiguration:
    """The line of a scenario, or a line alone, at rest. SI units unless named."""

    scenario: Scenario | LineAlone
    equilibrium: equilibrium.Equilibrium
    elasticity_x_m: list[float]
    elasticity_m_per_N: list[float]  # noqa: N815 - the unit is part of the name
    natural_frequencies_Hz: list[float]  # noqa: N815

    @classmethod
    def of(cls, source: Scenario | Line, progress: Progress | None = None) -> Self:
        """Find the initial configuration of a line; see `arcless.statics`."""
        if isinstance(source, Line):
            scenario: Scenario | LineAlone = LineAlone(source)
        else:
            check_kind(source)
            scenario = source
        tell = progress or (lambda _fraction, _text: None)
        tell(0.0, "finding the line at rest")
        found = equilibrium.find(scenario)
        tell(0.5, "finding the elasticity of the line")
        x = found.elasticity_positions()
        elasticity = found.elasticity(x)
        tell(0.7, "finding the natural frequencies")
        frequencies = found.frequencies()
        tell(1.0, "done")
        return cls(scenario, found, x.tolist(), elasticity.tolist(), frequencies.tolist())

    @property
    def droppers(self) -> list[dict[str, Any]]:
        """Droppers: name, span (from 1), x_m, wires, length_m between the clamps, force_N."""
        found, mesh = self.equilibrium, self.equilibrium.mesh
        values = zip(
            mesh.droppers,
            found.of_droppers("link_length"),
            found.of_droppers("link_rest_length"),
            found.of_droppers("link_tension"),
            strict=True,
        )
        return [
            {
                "name": dropper.name,
                "span": dropper.span,
                "x_m": dropper.x,
                "from": dropper.wires[0],
                "to": dropper.wires[1],
                "length_m": float(length),
                "unstretched_length_m": float(rest),
                "force_N": float(force),
            }
            for dropper, length, rest, force in values
        ]

    @property
    def supports(self) -> list[dict[str, Any]]:
        """Supports: name, x_m, forces on the support and in the steady arm, heights, stagger.

        Lateral forces are those of the wire, positive to the left (`support_forces`).
        """
        arrays, points = self.equilibrium.arrays, self.equilibrium.positions
        forces = SupportForces(self.equilibrium, self.scenario.line)
        alone = self.scenario.line.messenger_wire is None
        held = "contact_support_force_N" if alone else "messenger_force_N"
        return [
            {
                "name": support.name,
                "x_m": support.x,
                held: _entry(arrays["spring_force"], support.messenger_spring),
                "steady_arm_force_N": _entry(arrays["strut_tension"], support.steady_arm),
                "contact_wire_height_m": float(points[support.contact_node, 2]),
                "contact_wire_lateral_force_N": forces.of_contact_wire(support),
                "messenger_wire_height_m": _entry(points[:, 2], forces.messenger_node(support)),
                "messenger_wire_lateral_force_N": forces.of_messenger_wire(support),
            }
            for support in self.equilibrium.mesh.supports
        ]

    @property
    def spans(self) -> list[dict[str, Any]]:
        """Spans: sag below the chord and heights of messenger and contact wire."""
        return wires_at_rest.spans(self.equilibrium)

    @property
    def wires(self) -> list[dict[str, Any]]:
        """Wires: tension and axial stress σ = T/A along each."""
        return wires_at_rest.wires(self.equilibrium, self.scenario.line)

    @property
    def stitch_wires(self) -> list[dict[str, Any]]:
        """Stitch wires: support, clamps, height of clamps and lowest point, length, tension."""
        points, systems = self.equilibrium.positions, self.equilibrium.mesh.systems
        return [
            {**one, "lowest_m": float(points[stitch.nodes, 2].min())}
            for system in systems
            for stitch, one in self._clamped(system.label, system.stitches)
        ]

    @property
    def bridles(self) -> list[dict[str, Any]]:
        """Bridles: support, clamps, height of clamps and of the hanging point, length, tension."""
        points, systems = self.equilibrium.positions, self.equilibrium.mesh.systems
        return [
            {**one, "hangs_at_m": float(points[bridle.nodes, 2].max())}
            for system in systems
            for bridle, one in self._clamped(system.label, system.bridles)
        ]

    def _clamped(
        self, label: str, pieces: list[StitchPlace]
    ) -> Iterator[tuple[StitchPlace, dict[str, Any]]]:
        """Describe wires that are clamped to another one at both ends."""
        arrays, points = self.equilibrium.arrays, self.equilibrium.positions
        for stitch in pieces:
            yield (
                stitch,
                {
                    "support": f"{label} support {stitch.support}".lstrip(),
                    "from_m": float(points[stitch.nodes[0], 0]),
                    "to_m": float(points[stitch.nodes[-1], 0]),
                    "clamp_heights_m": [
                        float(points[n, 2]) for n in stitch.nodes[:: len(stitch.rows)]
                    ],
                    "unstretched_length_m": float(arrays["wire_rest_length"][stitch.rows].sum()),
                    "tension_N": float(arrays["wire_tension"][stitch.rows].max()),
                },
            )

    @property
    def middle_span(self) -> int:
        """Number of the span, from 1, of which elasticity and sag are told."""
        found = self.equilibrium
        return 1 + found.support_places().index(found.middle_span()[0])

    @property
    def elasticity_nonuniformity(self) -> float:
        """Non-uniformity of elasticity u = (e_max − e_min)/(e_max + e_min) in the middle span."""
        high, low = max(self.elasticity_m_per_N), min(self.elasticity_m_per_N)
        return (high - low) / (high + low)

    @property
    def contact_wire_sag_m(self) -> float:
        """Maximum less minimum height of the contact wire in the middle span, in m."""
        left, right = self.equilibrium.middle_span()
        sags = []
        for nodes in self.equilibrium.mesh.contact_wires:
            points = self.equilibrium.positions[nodes]
            inside = points[(points[:, 0] >= left - 1e-6) & (points[:, 0] <= right + 1e-6)]
            # A wire that only begins or ends there, raised to its anchor, does not run through.
            if len(inside) > 1:
                sags.append(float(np.ptp(inside[:, 2])))
        return max(sags)

    @property
    def contact_wire_lateral_max_m(self) -> float | None:
        """Largest lateral position of a contact wire at rest, wind included; None when planar."""
        mesh = self.equilibrium.mesh
        if mesh.dimension != SPATIAL:
            return None
        nodes = [node for wire in mesh.contact_wires for node in wire]
        return float(np.abs(self.equilibrium.positions[nodes, 1]).max())

    @property
    def wave_speed(self) -> float | None:
        """Wave speed of the contact wire in m/s: of the design, or the lowest as built."""
        return wave_speed_of(self.scenario, self.equilibrium)

    @property
    def as_built(self) -> dict[str, float] | None:
        """Tensions and travel of the wires' far ends as built; None for a line as designed."""
        if self.scenario.as_built.is_empty:
            return None
        contact, messenger = self.equilibrium.mean_tensions()
        contact_end, messenger_end = self.equilibrium.end_travel()
        points = self.equilibrium.positions[self.equilibrium.mesh.contact_nodes]
        both = self.scenario.line.midpoint_anchor is not None
        starts = self.equilibrium.end_travel(0) if both else (None, None)
        above = {
            "messenger_wire_tension_N": messenger,
            "messenger_wire_end_travel_m": messenger_end,
            "contact_wire_start_travel_m": starts[0],
            "messenger_wire_start_travel_m": starts[1],
        }
        return {
            "contact_wire_tension_N": contact,
            "contact_wire_end_travel_m": contact_end,
            **{name: value for name, value in above.items() if value is not None},
            "contact_wire_lowest_m": float(points[:, 2].min()),
            "contact_wire_highest_m": float(points[:, 2].max()),
            "contact_wire_across_most_m": float(points[:, 1].max()),
            "contact_wire_across_least_m": float(points[:, 1].min()),
        }


def _entry(values: Any, row: int | None) -> float | None:
    return None if row is None else float(values[row])


def wave_speed_of(scenario: Scenario | LineAlone, found: equilibrium.Equilibrium) -> float | None:
    """Return the wave speed of the contact wire in m/s: of the design or, as built, the lowest.

    None of a rail without tension, which has no wave speed.
    """
    design = scenario.line.wave_speed
    return design if scenario.as_built.is_empty or design is None else found.wave_speed()
