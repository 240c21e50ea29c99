"""Points of a chain that yield as those of the wire do, until the program itself sees to that.

The wire rounds the corner under a force on one point over λ/2, a chain with EI* over
ℓ/(2 sinh μ), 4 sinh² (μ/2) = T ℓ²/EI* (docs/theory/dynamics.md), so a point yields

    R = (λ/2 − ℓ/(2 sinh μ))/T        λ = √(EI/T),   EI* = T (λℓ/2) coth (ℓ/2λ)

too much. What acts there through a spring of stiffness k gets one of 1/k′ = 1/k − R, at both of
its ends. Hinged points have no bend, and nothing too much.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from math import asinh, sinh, sqrt, tanh
from typing import Any
from unittest.mock import patch

import arcless
from arcless.mesh import Mesh, build_mesh
from arcless.simulate import equilibrium

# Columns of the table of links: stiffness and the damping that follows it.
STIFFNESS, BETA = 1, 4


def too_much(tension: float, bending: float, length: float) -> float:
    """Return what a point of a chain of elements of a length in m yields too much, m/N."""
    if tension == 0.0 or bending == 0.0:
        return 0.0
    rounding = sqrt(bending / tension)
    fitted = tension * 0.5 * rounding * length / tanh(0.5 * length / rounding)
    decay = 2.0 * asinh(0.5 * length * sqrt(tension / fitted))
    return (0.5 * rounding - 0.5 * length / sinh(decay)) / tension


def of_points(mesh: Mesh) -> dict[int, float]:
    """Return what the points of a mesh yield too much, by node, m/N."""
    nodes, segments = mesh.parts["segments"]
    pairs, bends = mesh.parts["bends"]
    found: dict[int, float] = {}
    for (one, other), (bending, _) in zip(pairs, bends, strict=True):
        length = 0.5 * (segments[one, 0] + segments[other, 0])
        tension = 0.5 * (segments[one, 5] + segments[other, 5])
        found[int(nodes[one, 1])] = too_much(tension, bending, length)
    return found


def _stiffened(*arguments: Any) -> Mesh:
    mesh = build_mesh(*arguments)
    if not {"segments", "bends", "links"} <= set(mesh.parts):
        return mesh
    yields = of_points(mesh)
    ends, values = mesh.parts["links"]
    values = values.copy()
    for row, (upper, lower) in zip(values, ends[:, :2], strict=True):
        given = row[STIFFNESS]
        row[STIFFNESS] = 1.0 / (1.0 / given - yields.get(upper, 0.0) - yields.get(lower, 0.0))
        row[BETA] *= given / row[STIFFNESS]
    mesh.parts["links"] = (ends, values)
    return mesh


@contextmanager
def as_of_the_wire(scenario: arcless.Scenario) -> Iterator[arcless.Scenario]:
    """Let droppers and contacts of a scenario of chains meet points that yield as the wire does."""
    wire, law = scenario.line.contact_wire, scenario.contact
    length = scenario.solver.contact_wire_element_m
    if law.law == "compliant":
        room = too_much(wire.tension, wire.bending_stiffness, length)
        scenario = scenario.with_(**{"contact.stiffness": 1.0 / (1.0 / law.stiffness - room)})
    with patch.object(equilibrium, "build_mesh", _stiffened):
        yield scenario
