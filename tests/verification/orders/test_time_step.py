"""Time step of each scheme, on an oscillator

A mass m = 2 kg on a spring and a damper (5 Hz, ζ = 2 %) under a force that begins and ends
smoothly, `f(t) = 100 N sin⁴(π t/T)` for T = 0.5 s. Theory: order 2 for generalised-alpha, HHT, the
trapezoidal rule and Newmark with γ = ½ (Chung & Hulbert 1993); order 1 for Newmark with γ > ½, with
an error of (γ − ½) ωh/2 in damping (Hughes, The Finite Element Method, section 9.3), and for
one-sided differences. Both are cited second hand.

Reference: `sin⁴` is a sum of three cosines; the answer to each, and the free motion that makes the
start one at rest, are elementary. The program is asked twice, for a node of a line and for a
coordinate of a pantograph; the error is the largest at any step. Values belong to the time of
balance of the scheme, and are compared with the exact motion there.
"""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless.simulate.setup.core_data import LoadData
from tests.support import bare, schemes
from tests.support.faults import Fault, scaled
from tests.support.run_faults import pantograph_scaled, stepped_by
from tests.support.schemes import Member

Floats = NDArray[np.float64]

DURATION, MASS, OMEGA, ZETA = 0.5, 2.0, 2.0 * np.pi * 5.0, 0.02
DAMPING, STIFFNESS = 2.0 * ZETA * OMEGA * MASS, OMEGA**2 * MASS
STEPS = (1e-3, 5e-4, 2.5e-4, 1.25e-4)
# sin⁴ a = 3/8 − ½ cos 2a + ⅛ cos 4a
COSINES = {0: 3.0 / 8.0, 2: -1.0 / 2.0, 4: 1.0 / 8.0}


def force(t: Floats) -> Floats:
    """Force at instants, N."""
    return np.asarray(100.0 * np.sin(np.pi * t / DURATION) ** 4)


def exact(t: Floats) -> Floats:
    """Displacement at instants, m."""
    forced = np.zeros(len(t), dtype=complex)
    start = rate = 0j
    for number, share in COSINES.items():
        nu = number * np.pi / DURATION
        answer = 100.0 * share / (STIFFNESS - MASS * nu**2 + 1j * DAMPING * nu)
        forced += answer * np.exp(1j * nu * t)
        start += answer
        rate += 1j * nu * answer
    own = OMEGA * np.sqrt(1.0 - ZETA**2)
    first, second = -start.real, (-rate.real - ZETA * OMEGA * start.real) / own
    free = np.exp(-ZETA * OMEGA * t) * (first * np.cos(own * t) + second * np.sin(own * t))
    return np.asarray(forced.real + free)


def error(scheme: Member, h: float) -> float:
    """Largest error of both, m."""
    steps = round(DURATION / h)
    acting = force(h * np.arange(steps + 1))
    line = bare.oscillator(MASS, DAMPING, STIFFNESS)
    loads = [LoadData([(2, 1, 1.0)], acting.tolist())]
    asked = bare.Asked(scheme, h, bare.stand(0.5, steps), nodes=[2], loads=loads)
    on_line = bare.run(line, bare.free_mass(1.0, 10.0, np.zeros(steps + 1)), asked)
    matrices = (np.diag(pair) for pair in ([MASS, 1.0], [DAMPING, 0.0], [STIFFNESS, 0.0]))
    head = bare.pantograph(*matrices, strip=[0.0, 1.0], force=10.0, given=[([1.0, 0.0], acting)])
    on_pantograph = bare.run(bare.wall(), head, bare.Asked(scheme, h, bare.stand(0.0, steps)))
    moved = on_pantograph["masses"].reshape(-1, 2)[:, 0]
    return float(
        max(
            np.abs(on_line["uplift"] - exact(on_line["line_time"])).max(),
            np.abs(moved - exact(on_pantograph["time"])).max(),
        )
    )


@pytest.mark.parametrize("scheme", schemes.ALL, ids=lambda scheme: scheme.label)
def test_order(evidence: Any, scheme: Member) -> None:
    first = scheme not in schemes.SECOND_ORDER
    evidence.order(
        f"{scheme.label}: displacement, m",
        STEPS,
        [error(scheme, h) for h in STEPS],
        1.0 if first else 2.0,
        tolerance=0.05 if first else 0.003,
        reason="the next term is ωh = 0.03 of the first at 1 ms, and falls with h"
        if first
        else "the next terms are (ωh)² = 1e-3 of the first at 1 ms",
        unit="h",
    )


FAULTS = [
    *(Fault(f"{scheme.label}: {what}", broken, test_order, scheme=scheme)
      for scheme in schemes.BY_NAME
      for what, broken in (
          ("spring of the line 1 % stiff", scaled("springs", "stiffness", 1.01)),
          ("damper of the pantograph 10 % strong", pantograph_scaled("damping", 1.1)),
      )),
    Fault("newmark with γ = 0.51 in place of 0.5", stepped_by(schemes.newmark(0.26, 0.51)),
          test_order, scheme=schemes.newmark(0.25, 0.5)),
    Fault("default scheme in place of one-sided differences", stepped_by(schemes.DEFAULT),
          test_order, scheme=schemes.ALL[-1]),
]  # fmt: skip
