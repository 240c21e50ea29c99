"""Wire of finite length under a moving force, explicit steps

The series of the wire under a moving force (see there), held against explicit steps, and the same
series as the steps have it. Modes of a chain of N elements are sin nπj/N; each obeys, with K, S and
F of explicit steps (`tests/support/explicit_waves.py`) and μ' = μℓ the mass of a point,

    y₊ − 2y + y₋ = h² a,   a = F (p − S y),   p = (2F₀/Nμ') Σ φⱼ(x) sin nπj/N,   u = y + h²a/4

where φ are the shares of the points in the place x: a cubic with the slopes of parabolas through
three points each (Keys, IEEE Trans. ASSP 29 (1981) 1153). Near the force y a place x has what the
wire yields beyond the chain as well: R F₀, R = (Σ φᵢ(x) φⱼ(y) g*(xᵢ − xⱼ) − g(x − y))/T, with the
corners g(s) = (|s| + λ e^{−|s|/λ})/2, λ² = EI/T, of the wire and g*(s) = (|s| + a e^{−|s|/d})/2 of
the chain, a = ℓ/sinh μ, d = ℓ/μ, 4 sinh² (μ/2) = T ℓ²/EI* (docs/theory/dynamics.md).

The program is asked by a run: a strip of 1e-9 kg, which rigid contact does not let ring, presses
with 100 N on a straight wire (60 m in 133 elements of 0.45 m, 20 kN, 1.35 kg/m, EI 0 or 200 N m²)
and goes from 10 m to 55 m, 1 ms. Compared are deflections at 15, 30 and 45 m and under the strip,
over the largest.
"""

from unittest.mock import patch

import numpy as np
import pytest

from arcless.model.line.parts.components import Wire
from tests.support import moving_force, straight
from tests.support.evidence import Evidence
from tests.support.explicit_waves import Stepped
from tests.support.faults import Fault, scaled, without
from tests.support.moving_force import LENGTH, START, STEP, Series, furthest, series
from tests.support.pushing import EXPLICIT, Pressed, press
from tests.support.python_faults import press_late
from tests.support.straight import Floats
from tests.verification.closed_forms.test_moving_force_string import FAST, KINDS, SLOW

COUNT = 133
X = np.linspace(0.0, LENGTH, COUNT + 1)


def run(kind: Wire, speed: float) -> Pressed:
    """Run the force along the chain."""
    line = straight.Straight(X, kind, fitted=True)
    time = STEP * np.arange(int((moving_force.END - START) / speed / STEP) + 1)
    place = START + speed * time
    points, force = moving_force.POINTS, moving_force.FORCE
    return press(line.find(), force, place, speed, STEP, points=points, scheme=EXPLICIT)


def shares(place: Floats) -> Floats:
    """φ of the inner points at places (place × point), none of them near an end."""
    distance = LENGTH / COUNT
    away = np.abs(place[:, None] - distance * np.arange(1, COUNT)) / distance
    near = 1.0 - 2.5 * away**2 + 1.5 * away**3
    further = 2.0 - 4.0 * away + 2.5 * away**2 - 0.5 * away**3
    return np.where(away < 1.0, near, np.where(away < 2.0, further, 0.0))


def stepped(kind: Wire, speed: float, steps: int) -> Series:
    """Explicit steps make the deflections of the closed form, too."""
    chain = Stepped.of(kind, LENGTH / COUNT, STEP)
    numbers = np.arange(1, COUNT)
    modes = np.sin(np.pi * np.outer(numbers, numbers) / COUNT)
    k = 4.0 * np.sin(0.5 * np.pi * numbers / COUNT) ** 2
    filtered, below = chain.balance(0.0)
    filtered, stiffness = filtered(k), below(k).real / filtered(k)
    place = START + speed * STEP * np.arange(steps + 1)
    phi = shares(place)
    load = 2.0 * moving_force.FORCE / (COUNT * chain.density * chain.distance) * phi @ modes
    y, d = load[0] / stiffness, np.zeros(COUNT - 1)
    found = []
    for p in load[1:]:
        y = y + d
        a = STEP**2 * filtered * (p - stiffness * y)
        d = d + a
        found.append(modes @ (y + 0.25 * a))
    u, phi, place = np.array(found), phi[1:], place[1:]
    watched = shares(np.array(moving_force.POINTS))
    force = moving_force.FORCE / kind.tension
    points = [
        u @ own + force * missing(kind, phi, own[None], place - at)
        for own, at in zip(watched, moving_force.POINTS, strict=True)
    ]
    under = (phi * u).sum(axis=1) + force * missing(kind, phi, phi, 0.0 * place)
    return Series(np.array(points).T, under)


def missing(kind: Wire, phi: Floats, other: Floats, apart: Floats) -> Floats:
    """T R between places, m: what the wire yields beyond the points of the chain."""
    # The core measures EI per unstretched length.
    radius = np.sqrt(kind.bending_stiffness / kind.tension)
    distance = LENGTH / COUNT

    def corner(s: Floats, rise: float, width: float) -> Floats:
        fading = rise * np.exp(-np.abs(s) / width) if width else 0.0
        return np.asarray(0.5 * (np.abs(s) + fading))

    rise = width = 0.0
    if radius:
        own = Stepped.of(kind, distance, STEP)
        # EI* as it follows from unstretched lengths, over the distance of the points.
        mu = 2.0 * np.arcsinh(0.5 * own.stretch / np.sqrt(own.shares[2]))
        rise, width = distance / np.sinh(mu), distance / mu
    points = distance * np.arange(1, COUNT)
    between = corner(np.subtract.outer(points, points), rise, width)
    of_points = ((phi @ between) * other).sum(axis=1)
    return np.asarray(of_points - corner(apart, radius, radius))


LEFT = (
    "waves shorter than four elements are not kept: of the kink F/T that is (F/T) 2ℓ/π² = 4.6e-4 m,"
    " of 0.108 m"
)
SOLVED = (
    "the steps are what the program solves: rounding moves the wire slowly, as by 1e-7 of a pulse"
    " at the speed of waves"
)


@pytest.mark.parametrize("name", KINDS)
def test_moving_force(evidence: Evidence, name: str) -> None:
    for speed, share in ((SLOW, "0.49"), (FAST, "0.90")):
        found = run(KINDS[name], speed)
        own = stepped(KINDS[name], speed, len(found.time))
        evidence.below(
            f"|w − series of the steps| / largest w, {name}, {share} c", furthest(found, own), 1e-7,
            unit="1", reason=SOLVED,
        )  # fmt: skip
        if speed == SLOW:
            exact = series(KINDS[name], speed, found.time, stepped=False)
            evidence.below(
                f"|w − series| / largest w, {name}, {share} c", furthest(found, exact), 4.3e-3,
                unit="1", reason=LEFT,
            )  # fmt: skip


FAULTS = [
    *(Fault(f"{column} of the chain 0.1 % too large", scaled("segments", column, 1.001),
            test_moving_force, name="string")
      for column in ("tension", "mass")),
    Fault("EI 1 % too large", scaled("bends", "EI", 1.01), test_moving_force, name="contact wire"),
    Fault("points yield as those of a chain", without("fitted_bends"), test_moving_force,
          name="contact wire"),
    Fault("chords between points", without("fitted_bends"), test_moving_force, name="string"),
    Fault("force half a step behind its place", press_late(__name__), test_moving_force,
          name="string"),
    Fault("elements of 0.5 m in place of 0.45 m",
          patch.multiple(__name__, X=np.linspace(0.0, LENGTH, 121)), test_moving_force,
          name="string"),
]  # fmt: skip
