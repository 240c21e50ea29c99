"""One wire between two fixed points, of any wire model, by hand."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.mesh import PLANAR, Mesh
from arcless.mesh.tables.parts import Parts
from tests.support import catenary
from tests.support.evidence import Evidence
from tests.support.structures import add_element, at_rest, mesh_of

# Wire model, components of space.
MODELS = {
    "cubic, planar": ("hermite", 2),
    "cubic, spatial": ("hermite", 3),
    "point masses, planar": ("lumped", 2),
    "point masses, spatial": ("lumped", 3),
}


def span(
    model: str, count: int, *, length: float, rest: float, axial: float, bending: float,
    mass: float, gravity: float = 0.0, wind: float = 0.0, sag: float = 0.0, grading: float = 0.0,
) -> Mesh:  # fmt: skip
    """Return a wire of `count` pieces between points `length` m apart.

    Parameters
    ----------
    rest
        Its unstretched length, m.
    axial, bending, mass
        EA in N, EI in N·m², kg per metre of rest length.
    gravity, wind
        m/s²; force across the track in N per metre of rest length, in space only.
    sag
        Of the first guess, m.
    grading
        Pieces are longer by this share at the first end than on average, and shorter at the other.
    """
    kind, dimension = MODELS[model]
    s = np.linspace(0.0, 1.0, count + 1)
    s = s + grading * s * (1.0 - s)
    x, z, zero = length * s, -4.0 * sag * s * (1.0 - s), np.zeros(count + 1)
    pieces = (rest * np.diff(s)).tolist()
    slopes = (
        np.column_stack([np.full(count + 1, length), zero, -4.0 * sag * (1.0 - 2.0 * s)]) / rest
    )
    points = np.column_stack([x, zero, z])
    if dimension == PLANAR:
        points, slopes = points[:, [0, 2, 1]], slopes[:, [0, 2, 1]]
    parts = Parts()
    tension = axial * (length / rest - 1.0) if length > rest else 1.0
    for i, piece in enumerate(pieces):
        if kind == "hermite":
            add_element(
                parts, i, rest=piece, axial=axial, mass=mass, tension=tension, bending=bending
            )
        else:
            add_element(parts, i, rest=piece, axial=axial, mass=mass, tension=tension)
            if i and bending > 0.0:
                parts.add("bends", segments=(i - 1, i), bending_stiffness=bending, beta=0.0)
        if wind:
            parts.add("wire_loads", force=(0.0, wind, 0.0))
    for component in range(dimension):
        parts.fix(0, component)
        parts.fix(count, component)
    return mesh_of(dimension, points, slopes, parts, list(range(count)), gravity=gravity)


def middle(found: Any) -> Any:
    """Position of the node in the middle: along, across, up; m."""
    return found.positions[len(found.positions) // 2]


LENGTH, AXIAL, STRETCH, MASS = 60.0, 1e7, 1.002, 1.35


def tension(model: str) -> float:
    """Tension of a wire stretched by STRETCH, N: the law of its elements."""
    if MODELS[model][0] == "hermite":
        return AXIAL * 0.5 * (STRETCH**2 - 1.0) * STRETCH
    return AXIAL * (STRETCH - 1.0)


def rigidity(model: str, bending: float) -> float:
    """EI per metre of the stretched wire, N·m².

    Cubic elements take the true curvature and integrate over the unstretched length; chains of
    point masses take the second derivative by that length.
    """
    return bending / STRETCH if MODELS[model][0] == "hermite" else bending * STRETCH**3


def straight(
    model: str, count: int, *, bending: float, stretch: float = STRETCH, grading: float = 0.0
) -> Equilibrium:
    """Bring a weightless wire to rest."""
    rest = LENGTH / stretch
    mesh = span(
        model, count, length=LENGTH, rest=rest, axial=AXIAL, bending=bending, mass=MASS,
        grading=grading,
    )  # fmt: skip
    return at_rest(mesh)


def frequency_error(
    model: str, count: int, *, bending: float, taut: bool, grading: float = 0.0
) -> float:
    """Relative error of the third natural frequency, ω² = (T k² + EI k⁴)/μ, k = 3π/L."""
    stretch = STRETCH if taut else 1.0
    wire = straight(model, count, bending=bending, stretch=stretch, grading=grading)
    found = wire.frequencies(8)
    # In space each one comes twice.
    distinct = [f for f, before in zip(found, [0.0, *found], strict=False) if f > 1.01 * before]
    k = 3.0 * np.pi / LENGTH
    stiffness = bending * k**4 + (tension(model) * k**2 if taut else 0.0)
    exact = np.sqrt(stiffness * stretch / MASS) / (2.0 * np.pi)
    return abs(distinct[2] / float(exact) - 1.0)


def sag_error(model: str, count: int) -> float:
    """Relative error of the sag of a soft and heavy wire; in space wind blows across it."""
    kind, dimension = MODELS[model]
    wind, mass, gravity = (60.0 if dimension > PLANAR else 0.0), 20.0, 9.81
    law = catenary.green if kind == "hermite" else catenary.hooke
    exact = catenary.of_tension(LENGTH, float(np.hypot(mass * gravity, wind)), 1e5, 1e4, law)
    sag = -float(exact.at(exact.rest / 2.0)[1])
    mesh = span(
        model, count, length=LENGTH, rest=exact.rest, axial=1e5, bending=0.0, mass=mass,
        gravity=gravity, wind=wind, sag=sag,
    )  # fmt: skip
    _, across, up = middle(at_rest(mesh))
    # It hangs in the plane of its weight and the wind: both components are off, or none.
    plane = np.array([wind, -mass * gravity]) / np.hypot(wind, mass * gravity)
    return float(np.linalg.norm(np.array([across, up]) - sag * plane)) / sag


def elasticity_error(model: str, count: int, *, bending: float) -> float:
    """Relative error of the elasticity at mid-span, L/4T − tanh(λL/2)/(2Tλ), λ² = T/EI."""
    found = straight(model, count, bending=bending).elasticity(np.array([LENGTH / 2.0]))[0]
    pull = tension(model)
    exact = LENGTH / (4.0 * pull)
    if bending > 0.0:
        decay = np.sqrt(pull / rigidity(model, bending))
        exact -= float(np.tanh(decay * LENGTH / 2.0) / (2.0 * pull * decay))
    return abs(float(found) / exact - 1.0)


def show_order(
    evidence: Evidence, model: str, counts: Sequence[int], error: Callable[..., float], what: str,
    *, order: float, tolerance: float, unit: str,
    reason: str = "terms of the next order on the coarsest of these meshes", **wire: float,
) -> None:  # fmt: skip
    """Hold the order of an error in the length of pieces against theory."""
    evidence.order(
        f"{model}: {what}",
        [LENGTH / count for count in counts],
        [error(model, count, **wire) for count in counts],
        order,
        tolerance=tolerance,
        reason=reason,
        unit=unit,
    )
