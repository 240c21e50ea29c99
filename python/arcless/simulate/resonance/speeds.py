"""Speeds at which a passage of spans or droppers meets a natural frequency, and wave speeds.

    k v/L = f    k waves of the path in a span of length L shake at k times its passing frequency
    v/a = f      droppers a apart shake at the dropper passing frequency
    v = 2 f L    stiffness that varies as a cosine feeds an oscillation at half of its frequency
                 (Mathieu), if that of the mode varies by more than four times its damping ratio
    f d/v = k    the trailing pantograph pushes a span that the leading one left d/v before: after
                 whole periods it adds to the swing, after n + ½ it takes from it

with f of the span (see `spans`) or of the pantograph on the line (see `natural_modes`). None of
them is a resonance without damping: a span hands its swing on to its neighbours, and waves leave
the contact. They say where to look, not how high a peak is.
"""

from dataclasses import dataclass
from itertools import pairwise
from math import floor, inf, sqrt
from typing import TYPE_CHECKING, Any, Literal

from arcless.equilibrium.initial_configuration import InitialConfiguration
from arcless.equilibrium.line_alone import LineAlone
from arcless.model.pantograph.placement import placed
from arcless.model.pantograph.spacing import RANGES
from arcless.model.settings.run_settings import FASTEST_TRAIN
from arcless.pantograph.natural_modes import Band, PantographMode, modes, why_no_modes
from arcless.simulate.resonance.spans import Span, spans

if TYPE_CHECKING:
    from collections.abc import Iterator

    from arcless.model import Scenario
    from arcless.model.pantograph.placement import PantographPlacement

Kind = Literal[
    "wave speed",
    "span of the line",
    "span and pantograph",
    "droppers and pantograph",
    "parametric",
    "spacing, worst",
    "spacing, best",
]
# Waves of the path with an amplitude below this share of the largest are not told.
LEAST_AMPLITUDE = 0.1
# Limit of the speed as a share of the wave speed of the contact wire.
USE_OF_WAVE_SPEED = 0.7
# Threshold of the principal parametric resonance: variation of the stiffness over damping ratio.
MATHIEU = 4.0
# Periods between two pantographs that are told at most.
MOST_PERIODS = 6
TOO_FAST = f"speeds above {3.6 * FASTEST_TRAIN:.0f} km/h, more than any train ran, are left out"

EN_50119 = "EN 50119:2009, 5.2.4, as quoted in Bane NOR technical rules TRV:00599 (A)"
CALCULATOR = "GitHub showhoo/ocs-calculators, wavespeed (A): v = f₁ L"
ABOSHI = "M. Aboshi, RTRI Report, December 2001, abstract (A): resonance over the span cycle"
WU_BRENNAN = "Wu & Brennan, J. Sound Vib. 219 (1999) 483, abstract (A): periodic stiffness"
HANGERS = "Aboshi & Manabe, Quarterly Report of RTRI 41 (2000) 182, abstract (A): hanger span cycle"
MATHIEU_SOURCE = "A. D. Sergeev, J. Mach. Manuf. Reliab. 36 (2007) 178, abstract (A): Mathieu"
OWN_RUNS = "runs of this program, docs/validation/lines.md (D)"
STRING = "string under tension"


@dataclass(frozen=True)
class ResonanceSpeed:
    """A speed, what it is, and what it follows from.

    Attributes
    ----------
    kind, name
        What meets what, and which one of these.
    speed
        In m/s: middle, with the lowest and highest of the band that it stands for.
    formula, source
        How it follows, and from where; A: read there, D: from this program.
    frequency_Hz, length_m, order
        What the formula is filled with; None where it has no such value.
    about
        Values to weigh it by: shares, amplitudes, damping.
    """

    kind: Kind
    name: str
    speed: Band
    formula: str
    source: str
    frequency_Hz: float | None = None  # noqa: N815 - the unit is part of the name
    length_m: float | None = None
    order: float | None = None
    about: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Return plain values; speeds in m/s."""
        return {
            "kind": self.kind,
            "name": self.name,
            "speed_m_s": self.speed.middle,
            "lowest_speed_m_s": self.speed.low,
            "highest_speed_m_s": self.speed.high,
            "frequency_Hz": self.frequency_Hz,
            "length_m": self.length_m,
            "order": self.order,
            "formula": self.formula,
            "source": self.source,
            "about": self.about,
        }


@dataclass(frozen=True)
class ResonanceSpeeds:
    """Resonance speeds of a scenario.

    Attributes
    ----------
    speeds
        By rising speed, up to the fastest train.
    notes
        What has no such speed and why, and what the speeds are of.
    """

    speeds: tuple[ResonanceSpeed, ...]
    notes: tuple[str, ...]

    def __repr__(self) -> str:
        speeds = [f"{3.6 * one.speed.middle:.0f}" for one in self.speeds]
        span = f": {speeds[0]} to {speeds[-1]} km/h" if speeds else ""
        return f"<ResonanceSpeeds, {len(speeds)}{span}>"

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, ready for JSON."""
        return {"speeds": [one.to_dict() for one in self.speeds], "notes": list(self.notes)}


def resonance_speeds(source: "Scenario | InitialConfiguration") -> ResonanceSpeeds:
    """Return the speeds at which line and pantographs of a scenario may resonate.

    A line at rest that no scenario names has none: they take pantographs.

    Parameters
    ----------
    source
        A scenario, or its line at rest from `arcless.statics`. Its own speed plays no part.

    Raises
    ------
    MeshError, EquilibriumError
        The line has no equilibrium.
    """
    rest = source if isinstance(source, InitialConfiguration) else InitialConfiguration.of(source)
    scenario, notes = rest.scenario, list[str]()
    if isinstance(scenario, LineAlone):
        return ResonanceSpeeds((), ("a line without pantographs has no resonance speeds",))
    force = scenario.pantographs[0].start_force or 0.0
    told = spans(rest.equilibrium, scenario.line.span_list(), force)
    if len({round(s.length, 3) for s in scenario.line.span_list()}) > len(told):
        notes.append("spans of many lengths: those of the shortest, most frequent and longest")
    found = list(_wave_speeds(rest, notes))
    for span in told:
        found += _of_line(span)
        found += _of_pantographs(scenario, span, notes)
    found += _of_spacings(scenario, told[len(told) // 2])
    listed = [one for one in found if one.speed.middle <= FASTEST_TRAIN]
    if len(listed) < len(found):
        notes.append(TOO_FAST)
    listed.sort(key=lambda one: one.speed.middle)
    return ResonanceSpeeds(tuple(listed), tuple(dict.fromkeys(notes)))


def _wave_speeds(rest: InitialConfiguration, notes: list[str]) -> "Iterator[ResonanceSpeed]":
    line, contact = rest.scenario.line, rest.wave_speed
    if contact is None:
        notes.append("no wave speed: the contact line is a beam without tension")
        return
    yield _plain("contact wire", contact, "v = √(T/μ)", STRING)
    limit = USE_OF_WAVE_SPEED * contact
    yield _plain("limit of EN 50119", limit, "v = 0.7 √(T/μ)", EN_50119)
    if line.messenger_wire is None:
        notes.append("no messenger wire")
        return
    tension = rest.equilibrium.mean_tensions()[1] or 0.0
    if rest.scenario.as_built.is_empty:
        tension = line.messenger_wire.tension
    speed = sqrt(tension / line.messenger_wire.mass)
    yield _plain("messenger wire", speed, "v = √(T/μ)", STRING)


def _plain(name: str, speed: float, formula: str, source: str) -> ResonanceSpeed:
    return ResonanceSpeed("wave speed", name, Band(speed, speed, speed), formula, source)


def _orders(span: Span) -> dict[int, float]:
    """Return the amplitudes of the path in m that are told, by waves in the span.

    The first always: pre-sag may cancel it at one force, and at another it is there.
    """
    least = LEAST_AMPLITUDE * max(span.path.values(), default=0.0)
    return {k: size for k, size in span.path.items() if k == 1 or size >= least > 0.0}


def _of_line(span: Span) -> "Iterator[ResonanceSpeed]":
    for k, size in _orders(span).items():
        yield ResonanceSpeed(
            "span of the line",
            _waves("swing of a span", k, span),
            span.swing.scaled(span.length / k),
            "v = f L/k",
            f"{CALCULATOR}; {ABOSHI}",
            span.swing.middle,
            span.length,
            k,
            f"{span.swing_share:.0%} of the elasticity in the middle of the span;"
            f" path {1e3 * size:.1f} mm",
        )


def _of_pantographs(
    scenario: "Scenario", span: Span, notes: list[str]
) -> "Iterator[ResonanceSpeed]":
    law = scenario.contact
    stiffness = inf if law.law == "rigid" else law.stiffness
    if span.dropper_spacing is None:
        notes.append("no droppers to pass")
    models = {placement.model.name: placement for placement in scenario.pantographs}
    for name, placement in models.items():
        why = why_no_modes(placement.model)
        if why is not None:
            notes.append(f"pantograph {name}: {why}")
            continue
        whose = f" of {name}" if len(models) > 1 else ""
        for number, mode in enumerate(modes(placement.model, span.elasticity, stiffness), start=1):
            yield from _of_mode(f"mode {number}{whose}", mode, span)


def _of_mode(name: str, mode: PantographMode, span: Span) -> "Iterator[ResonanceSpeed]":
    f, length = mode.frequency, span.length
    about = f"damping ratio of the pantograph {mode.damping_ratio:.2f}"
    for k, size in _orders(span).items():
        yield ResonanceSpeed(
            "span and pantograph", _waves(name, k, span), f.scaled(length / k), "v = f L/k",
            WU_BRENNAN, f.middle, length, k, f"{about}; path {1e3 * size:.1f} mm",
        )  # fmt: skip
    # Of a mode's stiffness only what is the line's varies.
    varied = mode.share * (span.elasticity.high - span.elasticity.low) / 2.0
    varied /= span.elasticity.middle
    if varied > MATHIEU * mode.damping_ratio:
        yield ResonanceSpeed(
            "parametric", _waves(name, 1, span), f.scaled(2.0 * length), "v = 2 f L",
            MATHIEU_SOURCE, f.middle, length, 0.5,
            f"{about}; its stiffness varies by ± {varied:.0%}",
        )  # fmt: skip
    if span.dropper_spacing is not None:
        gap = span.dropper_spacing
        speed = Band(f.low * gap.low, f.middle * gap.middle, f.high * gap.high)
        yield ResonanceSpeed(
            "droppers and pantograph", name, speed, "v = f a", HANGERS, f.middle, gap.middle, 1,
            about,
        )  # fmt: skip


def _of_spacings(scenario: "Scenario", span: Span) -> "Iterator[ResonanceSpeed]":
    """Yield the worst and best speeds of pantographs one behind the other.

    Orders go up to where the band of frequencies covers half a period: beyond it worst and best
    are not told apart. A distance that is a word is another one in each range of speeds.
    """
    f = span.swing
    width = max(f.high - f.low, f.middle / (2.0 * MOST_PERIODS))
    most = max(1, floor(f.middle / (2.0 * width)))
    for lowest, highest, placements in _placed_by_speed(scenario):
        for one, other in pairwise(placements):
            distance = other.distance - one.distance
            for half in range(1, 2 * most + 2):
                k = half / 2.0
                speed = f.scaled(distance / k)
                if not lowest < speed.middle <= highest:
                    continue
                worst = half % 2 == 0
                yield ResonanceSpeed(
                    "spacing, worst" if worst else "spacing, best",
                    f"{other.name} {distance:g} m behind {one.name}, {k:g} period{'s' * (k != 1)}",
                    speed, "v = f d/k", OWN_RUNS, f.middle, distance, k,
                )  # fmt: skip


def _placed_by_speed(
    scenario: "Scenario",
) -> "Iterator[tuple[float, float, tuple[PantographPlacement, ...]]]":
    """Yield lowest and highest speed in m/s, and the pantographs with their distances there."""
    if not any(isinstance(one.distance_, str) for one in scenario.pantographs):
        yield 0.0, inf, scenario.pantographs
        return
    highest = inf
    for lowest, _ in RANGES:
        inside = (lowest + min(highest, FASTEST_TRAIN)) / 2.0
        yield lowest, highest, placed(scenario.pantographs, inside)
        highest = lowest


def _waves(what: str, order: int, span: Span) -> str:
    waves = "once a span" if order == 1 else f"{order} times a span"
    return f"{what}, {waves} of {span.length:g} m"
