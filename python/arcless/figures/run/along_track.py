"""Figures along the track: contact force, loss of contact, height of the contact point."""

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import low_pass, sample_rate_Hz
from arcless.display.numbers import number
from arcless.figures.description import Axis, Curve, Figure, Layer, Points, Rules, Texts
from arcless.figures.description.tokens import of_pantograph, of_series
from arcless.figures.run.run_data import RunData
from arcless.figures.run.track import (
    along,
    filtered,
    gaps,
    place_name,
    span_at,
    span_numbers,
    supports,
    thinned,
    titled,
    unfiltered,
)
from arcless.figures.wires.wire_points import wire_points

Bools = NDArray[np.bool_]

FORCE = "contact force"
# Half of the first figure in m where there are no spans.
AROUND_M = 150.0
# Spans of the first figure on either side of that with the worst place, and its extra height.
BESIDE, HEADROOM, FOOTROOM = 1, 0.16, 0.07
LEAD_HEIGHT, TALL = 330, 320
WIRE_POINTS = 3000
# A limit this far above what was reached is not drawn: it would flatten the curves.
FAR_LIMIT = 1.35


def lead(run: RunData) -> list[Figure]:
    """Return the first figure: the force in the spans around the worst place, with its limits."""
    window = _worst_window(run)
    shown = [(run.position[:, i] >= window[0]) & (run.position[:, i] <= window[1])
             for i in range(len(run.pantographs))]  # fmt: skip
    low, high = _force_range(run, shown)
    low, top = low - FOOTROOM * (high - low), high + HEADROOM * (high - low)
    found = []
    first = worst(run)[0]
    for i in sorted(range(len(run.pantographs)), key=lambda i: i != first):
        numbers, (begin, end) = run.assessment.pantographs[i], run.assessment.section_m
        peaks, alt = _peaks(run, i, window)
        x = Axis("position along the track", "m", window[0], window[1])
        found.append(
            Figure(
                f"lead-{i + 1}",
                titled(run, "Contact force around the worst place", i),
                x,
                Axis(FORCE, "N", low, top),
                [
                    *supports(run),
                    *_unfiltered(run, i, shown[i]),
                    *_statistics(run, i, limit_up_to=high),
                    filtered(run, i, run.record.bands.total[:, i], "contact force N 0.0",
                             name=_filtered_name(run), width=2.2),
                    *span_numbers(run, *window, top),
                    *peaks,
                ],
                caption=f"Mean and F_m ± 3σ of the analysis section, {begin:.0f} to {end:.0f} m.",
                alt=f"Contact force of {numbers.name} from {window[0]:.0f} to {window[1]:.0f} m."
                f" {alt} Mean {numbers.mean_force_N:.1f} N, standard deviation"
                f" {numbers.std_force_N:.1f} N in the analysis section.",
                height=LEAD_HEIGHT,
            )
        )  # fmt: skip
    return found


def extremes(run: RunData, pantograph: int) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return position in m and filtered force in N of the maximum and minimum in the section."""
    inside = np.flatnonzero(run.record.inside[:, pantograph])
    force = run.record.bands.total[inside, pantograph]
    rows = inside[[int(force.argmax()), int(force.argmin())]]
    (top, bottom) = (
        (float(run.position[row, pantograph]), float(run.record.bands.total[row, pantograph]))
        for row in rows
    )
    return top, bottom


def worst(run: RunData) -> tuple[int, str, float, float]:
    """Return the place at which the force is furthest from its mean, in N, of all pantographs.

    Number of the pantograph from 0, ``"maximum"`` or ``"minimum"``, position in m, force in N.
    """
    found = []
    for i, numbers in enumerate(run.assessment.pantographs):
        for kind, (x, force) in zip(("maximum", "minimum"), extremes(run, i), strict=True):
            found.append((abs(force - numbers.mean_force_N), (i, kind, x, force)))
    return max(found)[1]


def force(run: RunData) -> list[Figure]:
    """Return the contact force of the whole run, a figure for each pantograph."""
    everywhere = [np.ones(run.time.size, dtype=bool)] * len(run.pantographs)
    low, high = _force_range(run, everywhere)
    found = []
    for i, numbers in enumerate(run.assessment.pantographs):
        curve = filtered(run, i, run.record.bands.total[:, i], "contact force N 0.0",
                         name=_filtered_name(run))  # fmt: skip
        layers = [
            *gaps(run, i),
            *_unfiltered(run, i),
            *_statistics(run, i, limit_up_to=high),
            curve,
        ]
        found.append(
            along(
                run, f"force-{i + 1}", titled(run, "Contact force", i),
                Axis(FORCE, "N", low, high), layers, height=TALL,
                caption=f"The analysis section is shaded.{thinned(run)}",
                alt=f"Contact force of {numbers.name} along the track, between"
                f" {numbers.min_force_N:.1f} and {numbers.max_force_N:.1f} N in the analysis"
                " section after the low-pass.",
            )
        )  # fmt: skip
    return found


def shares(run: RunData) -> list[Figure]:
    """Return the filtered force of each contact, where a pantograph has several."""
    if not run.has("wire_contact_force"):
        return []
    limit = run.assessment.low_pass_Hz
    names = [str(name) for name in run.values("contact")]
    forces = low_pass(run.values("wire_contact_force"), sample_rate_Hz(run.time), limit)
    ends = _padded(float(forces.min()), float(forces.max()))
    found = []
    for i, name in enumerate(names):
        curve = filtered(run, _owner(run, name), forces[:, i], "contact force N 0.0",
                         colour=of_series(i), name=name)  # fmt: skip
        found.append(
            along(
                run, f"share-{i + 1}", f"Contact force of {name}", Axis(FORCE, "N", *ends), [curve],
                caption=f"After the {limit:g} Hz low-pass. All contacts have the same scale.",
                alt=f"Contact force of {name}, from {forces[:, i].min():.1f} to"
                f" {forces[:, i].max():.1f} N.",
            )
        )  # fmt: skip
    return found


def gap(run: RunData) -> list[Figure]:
    """Return the gap between strip and wire where contact is lost, or could be without a trace."""
    values = 1e3 * run.values("contact_gap")
    if not (run.rigid_contact or np.any(run.record.force <= 0.0)):
        return []
    top = 1.1 * float(values.max(initial=0.0)) or 1.0
    lost = run.rigid_contact | np.any(run.record.force <= 0.0, axis=0)
    return [
        along(
            run, f"gap-{i + 1}", titled(run, "Gap between contact strip and contact wire", i),
            Axis("gap", "mm", 0.0, top),
            [unfiltered(run, i, values[:, i], colour=of_pantograph(i), name="gap", width=1.3)],
            alt=f"Gap of {name}, at most {values[:, i].max(initial=0.0):.2f} mm.",
        )
        for i, name in enumerate(run.pantographs)
        if lost[i]
    ]  # fmt: skip


def height(run: RunData) -> list[Figure]:
    """Return the height of the contact point over the height of the wire at rest."""
    rest: list[Layer] = []
    if run.has("contact_wire_node_x", "contact_wire_node_z"):
        x, z = wire_points(run, "contact_wire", "z", WIRE_POINTS)
        rest = [Curve(x, z, colour="rest", name="contact wire at rest", width=1.2)]
    heights = run.dataset["contact_height"].values
    lowest, highest = float(np.nanmin(heights)), float(np.nanmax(heights))
    if rest:
        seen = (x >= run.position.min()) & (x <= run.position.max())
        lowest = min(lowest, float(np.nanmin(z[seen], initial=lowest)))
        highest = max(highest, float(np.nanmax(z[seen], initial=highest)))
    axis = Axis("height above rail", "m", *_padded(lowest, highest), form="0.00")
    found = []
    for i, name in enumerate(run.pantographs):
        if np.isnan(heights[:, i]).all():
            continue  # not measured
        curve = filtered(run, i, heights[:, i], "height m 0.000", name="contact point")
        found.append(
            along(
                run, f"height-{i + 1}", titled(run, "Height of the contact point", i), axis,
                [*gaps(run, i), *rest, curve],
                alt=f"Height of the contact point of {name}, from {np.nanmin(heights[:, i]):.3f}"
                f" to {np.nanmax(heights[:, i]):.3f} m above rail.",
            )
        )  # fmt: skip
    return found


def _filtered_name(run: RunData) -> str:
    return f"filtered, 0–{run.assessment.low_pass_Hz:g} Hz"


def _padded(low: float, high: float) -> tuple[float, float]:
    margin = 0.06 * (high - low) or 0.5
    return low - margin, high + margin


def _unfiltered(run: RunData, pantograph: int, shown: Bools | None = None) -> list[Layer]:
    force = run.record.force[:, pantograph]
    return [unfiltered(run, pantograph, force, shown=shown, name="unfiltered")]


def _statistics(run: RunData, pantograph: int, *, limit_up_to: float) -> list[Layer]:
    """Return mean, mean ± 3σ, and the limits of the latter two."""
    numbers = run.assessment.pantographs[pantograph]
    layers: list[Layer] = [
        Rules(axis="y", at=np.array([numbers.mean_force_N]), colour="mean", name="mean F_m",
              width=1.2),
        Rules(axis="y", at=np.array([numbers.statistical_min_N, numbers.statistical_max_N]),
              colour="spread", name="F_m ± 3σ", dash="dashed", width=1.2),
    ]  # fmt: skip
    limits = {
        "limit of F_m − 3σ": run.limit("statistical_min", pantograph),
        "limit of F_m + 3σ": run.limit("statistical_max", pantograph),
    }
    near = {name: one for name, one in limits.items() if one is not None and one <= limit_up_to}
    if near:
        name = "limits of F_m ± 3σ" if len(near) > 1 else next(iter(near))
        values = " and ".join(f"{one:g}" for one in near.values())
        layers.append(
            Rules(axis="y", at=np.array([*near.values()]), colour="limit", dash="dashed",
                  width=1.6, name=f"{name}: {values} N")
        )  # fmt: skip
    return layers


def _force_range(run: RunData, shown: list[Bools]) -> tuple[float, float]:
    """Return the ends of the force axis: what is shown, mean ± 3σ, and limits that are near."""
    force = [run.record.force[rows, i] for i, rows in enumerate(shown)]
    numbers = run.assessment.pantographs
    low = min(0.0, *(p.statistical_min_N for p in numbers), *(float(np.nanmin(f)) for f in force))
    high = max(*(p.statistical_max_N for p in numbers), *(float(np.nanmax(f)) for f in force))
    limits = [run.limit("statistical_max", i) for i in range(len(numbers))]
    high = max([high, *(one for one in limits if one is not None and one <= FAR_LIMIT * high)])
    margin = 0.04 * (high - low)
    return (low - margin if low < 0.0 else low), high + margin


def _worst_window(run: RunData) -> tuple[float, float]:
    """Return the ends of the spans around the worst place; without spans some metres around it."""
    _, _, x, _ = worst(run)
    number = span_at(run, x)
    if number is None:
        begin, end = float(run.position.min()), float(run.position.max())
        return max(begin, x - AROUND_M), min(end, x + AROUND_M)
    first, last = max(0, number - 1 - BESIDE), min(run.supports.size - 1, number + BESIDE)
    return float(run.supports[first]), float(run.supports[last])


def _peaks(run: RunData, pantograph: int, window: tuple[float, float]) -> tuple[list[Layer], str]:
    """Return marks at the extremes of the section inside a window, and their places in words."""
    layers: list[Layer] = []
    words = []
    for kind, (x, value) in zip(("maximum", "minimum"), extremes(run, pantograph), strict=True):
        words.append(f"The {kind} of the section is {number(value)} N at {place_name(run, x)}.")
        if window[0] <= x <= window[1]:
            up = kind == "maximum"
            at, text = (np.array([x]), np.array([value])), f"{kind} {number(value, 0)} N"
            offset = np.array([value + (1 if up else -1) * 0.02 * max(abs(value), 100.0)])
            third = (window[1] - window[0]) / 3.0
            layers.append(
                Texts(
                    at[0], offset, [text], colour="highlight", size=12.0, backed=True,
                    align="left" if x < window[0] + third
                    else "right" if x > window[1] - third else "center",
                    baseline="bottom" if up else "top",
                )
            )  # fmt: skip
            layers.append(Points(*at, colour="highlight", size=8.0))  # above the patch of the text
    return layers, " ".join(words)


def _owner(run: RunData, contact: str) -> int:
    """Return the number of the pantograph that a contact is named after."""
    owners = [i for i, name in enumerate(run.pantographs) if contact.startswith(f"{name} strip ")]
    return max(owners, key=lambda i: len(run.pantographs[i]))
