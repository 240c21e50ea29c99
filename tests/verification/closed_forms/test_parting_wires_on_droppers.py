"""Parting wires on droppers: droppers that lean, and wind

Two contact wires of tension T are held across at y = ± b/2 at the supports. In mid-span either one
has a dropper to the messenger wire (tension T_m), which is held in the middle by supports of
stiffness k. Such a dropper carries V, the weight of a span of wire, over the height h, which is the
encumbrance less the sag of the messenger wire. It pulls across by V y/h, y between its ends.

* **leaning droppers.** A wire between b/2 and c/2 is at `y = ¼ (b + c)/(1 + V L/4Th)` in mid-span,
  and pulls its supports by 4T (b/2 − y)/L and 4T (c/2 − y)/L. The dropper has V √(1 + y²/h²).
* **wind.** Wires that cross there have upright droppers. Loads of q on each contact wire and p on
  the messenger wire move them by `u = qL²/8T − PL/4T` and
  `m = pL²/8T_m + pL/k + 2P (L/4T_m + 1/k)`, with `P = V (u − m)/h` in each dropper. Both wires move
  alike: the pulls 2 T b/L of their separation stay, and q L − P comes to each.

Balance of forces to first order in slopes, derived here. A string of cubic elements keeps one slope
at a support: its corner is rounded as by a bending stiffness with ℓ = h/√72 (topic parting wires).

The program is asked by scenarios at rest: spans of 60 m, contact wires of 15 kN, 1.1 kg/m and
EA = 14 MN, messenger wire of 30 kN, EI = 0; droppers without mass; elements of both families. For
the wind of 10 m/s, wires of 13.2 and 10.5 mm under constant force, and supports that hold y.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless.equilibrium.equilibrium import find
from arcless.equilibrium.support_forces import SupportForces
from arcless.mesh.division import systems
from arcless.mesh.division.systems import WireSystem
from tests.support import parting
from tests.support.evidence import Evidence
from tests.support.faults import Fault, gravity, misbuilt
from tests.support.parting import AXIAL, ROUNDED, TENSION, Leaning, at_rest, pulls
from tests.support.python_faults import wrong

Floats = NDArray[np.float64]
SIZES = {"chain": (2.5, 1.25, 0.625), "cubic": (2.5, 1.25, 0.625)}
LONG, WIDE, NARROW = 60.0, 0.8, 0.1
SQUARES = 2e-4
SLOPES = "squares of slopes: a sixth of (wL/2T)², 8e-5, and half of (2V/2T_m)² of their sag, 2e-4"
CORNERS = "corners of the strings at supports, ℓ/L with ℓ = h/√72 at either end of a span"


def middle(found: Any, span: int) -> tuple[list[int], Floats, Floats]:
    """Return rows of both droppers of a span, and the positions in m of their upper, lower ends."""
    mesh = found.mesh
    rows = [row for row, dropper in enumerate(mesh.droppers) if dropper.span == span]
    upper, lower = np.transpose([mesh.droppers[row].nodes for row in rows])
    return rows, found.positions[upper], found.positions[lower]


@pytest.mark.parametrize("family", SIZES)
def test_leaning_droppers(evidence: Evidence, family: str) -> None:
    form, sizes, errors = Leaning(LONG), SIZES[family], []
    aside = form.middle(WIDE, NARROW)
    force = form.upright * np.hypot(1.0, aside / form.height)
    # Of wire 1 at the third support, which is wide, and at the fourth; wire 2 is its mirror image.
    exact = np.array([4.0 * TENSION * (0.5 * b - aside) / LONG for b in (WIDE, NARROW)])
    for size in sizes:
        found = at_rest(family, size, [LONG] * 6, [WIDE, NARROW])
        rows, _, lower = middle(found, 3)
        rounded = 2.0 * ROUNDED * size / LONG if family == "cubic" else 0.0
        mirrored = np.array([1.0, -1.0])
        errors.append(float(abs(lower[:, 1] * mirrored / aside - 1.0).max()))
        off = float(abs(found.of_droppers("link_tension")[rows] / force - 1.0).max())
        at = pulls(found)[1:3] * mirrored - exact[:, None]
        for what, error, limit in (
            ("wire in mid-span across the track, part of it", errors[-1], 2.0 * rounded),
            ("pull of an arm, part of that at a wide support", abs(at / exact[0]).max(), rounded),
            ("force of a dropper that leans, part of it", off, 0.0),
        ):
            evidence.below(
                f"{what}, {family} of {size:g} m", float(error), SQUARES + limit, unit="1",
                reason=f"{SLOPES}; {CORNERS}" if limit else SLOPES,
            )  # fmt: skip
    if family == "cubic":
        evidence.order(
            "wire in mid-span across the track, string of cubic elements", sizes, errors, 1.0,
            tolerance=0.05, unit="element", reason="ℓ = h/√72 is of first order in h",
        )  # fmt: skip


CROSSED, SPEED, DIAMETERS = 0.4, 10.0, {"contact": 13.2e-3, "messenger": 10.5e-3}
BLOWN: dict[str, Any] = {
    "steady_arm": parting.HELD,
    **{f"{wire}_wire__ends": "constant_force" for wire in DIAMETERS},
    **{f"{wire}_wire__diameter": diameter for wire, diameter in DIAMETERS.items()},
}


@pytest.mark.parametrize("family", SIZES)
def test_wind(evidence: Evidence, family: str) -> None:
    form, errors = Leaning(LONG), []
    sizes = tuple(2.0 * size for size in SIZES[family])
    stretched = [1.0 + TENSION / AXIAL,
                 1.0 + parting.MESSENGER_TENSION / parting.MESSENGER_AXIAL]  # fmt: skip
    # Loads on a metre of unstretched wire.
    loads = [0.5 * 1.225 * SPEED**2 * diameter / s
             for diameter, s in zip(DIAMETERS.values(), stretched, strict=True)]  # fmt: skip
    contact, messenger, pull = form.blown(*loads)
    carried, separate = loads[0] * LONG - pull, 2.0 * TENSION * CROSSED / LONG
    for size in sizes:
        asked = parting.line_of(family, size, [LONG] * 8, [CROSSED, -CROSSED],
                                built={"wind": {"speed": SPEED}}, **BLOWN)  # fmt: skip
        found = find(asked)
        rows, upper, lower = middle(found, 4)
        ways = lower - upper
        across = found.of_droppers("link_tension")[rows] * ways[:, 1]
        across /= np.linalg.norm(ways, axis=1)
        forces = SupportForces(found, asked.line)
        one, two = (forces.of_contact_wire(s) for s in found.mesh.supports if s.x == 4.0 * LONG)
        errors.append(float(abs(lower[:, 1] / contact - 1.0).max()))
        corner = 4.0 * ROUNDED * size / LONG if family == "cubic" else 0.0
        for what, error, limit in (
            ("contact wires in mid-span", errors[-1], corner),
            ("messenger wire in mid-span", abs(upper[:, 1] / messenger - 1.0).max(), corner),
            ("a dropper across the track", abs(across / pull - 1.0).max(), 2.0 * corner),
            ("both wires at a support", abs((one + two) / (2.0 * carried) - 1.0), corner),
            ("separation at a support", abs(abs(one - two) / (2.0 * separate) - 1.0), corner),
        ):
            evidence.below(
                f"wind, {what}, part of it, {family} of {size:g} m", float(error),
                2.0 * SQUARES + limit, unit="1",
                reason=f"{SLOPES}, twice; {CORNERS}, twice" if limit else f"{SLOPES}, twice",
            )  # fmt: skip
    if family == "cubic":
        evidence.order(
            "wind, contact wires in mid-span, strings of cubic elements", sizes, errors, 1.0,
            tolerance=0.05, unit="element", reason="ℓ = h/√72 is of first order in h",
        )  # fmt: skip


def aside(system: WireSystem) -> WireSystem:
    return replace(system, messenger_stagger=[0.01] * len(system.messenger_stagger))


def on_contact_wires(load: Floats) -> Floats:
    """Take the wind from the messenger wire."""
    load[load[:, 1] < load[:, 1].max()] = 0.0
    return load


FAULTS = [
    Fault("gravity 1 % large", gravity(1.01), test_leaning_droppers, family="chain"),
    Fault("messenger wire 10 mm aside", wrong(systems, "_system", aside), test_leaning_droppers,
          family="chain"),
    Fault("messenger wire 10 mm aside, cubic elements", wrong(systems, "_system", aside),
          test_leaning_droppers, family="cubic"),
    Fault("wind 0.2 % strong", misbuilt("load", lambda load: 1.002 * load), test_wind,
          family="chain"),
    Fault("no wind on the messenger wire", misbuilt("load", on_contact_wires), test_wind,
          family="chain"),
    Fault("no wind on the messenger wire, cubic elements", misbuilt("load", on_contact_wires),
          test_wind, family="cubic"),
]  # fmt: skip
