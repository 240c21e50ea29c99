"""Published elasticities and uplifts of Spanish lines (Adif) beside those of the product.

FOM/1630/2015 quotes elasticities of CA-160 and CA-220 (source S20). Adif's NAE 107, 300, 301 and
302 (S13) give wires, tensions and, for two pantographs at the highest speed, the uplift S0 of the
steady arm and fs within the span. The spacing is not said: here that of the TSI, 85 m (TRV:00597).
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from validation.runs import run, table

import arcless
from arcless.equilibrium import equilibrium
from arcless.equilibrium.equilibrium import Equilibrium

Floats = NDArray[np.float64]
Answer = Callable[[Equilibrium, Floats], Floats]

CA160, CA220 = "spain-ca-160-3kv-160", "spain-ca-220-3kv-200"
CA200_AC, CA220_AC = "spain-ca-200-200", "spain-ca-220-220"
# Elasticity in mid-span and at the support, mm/N (A, S20).
PUBLISHED = {CA160: (0.65, 0.32), CA220: (0.37, 0.25)}
TITLES = {CA160: "CA-160", CA220: "CA-220"}
WORN = [{"from": "0 m", "to": "960 m", "fraction": 0.3}]


def heavier(tension: float) -> dict[str, float]:
    """Changes to contact wires of 120 mm² (HC120 of the catalogue) with a tension in N."""
    own = {"mass": 1.067, "axial_stiffness": 15.06e6, "bending_stiffness": 143.8}
    return {f"line.contact_wire.{name}": v for name, v in {**own, "tension": tension}.items()}


def both(force: float) -> Answer:
    """Elasticity with both wires lifted, by a force in N; 0 for a small one."""
    return lambda found, x: found.elasticity(x, force)


def alone(force: float) -> Answer:
    """Elasticity of the first of both wires alone."""

    def answer(found: Equilibrium, x: Floats) -> Floats:
        return np.array(found.core.elasticity([found.mesh.lanes[0]], x.tolist(), force))

    return answer


@dataclass(frozen=True)
class Definition:
    """A reading of the published elasticity: its question, on a line changed in some way."""

    words: str
    answer: Answer
    changes: dict[str, Any] = field(default_factory=dict)
    factor: float = 1.0  # of all tensions


DEFINITIONS = {
    "product": Definition("both wires lifted: the product", both(0.0)),
    "strong": Definition("both, by 400 N", both(400.0)),
    "one": Definition("one of both wires", alone(0.0)),
    "one, strong": Definition("one of both, by 400 N", alone(400.0)),
    "worn": Definition(
        "both, contact wires worn by 30 %", both(0.0), {"as_built.contact_wire_wear": WORN}
    ),
    "friction": Definition("both, tensions 3 % lower: friction of weights", both(0.0), factor=0.97),
    "slack": Definition(
        "both, tensions 30 % lower, encumbrance 2.4 m",
        both(0.0),
        {"line.geometry.encumbrance": 2.4},
        factor=0.7,
    ),
    "heavier": Definition(
        "both, contact wires of 120 mm² and 11.76 kN: CA-160 type B", both(0.0), heavier(11.76e3)
    ),
}


@cache
def elasticities(scenario: str, name: str) -> tuple[float, float]:
    """Elasticity in mid-span and at the support of the middle span, mm/N, by a definition."""
    base, definition = arcless.load(scenario), DEFINITIONS[name]
    changes = dict(definition.changes)
    if definition.factor != 1.0:
        for wire, own in base.line.wires():
            changes[f"line.{wire}.tension"] = definition.factor * own.tension
    found = equilibrium.find(base.with_(**changes))
    left, right = found.middle_span()
    middle, support = 1e3 * definition.answer(found, np.array([(left + right) / 2.0, left]))
    return float(middle), float(support)


def share(scenario: str) -> float:
    """Span over the sum of all tensions, mm/N: of what short formulas take a part."""
    line = arcless.load(scenario).line
    assert line.messenger_wire is not None
    total = 2.0 * line.contact_wire.tension + line.messenger_wire.tension
    return 1e3 * line.span_list()[0].length / total


def _beside(scenario: str, pair: tuple[float, float]) -> list[str]:
    known = PUBLISHED[scenario]
    return [f"{e:.2f} ({100 * (e / p - 1):+.0f} %)" for e, p in zip(pair, known, strict=True)]


def elasticity_table() -> str:
    rows = [["published, mark A", *(f"{e:.2f}" for pair in PUBLISHED.values() for e in pair)]]
    for name, definition in DEFINITIONS.items():
        row = [definition.words]
        for scenario in PUBLISHED:
            if name == "heavier" and scenario != CA160:
                row += ["–", "–"]
            else:
                row += _beside(scenario, elasticities(scenario, name))
        rows.append(row)
    for words, part in (("the rule 3 l/(8 ΣT)", 3 / 8), ("the rule l/(4 ΣT)", 1 / 4)):
        row = [words]
        for scenario in PUBLISHED:
            row += _beside(scenario, (part * share(scenario),) * 2)
        rows.append(row)
    places = (f"{TITLES[name]} {where}" for name in PUBLISHED for where in ("mid-span", "support"))
    return table(("asked", *places), rows)


@dataclass(frozen=True)
class System:
    """A system of Adif: the scenario it is made of, and its published uplifts in mm."""

    scenario: str
    support: float
    span: float
    mean_force: float
    changes: dict[str, Any] = field(default_factory=dict)


def _force(speed: float, start: float) -> float:
    """Mean force in N, F_m = 0.00097 v² + start, v in km/h (S8; start 70 N AC, 110 N DC 3 kV)."""
    return round(0.00097 * speed**2 + start, 1)


def _class_200(messenger: float) -> dict[str, Any]:
    """CA-200H: contact wires of 120 mm² and 14.70 kN, pre-sag of 0.5 instead of 0.6 per mille."""
    line = arcless.load(CA160).line
    presag = [5.0 / 6.0 * own for own in line.span_types["standard"].droppers.presag or ()]
    return heavier(14.70e3) | {
        "line.messenger_wire.tension": messenger,
        "line.span_types.standard.droppers.presag": presag,
        "speed": "200 km/h",
    }


def systems() -> dict[str, System]:
    """Return the eight systems of which S0 and fs are published (A, S13)."""
    return {
        "CA-160/3kV A": System(CA160, 67, 98, _force(160, 110)),
        "CA-160/3kV B": System(CA160, 61, 89, _force(160, 110), heavier(11.76e3)),
        "CA-200H/3kV": System(CA160, 55, 68, _force(200, 110), _class_200(16.18e3)),
        "CA-220/3kV": System(CA220, 41, 42, _force(200, 110)),
        "CA-200/25kV": System(CA200_AC, 46, 78, _force(200, 70)),
        "CA-220/25kV": System(CA220_AC, 43, 77, _force(220, 70)),
        "CA-160H/25kV": System(CA160, 34, 55, _force(160, 70), heavier(11.76e3)),
        "CA-200H/25kV": System(CA160, 35, 48, _force(200, 70), _class_200(16.17e3)),
    }


@cache
def uplifts(name: str) -> tuple[float, float]:
    """Highest uplift in mm at a support and in mid-span, two pantographs at the TSI's spacing."""
    own = systems()[name]
    base = arcless.load(own.scenario).with_(**own.changes)
    first, last = base.analysis_range()
    places = np.array(base.line.support_positions())
    middles = (places[1:] + places[:-1]) / 2.0
    one = base.to_dict()["pantographs"][0] | {"mean_force": own.mean_force}
    changes = own.changes | {
        "pantographs": [one, {**one, "name": "P2", "distance": "tsi"}],
        "output.points": [float(x) for x in middles if first < x < last],
        "output.droppers": False,
    }
    found = run(own.scenario, changes)
    support = found.assessment.max_uplift_at_support_mm
    assert support is not None
    return support, 1e3 * float(found.dataset["point_uplift"].values.max())


def uplift_table() -> str:
    rows = []
    for name, own in systems().items():
        row: list[object] = [name, f"{own.mean_force:.1f}"]
        for known, found in zip((own.support, own.span), uplifts(name), strict=True):
            row += [f"{known:.0f}", f"{found:.0f}", f"{100 * (found / known - 1):+.0f}"]
        rows.append(row)
    head = ("system", "F_m N", "S0 published mm", "S0 mm", "S0 %")
    return table((*head, "fs published mm", "fs mm", "fs %"), rows)


TABLES = {"adif-elasticity": elasticity_table, "adif-uplift": uplift_table}
