"""Tables of published reference cases: pages en50318-2002, ac-simple, convergence, energy."""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from validation.runs import run, table
from validation.variants import (
    BY_MATRIX,
    WIRES,
    Changes,
    ac_variants,
    en_variants,
    force,
    rayleigh,
)

import arcless
from arcless.model.settings.schemes import EXPLICIT
from arcless.results import Result
from arcless.validate import CASES, compare
from arcless.validate.evidence import recorded
from arcless.validate.reference import DROPPERS, INSIDE

EN_CASES, AC_CASES = CASES[:2], CASES[2:]
SHOWN = {
    "mean_force_N": "Fm",
    "std_force_N": "σ",
    "statistical_max_N": "Fm + 3σ",
    "statistical_min_N": "Fm − 3σ",
    "std_force_0_5Hz_N": "σ 0–5 Hz",
    "std_force_5_20Hz_N": "σ 5–20 Hz",
    "max_force_N": "max",
    "min_force_N": "min",
    "contact_point_range_mm": "range mm",
    "max_uplift_at_support_mm": "uplift mm",
}


def numbers(result: Result) -> dict[str, float]:
    """Return the assessment of the only pantograph, with the uplift at supports."""
    found = result.assessment.to_dict()
    return {**found, **found["pantographs"][0]}


def ranges_table(topic: str, cases: Iterable[Any]) -> str:
    """Return published ranges with the values and verdicts that the tests recorded."""
    (record,) = (known for known in recorded() if known.name == topic)
    values = {row.what: row for row in record.rows}
    rows = []
    for case in cases:
        short = case.title.partition(", ")[2]
        for allowed in case.ranges:
            found = values[f"{allowed.label}, {short}"]
            rows.append(
                (
                    short,
                    f"{allowed.label} ({allowed.unit})",
                    f"{allowed.low:g} to {allowed.high:g}",
                    f"{found.value:.1f}",
                    found.verdict if found.verdict == INSIDE else f"**{found.verdict}**",
                    found.mark,
                )
            )
    return table(("case", "quantity", "published", "Arcless", "verdict", "mark"), rows)


def kinks_table() -> str:
    """Return what kinks have of the force above 5 Hz, as the tests recorded it."""
    (record,) = (known for known in recorded() if known.name == "superposed_kinks")
    values = {row.what: row for row in record.rows}
    cases = dict.fromkeys(row.what.partition(": ")[0] for row in record.rows)
    rows = []
    for case in cases:
        of_sum = values[f"{case}: σ of the sum at 5 to 20 Hz"]
        sigma = of_sum.reference or 0.0
        ratio = values[f"{case}: σ of the kinks over that of the run"].value
        left = values[f"{case}: share of the variance that the sum leaves"].value
        rows.append(
            (
                case,
                f"{sigma:.1f}",
                f"{ratio * sigma:.1f}",
                f"{values[f'{case}: correlation of the kinks with the run'].value:+.2f}",
                f"{100 * values[f'{case}: passages that meet a slack dropper'].value:.0f} %",
                f"{of_sum.value:.1f}",
                f"{100 * (1.0 - left):.0f} %",
            )
        )
    head = ("line", "run, σ N", "kinks alone, σ N", "correlation with the run")
    more = ("slack when passed", "with changes of forces, σ N", "variance explained")
    return table((*head, *more), rows)


def sensitivity_table(cases: Iterable[Any], variants: list[tuple[str, Changes]]) -> str:
    """One row for each variant and speed; a value outside of its range is marked with `!`."""
    keys = [key for key in SHOWN if any(r.key == key for r in next(iter(cases)).ranges)]
    rows = []
    for title, changes in variants:
        for case in cases:
            name = changes.get("scenario", {}).get(case.scenario, case.scenario)
            rest = {key: value for key, value in changes.items() if key != "scenario"}
            found = {r.key: r for r in compare(case, run(name, rest).assessment.to_dict())}
            cells = [
                f"{found[key].value:.1f}{'' if found[key].verdict == INSIDE else '!'}"
                for key in keys
            ]
            inside = sum(row.verdict == INSIDE for row in found.values())
            speed = case.title.rpartition(", ")[2].split()[0]
            rows.append((title, speed, *cells, f"{inside} of {len(found)}"))
    return table(("variant", "km/h", *(SHOWN[key] for key in keys), "inside"), rows)


def lengths_table() -> str:
    solver = arcless.load(DROPPERS.scenario).stepping
    halved = {f"solver.{wire}_element": getattr(solver, f"{wire}_element_m") / 2 for wire in WIRES}

    def found(name: str, changes: Changes) -> list[float]:
        droppers = arcless.statics(arcless.load(name).with_(**changes)).droppers
        return [d["length_m"] for d in droppers if d["span"] == 10]

    columns = [
        found(DROPPERS.scenario, {}),
        found(DROPPERS.scenario, halved),
        found("en50318-ac-simple-320", {}),
    ]
    rows = [
        (
            number,
            f"{published:.3f}",
            *(f"{x:.4f}" for x in row),
            f"{(row[0] - published) * 1e3:+.1f}",
        )
        for number, (published, *row) in enumerate(
            zip(DROPPERS.lengths, *columns, strict=True), start=1
        )
    ]
    return table(
        ("dropper", "published m", "Arcless m", "elements halved m", "in space m", "difference mm"),
        rows,
    )


def elasticity_table() -> str:
    cases = {
        "planar, arm 2673.58 N/m": ("en50318-ac-simple-320-planar", {}),
        "planar, arm 267.36 N/m": (
            "en50318-ac-simple-320-planar",
            {"line.steady_arm.vertical_stiffness": 267.36},
        ),
        "in space, hinged arm": ("en50318-ac-simple-320", {}),
    }
    rows = []
    for title, (name, changes) in cases.items():
        found = arcless.statics(arcless.load(name).with_(**changes))
        e = 1e3 * np.array(found.elasticity_m_per_N)
        middle = e[len(e) // 2]
        k = 55.0 / (38.0 * middle)
        rows.append((title, f"{e[0]:.3f}", f"{middle:.3f}", f"{e.max():.3f}", f"{k:.2f}"))
    return table(("line", "support mm/N", "mid-span mm/N", "highest mm/N", "k = L/(e ΣT)"), rows)


def halving_table() -> str:
    rows = []
    for case in CASES:
        base = run(case.scenario)
        solver = base.scenario.stepping
        fixed = force(base.metadata["static_force_found"]["P1"])
        fine = {
            f"solver.{wire}_element": getattr(solver, f"{wire}_element_m") / 2 for wire in WIRES
        }
        step = {"solver.time_step": solver.time_step / 2}
        reference = numbers(base)
        variants: list[tuple[str, Changes | None]] = [
            (f"{solver.contact_wire_element_m:g} m, {solver.time_step * 1e3:g} ms", None),
            ("elements halved", fine),
            ("time step halved", step),
            ("both halved", {**fine, **step}),
        ]
        if solver.scheme.name == EXPLICIT:
            # Elements half as long are not stable with half of the step, and `auto` would then
            # take a matrix: a quarter of it, and the family is given.
            explicit: Changes = {"solver.scheme": EXPLICIT}
            quarter: Changes = {**explicit, "solver.time_step": solver.time_step / 4}
            variants[1:] = [
                ("time step halved", explicit | step),
                ("time step a quarter", quarter),
                ("elements halved, time step a quarter", quarter | fine),
            ]
        for title, changes in variants:
            found = reference if changes is None else numbers(run(case.scenario, fixed | changes))
            keys = ("mean_force_N", "std_force_N", "max_uplift_at_support_mm")
            changed = [f"{100 * (found[key] / reference[key] - 1):+.2f}" for key in keys]
            values = [f"{found[key]:.2f}" for key in (*keys, "max_force_N", "min_force_N")]
            rows.append((case.title, title, *values, *(changed if changes else ["", "", ""])))
    head = ("Fm N", "σ N", "uplift mm", "max N", "min N", "Fm %", "σ %", "uplift %")
    return table(("case", "run", *head), rows)


# Kilometres of line: longer elements and steps than `auto` takes, explicit as with it.
LONG_STEPS: Changes = {
    "solver.scheme": EXPLICIT,
    "solver.contact_wire_element": 0.45,
    "solver.messenger_wire_element": 0.6,
    "solver.time_step": 2e-3,
}


def distance_table() -> str:
    """A single pantograph, and the trailing one of two, over the same ten spans."""
    name = "en50318-ac-simple-320-planar"
    placement = arcless.load(name).to_dict()["pantographs"][0]
    placement |= {"mean_force": None, "static_force": 172.0}
    rows = []
    for apart, damping, title in (
        (20, {}, "as shipped"),
        (182, {}, "as shipped"),
        (100, rayleigh(0.114, 2.9e-4), "1 %"),
    ):
        behind = {**placement, "name": "P2", "distance": 55.0 * apart}
        line = {
            "line.spans": [{"type": "standard", "count": 2 * apart + 17}],
            **LONG_STEPS,
            "output": {"line_every": 1000, "droppers": False},
            "analysis.spans": [apart + 6, apart + 15],
            **damping,
        }
        start, end = 55.0 * (apart + 1), 55.0 * (apart + 15)
        alone = {"pantographs": [placement], "travel": {"start": start, "end": end}}
        pair = {
            "pantographs": [placement, behind],
            "travel": {"start": start, "end": end + 55.0 * apart},
        }
        place = f"{55 * apart / 1000:g} km", title
        both = run(name, line | pair).assessment.pantographs
        single = run(name, line | alone).assessment.pantographs[0]
        for who, found in (("single", single), ("leading", both[0]), ("trailing", both[1])):
            keys = ("mean_force_N", "std_force_N", "max_force_N", "min_force_N")
            values = [f"{getattr(found, key):.2f}" for key in keys]
            rows.append((*place, who, *values))
    head = ("distance", "damping", "pantograph", "Fm N", "σ N", "max N", "min N")
    return table(head, rows)


def energy_table() -> str:
    force_ = force(172.0)
    short = {**BY_MATRIX, "output.energy": "always", **force_}
    variants = {
        "trapezoidal": {"solver.scheme": "trapezoidal"},
        "trapezoidal, 0.5 ms": {"solver.scheme": "trapezoidal", "solver.time_step": 5e-4},
        "generalised-α": {},
        "generalised-α, 0.5 ms": {"solver.time_step": 5e-4},
        "generalised-α, rigid": {"contact.law": "rigid"},
        "generalised-α of radius 0, rigid": {
            "contact.law": "rigid",
            "solver.scheme": {"name": "generalised-alpha", "spectral_radius": 0.0},
        },
        "trapezoidal, friction 0.2": {
            "solver.scheme": "trapezoidal",
            "contact.friction_coefficient": 0.2,
        },
    }
    runs = {title: run("en50318-ac-simple-320-planar", short | c) for title, c in variants.items()}
    names = [name for name in next(iter(runs.values())).dataset if str(name).startswith("energy_")]
    rows = [
        (
            str(name).removeprefix("energy_").replace("_", " "),
            *(f"{float(r.dataset[name][-1]):.3g}" for r in runs.values()),
        )
        for name in names
    ]
    relative = [f"{r.metadata['energy_residual_relative']:.1e}" for r in runs.values()]
    slack = [r.metadata["slack_droppers_max"] for r in runs.values()]
    lost = [f"{r.assessment.pantographs[0].contact_loss_percent:.1f}" for r in runs.values()]
    rows += [
        ("**relative residual**", *relative),
        ("most slack droppers at once", *slack),
        ("loss of contact, unfiltered %", *lost),
    ]
    return table(("entry J", *runs), rows)


QUICK: dict[str, dict[str, Callable[[], str]]] = {
    "en50318-2002": {"ranges": lambda: ranges_table("en50318_2002", EN_CASES)},
    "ac-simple": {
        "ranges": lambda: ranges_table("ac_simple", AC_CASES),
        "kinks": kinks_table,
    },
}
SLOW: dict[str, dict[str, Callable[[], str]]] = {
    "en50318-2002": {"sensitivity": lambda: sensitivity_table(EN_CASES, en_variants())},
    "ac-simple": {
        "lengths": lengths_table,
        "elasticity": elasticity_table,
        "sensitivity": lambda: sensitivity_table(AC_CASES[:2], ac_variants()),
    },
    "convergence": {"halving": halving_table, "distance": distance_table},
    "energy": {"ledger": energy_table},
}
