"""AC simple above 5 Hz, put together from kinks and from what droppers and arms change by

The mechanism of σ above 5 Hz is said to be the kinks of the contact wire at its droppers. With the
closed form of a pantograph that crosses a kink (section "A pantograph crosses a kink") the force
can be put together from them, without the product's elements, steps or contact: as a sum over the
droppers and the arm of a span, with their forces at rest. Then the same wire is sent waves by what
these forces change by in the run:

    z = z₀(x) + Σ ∫ (F_i − F_i0) dt/Z,   at t − |x − x_i|/c;   ΔP̂ = −D ẑ/(1 + D (1/k_c + H))

(`tests/support/superposed.py`; derived here.) What is asked: the force of the shipped runs at 5 to
20 Hz over the ten spans assessed, against each part and their sum.

**Kinks of constant forces explain none of it.** They alone would make a force of that size (21 to
30 N, the runs have 20 to 41 N), and it has nothing to do with the run's: the correlation is −0.08
to −0.42. For a dropper that the pantograph comes to has let go of its kink: of 90 passages 70 (on
the planar line at 275 km/h) to 90 (all others) meet a slack one. What is left is the weight of the
wire between, and waves from droppers that go slack and tighten. With these the same closed form has
95 to 97 % of the variance of three runs and 87 % of the fourth.

What stays open: the fourth, in space at 320 km/h. There the hinged arm turns while it is pulled,
by forces across the track that change, which the sum does not have; nor has it the masses of clamps
(0.165 kg: 3 % of ωZ at 12 Hz) and the bending of the waves that are sent.
"""

import numpy as np
import pytest

import arcless
from tests.support.evidence import Evidence
from tests.support.faults import Fault
from tests.support.python_faults import misled, wrong
from tests.support.superposed import Parts, Passing, superposed

LINES = {
    "planar, 275 km/h": "en50318-ac-simple-275-planar",
    "planar, 320 km/h": "en50318-ac-simple-320-planar",
    "in space, 275 km/h": "en50318-ac-simple-275",
    "in space, 320 km/h": "en50318-ac-simple-320",
}
CLAMPS = "masses of clamps, bending of the waves that are sent: some % of the force each"
LEFT = {
    "planar, 275 km/h": (0.07, CLAMPS),
    "planar, 320 km/h": (0.07, CLAMPS),
    "in space, 275 km/h": (0.07, CLAMPS),
    "in space, 320 km/h": (
        0.2,
        CLAMPS + "; and of the arm what its force across the track changes",
    ),
}


def found(case: str) -> tuple[Parts, float]:
    """Return the parts of a run, and the share of passages that meet a slack dropper."""
    scenario = arcless.load(LINES[case])
    rest = arcless.statics(scenario)
    result = arcless.run(scenario.with_(**{"output.line_every": 1}))
    parts, data = superposed(result, rest), result.dataset
    places = data["dropper_x"].values
    passed = np.flatnonzero((places > parts.x[0]) & (places < parts.x[-1]))
    when = np.searchsorted(data["position"].values[:, 0], places[passed])
    force = data["dropper_force"].values[when, passed]
    return parts, float((force <= 0.0).mean())


@pytest.mark.parametrize("case", LINES)
def test_superposed_kinks(evidence: Evidence, case: str) -> None:
    parts, slack = found(case)
    together = parts.kinks + parts.droppers + parts.arms
    limit, reason = LEFT[case]
    evidence.below(
        f"{case}: share of the variance that the sum leaves",
        (parts.run - together).var() / parts.run.var(), limit, unit="1", reason=reason,
    )  # fmt: skip
    evidence.close(
        f"{case}: σ of the sum at 5 to 20 Hz", together.std(), parts.run.std(), unit="N",
        relative=0.12, reason=reason,
    )  # fmt: skip
    evidence.within(
        f"{case}: correlation of the kinks with the run",
        float(np.corrcoef(parts.run, parts.kinks)[0, 1]), -0.6, 0.1, unit="1",
        reason="a dropper that is slack when the pantograph comes has no kink",
    )  # fmt: skip
    evidence.within(
        f"{case}: σ of the kinks over that of the run", parts.kinks.std() / parts.run.std(),
        0.6, 1.4, unit="1", reason="forces at rest of 46 to 191 N would do as much",
    )  # fmt: skip
    evidence.within(
        f"{case}: passages that meet a slack dropper", slack, 0.7, 1.0, unit="1",
        reason="the pantograph lifts the wire by more than droppers are stretched at rest",
    )  # fmt: skip
    if not case.endswith("275 km/h"):
        return
    shown = slice(0, int(np.searchsorted(parts.x, parts.x[0] + 110.0)))
    evidence.figure(
        "planar" if case.startswith("planar") else "space",
        {"run": (parts.x[shown], parts.run[shown]), "sum": (parts.x[shown], together[shown]),
         "kinks alone": (parts.x[shown], parts.kinks[shown])},
        x="place in m", y="force at 5 to 20 Hz in N", title=f"AC simple, {case}, two spans",
    )  # fmt: skip


FAULTS = [
    Fault("forces of droppers 5 ms late", misled(
        Passing, "sent", lambda own, x, f: (own, x, np.roll(f, 5, axis=0))),
        test_superposed_kinks, case="planar, 275 km/h"),
    Fault("droppers stay as they are at rest", misled(
        Passing, "sent", lambda own, x, f: (own, x, 0.0 * f)), test_superposed_kinks,
        case="planar, 275 km/h"),
    Fault("kinks of the other sign", wrong(Passing, "kinks", lambda found: -found),
          test_superposed_kinks, case="planar, 275 km/h"),
    Fault("no arm", wrong("tests.support.superposed", "arm_stiffness", lambda _: 0.0),
          test_superposed_kinks, case="planar, 275 km/h"),
]  # fmt: skip
