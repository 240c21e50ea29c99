"""Bands of a wire on equal springs, and a force that runs over it

Waves of a wire that rests on equal springs K, L apart, pass or are stopped, by

    cos qL = cos(ωL/c) + K/(2ω√(Tμ)) sin(ωL/c);   beyond ± 1 no wave runs

up to a first cut-off nothing, then band by band, each ending where half waves fit between springs,
ωL/c = nπ, whatever K is. With bending stiffness and near fields at the springs, and for forces at
any place, see `tests/support/bands.py`. All derived here; subject: Wu & Brennan, J. Sound Vib. 219
(1999) 483. In a contact wire droppers are such springs, as far as the messenger holds them; and in
space arms: a radial force F, in a hinged arm of the length l, is a spring K = F/l. A wire that
passes at ± y from arm to arm and resists bending is rounded there over λ = √(EI/T); where its
straight pieces would meet lies λ times their slope further out, so that

    F = 4Ty/(L − 2λ)

The program is asked by runs along a straight wire (288 m, 22 kN, 1.35 kg/m, 195 N m²; 0.5 ms) on
springs of 4 kN/m, 7.2 m apart, at rest, at 275 and at 320 km/h: a strip of 1 µg that presses has a
pulse more. In the plane, and with stagger (s = 0.03, turns each fourth spring). Then with stagger
and without springs: arms of 1.2 m, 28.8 m apart, which 1329 N make springs of 1.1 kN/m. From
three springs side by side C = (u₋₁ + u₁)/2u₀ at 1 to 20 Hz, in both kinds of bands and beyond the
force; where C = ± 1; and what one spring does over 1.2 s, below 20 Hz.
"""

from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest
from scipy.optimize import brentq

from tests.support.bands import OnSprings
from tests.support.evidence import Evidence
from tests.support.families import CONTACT, FAMILIES, Family, hold
from tests.support.faults import Fault, forgotten, scaled
from tests.support.moving_runs import CHAIN_FIRST, KMH, SPEEDS, Travel, Travelled, filtered
from tests.support.moving_wire import LINE, over_time
from tests.support.plans import IN_PLANE, STAGGERED, Plan
from tests.support.pushing import WEIGHTLESS, mass
from tests.support.python_faults import misled, wrong
from tests.support.straight import Floats
from tests.support.waves import Complex, pulse, spectrum

END, START, LAST = 288.0, 129.6, 1.7  # m, s
SPRING, APART = 4e3, 7.2  # N/m, m
MIDDLE, WIDTH, SIZE = 0.15, 0.012, 5.0  # s, N
# e^{−σt} at the end of the record is 4e-8.
WEIGHED = 10.0  # 1/s
HERTZ = np.linspace(1.0, 20.0, 191)
ARMED = Plan(0.03, apart=28.8, arms=1.2, said=", on arms of a staggered wire")
ROUNDED = float(np.sqrt(CONTACT.bending_stiffness / CONTACT.tension))  # m
PULL = CONTACT.tension * 2.0 * 0.03 * 28.8 / (28.8 - 2.0 * ROUNDED)  # N
PLANS = {"plane": IN_PLANE, "staggered": STAGGERED, "arms": ARMED}
KIND = {"plane": SPRING, "staggered": SPRING, "arms": PULL / 1.2}


def springs_of(family: Family, where: str) -> OnSprings:
    plan = PLANS[where]
    apart = (plan.apart if plan.arms and plan.apart else APART) * plan.longer
    return OnSprings(plan.along(family.waves(CONTACT), 0.0)[0], KIND[where], apart)


Run = tuple[list[float], Travelled]


@lru_cache
def run(name: str, size: float, speed: float, where: str) -> Run:
    """Return places of the springs, m, and what the pulse adds."""
    family, plan = FAMILIES[name], PLANS[where]
    line = plan.lay(family, family.even(END, size), CONTACT)
    springs = [float(x) for x in np.arange(APART, END - 1.0, APART)]
    if plan.arms:
        springs = list(plan.corners(END))
    else:
        for x in springs:
            line.add_spring(x, SPRING)
    travel = Travel(family, [mass(WEIGHTLESS)], np.inf, START, speed, LAST)
    found, nodes, time = line.find(), [line.node(x) for x in springs], travel.time
    force, loads = pulse(time, MIDDLE, WIDTH, SIZE), plan.loads(line, 86.4, time)
    more = travel.run(found, [force], nodes=nodes, loads=loads)
    return springs, more - travel.run(found, [0.0 * time], nodes=nodes)


def measured(springs: list[float], more: Travelled, hertz: Floats, speed: float) -> Complex:
    """C at ω − iσ: by least squares over all springs that have no force next to them."""
    omega = 2.0 * np.pi * hertz
    weight = np.exp(-WEIGHED * more.time)[:, None]
    moved = spectrum(more.time, weight * more.nodes, omega)
    gap = springs[1] - springs[0]
    reach = START + speed * np.array([MIDDLE - 6.0 * WIDTH, MIDDLE + 6.0 * WIDTH])
    x = np.array(springs[1:-1])
    free = (x + gap < reach[0] - 1.0) | (x - gap > reach[1] + 1.0)
    beside, own = 0.5 * (moved[:, :-2] + moved[:, 2:])[:, free], moved[:, 1:-1][:, free]
    return np.asarray((beside * own.conj()).sum(axis=1) / (abs(own) ** 2).sum(axis=1))


def edge(springs: list[float], more: Travelled, speed: float, near: float) -> float:
    """Frequency in Hz at which C is ± 1: C, which is smooth, brought to the real axis."""
    hertz = near + np.linspace(-2.5, 2.5, 51)
    values = measured(springs, more, hertz, speed)
    offset = hertz - near - 1j * WEIGHED / (2.0 * np.pi)
    powers = np.vander(offset, 9, increasing=True)
    shares = np.linalg.lstsq(powers, values, rcond=None)[0]
    limit = float(np.sign(shares[0].real))

    def off(away: float) -> float:
        return float((shares @ away ** np.arange(9)).real) - limit

    tried = np.linspace(-0.3, 0.3, 601)
    signs = np.sign([off(one) for one in tried])
    at = np.flatnonzero(signs[1:] != signs[:-1])
    best = at[int(np.argmin(abs(tried[at])))]
    return near + float(brentq(off, tried[best], tried[best + 1]))


def uplift(on_springs: OnSprings, time: Floats, place: float, speed: float, plan: Plan) -> Floats:
    """Return the uplift in m of the spring at a place, m, under the pulse that runs along."""
    when = np.arange(MIDDLE - 6.0 * WIDTH, MIDDLE + 6.0 * WIDTH, 2e-3)
    force = pulse(when, MIDDLE, WIDTH, SIZE) * 2e-3
    # Beyond, the pulse has nothing: e^{−σt} below the axis would bring up what is cut off.
    low = LINE.real < 2.0 * np.pi * 120.0
    values = np.zeros_like(LINE)
    away = plan.longer * (START + speed * when - place)
    moved = on_springs.moved(LINE[low], away)
    values[low] = (moved * np.exp(-1j * np.outer(LINE[low], when))) @ force
    return over_time(lambda _: values, time)


# Largest |C − closed form| from 1 to 20 Hz, error of an edge in Hz, and of the uplift over its
# largest, for three sizes.
COSINES = {"chain": (2e-3, 1e-3, 6e-4), "cubic": (4e-3, 2.5e-3, 2.5e-3)}
EDGES = {"chain": (0.01, 4e-3, 1.5e-3), "cubic": (0.06, 0.015, 4e-3)}
UPLIFTS = {"chain": (6e-3, 3e-3, 3e-3), "cubic": (0.02, 5e-3, 4e-3)}
SLOWER = {
    "chain": "waves of 20 Hz, 6.4 m long, have 11 points of 0.6 m; the error falls with ℓ⁴ down to"
    " that of the time step, (ωh)²/24 of kL: 2e-4 of 7",
    "cubic": "waves of 20 Hz, 6.4 m long, have four elements of 1.44 m; the error falls with ℓ⁴"
    " down to that of the time step, (ωh)²/12 of kL: 3e-4 of 7",
}
FLAT = " and near an edge C is flat: 0.01 of it is 0.03 Hz at 17.8 Hz"
AHEAD = (
    "what reaches a spring has passed bands of long waves: points of 0.6 m or elements of 1.44 m"
    " tell at 15 Hz and more; then steps of 0.5 ms, (ωh)²/12 = 1e-3 at 35 Hz, where the filter ends"
)


@pytest.mark.parametrize("number", [None, 0, pytest.param(1, marks=pytest.mark.evidence)])
@pytest.mark.parametrize("where", PLANS)
@pytest.mark.parametrize("name", CHAIN_FIRST)
def test_bands(evidence: Evidence, name: str, where: str, number: int | None) -> None:
    speed = 0.0 if number is None else SPEEDS[number]
    # Smaller elements show the error of the time step alone.
    family = replace(FAMILIES[name], sizes=FAMILIES[name].sizes[:3])
    exact, plan = springs_of(family, where), PLANS[where]
    what = f"{speed / KMH:.0f} km/h{plan.said}"
    runs = [run(name, size, speed, where) for size in family.sizes]
    wanted = exact.cosine(2.0 * np.pi * HERTZ - 1j * WEIGHED)
    found = [measured(*own, HERTZ, speed) for own in runs]
    longer = exact.apart / APART
    hold(
        evidence, family, f"|C − closed form|, 1 to 20 Hz, {what}",
        [float(abs(own - wanted).max()) for own in found],
        [longer * limit for limit in COSINES[name]], reason=SLOWER[name], unit="1",
    )  # fmt: skip
    if not plan.arms:
        edges = exact.edges(20.0)
        off = [max(abs(edge(*own, speed, near) - near) for near in edges) for own in runs]
        hold(
            evidence, family, f"ends of bands, 3.1 to 18.4 Hz, {what}", off, EDGES[name],
            reason=SLOWER[name] + FLAT, unit="Hz",
        )  # fmt: skip
    if number is not None:
        check_uplift(evidence, family, runs, number, where)
    if where == "plane" and number is None and name == "chain":
        draw(evidence, exact)


def check_uplift(
    evidence: Evidence, family: Family, runs: list[Run], number: int, where: str
) -> None:
    """Hold what the spring that the pulse runs to does over time."""
    speed, plan, exact = SPEEDS[number], PLANS[where], springs_of(family, where)
    springs, more = runs[0]
    which = int(np.searchsorted(springs, START + speed * MIDDLE + 2.0))
    wanted = filtered(uplift(exact, more.time, springs[which], speed, plan))
    early = more.time < MIDDLE + 1.2
    off = [
        float(abs(filtered(own.nodes[:, which]) - wanted)[early].max() / abs(wanted).max())
        for _, own in runs
    ]
    rounded = round(speed / KMH)
    hold(
        evidence, family, f"uplift of a spring below 20 Hz, {rounded} km/h{plan.said}", off,
        UPLIFTS[family.name], reason=AHEAD, unit="1",
    )  # fmt: skip
    if where != "plane":
        return
    time = more.time[early]
    evidence.figure(
        f"uplift-{family.name}-{rounded}",
        {"closed form": (time, 1e3 * wanted[early]),
         "run": (time, 1e3 * filtered(runs[1][1].nodes[:, which])[early])},
        x="time in s", y="uplift in mm",
        title=f"A spring, {rounded} km/h, {family.name} of {family.sizes[1]:g} m",
    )  # fmt: skip


def draw(evidence: Evidence, exact: OnSprings) -> None:
    """Hold where bands are against what is known of their ends, and draw them."""
    edges = exact.edges(20.0)
    evidence.close(
        "first cut-off over that of a foundation K/L", edges[0],
        np.sqrt(SPRING / APART / exact.wire.density) / (2.0 * np.pi), unit="Hz", relative=0.06,
        reason="springs far apart are softer: κL²/12T = 11 % of the stiffness, half of it here",
    )  # fmt: skip
    for bottom, half_waves in ((edges[1], 1), (edges[3], 2)):
        evidence.close(
            f"end of pass band {half_waves}: half waves between springs", bottom,
            half_waves * exact.wire.speed / (2.0 * exact.apart), unit="Hz", relative=6e-3,
            reason="bending makes short waves faster: EI k²/2T, 0.1 and 0.35 %",
        )  # fmt: skip
    hertz = np.linspace(1.0, 20.0, 400)
    values = exact.cosine(2.0 * np.pi * hertz + 0j).real
    evidence.figure(
        "bands", {"C": (hertz, values), "1": (hertz, 0.0 * hertz + 1.0),
                  "−1": (hertz, 0.0 * hertz - 1.0)},
        x="frequency in Hz", y="cos qL", title="A wire on springs: waves pass where |C| < 1",
    )  # fmt: skip


SOFTER = wrong(__name__, "springs_of", lambda exact: replace(exact, spring=1.02 * exact.spring))
FAULTS = [
    *(Fault(f"{name}: {what}", [forgotten(run), broken], test_bands, name=name, where="plane",
            number=None)
      for name in ("chain", "cubic")
      for what, broken in (
          ("springs 2 % too stiff", scaled("springs", "stiffness", 1.02)),
          ("wire 1 % too heavy", scaled("wires", "mass", 1.01)),
      )),
    Fault("staggered: springs 2 % too stiff",
          [forgotten(run), scaled("springs", "stiffness", 1.02)], test_bands, name="chain",
          where="staggered", number=0),
    Fault("arms: 2 % softer than F/l", SOFTER, test_bands, name="chain", where="arms",
          number=None),
    Fault("a force that runs 2 % too fast",
          misled(__name__, "uplift", lambda e, t, x, v, p: (e, t, x, 1.02 * v, p)), test_bands,
          name="chain", where="plane", number=0),
]  # fmt: skip
