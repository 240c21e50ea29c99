"""Tables and figures of the page about the published example."""

from collections.abc import Callable, Sequence
from functools import cache

from validation.figures import draw_forces, draw_gaps
from validation.runs import run, table
from validation.variants import Changes, elements, force, rayleigh

from arcless.results import Result
from arcless.validate import Row
from arcless.validate.founding_paper import GAPS, INTERVAL, JOINTS, held, rows
from arcless.validate.observation import Observation, observe

SPEEDS = (180, 250, 340, 360)
Varied = Changes | Callable[[int], Changes]

COMPLIANT = {"contact.law": "compliant", "contact.stiffness": 50e3}


def joint_mass(kg: float) -> Changes:
    return {"line.dropper.clamp_mass_contact_wire": kg}


def wire_mass(kg_per_m: float) -> Changes:
    return {"line.contact_wire.mass": kg_per_m}


def hangers(*positions: float) -> Changes:
    return {"line.span_types.standard.droppers.positions": list(positions)}


def scheme(name: str, step_ms: float | None = None, **parameters: float) -> Changes:
    step = {} if step_ms is None else {"solver.time_step": step_ms / 1e3}
    return {"solver.scheme": {"name": name, **parameters}} | step


def generalised_alpha(radius: float, step_ms: float | None = None) -> Changes:
    return scheme("generalised-alpha", step_ms, spectral_radius=radius)


def step(part: float) -> Callable[[int], Changes]:
    """A step of so much of 0.25 m, in s, at any element length."""
    return lambda kmh: {"solver.time_step": part * 0.25 / (kmh / 3.6)}


def both(changes: Changes, other: Callable[[int], Changes]) -> Callable[[int], Changes]:
    return lambda kmh: changes | other(kmh)


def pantograph_damping(ratio: float) -> Changes:
    """Damping of each mass on its own spring, as a part of critical: c = 2 ζ √(k m)."""
    pairs = ((45.0, 1e3), (16.0, 6e3))
    return {
        f"pantographs.0.model.masses.{i}.damping": 2 * ratio * (k * m) ** 0.5
        for i, (m, k) in enumerate(pairs)
    }


LINEARISED = {"solver.kinematics": "linearised"}
BEAMS = {"solver.wire_model": "hermite", **LINEARISED}
HALVED = elements(0.125) | {"solver.messenger_wire_element": 1.25}
# Linearised: with re-formed stiffness the rule, which damps nothing, does not stay stable here.
TRAPEZOIDAL = COMPLIANT | LINEARISED | scheme("trapezoidal", 1.0)

GROUPS: dict[str, dict[str, Varied]] = {
    "joints": {
        "no mass at hanger joints": joint_mass(0.0),
        "1.5 kg": joint_mass(1.5),
        "**2.5 kg, as shipped**": {},
        "4 kg": joint_mass(4.0),
    },
    "line": {
        "**as shipped**": {},
        "contact wire 0.89 kg/m": wire_mass(0.89),
        "contact wire 1.35 kg/m": wire_mass(1.35),
        "hangers at 2.5 m of each span": hangers(2.5),
        "two hangers in each span, 2.5 and 7.5 m": hangers(2.5, 7.5),
        "two hangers, half the mass at each": hangers(2.5, 7.5) | joint_mass(1.25),
        "hangers can go slack": {"line.dropper.slackens": True},
        "pantograph damped, 10 % of critical": pantograph_damping(0.1),
        "line damped: α 0.0125 1/s, β 1e-4 s": rayleigh(0.0125, 1e-4),
        "line damped, 1 %: α 0.114 1/s, β 2.9e-4 s": rayleigh(0.114, 2.9e-4),
        "friction 0.2": {"contact.friction_coefficient": 0.2},
        "initial force 60 N": force(60.0),
        "initial force 150 N": force(150.0),
    },
    "step": {
        "**as shipped**: one element of 0.25 m a step": {},
        "half an element a step": step(1 / 2),
        "a quarter of an element a step": step(1 / 4),
        "0.5 ms": scheme("backward-difference", 0.5),
        "elements halved, one of them a step": HALVED,
        "elements halved, half of one a step": both(HALVED, step(1 / 4)),
        "kinematics linearised": LINEARISED,
        "wires as beams, linearised": BEAMS,
        "wires as beams, linearised, 0.5 ms": BEAMS | scheme("backward-difference", 0.5),
        "generalised-α, ρ 0, one element a step": generalised_alpha(0.0),
        "generalised-α, ρ 0, 0.5 ms": generalised_alpha(0.0, 0.5),
    },
    "law": {
        "backward differences, one element a step": COMPLIANT,
        "backward differences, 0.5 ms": COMPLIANT | scheme("backward-difference", 0.5),
        "generalised-α, ρ 0, 0.5 ms": COMPLIANT | generalised_alpha(0.0, 0.5),
        "generalised-α, ρ 0.9, 0.5 ms": COMPLIANT | generalised_alpha(0.9, 0.5),
        "trapezoidal, 1 ms, linearised": TRAPEZOIDAL,
        "beams, backward differences, 0.5 ms": COMPLIANT
        | BEAMS
        | scheme("backward-difference", 0.5),
        "beams, backward differences, 0.1 ms": COMPLIANT
        | BEAMS
        | scheme("backward-difference", 0.1),
        "beams, generalised-α, ρ 0.9, 0.5 ms": COMPLIANT | BEAMS | generalised_alpha(0.9, 0.5),
        "no mass at joints, generalised-α, ρ 0.9, 0.5 ms": COMPLIANT
        | generalised_alpha(0.9, 0.5)
        | joint_mass(0.0),
        "no mass at joints, trapezoidal, 1 ms, linearised": TRAPEZOIDAL | joint_mass(0.0),
    },
}


def results(varied: Varied) -> list[Result]:
    return [run(f"praks-{kmh}", varied(kmh) if callable(varied) else varied) for kmh in SPEEDS]


def observations(varied: Varied) -> list[Observation]:
    return [observe(result) for result in results(varied)]


@cache
def shipped() -> tuple[Row, ...]:
    return tuple(rows(observations({})))


def conclusions_table() -> str:
    return table(
        ("conclusion", "quantity", "value", "limit", "verdict", "found"),
        (
            (
                row.case,
                row.quantity + (f" ({row.unit})" if row.unit else ""),
                f"{row.value:.{row.digits}f}",
                row.limit,
                row.verdict,
                row.note,
            )
            for row in shipped()
        ),
    )


def sensitivity_table(group: str) -> str:
    made = []
    for title, varied in GROUPS[group].items():
        seen = observations(varied)
        verdicts = held(rows(seen))
        made.append((title, *(cell(one) for one in seen), *(
            _word(verdicts[name]) + extra
            for name, extra in ((JOINTS, _located(seen)), (INTERVAL, ""), (GAPS, ""))
        )))  # fmt: skip
    return table(("variant", *(f"{kmh} km/h" for kmh in SPEEDS), "1 joints", "2", "3"), made)


def cell(seen: Observation) -> str:
    """Lowest and highest force, N; largest gap, mm, and loss of contact, % of the time."""
    if seen.loss == 0.0 and seen.gap == 0.0:
        return f"{seen.low:.0f}–{seen.high:.0f}"
    return f"{seen.low:.0f}–{seen.high:.0f}; {seen.gap:.2f} mm, {seen.loss:.1f} %"


def _word(holds: bool) -> str:
    return "yes" if holds else "**no**"


def _located(seen: Sequence[Observation]) -> str:
    least = min(one.changes.located / len(one.changes.joints) for one in seen)
    rms = min(one.changes.rms_ratio for one in seen)
    return f", {100 * least:.0f} %, {rms:.1f}"


def places_table() -> str:
    """Where the force changes fastest around a joint, with rigid and with compliant contact."""
    made = []
    titles = {
        "as shipped": {},
        "compliant, 50 kN/m": COMPLIANT,
        "generalised-α, ρ 0.9, compliant, 0.5 ms": COMPLIANT | generalised_alpha(0.9, 0.5),
    }
    for title, varied in titles.items():
        for seen in observations(varied):
            away = [joint.fastest - joint.x for joint in seen.changes.joints]
            largest = max(abs(joint.change) for joint in seen.changes.joints)
            made.append((
                title, seen.kmh, f"{seen.changes.located} of {len(away)}",
                f"{min(away):+.2f} to {max(away):+.2f}", f"{largest:.1f}",
                f"{seen.changes.near:.1f}", f"{seen.changes.elsewhere:.1f}",
            ))  # fmt: skip
    head = ("joints located", "fastest change: m from its joint", "largest at a joint N")
    return table(("run", "speed", *head, "rms at joints N", "rms elsewhere N"), made)


def slack_table() -> str:
    made = []
    for title, varied in (
        ("as shipped, cannot", {}),
        ("can go slack", {"line.dropper.slackens": True}),
        ("can go slack, 150 N", {"line.dropper.slackens": True} | force(150.0)),
    ):
        for result in results(varied):
            data = result.dataset
            slack = data["slack_droppers"].values
            made.append((
                title, f"{3.6 * result.assessment.speed_m_s:.0f} km/h",
                f"{float(data['dropper_force_static'].max()):.0f}",
                f"{float(data['dropper_force_min'].min()):.1f}",
                f"{100 * (slack > 0).mean():.1f}", int(slack.max()),
            ))  # fmt: skip
    head = ("force at rest N", "lowest force N", "time with one slack %", "most at once")
    return table(("hangers", "speed", *head), made)


# Gaps in mm, and ranges of the force in N, of an independent planar program; None: no gap.
Other = tuple[float | None, float | None, tuple[int, int] | None, tuple[int, int] | None]
OTHER: dict[str, tuple[Varied, Other]] = {
    "paper's scheme, 0.89 kg/m, no mass at joints": (
        wire_mass(0.89) | joint_mass(0.0),
        (None, None, None, None),
    ),
    "paper's scheme, no mass": (joint_mass(0.0), (None, None, (46, 164), (39, 168))),
    "paper's scheme, 1.5 kg": (joint_mass(1.5), (None, None, (40, 182), (33, 203))),
    "paper's scheme, 2.5 kg": ({}, (0.06, 0.16, (0, 215), (0, 299))),
    "paper's scheme, 4 kg": (joint_mass(4.0), (0.35, 1.35, (0, 343), (0, 730))),
    "trapezoidal, 1 ms, 50 kN/m, 0.89 kg/m, no mass": (
        TRAPEZOIDAL | wire_mass(0.89) | joint_mass(0.0),
        (0.35, 0.05, None, None),
    ),
}


def comparison_table() -> str:
    made = []
    for title, (varied, (gap_340, gap_360, range_340, range_360)) in OTHER.items():
        seen = observations(varied)[2:]
        theirs = ((gap_340, range_340), (gap_360, range_360))
        cells = []
        for one, (their_gap, their_range) in zip(seen, theirs, strict=True):
            text = "no gap" if their_gap is None else f"{their_gap:g} mm"
            if their_range:
                text += f", {their_range[0]}–{their_range[1]} N"
            gap = f"{one.gap:.2f} mm" if one.gap else "no gap"
            cells += [text, f"{gap}, {one.low:.0f}–{one.high:.0f} N"]
        made.append((title, *cells))
    head = ("340 km/h, other", "340 km/h, Arcless", "360 km/h, other", "360 km/h, Arcless")
    return table(("run", *head), made)


def figures() -> str:
    shown = results({})
    draw_forces(shown)
    draw_gaps(shown[2:])
    return (
        "![Contact force over time at 180, 250, 340 and 360 km/h](../images/praks-force.svg)\n\n"
        "![Gap over time at 340 and 360 km/h](../images/praks-gap.svg)"
    )


TABLES: dict[str, Callable[[], str]] = {
    "conclusions": conclusions_table,
    "figures": figures,
    "places": places_table,
    "joints": lambda: sensitivity_table("joints"),
    "line": lambda: sensitivity_table("line"),
    "step": lambda: sensitivity_table("step"),
    "law": lambda: sensitivity_table("law"),
    "slack": slack_table,
    "other": comparison_table,
}
