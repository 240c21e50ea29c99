"""Energy of a run

Multiplying the balance of a time step by its increment Δu gives, for every scheme, an identity
in joules:

    stored + dissipated + taken by the scheme + lost where a contact or dropper switches = work done

(the terms are derived in docs/theory/energy.md). The program books each term from the matrices;
the solver never forms the products it is booked from. Here the terms of the result are added up
anew, for every scheme, contact law, friction, gusts, a controlled force, and slack droppers:
what is left is rounding. For the trapezoidal rule nothing may be taken by the scheme either
(its α_f = ½, α_m = ½ make the extra terms vanish).

That a ledger adds up says nothing of its terms. So those of the pantograph are found a second
time, from the recorded motion x of its three masses and the contact force F alone, by the
trapezoidal rule written out: x is that of the middle of a step, so

    u' = 2x − u,  Δ = u' − u,  v' = 2Δ/h − v

    stored      ½ Σ m v² + ½ Σ k (uᵢ − uᵢ₋₁)² − P (u₃ − u₁)   P = 150 N, static force
    dissipated  Σ c (Δᵢ − Δᵢ₋₁)²/h                            added up over the steps
    work        P u₁  of the uplift,  − F Δ₃  of the contact, added up

and the theorem of energy for these recorded series, stored + dissipated = work, is checked by
itself: no term of it comes from the ledger. The pantograph stands on a damper alone (k₁ = 0),
so that P is all that carries it.

Line: four uneven spans in space (`tests/support/small.py`), 1309 steps at 275 km/h; and the
shipped case AC simple at 320 km/h with 11 000 steps.
"""

from dataclasses import replace
from functools import cache
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

import arcless
from arcless.pantograph.equation_of_motion import Matrices
from arcless.results import Result
from arcless.simulate.recording import record
from arcless.simulate.setup import pantographs
from tests.support.faults import Fault, forgotten
from tests.support.python_faults import not_booked, wrong
from tests.support.small import FORCE, small

BASE = "pantographs.0.model.masses.0"
TRAPEZOIDAL = {"solver.scheme": {"name": "trapezoidal"}}
CASES: dict[str, dict[str, Any]] = {
    "trapezoidal rule": TRAPEZOIDAL,
    "generalised-alpha": {},
    "HHT": {"solver.scheme": {"name": "hht", "alpha": -0.1}},
    "backward differences": {"solver.scheme": {"name": "backward-difference"}},
    "rigid contact, loss of contact": {
        "contact.law": "rigid",
        "solver.scheme": {"name": "generalised-alpha", "spectral_radius": 0.0},
        "pantographs.0.static_force": 60.0,
    },
    "friction along the wire": {"contact.friction_coefficient": 0.3},
    "gusts": {
        "line.contact_wire.diameter": "12 mm",
        "line.messenger_wire.diameter": "14 mm",
        "as_built.wind.speed": 12.0,
        "as_built.gusts": {"time": [0.0, 0.4, 0.8, 2.0], "speed": [12.0, 19.0, 7.0, 15.0]},
    },
    "controlled force": {
        "pantographs.0.controller": {
            "sample_time": "5 ms",
            "pid": {"target": 150.0, "proportional": 0.4, "integral": 2.0},
        }
    },
}


def terms(result: Result) -> dict[str, Any]:
    """Return the entries of the ledger, J over line_time, without the residual."""
    data = result.dataset
    named = {str(n).removeprefix("energy_"): data[n].values for n in data if "energy_" in str(n)}
    named.pop("residual")
    return named


def remainder(result: Result) -> tuple[float, float]:
    """Return what the terms leave, and the energy turned over, J."""
    found = terms(result)
    signs = {name: -1.0 if name.startswith("work_") else 1.0 for name in found}
    left = sum(signs[name] * values for name, values in found.items())
    stored = sum(np.abs(found[name]) for name in ("kinetic", "elastic", "pantograph"))
    done = sum(np.abs(values) for name, values in found.items() if name.startswith("work_"))
    assert len(left) > 200, "many instants"
    return float(np.max(np.abs(left))), float(np.max(np.maximum(stored, done)))


@cache
def ran(case: str) -> Result:
    return arcless.run(small(**CASES[case] | {"output.energy": "always"}))


@pytest.mark.parametrize("case", CASES)
def test_the_ledger_closes(evidence: Any, case: str) -> None:
    result = ran(case)
    assert result.metadata["slack_droppers_max"] > 0, "droppers go slack"
    left, turnover = remainder(result)
    evidence.below(
        f"{case}: what the terms leave, over the energy turned over",
        left / turnover,
        2e-12,
        unit="1",
        reason="1309 steps with rounding of 2e-16 of the energy stored each, 3e-13 at worst;"
        " elastic energies are differences of larger ones: some times that",
    )


def test_the_trapezoidal_rule_takes_nothing(evidence: Any) -> None:
    result = ran("trapezoidal rule")
    taken = float(np.max(np.abs(terms(result)["dissipated_scheme"])))
    evidence.below(
        "trapezoidal rule: energy taken by the scheme, over the energy turned over",
        taken / remainder(result)[1],
        2e-12,
        unit="1",
        reason="zero but for the same rounding",
    )


@cache
def on_a_damper() -> Result:
    changes = TRAPEZOIDAL | {f"{BASE}.stiffness": 0.0, "output.line_every": 1}
    return arcless.run(small(**changes))


def of_the_motion(result: Result) -> dict[str, Any]:
    """Find the energies of the pantograph from its recorded motion, J over the ends of steps."""
    masses = result.scenario.pantographs[0].model.masses
    m, c, k = (
        np.array([getattr(part, name) or 0.0 for part in masses])
        for name in ("mass", "damping", "stiffness")
    )
    middle = result.dataset["mass_displacement"].values[:, 0]
    force, h = result.dataset["contact_force"].values[:, 0], result.scenario.time_step_s
    u, v, lost, pushed, rows = 0.0 * m, 0.0 * m, 0.0, 0.0, []
    for x, contact in zip(middle, force, strict=True):
        step = 2.0 * (x - u)
        u, v = u + step, 2.0 * step / h - v
        lost += float(c @ np.diff(step, prepend=0.0) ** 2) / h
        pushed += contact * step[-1]
        stored = 0.5 * m @ v**2 + 0.5 * k @ np.diff(u, prepend=0.0) ** 2
        rows.append((stored - FORCE * (u[-1] - u[0]), lost, FORCE * u[0], pushed))
    names = ("pantograph", "dissipated_pantograph", "work_uplift", "contact")
    return dict(zip(names, np.array(rows).T, strict=True))


def test_energies_of_the_pantograph(evidence: Any) -> None:
    result = on_a_damper()
    own, booked = of_the_motion(result), terms(result)
    scale = float(np.ptp(own["contact"]))
    assert scale > 1.0, "energy goes through the contact"
    speeds = (
        "u' = 2x − u adds up the rounding of x, 1e-17 m, over 1309 steps, and v' that of 2Δ/h"
        " with 2/h = 2000/s: 2e-8 m/s of 0.1 m/s if all errors had one sign; a hundredth of that"
    )
    plain = "rounding of x, 1e-17 m of 0.01 m, over 1309 steps, as often up as down; ten times that"
    for name, words, limit, reason in (
        ("pantograph", "stored in the pantograph", 3e-9, speeds),
        ("dissipated_pantograph", "dissipated in its dampers", 2e-13, plain),
        ("work_uplift", "work of the uplift", 2e-13, plain),
    ):
        assert np.ptp(own[name]) > 1.0, "there is something to compare"
        evidence.below(
            f"{words}: ledger against the recorded motion, over the work of the contact",
            float(np.max(np.abs(own[name] - booked[name]))) / scale,
            limit,
            unit="1",
            reason=reason,
        )
    left = own["pantograph"] + own["dissipated_pantograph"] - own["work_uplift"] + own["contact"]
    evidence.below(
        "energy theorem of the recorded motion and force alone, over the work of the contact",
        float(np.max(np.abs(left))) / scale,
        3e-9,
        unit="1",
        reason=speeds,
    )


@pytest.mark.evidence
def test_a_whole_shipped_run(evidence: Any) -> None:
    force = {"pantographs.0.mean_force": None, "pantographs.0.static_force": 172.0}
    result = arcless.run(arcless.load("en50318-ac-simple-320-planar").with_(**TRAPEZOIDAL | force))
    assert result.metadata["slack_droppers_max"] > 0, "droppers go slack"
    left, turnover = remainder(result)
    evidence.below(
        "AC simple, 320 km/h, trapezoidal rule: what the terms leave, over the energy turned over",
        left / turnover,
        1e-11,
        unit="1",
        reason="11 000 steps with rounding of 2e-16 of the energy stored each, 2e-12 at worst; some"
        " times that",
    )


def damped(found: Matrices) -> Matrices:
    return replace(found, damping=1.0001 * found.damping)


def late(found: dict[str, Any]) -> dict[str, Any]:
    force = found["contact_force"].copy()
    force[1:] = force[:-1]
    return found | {"contact_force": force}


AFRESH = forgotten(ran, on_a_damper)
DAMPING = {"solver.scheme": {"name": "generalised-alpha", "spectral_radius": 0.999}}
FAULTS = [
    *(Fault(f"`{term}` not booked", [AFRESH, not_booked(term)], test_the_ledger_closes, case=case)
      for term, case in (
          ("energy_dissipated_supports", "generalised-alpha"),
          ("energy_switching", "rigid contact, loss of contact"),
          ("energy_work_control", "controlled force"),
          ("energy_work_friction", "friction along the wire"),
          ("energy_work_wind", "gusts"),
      )),
    Fault("spectral radius 0.999 in place of 1",
          [AFRESH, patch.dict(CASES, {"trapezoidal rule": DAMPING})],
          test_the_trapezoidal_rule_takes_nothing),
    Fault("dampers 0.01 % off", [AFRESH, wrong(pantographs, "matrices", damped)],
          test_energies_of_the_pantograph),
    Fault("contact force one step late", [AFRESH, wrong(record, "dynamic_variables", late)],
          test_energies_of_the_pantograph),
]  # fmt: skip
