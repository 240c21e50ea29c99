"""Acceptance criteria as data: one list of rules, each with its source and confidence mark.

Marks: A, read in the named source; C, from memory, not verified. A source that quotes a standard
is named itself: the standards' own texts were not read. A limit that is only remembered or assumed
is shown, and decides nothing: see `decides`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from arcless.assess.statistics import PantographAssessment

COURSE_NOTES = "course notes on Orden TMA/135/2023 and UNE-EN 50367 / 50119"
FORCE_LAW = "TSI 2011/274 and EN 50367, as quoted by a public contact-line calculator"
MEMORY = "EN 50367, from memory"

AC = ("AC 25 kV", "AC 15 kV")
ANY_SUPPLY = (*AC, "DC 3 kV", "DC 1.5 kV")

ANY_SPEED = (-1.0, float("inf"))

# Half of the interval in km/h that a speed is known to, within which it counts as the boundary of
# two classes. Given speeds: to 0.1 km/h, since one in mph or m/s rarely is a whole number of km/h.
# Measured means: to 1 km/h, as speedometers are read (assumed), since none is 250.000. Larger, a
# run above a boundary gets the limits below it; smaller, a rounding error chooses the limits.
GIVEN_SPEED_KM_H, MEASURED_SPEED_KM_H = 0.05, 0.5
# Distance in km/h that the unit alone makes: 320 km/h is 88.888… m/s. Larger, a class is taken
# without a note; smaller, the note stands where nothing was chosen.
SAME_SPEED_KM_H = 1e-6

ASSUMED = "assumed"
LATERAL_LIMIT = "lateral_limit_mm"

# Criteria whose value is a deviation over the section, or is made of one.
OF_DEVIATION = ("standard_deviation", "statistical_max", "statistical_min")

# Marks of limits that decide: read, quoted by who read them, or computed from such.
DECIDING = ("A", "A'", "B", "D")


def decides(mark: str) -> bool:
    """Return whether a limit with this mark decides whether a run, or a reference case, passes."""
    return mark in DECIDING


@dataclass(frozen=True)
class HeadLimit:
    """Lateral range of the contact wire on a collector head, from its middle."""

    limit_mm: float
    mark: str
    """Mark of the limit, or of the width of the head if that is less sure."""


@dataclass(frozen=True)
class Facts:
    """Facts that the rules are judged by, besides the pantographs' own numbers."""

    supply: str
    speed_km_h: float
    supply_given: bool = True
    """False where the line names no supply, and one was assumed."""
    speed_known_to_km_h: float = GIVEN_SPEED_KM_H
    """Error that the speed may have; within it of a boundary of classes, it counts as that."""
    wave_speed_use: float | None = None
    """Maximum speed over the wave speed of the contact wire."""
    uplift_mm: float | None = None
    """Maximum uplift at a support inside the section."""
    uplift_space_mm: float | None = None
    uplift_limited: bool = False
    heads: Mapping[str, "HeadLimit"] = field(default_factory=dict)
    """Lateral range of the contact wire that each head allows, by name of the pantograph."""

    @property
    def class_speed_km_h(self) -> float:
        """Speed by which limits are chosen: a boundary of classes where it is as good as that."""
        near = min(BOUNDARIES_KM_H, key=lambda one: abs(one - self.speed_km_h))
        as_good = abs(near - self.speed_km_h) <= self.speed_known_to_km_h
        return near if as_good else self.speed_km_h

    @property
    def uplift_to_provide_mm(self) -> float | None:
        """Space that the uplift asks for: twice, or 1.5 times where it is limited."""
        if self.uplift_mm is None:
            return None
        return (1.5 if self.uplift_limited else 2.0) * self.uplift_mm


@dataclass(frozen=True)
class Limit:
    """A limit a·v² + b (v in km/h), or a factor times another quantity."""

    constant: float = 0.0
    per_speed_squared: float = 0.0
    factor: float = 1.0
    of: str | None = None
    """Name of the quantity that the factor multiplies."""

    def value(self, facts: Facts, pantograph: PantographAssessment) -> float | None:
        """Return the limit for this run; None if its reference quantity is not known."""
        if self.of is None:
            return self.constant + self.per_speed_squared * facts.speed_km_h**2
        quantity = quantity_of(self.of, facts, pantograph)
        return None if quantity is None else self.factor * quantity

    def __str__(self) -> str:
        if self.of is not None:
            return self.of if self.factor == 1.0 else f"{self.factor:g} × {self.of}"
        if self.per_speed_squared:
            return f"{self.per_speed_squared:g} v² + {self.constant:g}"
        return f"{self.constant:g}"


@dataclass(frozen=True)
class Rule:
    """One row of the table of criteria."""

    name: str
    title: str
    unit: str
    quantity: str
    """Name of the value judged: of a pantograph, or of `Facts` for a rule of the whole run."""
    relation: Literal["<=", ">=", ">"]
    limit: Limit
    mark: str
    source: str
    note: str = ""
    supplies: tuple[str, ...] = ANY_SUPPLY
    speeds_km_h: tuple[float, float] = ANY_SPEED
    """Range of speed in km/h: above the first, up to and including the second."""
    tolerance: float = 0.0
    whole_run: bool = False
    """True for a rule that is judged once, not for every pantograph."""

    def applies(self, facts: Facts) -> bool:
        """Say whether the rule is meant for this supply and speed."""
        above, up_to = self.speeds_km_h
        return facts.supply in self.supplies and above < facts.class_speed_km_h <= up_to


def quantity_of(name: str, facts: Facts, pantograph: PantographAssessment) -> float | None:
    """Return a quantity by name, from the facts or from the pantograph."""
    if name == LATERAL_LIMIT:
        head = facts.heads.get(pantograph.name)
        return None if head is None else head.limit_mm
    value: float | None = getattr(facts if hasattr(facts, name) else pantograph, name)
    return value


def mark_of(rule: "Rule", facts: Facts, pantograph: PantographAssessment) -> str:
    """Return the mark of a limit: of the rule, or of what the limit was chosen by if less sure."""
    if rule.supplies != ANY_SUPPLY and not facts.supply_given:
        return ASSUMED
    head = facts.heads.get(pantograph.name)
    if rule.limit.of == LATERAL_LIMIT and head is not None and not decides(head.mark):
        return head.mark
    return rule.mark


UP_TO_200 = (-1.0, 200.0)
ABOVE_200 = (200.0, float("inf"))

# (supplies, speeds, a, b, relation, mark, source): mean force against a v² + b.
_MEAN_FORCE_LAWS = (
    (AC, ABOVE_200, 0.00097, 70.0, "<=", "A", FORCE_LAW),
    (AC, UP_TO_200, 0.00047, 90.0, "<=", "C", MEMORY),
    (AC, UP_TO_200, 0.00047, 60.0, ">=", "C", MEMORY),
    # Other coefficients are remembered for DC up to 200 km/h; those that were read are used.
    (("DC 3 kV",), ANY_SPEED, 0.00097, 110.0, "<=", "A", FORCE_LAW),
    (("DC 1.5 kV",), ANY_SPEED, 0.00097, 140.0, "<=", "A", FORCE_LAW),
)

# (supply, speeds, limit in N, mark): statistical maximum. Read for 25 kV and 3 kV, taken over
# for the other supply of the same kind.
_MAXIMA = (
    ("AC 25 kV", UP_TO_200, 300.0, "A"),
    ("AC 25 kV", (200.0, 320.0), 350.0, "A"),
    ("AC 25 kV", (320.0, float("inf")), 400.0, "A"),
    ("AC 15 kV", UP_TO_200, 300.0, "C"),
    ("AC 15 kV", (200.0, 320.0), 350.0, "C"),
    ("AC 15 kV", (320.0, float("inf")), 400.0, "C"),
    ("DC 3 kV", UP_TO_200, 300.0, "A"),
    ("DC 3 kV", ABOVE_200, 400.0, "A"),
    ("DC 1.5 kV", UP_TO_200, 300.0, "C"),
    ("DC 1.5 kV", ABOVE_200, 400.0, "C"),
)

# A target of 143.4 N, the law's 143.36 N rounded, must not miss it, nor a mean found to 0.5 N.
MEAN_FORCE_TOLERANCE_N = 1.0

RULES: tuple[Rule, ...] = (
    *(
        Rule(
            name="mean_force" if relation == "<=" else "mean_force_lower",
            title=f"mean contact force F_m, {'upper' if relation == '<=' else 'lower'} limit",
            unit="N",
            quantity="mean_force_N",
            relation=relation,  # type: ignore[arg-type]
            limit=Limit(constant=b, per_speed_squared=a),
            mark=mark,
            source=source,
            note=f"compared with a tolerance of {MEAN_FORCE_TOLERANCE_N:g} N (assumed); the law of"
            " the open line; EN 50367 has another one for tunnels (from memory, mark C), which is"
            " not judged",
            supplies=supplies,
            speeds_km_h=speeds,
            tolerance=MEAN_FORCE_TOLERANCE_N,
        )
        for supplies, speeds, a, b, relation, mark, source in _MEAN_FORCE_LAWS
    ),
    Rule(
        name="standard_deviation",
        title="standard deviation σ",
        unit="N",
        quantity="std_force_N",
        relation="<=",
        limit=Limit(factor=0.3, of="mean_force_N"),
        mark="A",
        source=COURSE_NOTES,
    ),
    *(
        Rule(
            name="statistical_max",
            title="statistical maximum F_m + 3σ",
            unit="N",
            quantity="statistical_max_N",
            relation="<=",
            limit=Limit(constant=limit),
            mark=mark,
            source=COURSE_NOTES,
            note="" if mark == "A" else "the source gives it for 25 kV and 3 kV; taken over",
            supplies=(supply,),
            speeds_km_h=speeds,
        )
        for supply, speeds, limit, mark in _MAXIMA
    ),
    Rule(
        name="statistical_min",
        title="statistical minimum F_m − 3σ",
        unit="N",
        quantity="statistical_min_N",
        relation=">",
        limit=Limit(constant=0.0),
        mark="A",
        source=COURSE_NOTES,
    ),
    *(
        Rule(
            name="contact_loss",
            title="percentage of arcing NQ, losses above 5 ms",
            unit="%",
            quantity="NQ_percent",
            relation="<=",
            limit=Limit(constant=limit),
            mark="C",
            source=MEMORY,
            note="each loss counts as an arc, as if current flowed all the time;"
            " contact_loss_percent has all losses",
            speeds_km_h=speeds,
        )
        for speeds, limit in (((-1.0, 250.0), 0.1), ((250.0, float("inf")), 0.2))
    ),
    Rule(
        name="uplift_space",
        title="space required for the uplift at supports, 2·S0",
        unit="mm",
        quantity="uplift_to_provide_mm",
        relation="<=",
        limit=Limit(of="uplift_space_mm"),
        mark="A",
        source=f"EN 50119, 5.10.2, as quoted in {COURSE_NOTES}",
        note="1.5·S0 where the uplift is limited mechanically",
        whole_run=True,
    ),
    Rule(
        name="lateral_position",
        title="lateral position of the contact wire on the head",
        unit="mm",
        quantity="max_lateral_position_mm",
        relation="<=",
        limit=Limit(of=LATERAL_LIMIT),
        mark="A",
        source=COURSE_NOTES,
        note="400 mm for a head of 1600 mm, 550 mm for one of 1950 mm; stagger, curve, wind and the"
        " sway given for the pantograph",
    ),
    Rule(
        name="wave_speed_use",
        title="maximum speed over wave propagation speed of the contact wire",
        unit="1",
        quantity="wave_speed_use",
        relation="<=",
        limit=Limit(constant=0.7),
        mark="A",
        source="EN 50119:2009, 5.2.4, as quoted in Bane NOR technical rules TRV:00599",
        whole_run=True,
    ),
)

# Speeds in km/h at which classes of limits meet.
BOUNDARIES_KM_H = sorted(
    {end for rule in RULES for end in rule.speeds_km_h if 0.0 < end < float("inf")}
)
