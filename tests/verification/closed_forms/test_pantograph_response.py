"""Frequency response of a two-mass pantograph

The pantograph of EN 50318:2002 (15 kg on 50 N/m and 90 N s/m, 7.2 kg on 4200 N/m and 10 N s/m, base
to head) has the receptance `G(ω) = (K + iω C − ω² M)⁻¹`. Exact responses (derived here), with the
contact of k = 50 kN/m in series and e the head, r = (1, 1) the masses carried by the roof:

    head and frame, force on the head        u/F = G e
    contact force below a wavy wire          λ/z = −1/(1/k + e·G e)
    contact force on a moving roof           λ/z = e·G (K + iω C) r / (1/k + e·G e)

In steps of h the program must give the same with the rates of its scheme in place of iω and −ω²:
with z = exp(iωh), α_m, α_f, β, γ as in Damped oscillator and `n = (1 − α_f) z + α_f`,

    v = h (1 − γ + γ z)/(z − 1),   u = (h v + h² (½ − β + β z))/(z − 1)
    iω → v/u,   −ω² → ((1 − α_m) z + α_m)/(n u),   what is recorded = n × what ends the step

The program is asked with the shipped pantograph, the default scheme, 1 ms. Fifteen frequencies from
0.5 to 20 Hz act at once; once the start has died out, two seconds (a common period of all) are
compared by their Fourier coefficients. The free pantograph is drawn off the wire by 8 N; the wavy
wire is a chain of straight pieces of 5 cm, held, below which it runs at 1.5 m/s.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless.model import load_pantograph
from arcless.simulate.setup import pantographs
from arcless.simulate.setup.core_data import BaseMotion, Excitation, ForceHistory
from tests.support import bare, multisine, schemes
from tests.support.faults import Fault
from tests.support.run_faults import contact_scaled, pantograph_scaled, spoiled

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

H, SCHEME, CONTACT = 1e-3, schemes.DEFAULT, 50e3
FREQUENCIES = np.array([0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6.5, 8, 10, 12.5, 16, 20])
OMEGA, PERIOD = 2.0 * np.pi * FREQUENCIES, 2000
M = np.diag([15.0, 7.2])
C = np.array([[90.0 + 10.0, -10.0], [-10.0, 10.0]])
K = np.array([[50.0 + 4200.0, -4200.0], [-4200.0, 4200.0]])


waves = partial(multisine.waves, OMEGA)


def coefficients(values: Floats, t: Floats) -> Complex:
    """Fourier coefficients of the last two seconds."""
    return multisine.coefficients(OMEGA, values[-PERIOD:], t[-PERIOD:])


def free(t: Floats) -> list[Complex]:
    """Displacements of frame and head for a force on the head, m/N."""
    force = waves(t)
    drawn = np.where(t > 0.05, force - 8.0, force)
    found = asked(
        bare.wall(), 4.0, np.zeros(len(t)), Excitation([ForceHistory([0.0, 1.0], drawn.tolist())])
    )
    assert not found["force"][-PERIOD:].any(), "it hangs free"
    per_newton = 1.0 / coefficients(force, t)
    moved = found["masses"].reshape(-1, 2).T
    return [coefficients(one, found["time"]) * per_newton for one in moved]


def below_waves(t: Floats) -> list[Complex]:
    """Contact force for the height of the wire, N/m."""
    x = np.arange(0.0, 1.5 * t[-1] + 1.0, 0.05)
    wire = bare.wall((x - 0.5).tolist(), (1e-4 * waves(x / 1.5)).tolist())
    found = asked(wire, 400.0, 1.5 * t)
    assert found["force"].min() > 0.0, "it touches"
    height = coefficients(found["height"], found["time"])
    return [coefficients(found["force"], found["time"]) / height]


def on_roof(t: Floats) -> list[Complex]:
    """Contact force for the height of the roof, N/m."""
    base = BaseMotion(
        influence=[1.0, 1.0],
        displacement=(2e-3 * waves(t)).tolist(),
        rate=(2e-3 * multisine.rates(OMEGA, t)).tolist(),
    )
    found = asked(bare.wall(), 400.0, np.zeros(len(t)), Excitation([], base))
    assert found["force"].min() > 0.0, "it touches"
    height = coefficients(2e-3 * waves(t), t)
    return [coefficients(found["force"], found["time"]) / height]


def asked(wire: Any, force: float, positions: Floats, given: Any = pantographs.NOTHING) -> Any:
    """Run the shipped pantograph below a wire."""
    head = pantographs.data(load_pantograph("en50318-2002"), force, given)
    return bare.run(wire, head, bare.Asked(SCHEME, H, positions, contact_stiffness=CONTACT))


def exact(kind: str, s: Complex, q: Complex, recorded: Complex) -> list[Complex]:
    """Responses for the rates s and q; `recorded` is the record of 1 at the end of a step."""
    receptance = np.linalg.inv(K + s[:, None, None] * C + q[:, None, None] * M)
    head = receptance[:, 1, :]
    series = 1.0 / CONTACT + head[:, 1]
    if kind == "free":
        return [receptance[:, i, 1] * recorded for i in (0, 1)]
    if kind == "wavy wire":
        return [-1.0 / series]
    pull = (K + 1j * OMEGA[:, None, None] * C) @ np.ones(2)
    return [np.einsum("fi,fi->f", head, pull) / series * recorded]


# Seconds until the start has died out to exp(−25) and less; what rounding leaves, and why.
IN_FORCE = (
    "rounding of places, 1e-18 m over h² in every step, is a force of 1e-11 N on 7.2 kg of 1 N"
)
IN_PLACE = (
    "rounding of places of 0.2 m, 1e-17 m over h² in every step, moves 15 kg by 1e-15 m at 20 Hz;"
    " a force of 1 N moves the frame by 2e-7 m"
)
KINDS: dict[str, tuple[Callable[[Floats], list[Complex]], float, float, str]] = {
    "free": (free, 60.0, 1e-7, IN_PLACE),
    "wavy wire": (below_waves, 36.0, 1e-10, IN_FORCE),
    "roof": (on_roof, 40.0, 1e-10, IN_FORCE),
}


@pytest.mark.parametrize("kind", KINDS)
def test_response(evidence: Any, kind: str) -> None:
    response, settled, limit, reason = KINDS[kind]
    found = response(H * np.arange(round(settled / H) + PERIOD + 2))
    smooth = exact(kind, 1j * OMEGA, -(OMEGA**2) + 0j, np.ones(len(OMEGA), complex))
    ratios = np.array([one / other for one, other in zip(found, smooth, strict=True)])
    in_steps = np.exp(1j * OMEGA * H)
    at_balance = SCHEME.balanced(in_steps) / in_steps ** (1.0 - SCHEME.alpha_f)
    if kind == "wavy wire":
        evidence.figure(
            "force", {name: (FREQUENCIES, np.abs(values[0])) for name, values in
                      (("program", found), ("matrices", smooth))},
            x="frequency in Hz", y="contact force over height of the wire in N/m",
            title="EN 50318:2002 pantograph below a wavy wire", log_x=True, log_y=True,
        )  # fmt: skip
    stepped = exact(kind, *SCHEME.rates(in_steps, H), at_balance)
    evidence.below(
        f"{kind}: amplitude against the matrices, worst of 15 frequencies",
        float(np.max(np.abs(np.abs(ratios) - 1.0))),
        float((OMEGA[-1] * H) ** 2),
        unit="1",
        reason="second order: (ωh)² at 20 Hz",
    )
    evidence.below(
        f"{kind}: phase against the matrices, worst of 15 frequencies",
        float(np.degrees(np.abs(np.angle(ratios))).max()),
        0.2,
        unit="°",
        reason="a resonance at 5 Hz with a damping of 4 % moves by (ωh)²/12 = 8e-5, and turns the"
        " phase by 1/0.04 of that, 0.12°",
    )
    evidence.below(
        f"{kind}: against the matrices with the scheme's own rates, worst of 15 frequencies",
        float(max(np.max(np.abs(a / b - 1.0)) for a, b in zip(found, stepped, strict=True))),
        limit,
        unit="1",
        reason=reason,
    )


def still(arguments: dict[str, Any]) -> None:
    """Take the rate of the roof, which dampers feel."""
    (head,) = arguments["pantographs"]
    excitation = head.excitation
    base = excitation.base._replace(rate=[0.0 * value for value in excitation.base.rate])
    arguments["pantographs"] = [head._replace(excitation=excitation._replace(base=base))]


def turned(arguments: dict[str, Any]) -> None:
    """Turn round the sign of the damper between the masses."""
    (head,) = arguments["pantographs"]
    a, b, c, d = head.damping
    arguments["pantographs"] = [head._replace(damping=[a, -b, -c, d])]


FAULTS = [
    Fault("mass 1 % high", pantograph_scaled("mass", 1.01), test_response, kind="roof"),
    Fault("stiffness 1 % high", pantograph_scaled("stiffness", 1.01), test_response, kind="roof"),
    Fault("damping 1 % high", pantograph_scaled("damping", 1.01), test_response, kind="free"),
    Fault("contact 1 % stiff", contact_scaled(1.01), test_response, kind="wavy wire"),
    Fault("dampers do not feel the roof move", spoiled(running=still), test_response, kind="roof"),
    Fault("sign of the damper between the masses", spoiled(running=turned), test_response,
          kind="free"),
]  # fmt: skip
