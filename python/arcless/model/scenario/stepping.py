"""Choice of scheme, elements and time step where `solver` leaves them to `auto`.

Explicit steps on chains of point masses wherever a line allows them, otherwise a matrix with cubic
elements and residual flexibility. The goal of both: F_m, σ, maximum and uplift within 1 % of the
limit of refined elements, the minimum within 1 % of F_m (of a trailing pantograph 1.5 %); measured
in docs/validation/limits.md.

**Elements.** A pantograph at the speed v sends a wave of frequency f ahead that is c/(c − v) times
as fast at a fixed point; with f the low-pass frequency of the assessment

    λ₊ = (c − v)/f,    λₘ = λ₊ cₘ/c

are the shortest waves that matter on the contact wire and on the wires above, whose slowest has the
wave speed cₘ. Errors grow with the fourth power of element over wavelength:

    chains    contact wire max(λ₊/8, min(0.30 m, λ₊/5)), others λₘ/5, both at most 0.45 m;
              at most 0.20 m where a wire is clamped to another, 0.30 m where it has a mass of
              more than 1 kg: there R of the points cannot be taken from a compliance
    cubic     λ₊/3.3 and λₘ/3.3, both at most 0.725 m

rounded down to a ladder, so that runs at similar speeds share their elements.

**Time step.** 1 ms; 0.5 ms for conductor rails, whose spans ring below trailing pantographs (σ of
the second, 100 m apart, is 1.7 % off with 1 ms); less where explicit steps would not be stable with
the elements, or above 0.7 c, where a fixed point sees f as f c/(c − v) and a step of
0.42/(2π f) (c − v)/c resolves that. Lengths and steps were found by measurement on the shipped
lines and on random ones, one error source at a time.
"""

from dataclasses import dataclass
from math import floor, pi, sqrt, tanh
from typing import Final

from arcless.model.line.parts.components import TensionedWire
from arcless.model.line.places.wire_places import shortest_distances
from arcless.model.scenario.scenario_data import ScenarioData
from arcless.model.settings.run_settings import AUTO, ONE_ELEMENT, Solver
from arcless.model.settings.schemes import (
    EXPLICIT,
    Auto,
    CentralDifference,
    GeneralisedAlpha,
    Scheme,
)

# Lengths of elements in m that `auto` takes: each about a sixth shorter than the one before.
LADDER: Final = (0.725, 0.6, 0.5, 0.45, 0.4, 0.35, 0.3, 0.25, 0.2, 0.15)
# Wavelengths of the contact wire over its elements, and of the other wires over theirs.
PER_WAVE_OF_CHAIN = 8.0, 5.0
PER_WAVE_OF_CUBIC = 3.3, 3.3
# A contact wire of chains may have these, in m, where λ₊ is PER_WAVE_AT_SPEED of them.
FINE_ENOUGH, PER_WAVE_AT_SPEED = 0.30, 5.0
# Wires next to a clamp of a bridle, in m: with 0.30 the elasticity there is up to 0.6 % off.
LONGEST_CLAMPED = 0.20
LONGEST_OF_CHAIN, LONGEST_OF_CUBIC = 0.45, 0.725
# Points along the wire are so many of the shortest stable distances apart; and the share of the
# stiffest spring along the track that explicit steps keep stable by themselves.
REACH, STIFFEST_ALONG = 1.5, 0.5
# Masses in kg above which the points of 0.45 m, which yield 0.3 µm/N too much, send back 0.5 % too
# much of a wave of 20 Hz (docs/validation/closed-forms.md).
HEAVY = 1.0
# Cubic elements without residual flexibility, which updated kinematics leave out, in m.
LONGEST_ALONE = 0.35
# Steps in s that `auto` takes. Shorter explicit ones than the shortest cost more than a matrix.
STEPS = (1e-3, 0.8e-3, 0.6e-3, 0.5e-3, 0.4e-3, 0.3e-3, 0.25e-3, 0.2e-3)
LONGEST_STEP, SHORTEST_STEP = STEPS[0], STEPS[-1]
STEP_OF_RAILS = 0.5e-3
# ω h of the highest frequency that counts, f c/(c − v) at a fixed point.
LARGEST_ANGLE = 0.42
# Share of the longest stable step of a wire by itself that is taken: the core keeps 5 % for
# contacts and links, and its estimate has the ends of wires and their masses in it.
STABLE_SHARE = 0.9
# ω² h² of what central differences just keep stable.
LIMIT = 4.0
# A length that is given may be longer than the rule's by rounding.
ROUNDING = 1.001


@dataclass(frozen=True)
class Choice:
    """Scheme, elements and time step that a run takes.

    Attributes
    ----------
    solver
        The solver settings with nothing left to `auto`.
    why
        Why a matrix is taken where the scheme was left to `auto`; empty otherwise.
    contact_wire, messenger_wire
        Longest elements in m by the rule for the family that is taken.
    """

    solver: Solver
    why: str
    contact_wire: float
    messenger_wire: float

    @property
    def sentence(self) -> str:
        """Say how a run steps, and why with a matrix where that was left to `auto`."""
        solver, step = self.solver, self.solver.time_step
        length = "one element" if isinstance(step, str) else f"{1e3 * step:g} ms"
        family = "point masses" if solver.wires == "lumped" else "cubic elements"
        lengths = f"{solver.contact_wire_element_m:g} and {solver.messenger_wire_element_m:g} m"
        kind = (
            "explicit steps" if solver.scheme.name == EXPLICIT else f"{solver.scheme.name}, steps"
        )
        why = f"; a matrix because {self.why}" if self.why else ""
        return f"{kind} of {length}, {family} {lengths} apart at most{why}"


def choose(scenario: ScenarioData) -> Choice:
    """Return what a run of a scenario takes."""
    given = scenario.solver
    if given.scheme.name == EXPLICIT:
        return _with(scenario, CentralDifference(name=EXPLICIT), "")
    if not isinstance(given.scheme, Auto):
        return _with(scenario, given.scheme, "")
    why = _asked_for(scenario) or _not_explicit(scenario)
    if not why:
        return _with(scenario, CentralDifference(name=EXPLICIT), "")
    return _with(scenario, GeneralisedAlpha(name="generalised-alpha"), why)


def time_step_of(scenario: ScenarioData, solver: Solver) -> float:
    """Return the time step in s of a solver without `auto`, also where it is one element."""
    step = solver.time_step
    if not isinstance(step, str):
        return step
    assert scenario.speed is not None  # a speed profile is refused then, see `step_rules`
    return solver.contact_wire_element_m / scenario.speed


def _with(scenario: ScenarioData, scheme: Scheme, why: str) -> Choice:
    given = scenario.solver
    explicit = scheme.name == EXPLICIT
    wires = given.model_copy(update={"scheme": scheme}).wires
    contact, messenger = _lengths(scenario, chains=explicit)
    if not explicit and (given.kinematics == "updated" or wires == "lumped"):
        contact, messenger = min(contact, LONGEST_ALONE), min(messenger, LONGEST_ALONE)
    # No step may jump over an element: one that is given has a say in what is left to auto.
    step = given.time_step
    way = 0.0 if isinstance(step, str) else scenario.top_speed * step
    contact = max(contact, min(way, LONGEST_OF_CUBIC))
    taken = _taken(given, (contact, messenger))
    if step == AUTO:
        step = _step(scenario, taken) if explicit else _resolving(scenario)
    flexible: bool | str = given.residual_flexibility
    if flexible == AUTO:
        flexible = not explicit and wires == "hermite" and given.kinematics == "linearised"
    resolved = given.model_copy(
        update={
            "scheme": scheme,
            "wire_model": wires,
            "contact_wire_element": taken[0],
            "messenger_wire_element": taken[1],
            "time_step": step,
            "residual_flexibility": flexible,
        }
    )
    return Choice(resolved, why, contact, messenger)


def _taken(solver: Solver, rule: tuple[float, float]) -> list[float]:
    """Return the lengths of elements in m: those given, and by the rule where left to `auto`."""
    given = solver.contact_wire_element, solver.messenger_wire_element
    return [own if isinstance(one, str) else one for one, own in zip(given, rule, strict=True)]


def _asked_for(scenario: ScenarioData) -> str:
    """Say which setting asks for a matrix; nothing if none does."""
    solver = scenario.solver
    for name, asked, reason in (
        ("kinematics", solver.kinematics == "updated", "updated kinematics"),
        ("wire_model", solver.wire_model == "hermite", "cubic elements"),
        ("residual_flexibility", isinstance(solver.residual_flexibility, bool),
         "residual flexibility as given, of cubic elements"),
        ("period_correction", not solver.period_correction, "no period correction"),
        ("time_step", solver.time_step == ONE_ELEMENT, "a time step of one element"),
    ):  # fmt: skip
        if asked:
            return f"solver.{name} requires {reason}"
    if scenario.contact.law == "rigid":
        return "rigid contact rings with a scheme that damps nothing"
    return ""


def _not_explicit(scenario: ScenarioData) -> str:
    """Say why a line cannot step explicitly as well as with a matrix; nothing if it can."""
    solver = scenario.solver
    for name, wire in _wires(scenario):
        if wire.tension == 0.0:
            return f"{name} has no tension: its waves have no speed of their own"
    given = solver.time_step
    stiff = too_stiff_along(scenario, LONGEST_STEP if isinstance(given, str) else given)
    if stiff:
        return stiff
    rule = _lengths(scenario, chains=True)
    taken = _taken(solver, rule)
    names = ("contact_wire_element", "messenger_wire_element")[: 2 if _has_above(scenario) else 1]
    for name, length, own in zip(names, taken, rule, strict=False):
        if length > own * ROUNDING:
            return f"solver.{name} of {length:g} m is too long for point masses ({own:g} m)"
    stable = stable_step(scenario, taken)
    if solver.time_step == AUTO:
        if stable < SHORTEST_STEP:
            return f"explicit steps would have to be shorter than {1e3 * SHORTEST_STEP:g} ms"
    elif not isinstance(solver.time_step, str) and solver.time_step > stable:
        return f"solver.time_step of {1e3 * solver.time_step:g} ms is too long for explicit steps"
    return ""


def too_stiff_along(scenario: ScenarioData, step: float) -> str:
    """Say what holds the wires along the track too stiffly for a step in s, if anything does.

    Motion along the wires is explicit between points L apart, L = 1.5 (h + 2β) √(EA/μ), and a
    spring k there is stable for k h² < 4 μL by itself; half of that is left to what the wire adds.
    """
    line = scenario.line
    anchor, support = line.midpoint_anchor, line.support
    for name, stiffness in (
        ("line.midpoint_anchor", anchor.stiffness if anchor else 0.0),
        ("line.support", support.longitudinal_stiffness if support else 0.0),
    ):
        for _, wire in _wires(scenario):
            apart = REACH * (step + 2 * wire.damping.beta) * sqrt(wire.axial_stiffness / wire.mass)
            if stiffness * step**2 > STIFFEST_ALONG * 4 * wire.mass * apart:
                return f"{name} holds the wires along the track by {stiffness:g} N/m"
    return ""


def _wires(scenario: ScenarioData) -> list[tuple[str, TensionedWire]]:
    return [(f"line.{name}", wire) for name, wire in scenario.line.wires()]


def _has_above(scenario: ScenarioData) -> bool:
    return len(_wires(scenario)) > 1


def _speed(wire: TensionedWire) -> float:
    return sqrt(wire.tension / wire.mass)


def _ahead(scenario: ScenarioData) -> float | None:
    """Return λ₊ in m; None for a wire whose waves have no speed of their own."""
    wave = scenario.line.wave_speed
    if wave is None:
        return None
    return max(wave - scenario.top_speed, 0.0) / scenario.analysis.low_pass


def _lengths(scenario: ScenarioData, *, chains: bool) -> tuple[float, float]:
    """Return the longest elements in m of the contact wire and of the wires above."""
    longest = LONGEST_OF_CHAIN if chains else LONGEST_OF_CUBIC
    ahead = _ahead(scenario)
    if ahead is None:
        return longest, longest
    per_wave, per_wave_above = PER_WAVE_OF_CHAIN if chains else PER_WAVE_OF_CUBIC
    contact = ahead / per_wave
    if chains:
        longest = min(longest, _beside_joints(scenario))
        contact = max(contact, min(FINE_ENOUGH, ahead / PER_WAVE_AT_SPEED))
    above = [
        _speed(wire)
        for name, wire in _wires(scenario)
        if name in ("line.messenger_wire", "line.auxiliary_wire")
    ]
    slowest = min(above, default=scenario.line.wave_speed or 1.0)
    ratio = slowest / (scenario.line.wave_speed or slowest)
    return _rung(min(longest, contact)), _rung(min(longest, ahead * ratio / per_wave_above))


def _beside_joints(scenario: ScenarioData) -> float:
    """Return the longest elements in m where bridles are clamped to points, or masses count."""
    line = scenario.line
    if line.bridle is not None:
        return LONGEST_CLAMPED
    masses = [part.mass for part in line.point_masses] + [part.mass for part in line.inserts]
    return FINE_ENOUGH if max(masses, default=0.0) > HEAVY else LONGEST_OF_CHAIN


def _rung(length: float) -> float:
    """Return the longest length of the ladder that is not longer; its shortest where all are."""
    return next((rung for rung in LADDER if rung <= length * ROUNDING), LADDER[-1])


def _resolving(scenario: ScenarioData) -> float:
    """Return the longest step in s that resolves the assessed frequency at a fixed point."""
    ahead, wave = _ahead(scenario), scenario.line.wave_speed
    if ahead is None or wave is None:
        return STEP_OF_RAILS
    return _rounded(max(LARGEST_ANGLE * ahead / (2 * pi * wave), SHORTEST_STEP))


def _step(scenario: ScenarioData, lengths: list[float]) -> float:
    """Return the time step in s of explicit steps with elements of some lengths in m."""
    found = _rounded(min(_resolving(scenario), stable_step(scenario, lengths)))
    shorter = (one for one in STEPS if one <= found and not too_stiff_along(scenario, one))
    return next(shorter, found)


def _rounded(step: float) -> float:
    return next((one for one in STEPS if one <= step * ROUNDING), step)


def stable_step(scenario: ScenarioData, lengths: list[float]) -> float:
    """Return the longest step in s that is stable on every wire, with some room.

    With elements of lengths in m: of the contact wire, and of the wires above.
    """
    shortest = shortest_distances(scenario.line)
    contact, above = lengths
    found = LONGEST_STEP * 10
    for name, wire in _wires(scenario):
        length = contact if name == "line.contact_wire" else above
        # Between two places there are whole elements.
        gaps = shortest[name.removeprefix("line.")]
        elements = min(gap / max(1, -floor(-gap / length * (1 - 1e-9))) for gap in (*gaps, length))
        found = min(found, longest_step(wire, elements))
    return STABLE_SHARE * found


def longest_step(wire: TensionedWire, length: float) -> float:
    """Return the longest stable explicit step in s of a chain with elements of a length in m.

    Notes
    -----
    The highest frequency is that of neighbours that move by turns, K = 4 in
    (docs/theory/dynamics.md, explicit steps)

        ω² = (T/mℓ²) (K + ε* K²) (1 + a K + b K²),    4 = ω² h² (1 + 2β/h) + 2 α h

    found by halving, as a and b depend on h.
    """
    tension, mass = wire.tension, wire.mass
    unit = tension / (mass * length * length)
    ratio = wire.bending_stiffness / (tension * length * length)
    x = 0.5 / sqrt(ratio) if ratio > 0.0 else 0.0
    fitted = ratio * x / tanh(x) if x else 0.0
    low, high = 0.0, 2.0 / sqrt(unit)
    for _ in range(40):
        h = 0.5 * (low + high)
        courant = unit * h * h
        a = (1.0 - courant) / 12.0 - (fitted - ratio)
        b = (fitted + a) / 6.0 - a * fitted
        b = min(max(b - (1.0 - courant**2) / 360.0 - courant * ratio / 6.0, 0.0), 1.0 / 30.0)
        fastest = unit * (4.0 + 16.0 * fitted) * (1.0 + 4.0 * a + 16.0 * b)
        alpha, beta = wire.damping.alpha, wire.damping.beta
        if fastest * h * (h + 2.0 * beta) + 2.0 * alpha * h < LIMIT:
            low = h
        else:
            high = h
    return low
