"""Tables of the page convergence-published: the published and the default method, refined.

A line on which orders can be seen. Wires bend over √(EI/T), 0.09 m for the wires of PRAKS, shorter
than most elements; sixteen times the bending stiffness makes it 0.34 m. Backward differences damp
like β = τ, so the force is linear in τ only where τ is small beside the damping that is there:
β = 4 ms, and 100 N s/m in the pantograph.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from math import log2, pi
from typing import Any

import numpy as np
from numpy.typing import NDArray
from validation.runs import table

import arcless
from arcless import lcp
from arcless.assess.signals.filter import low_pass
from arcless.results import Result

Changes = dict[str, Any]
Floats = NDArray[np.float64]
Table = tuple[tuple[str, ...], list[tuple[object, ...]]]

SCENARIO = "praks-250"
SPEED = 250 / 3.6
PUBLISHED = ("lumped", "backward-difference", "updated")
DEFAULT = ("hermite", "generalised-alpha", "linearised")
# Five spans after the start and one before the end of the travel; 1 cm is a fifth of the finest
# element, and the record is interpolated to it.
FIRST, LAST = 30.0, 90.0
COMPARED = np.arange(FIRST, LAST, 0.01)
LADDER = (0.5, 0.25, 0.125, 0.0625)
FINE = 0.125, 1e-4
# The default method changes by a hundredth of a newton from here on; with updated kinematics, whose
# runs cost fifty times as much, that is enough.
FINE_UPDATED = 0.25, 2e-4

ANY_LINE: Changes = {
    "line.spans": [{"type": "standard", "count": 12}],
    "contact": {"law": "compliant"},
    "travel": {"start": 5.0, "end": 95.0},
    "analysis": {"from": FIRST, "to": LAST},
}
_DAMPING = {"alpha": 0.0, "beta": 4e-3}
WIRES = {"contact_wire": 145.0, "messenger_wire": 100.0}  # EI as shipped, N m²
STIFFER = 16.0
SMOOTH_LINE: Changes = {
    **ANY_LINE,
    "line.contact_wire.damping": _DAMPING,
    "line.messenger_wire.damping": _DAMPING,
    "pantographs.0.model.masses.0.damping": 100.0,
    "pantographs.0.model.masses.1.damping": 100.0,
    **{f"line.{wire}.bending_stiffness": STIFFER * EI for wire, EI in WIRES.items()},
}


@dataclass(frozen=True)
class Run:
    """Contact force of one run over COMPARED, N."""

    force: Floats
    filtered: Floats
    result: Result


def method(way: tuple[str, str, str], element: float, step: float) -> Changes:
    """Return the settings of a method, which differ in nothing but what it names.

    Residual flexibility, which updated kinematics and chains that are solved for leave out, is left
    out of all.
    """
    wire_model, scheme, kinematics = way
    return {
        "solver.residual_flexibility": False,
        "solver.wire_model": wire_model,
        "solver.scheme": scheme,
        "solver.kinematics": kinematics,
        "solver.contact_wire_element": element,
        "solver.messenger_wire_element": element,
        "solver.time_step": step,
    }


def smooth(way: tuple[str, str, str], element: float, step: float, **more: Any) -> Run:
    """Run the smooth line by a method."""
    return run(SMOOTH_LINE | method(way, element, step) | more)


def shipped(way: tuple[str, str, str], element: float, step: float) -> Run:
    """Run the PRAKS line as it ships, but for its contact law."""
    return run(ANY_LINE | method(way, element, step))


_known: dict[str, Run] = {}


def run(changes: Changes) -> Run:
    key = repr(sorted(changes.items()))
    if key not in _known:
        print(f"{SCENARIO} {method_of(changes)}", flush=True)
        result = arcless.run(arcless.load(SCENARIO).with_(**changes))
        data = result.dataset.isel(pantograph=0)
        x, force = data["position"].values, data["contact_force"].values
        rate = SPEED / (x[1] - x[0])
        smoothed = low_pass(force[:, np.newaxis], rate, 20.0)[:, 0]
        both = (np.interp(COMPARED, x, values) for values in (force, smoothed))
        _known[key] = Run(*both, result)
    return _known[key]


def method_of(changes: Changes) -> str:
    return " ".join(str(v) for k, v in changes.items() if k.startswith("solver."))


def rms(values: Floats) -> float:
    return float(np.sqrt(np.mean(values**2)))


def order(before: float | None, now: float) -> str:
    """Observed order between two rows, the second with half the element or step."""
    return "" if before is None else f"{log2(before / now):.2f}"


DIFFERENCE = ("rms N", "order", "max N", "order", "rms 20 Hz N", "order", "rms/σ %")
STATISTICS = ("mean N", "σ N", "uplift mm")


def statistics(run: Run) -> tuple[str, ...]:
    uplift = run.result.assessment.max_uplift_at_support_mm
    return f"{run.force.mean():.2f}", f"{run.force.std():.2f}", f"{uplift:.2f}"


def differences(titled: Iterable[tuple[tuple[str, ...], Run]], reference: Run) -> list[Any]:
    """Rows of differences to a reference, each with the order since the row before."""
    rows, before = [], (None, None, None)
    for title, found in titled:
        apart = found.force - reference.force
        now = rms(apart), float(np.abs(apart).max()), rms(found.filtered - reference.filtered)
        cells = [
            cell
            for value, last in zip(now, before, strict=True)
            for cell in (f"{value:.3f}", order(last, value))
        ]
        relative = f"{100 * now[0] / reference.force.std():.2f}"
        rows.append((*title, *cells, relative, *statistics(found)))
        before = now
    return rows


def ms(step: float) -> str:
    return f"{1e3 * step:.4g}"


def reference() -> Run:
    return smooth(DEFAULT, *FINE)


def reference_table() -> Table:
    finest = smooth(DEFAULT, FINE[0] / 2, FINE[1] / 2)
    ladder = ((0.5, 4e-4), (0.25, 2e-4), FINE)
    runs = [((f"{ell:g}", ms(step)), smooth(DEFAULT, ell, step)) for ell, step in ladder]
    return ("ℓ m", "τ ms", *DIFFERENCE, *STATISTICS), differences(runs, finest)


def wire_table() -> Table:
    way = ("lumped", *DEFAULT[1:])
    runs = [((f"{ell:g}",), smooth(way, ell, FINE[1])) for ell in LADDER]
    rows = differences(runs, reference())
    # What the two meanings of EI make: with δ = T/EA a chain has EI (1 + δ)³ per metre of stretched
    # wire, a Hermite element EI/(1 + δ).
    line = arcless.load(SCENARIO).line
    stretched = {
        f"line.{name}.bending_stiffness": STIFFER
        * EI
        * (1 + wire.tension / wire.axial_stiffness) ** 4
        for name, EI in WIRES.items()
        for wire in (getattr(line, name),)
    }
    title = (f"Hermite, {FINE[0]:g}, EI (1 + δ)⁴",)
    rows += differences([(title, smooth(DEFAULT, *FINE, **stretched))], reference())
    return ("ℓ m", *DIFFERENCE, *STATISTICS), rows


def scheme_table() -> Table:
    element = 0.25
    way = (DEFAULT[0], PUBLISHED[1], DEFAULT[2])
    steps = [element / SPEED / 2**k for k in range(7)]
    runs = [((ms(step),), smooth(way, element, step)) for step in steps]
    rows = differences(runs, smooth(DEFAULT, element, FINE[1]))
    return ("τ ms", *DIFFERENCE, *STATISTICS), rows


def kinematics_table() -> Table:
    updated = (*DEFAULT[:2], "updated")
    rows = []
    mesh = 0.5, 4e-4
    for gravity, title in ((9.81, "as is"), (0.0, "without weight")):
        before = None
        for force in (50.0, 100.0, 200.0):
            more = {"solver.gravity": gravity, "pantographs.0.static_force": force}
            flat, moved = smooth(DEFAULT, *mesh, **more), smooth(updated, *mesh, **more)
            now = rms(moved.force - flat.force)
            factor = "" if before is None else f"{now / before:.2f}"
            peak = float(np.abs(moved.force - flat.force).max())
            relative = f"{100 * now / flat.force.std():.3f}"
            row = (title, "0.5, 0.4", f"{force:g}", f"{now:.4f}", factor, f"{peak:.4f}", relative)
            rows.append(row)
            before = now
    finer = smooth(updated, *FINE_UPDATED).force - smooth(DEFAULT, *FINE_UPDATED).force
    chain = smooth(PUBLISHED, 0.25, 4e-4), smooth((*PUBLISHED[:2], "linearised"), 0.25, 4e-4)
    for title, apart in (
        ("0.25, 0.2", finer),
        ("0.25, 0.4, lumped, backward", chain[0].force - chain[1].force),
    ):
        relative = f"{100 * rms(apart) / reference().force.std():.3f}"
        peak = f"{float(np.abs(apart).max()):.4f}"
        rows.append(("as is", title, "100", f"{rms(apart):.4f}", "", peak, relative))
    return ("line", "ℓ m, τ ms", "static force N", "rms N", "factor", "max N", "rms/σ %"), rows


def published_table() -> Table:
    other = smooth((*DEFAULT[:2], "updated"), *FINE_UPDATED)
    rows = []
    for parts in (1, 8):
        steps = [(ell, ell / SPEED / parts) for ell in LADDER]
        runs = [((f"{ell:g}", ms(step)), smooth(PUBLISHED, ell, step)) for ell, step in steps]
        against_other = [f"{rms(found.force - other.force):.3f}" for _, found in runs]
        found = differences(runs, reference())
        rows += [(*row, last) for row, last in zip(found, against_other, strict=True)]
    # On one mesh what is left is of first order in τ: twice the shorter step less the longer one.
    ell, step = steps[-1]
    limit = 2 * runs[-1][1].force - smooth(PUBLISHED, ell, 2 * step).force
    apart = limit - reference().force
    cells = (f"{rms(apart):.3f}", "", f"{np.abs(apart).max():.3f}", "", "", "")
    relative = f"{100 * rms(apart) / reference().force.std():.2f}"
    shown = (f"{limit.mean():.2f}", f"{limit.std():.2f}", "")
    rows.append((f"{ell:g}", "→ 0", *cells, relative, *shown, f"{rms(limit - other.force):.3f}"))
    head = ("ℓ m", "τ ms", *DIFFERENCE, *STATISTICS, "rms N, default method updated")
    return head, rows


def praks_table() -> Table:
    rows = []
    found = shipped(DEFAULT, *FINE)
    runs = [(("default", "0.25", "0.2"), shipped(DEFAULT, 0.25, 2e-4))]
    rows += differences(runs, found)
    for parts in (1, 8):
        steps = [(ell, ell / SPEED / parts) for ell in LADDER]
        runs = [
            (("published", f"{ell:g}", ms(step)), shipped(PUBLISHED, ell, step))
            for ell, step in steps
        ]
        rows += differences(runs, found)
    blank = ("", "", "", "", "", "", "")
    rows.append(("default", f"{FINE[0]:g}", ms(FINE[1]), *blank, *statistics(found)))
    return ("method", "ℓ m", "τ ms", *DIFFERENCE, *STATISTICS), rows


def rigid_table() -> Table:
    rows = []
    for scheme in (DEFAULT[1], PUBLISHED[1]):
        way = (DEFAULT[0], scheme, DEFAULT[2])
        for parts in (1, 2, 4):
            step = 9e-4 / parts
            cells: list[str] = []
            for law in ("compliant", "rigid"):
                found = run(ANY_LINE | method(way, 0.25, step) | {"contact": {"law": law}})
                lost = 100 * np.mean(found.force == 0.0)
                peak = f"{found.force.max():.0f}"
                smooth_ = f"{found.filtered.std():.2f}"
                cells += [f"{found.force.std():.1f}", peak, f"{lost:.1f}", smooth_]
            rows.append((scheme, ms(step), *cells))
    values = ("σ N", "max N", "no contact %", "σ 20 Hz N")
    names = [f"{law}: {value}" for law in ("compliant", "rigid") for value in values]
    return ("scheme", "τ ms", *names), rows


def oscillation(omega_tau: float) -> tuple[float, float]:
    """Damping ratio and angle per step of an undamped oscillator, from its steps."""
    tau = 1e-3
    stepper = lcp.PublishedStep([[1.0]], [[0.0]], [[(omega_tau / tau) ** 2]], tau)
    u = [1.0, 1.0]
    for _ in range(40):
        u.append(float(stepper.step([u[-1]], [u[-2]], [0.0], np.zeros((1, 0)), []).u[0]))
    # Two neighbours determine the next: u_i = a u_{i−1} + b u_{i−2}, fitted; z² = a z + b.
    past = np.column_stack([u[1:-1], u[:-2]])
    # Every equation counts alike, however far the motion has decayed.
    size = np.abs(past).max(axis=1)
    a, b = np.linalg.lstsq(past / size[:, np.newaxis], np.array(u[2:]) / size, rcond=None)[0]
    z = np.roots([1.0, -a, -b])[0]
    decay, angle = -np.log(abs(z)), abs(np.angle(z))
    return float(decay / np.hypot(decay, angle)), float(angle)


def oscillator_table() -> Table:
    rows = []
    for omega_tau in (0.01, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0):
        damping, angle = oscillation(omega_tau)
        decay, turn = 0.5 * np.log1p(omega_tau**2), np.arctan(omega_tau)
        exact = decay / np.hypot(decay, turn)
        longer, exactly = omega_tau / angle - 1, omega_tau / turn - 1
        percent = [f"{100 * v:.5g}" for v in (damping, exact, longer, exactly)]
        rows.append((f"{omega_tau:g}", f"{2 * pi / omega_tau:.3g}", *percent))
    head = ("ωτ", "steps per period", "damping %", "closed form %")
    return (*head, "longer period %", "closed form %"), rows


def _made(make: Callable[[], Table]) -> Callable[[], str]:
    return lambda: table(*make())


TABLES = {
    name: _made(make)
    for name, make in {
        "reference": reference_table,
        "wires": wire_table,
        "scheme": scheme_table,
        "kinematics": kinematics_table,
        "published": published_table,
        "praks": praks_table,
        "rigid": rigid_table,
        "oscillator": oscillator_table,
    }.items()
}
