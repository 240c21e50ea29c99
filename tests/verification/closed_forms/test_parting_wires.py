"""Parting wires: two contact wires that meet and part in plan

Two contact wires of tension T are held across at y = ± b/2 at the supports. To first order in the
slopes:

* **pull.** A string pulls a support by `F = T [(y₁ − y₀)/l₀ − (y₂ − y₁)/l₁]`, whatever is suspended
  from it. Both wires together pull as the stagger alone makes them, by twice that of its change of
  direction: the parts of the separation cancel.
* **layer.** A wire that bends obeys `T y″ − EI y⁗ = 0`. Between + b/2 and − b/2 in equal spans it
  turns at each support with y′ = 0: `y = −A [x − q sinh(x/ℓ)/sinh(L/2ℓ)]` from mid-span, with ℓ =
  √(EI/T), `q = ℓ tanh(L/2ℓ)`, `A = b/(L − 2q)`, and pulls by 2 T A. In a chain of segments h,
  2 sinh(h/2ℓ′) = h/ℓ gives the ℓ′ of the functions, and h/sinh(h/ℓ′) is the ℓ of q.
* **sag.** A wire that crosses the track by b over L hangs in an upright plane, longer by
  `u = √(1 + b²/L²)`, under u T: it sags by w L² u/8T, so that the separation adds b²/2L² of it.

Balance of forces, derived here; the catenary in the plane of the wire is integrated (Irvine, Cable
Structures, 1981). A string of cubic elements keeps one slope at a support: its corner is rounded as
by a bending stiffness with ℓ = h/√72 (from the mode of such elements, with the factor 3 − √8).

The program is asked by scenarios at rest: 15 kN, 1.1 kg/m, EA = 14 MN; EI = 0, in the layer
15 kN m², so that ℓ = 1 m; two droppers in mid-span, one on either wire; elements of both families.
"""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless.mesh.division import systems
from tests.support import parting
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.parting import AXIAL, HEIGHT, ROUNDED, TENSION, Layer, at_rest, pulls
from tests.support.python_faults import wrong

Floats = NDArray[np.float64]
# The weight hardly matters for what is across the track: a hundredth of it.
LIGHT = 0.0981
WEIGHT = parting.MASS * parting.GRAVITY
SIZES = {"chain": (2.5, 1.25, 0.625), "cubic": (2.5, 1.25, 0.625)}

LENGTHS, STAGGER, PARTED = (40.0, 60.0, 45.0, 60.0, 50.0, 40.0), 0.1, 0.6


@pytest.mark.parametrize("family", SIZES)
def test_pull(evidence: Evidence, family: str) -> None:
    sign = np.array([1.0, -1.0] * 4)[: len(LENGTHS) + 1]
    exact = np.column_stack([
        parting.of_strings(LENGTHS, sign * (STAGGER + 0.5 * side * PARTED)) for side in (1.0, -1.0)
    ])  # fmt: skip
    common = 2.0 * parting.of_strings(LENGTHS, sign * STAGGER)
    stagger = {f"geometry__stagger_{wire}_wire": [STAGGER, -STAGGER]
               for wire in ("contact", "messenger")}  # fmt: skip
    errors = []
    for size in SIZES[family]:
        found = pulls(at_rest(family, size, LENGTHS, [PARTED, -PARTED], gravity=LIGHT, **stagger))
        named = f"{family} of {size:g} m"
        limit = 2.0 * ROUNDED * size / min(LENGTHS) if family == "cubic" else 1e-9
        reason = (
            "2ℓ/L of the shortest span, of a corner that is rounded over ℓ = h/√72"
            if family == "cubic"
            else "rounding of the horizontal tension, which the design finds to 1e-7 N"
        )
        errors.append(float(abs(found / exact - 1.0).max()))
        evidence.below(f"pull of an arm, worst of ten, part of it, {named}", errors[-1], limit,
                       unit="1", reason=reason)  # fmt: skip
        evidence.below(
            f"pull of both wires together, worst of five, part of it, {named}",
            float(abs(found.sum(axis=1) / common - 1.0).max()), limit, unit="1", reason=reason,
        )  # fmt: skip
    if family == "cubic":
        evidence.order(
            "pull of an arm, string of cubic elements", SIZES[family], errors, 1.0, tolerance=0.05,
            unit="element", reason="ℓ = h/√72 is of first order in h; 2ℓ/L ≤ 1.5 % bends the slope",
        )  # fmt: skip


SPAN, APART, BENDING = 20.0, 0.02, 15e3
LABELS = {"chain": "chain", "cubic": "cubic", "explicit chain": "explicit steps, chain"}
LAYERED = {"chain": (1.0, 0.5, 0.25), "cubic": (2.0, 1.0, 0.5), "explicit chain": (2.0, 1.0, 0.5)}


def layer(family: str, size: float) -> tuple[float, Floats, Floats]:
    """Return the pull in N in the middle of twelve spans, and x and y of the wire in one."""
    found = at_rest(family, size, [SPAN] * 12, [APART, -APART], bending=BENDING, gravity=LIGHT)
    x, y, _ = found.positions[found.mesh.contact_wires[0]].T
    inside = abs(x - 6.5 * SPAN) <= 0.5 * SPAN + 1e-6
    assert np.count_nonzero(inside) == round(SPAN / size) + 1
    return float(pulls(found)[5, 0]), x[inside] - 6.5 * SPAN, y[inside]


@pytest.mark.parametrize("family", LAYERED)
def test_layer(evidence: Evidence, family: str) -> None:
    errors, sizes = [], LAYERED[family]
    wire = "cubic" if family == "cubic" else "chain"
    for size in sizes:
        pull, x, y = layer(family, size)
        of_wire = Layer(SPAN, APART, parting.bending_of(wire, size, BENDING))
        errors.append(abs(pull / of_wire.pull - 1.0))
        if family == "cubic":
            limit = 2.0 / SPAN * size**4 / 720.0
            reason = "(h/ℓ)⁴/720 of what bending adds, 2ℓ/L of the pull; ℓ = 1 m"
            form = of_wire
        else:
            limit, reason = 1e-6, "exact but for the square of the slope, 1e-6"
            form = Layer(SPAN, APART, parting.bending_of(family, size, BENDING), size)
        named = f"{LABELS[family]} of {size:g} m"
        evidence.below(f"pull of an arm, part of it, {named}", abs(pull / form.pull - 1.0), limit,
                       unit="1", reason=reason)  # fmt: skip
        evidence.below(
            f"worst node in plan, part of half of the separation, {named}",
            float(abs(y - form.across(x)).max()) / (0.5 * APART), limit, unit="1", reason=reason,
        )  # fmt: skip
    if family != "explicit chain":
        expected, tolerance = (4.0, 0.3) if family == "cubic" else (2.0, 0.2)
        evidence.order(
            f"pull of an arm against the wire that bends, {family}", sizes, errors, expected,
            tolerance=tolerance, unit="element",
            reason="elements from ℓ/4 to 2 ℓ: the largest resolve the layer by one or two, and "
            "squares of slopes are 10 % of the smallest error of cubic elements",
        )  # fmt: skip
    x = np.linspace(-0.5 * SPAN, -0.3 * SPAN, 201)
    string = -APART * x / SPAN
    form = Layer(SPAN, APART, BENDING)
    _, place, y = layer(family, sizes[0])
    near = place <= x[-1]
    evidence.figure(
        f"layer-{family.replace(' ', '-')}",
        {"wire that bends": (x + 0.5 * SPAN, 1e3 * form.across(x)),
         f"program, {family} of {sizes[0]:g} m": (place[near] + 0.5 * SPAN, 1e3 * y[near]),
         "string": (x + 0.5 * SPAN, 1e3 * string)},
        x="from the support, m", y="across the track, mm",
        title=f"Wire that bends at a support, {family}",
    )  # fmt: skip


HUNG, NARROWEST, SEPARATIONS = 20.0, 0.002, (0.5, 1.0, 2.0)


def sag(family: str, size: float, apart: float) -> float:
    """Return how much lower in m a wire is at a support than at its droppers."""
    found = at_rest(family, size, [HUNG] * 8, [apart, -apart])
    x, _, z = found.positions[found.mesh.contact_wires[0]].T
    (node,) = np.flatnonzero(abs(x - 4.0 * HUNG) < 1e-6)
    return float(HEIGHT - z[node])


@pytest.mark.parametrize("family", ["chain", pytest.param("cubic", marks=pytest.mark.evidence)])
def test_sag(evidence: Evidence, family: str) -> None:
    sizes, widest = SIZES[family], SEPARATIONS[-1]
    exact = {apart: parting.sag(family, HUNG, apart) for apart in (NARROWEST, *SEPARATIONS)}
    errors = []
    for size in sizes:
        # Of a corner with the slope b/L, and of the weight of an element over the tension.
        corner = AXIAL / TENSION * (size / HUNG) ** 2 / 20.0 * (widest / HUNG) ** 2
        limit, reason = (
            ((WEIGHT * size / TENSION) ** 2 / 20.0, "(wh/T)²/24: a chain turns by wh/T at a point")
            if family == "chain"
            else (0.08 * ROUNDED * size / HUNG + corner,
                  "2 % of 4ℓ/L with ℓ = h/√72, what residual flexibility leaves of the corners at "
                  "droppers, and (EA p²/T)(h/L)²/20 of the slope p in plan: along the element at a "
                  "corner the tension is off by up to EA p²/2, while its mean is met. Orders in h "
                  "and p are derived, both factors are about twice what was found")
        )  # fmt: skip
        errors.append(abs(sag(family, size, widest) / exact[widest] - 1.0))
        evidence.below(f"sag, {widest:g} m apart, part of it, {family} of {size:g} m", errors[-1],
                       limit, unit="1", reason=reason)  # fmt: skip
    plain, grown = sag(family, sizes[-1], NARROWEST), []
    for apart in SEPARATIONS:
        grown.append(sag(family, sizes[-1], apart) / plain - 1.0)
        chained = family == "chain"
        evidence.close(
            f"growth of the sag, {apart:g} m apart, {family} of {sizes[-1]:g} m", grown[-1],
            exact[apart] / exact[NARROWEST] - 1.0, unit="1",
            relative=1e-5 if chained else AXIAL / TENSION * (sizes[-1] / HUNG) ** 2 / 10.0,
            reason="heights to 1e-10 m, of a growth of 11 µm" if chained else
            "(EA p²/T)(h/L)²/20 as of the sag, of a growth of p²/2; twice what was found",
        )  # fmt: skip
    if family == "chain":
        evidence.order(f"sag, {widest:g} m apart, chain", sizes, errors, 2.0, tolerance=0.05,
                       unit="element", reason="(wh/T)²/24, of errors above 8e-9")  # fmt: skip
        slopes = [apart / HUNG for apart in SEPARATIONS]
        evidence.order(
            "growth of the sag over the slope in plan", slopes, grown, 2.0, tolerance=0.01,
            unit="slope", reason="b²/2L²; the fourth power is 0.3 % of it at a slope of 0.1",
        )  # fmt: skip


def wider(factor: float, place: int) -> Any:
    """Let the wires be further apart at one support."""

    def spoil(found: dict[str, list[float]]) -> dict[str, list[float]]:
        return {name: [*y[:place], factor * y[place], *y[place + 1 :]] for name, y in found.items()}

    return wrong(systems, "_contact_wires", spoil)


def alike(found: dict[str, list[float]]) -> dict[str, list[float]]:
    """Let the second wire follow the first one."""
    return dict.fromkeys(found, next(iter(found.values())))


FAULTS = [
    Fault("wires 0.1 % wider apart at one support", wider(1.001, 3), test_pull, family="chain"),
    Fault("tension 0.1 % high", scaled("wires", "tension", 1.001), test_pull, family="chain"),
    Fault("wires side by side", wrong(systems, "_contact_wires", alike), test_pull,
          family="cubic"),
    Fault("EI 1 % high", scaled("bends", "EI", 1.01), test_layer, family="chain"),
    Fault("EI 1 % high, explicit steps", scaled("bends", "EI", 1.01), test_layer,
          family="explicit chain"),
    Fault("EI 1 % high, cubic elements", scaled("wires", "EI", 1.01), test_layer, family="cubic"),
    Fault("wires 0.1 % wider apart next to the middle", wider(1.001, 5), test_layer,
          family="chain"),
    Fault("mass 0.1 % high", scaled("wires", "mass", 1.001), test_sag, family="chain"),
    Fault("tension 0.1 % high, of the sag", scaled("wires", "tension", 1.001), test_sag,
          family="chain"),
    Fault("mass 1 % high, cubic elements", scaled("wires", "mass", 1.01), test_sag,
          family="cubic", slow=True),
]  # fmt: skip
