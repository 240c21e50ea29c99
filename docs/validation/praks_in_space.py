"""Tables of the published example in space: two contact wires next to their planar substitute."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from validation.praks import SPEEDS, TRAPEZOIDAL
from validation.runs import run, table
from validation.variants import Changes

import arcless
from arcless.results import Result
from arcless.simulate import statics
from arcless.validate.observation import observe

# Half of the substitute each: tension, mass, EA, EI, hangers and fittings.
HALVES: Changes = {
    "line.contact_wire.tension": 9800.0,
    "line.contact_wire.mass": 0.535,
    "line.contact_wire.axial_stiffness": 7.2e6,
    "line.contact_wire.bending_stiffness": 72.5,
    "line.dropper.stiffness": 1800.0,
    "line.dropper.clamp_mass_contact_wire": 1.25,
}
# Held across at the messenger's supports, and free to rise there.
HELD: Changes = {"line.steady_arm": {"kind": "spring", "vertical_stiffness": 0.0}}
ARM = {"kind": "arm", "length": 1.0, "slope": 0.0, "mass": 1.0}
# One hanger a span on either wire, half a span apart.
APART: Changes = {"line.span_types.standard.droppers.positions": [2.5, 7.5]}


def twin(*separations: float, droppers: str = "paired") -> Changes:
    """Two wires: one distance for wires side by side, several for wires that part and meet."""
    (name, value) = (
        ("separation", separations[0])
        if len(separations) == 1
        else ("separations", list(separations))
    )
    return HALVES | HELD | {"line.twin_contact_wires": {name: value, "droppers": droppers}}


CROSSING = twin(0.4, -0.4)
VARIANTS: dict[str, Changes] = {
    "**substitute, as shipped**": {},
    "two wires side by side, in the plane": twin(0.04),
    "crossing in mid-span, 0.4 m apart at supports": CROSSING,
    "the same, 0.2 m": twin(0.2, -0.2),
    "the same, 0.8 m": twin(0.8, -0.8),
    "0.4 m apart at one support, 0.04 m at the next": twin(0.4, 0.04),
    "crossing, held by hinged arms": CROSSING | {"line.steady_arm": ARM},
    "crossing, hangers of the wires half a span apart": twin(0.4, -0.4, droppers="alternating")
    | APART,
    "substitute, two hangers of half of all": APART
    | {name: HALVES[name] for name in HALVES if "dropper" in name},
    "substitute with 1.78 kg/m": {"line.contact_wire.mass": 1.78},
    "crossing, wires of 0.89 kg/m": CROSSING | {"line.contact_wire.mass": 0.89},
}


@dataclass(frozen=True)
class Section:
    """Series of a run in its analysis section."""

    result: Result

    @property
    def inside(self) -> np.ndarray:
        x = self.result.dataset["position"].values[:, 0]
        first, last = self.result.assessment.section_m
        return np.asarray((x >= first) & (x <= last))

    def one_wire_free(self) -> float | None:
        """Share of time in % in which one of two wires is without contact; None of one wire."""
        data = self.result.dataset
        if "wire_contact_force" not in data:
            return None
        return 100.0 * float(
            (data["wire_contact_force"].values[self.inside] <= 0.0).any(axis=1).mean()
        )

    def moved_aside(self) -> float | None:
        """Largest motion of a wire at the strip across the track in m; None in the plane."""
        data = self.result.dataset
        if "wire_contact_lateral" not in data or not np.ptp(data["contact_wire_node_y"].values):
            return None
        x = data["position"].values[self.inside, 0]
        wires = data["contact_wire_node_wire"].values
        most = 0.0
        for number in (1, 2):
            mine = wires == number
            rest = np.interp(
                x,
                data["contact_wire_node_x"].values[mine],
                data["contact_wire_node_y"].values[mine],
            )
            now = data["wire_contact_lateral"].values[self.inside, number - 1]
            most = max(most, float(np.abs(now - rest).max()))
        return most


def or_none(value: float | None, form: str) -> str:
    return "–" if value is None else format(value, form)


def results(changes: Changes) -> list[Result]:
    return [run(f"praks-{kmh}", changes) for kmh in SPEEDS]


def published_table() -> str:
    made = []
    for title, changes in VARIANTS.items():
        cells = []
        for result in results(changes):
            one = observe(result)
            text = f"{one.low:.0f}–{one.high:.0f}"
            if one.gap or one.loss:
                text += f"; {one.gap:.2f} mm, {one.loss:.1f} %"
            free = Section(result).one_wire_free()
            cells.append(text if not free else f"{text}; one {free:.1f} %")
        made.append((title, *cells))
    return table(("line", *(f"{kmh} km/h" for kmh in SPEEDS)), made)


def force_cells(result: Result) -> Sequence[str]:
    own, section = result.assessment.pantographs[0], Section(result)
    aside = section.moved_aside()
    return (
        f"{own.mean_force_N:.1f}",
        f"{own.std_force_N:.1f}",
        f"{own.contact_loss_percent:.2f}",
        or_none(section.one_wire_free(), ".2f"),
        f"{result.assessment.max_uplift_at_support_mm:.1f}",
        or_none(None if aside is None else 1e3 * aside, ".1f"),
    )


def forces_table() -> str:
    made = []
    for kmh in (250, 360):
        for title, changes in VARIANTS.items():
            # Two contacts of 25 kN/m yield like one of 50 kN/m.
            stiffness = {
                "contact.stiffness": 25e3 if "line.twin_contact_wires" in changes else 50e3
            }
            result = run(f"praks-{kmh}", TRAPEZOIDAL | stiffness | changes)
            made.append((f"{kmh} km/h", title, *force_cells(result)))
    head = ("F_m N", "σ N", "loss %", "one wire free %", "uplift mm", "moved aside mm")
    return table(("speed", "line", *head), made)


def rest_table() -> str:
    """The line at rest: forces across and in hangers, and elasticity."""
    made = []
    for title, changes in VARIANTS.items():
        found = statics(arcless.load("praks-250").with_(**changes))
        across = [
            abs(support["contact_wire_lateral_force_N"])
            for support in found.supports
            if support["contact_wire_lateral_force_N"] is not None
        ]
        inner = found.droppers[len(found.droppers) // 2]
        elasticity = 1e3 * np.array(found.elasticity_m_per_N)
        made.append((
            title,
            f"{max(across):.0f}" if across and max(across) > 0.0 else "–",
            f"{inner['force_N']:.1f}",
            f"{elasticity.min():.3f} to {elasticity.max():.3f}",
        ))  # fmt: skip
    head = ("across at a support N", "hanger N", "elasticity mm/N")
    return table(("line", *head), made)


TABLES: dict[str, Callable[[], str]] = {
    "space-rest": rest_table,
    "space-published": published_table,
    "space-forces": forces_table,
}
