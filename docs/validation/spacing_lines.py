"""Two pantographs on each hanging line of the library, over their spacing: runs, tables, figure."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from validation.runs import table
from validation.wake import Wake, recorded_points

import arcless
from arcless.equilibrium.initial_configuration import InitialConfiguration
from arcless.model import Scenario
from arcless.model.pantograph.spacing import tsi_spacing
from arcless.model.scenario.coarse_copy import coarse
from arcless.simulate.resonance import Band, SpacingPeriod, spacing_period
from arcless.simulate.resonance.spans import spans

IMAGES = Path(__file__).parents[1] / "images"
Floats = NDArray[np.float64]

# The shipped scenario with the highest speed on lines that hang and have equal spans, and lines
# that no scenario runs below (`BORROWED`).
SCENARIOS = (
    "en50318-ac-simple-320-planar",
    "china-stitched-350",
    "france-lgv-est-320",
    "china-beijing-yizhuang-300",
    "en50318-2002-300",
    "germany-re-330-300",
    "norway-s25-250",
    "shinkansen-compound-240",
    "spain-ca-220-220",
    "spain-ca-200-200",
    "spain-ca-220-3kv-200",
    "germany-re-200-200",
    "norway-s20a-200",
    "norway-s20b-160",
    "norway-s35",
    "sweden-syt-7.0-9.8",
    "spain-ca-160-3kv-160",
    "india-25kv-140",
)
# Scenario with the pantograph, force and speed for lines that have none: no source states theirs.
BORROWED = {"norway-s35": "norway-s20b-160", "sweden-syt-7.0-9.8": "norway-s20b-160"}
# Steps in s of coarse copies for which 2 ms are too long: the longest stable ones with their
# elements are 1.94 ms (Re 200) and 1.95 ms (S20A).
SHORTER = {"germany-re-200-200": 1.5e-3, "norway-s20a-200": 1.5e-3}
SPACINGS = tuple(float(d) for d in range(30, 221, 10))
FURTHEST = 220.0
# Spans before the section and within it, for both pantographs.
BEFORE, ASSESSED = 6, 10
# Spacings in m that the wake is looked at in, for its frequencies and for σ to first order.
WAKE = np.arange(20.0, FURTHEST + 0.1, 2.0)


@dataclass(frozen=True)
class Setting:
    """Run of a line: its scenario, where the section lies, and how steps and elements are.

    Those that are coarse are twice as long (`coarse_copy`), where the line takes explicit steps.
    """

    scenario: str  # or the line, of those borrowed for
    before: int = BEFORE
    assessed: int = ASSESSED
    is_coarse: bool = True

    @property
    def base(self) -> Scenario:
        """The shipped scenario; of a line without one, another line's on this line."""
        if self.scenario in BORROWED:
            return arcless.load(BORROWED[self.scenario]).with_(line=self.scenario)
        return arcless.load(self.scenario)

    @property
    def length(self) -> float:
        """Length of a span in m."""
        return self.base.line.span_list()[0].length

    @property
    def speed(self) -> float:
        """Speed in m/s."""
        speed = self.base.speed
        assert speed is not None
        return speed

    @property
    def spacings(self) -> tuple[float, ...]:
        """Spacings in m, that of the TSI among them."""
        return tuple(sorted({*SPACINGS, max(tsi_spacing(self.speed), SPACINGS[0])}))

    def _steps(self) -> dict[str, Any]:
        copied = coarse(self.base) if self.is_coarse else None
        names = ("contact_wire_element", "messenger_wire_element")
        if copied is None:
            return {}
        step = min(copied.time_step_s, SHORTER.get(self.scenario, copied.time_step_s))
        explicit = {"solver.scheme": copied.solver.scheme.name, "solver.time_step": step}
        return explicit | {f"solver.{name}": getattr(copied.solver, name) for name in names}

    def section(self) -> tuple[float, float]:
        """Return the ends of the section in m."""
        first = ceil(FURTHEST / self.length) + 1 + self.before
        return first * self.length, (first + self.assessed) * self.length

    def at(self, spacing: float | None, **changes: Any) -> Scenario:
        """Return the scenario with two pantographs so far apart in m, or with one.

        Each has as static force the mean force that the scenario asks for, where it asks for one:
        so nothing is searched for, and both have the same.
        """
        base, length = self.base, self.length
        behind = ceil(FURTHEST / length)
        first, last = self.section()
        data = base.to_dict()
        one: dict[str, Any] = data["pantographs"][0]
        if one["mean_force"] is not None:
            one |= {"mean_force": None, "static_force": one["mean_force"]}
        placed = [one] if spacing is None else [one, {**one, "name": "P2", "distance": spacing}]
        kind = data["line"]["spans"][0]["type"]
        count = 2 * behind + self.before + self.assessed + 3
        return base.with_(**{
            "line.spans": [{"type": kind, "count": count}],
            "pantographs": placed,
            "travel": {"start": (behind + 1) * length, "end": last + (spacing or 0.0) + length / 2},
            "analysis": {"from": first, "to": last},
            **self._steps(),
            "output": {"line_every": 10_000, "droppers": False},
            **changes,
        })  # fmt: skip


@dataclass(frozen=True)
class Curve:
    """Standard deviations in N over the spacing in m, and that of one pantograph alone."""

    spacings: Floats
    leading: Floats
    trailing: Floats
    alone: float

    @property
    def worst(self) -> int:
        """Number of the spacing with the highest σ of the trailing pantograph."""
        return int(np.argmax(self.trailing))

    @property
    def best(self) -> int:
        """Number of the spacing with the lowest σ of the trailing pantograph."""
        return int(np.argmin(self.trailing))


@cache
def curve(setting: Setting, spacings: tuple[float, ...] = ()) -> Curve:
    """Run one pantograph, and two at each spacing; at those of the setting without."""
    spacings = spacings or setting.spacings
    print(f"{setting.scenario}: {len(spacings)} spacings", flush=True)
    outcomes = arcless.batch([setting.at(None), *map(setting.at, spacings)])
    found = []
    for outcome in outcomes:
        if outcome.error is not None:
            raise outcome.error
        assert outcome.assessment is not None
        found.append([one.std_force_N for one in outcome.assessment.pantographs])
    (alone,), *pairs = found
    leading, trailing = np.array(pairs).T
    return Curve(np.array(spacings), leading, trailing, alone)


@cache
def wake(setting: Setting) -> Wake:
    """Run one pantograph, with the motion of the wire behind it."""
    first, last = setting.section()
    output = {"line_every": 2, "droppers": False,
              "points": recorded_points(first, last, setting.length)}  # fmt: skip
    end = last + FURTHEST + 1.2 * setting.length  # the margin behind the section has a wake, too
    scenario = setting.at(None, output=output)
    scenario = scenario.with_(**{"travel.end": end})
    return Wake.of(arcless.run(scenario), setting.length)


@cache
def first_order(setting: Setting) -> tuple[Floats, Floats]:
    """Return spacings in m, and σ in N of a trailing pantograph that follows from the wake."""
    behind = wake(setting)
    sigma = [behind.deviation(behind.second_force(d)) for d in WAKE]
    return WAKE, np.array(sigma)


@cache
def swing(setting: Setting) -> Band:
    """Return the frequencies in Hz in which a span swings as one half wave."""
    base = setting.base
    rest = InitialConfiguration.of(base)
    force = base.pantographs[0].start_force or 0.0
    found = spans(rest.equilibrium, base.line.span_list(), force)
    return found[len(found) // 2].swing


def free_wave(setting: Setting) -> float:
    """Return f = v/(L (1 + v/c)) in Hz, of a wave that runs back along a free contact wire."""
    speed, c = setting.speed, setting.base.line.wave_speed
    assert c is not None
    return speed / (setting.length * (1.0 + speed / c))


def period_of(setting: Setting) -> SpacingPeriod:
    """Return the period of σ² over the spacing as it was found by runs."""
    found = curve(setting)
    period = spacing_period(found.spacings, found.trailing)
    assert period is not None
    return period


@dataclass(frozen=True)
class Prediction:
    """What the wake of one pantograph says, at the spacings of the runs.

    Attributes
    ----------
    sigma
        To first order, in N.
    correlation
        With σ as found.
    error
        Root mean square of the difference in N.
    worst, best
        Spacings in m.
    """

    sigma: Floats
    correlation: float
    error: float
    worst: float
    best: float


def prediction(setting: Setting) -> Prediction:
    """Return the prediction for a line beside what was found."""
    found = curve(setting)
    sigma = np.interp(found.spacings, *first_order(setting))
    return Prediction(
        sigma,
        float(np.corrcoef(sigma, found.trailing)[0, 1]),
        float(np.sqrt(np.mean((sigma - found.trailing) ** 2))),
        float(found.spacings[np.argmax(sigma)]),
        float(found.spacings[np.argmin(sigma)]),
    )


def _line(setting: Setting) -> str:
    return f"{setting.base.line.name}, {3.6 * setting.speed:.0f} km/h"


def each() -> Iterator[tuple[Setting, Curve]]:
    """Yield the setting of each line and σ over its spacings."""
    for name in SCENARIOS:
        setting = Setting(name)
        yield setting, curve(setting)


def worst_table() -> str:
    rows = []
    for setting, found in each():
        rule, worst, best = tsi_spacing(setting.speed), found.worst, found.best
        at_rule = found.trailing[list(found.spacings).index(rule)]
        rows.append((
            _line(setting), f"{found.alone:.1f}",
            f"{found.leading.min():.1f} to {found.leading.max():.1f}",
            f"{found.spacings[worst]:.0f} m", f"{found.trailing[worst]:.1f}",
            f"{found.trailing[worst] / found.alone:.1f}",
            f"{found.spacings[best]:.0f} m", f"{found.trailing[best]:.1f}",
            f"{found.trailing[best] / found.alone:.1f}",
            f"{rule:.0f} m", f"{at_rule:.1f}", f"{at_rule / found.alone:.1f}",
        ))  # fmt: skip
    head = ("line", "alone N", "leading N", "worst", "N", "over alone", "best", "N", "over alone",
            "TSI", "N", "over alone")  # fmt: skip
    return table(head, rows)


def why_table() -> str:
    rows = []
    for setting, found in each():
        period, behind, band = period_of(setting), wake(setting), swing(setting)
        frequency = period.frequency(setting.speed)
        parts = [behind.frequency(n, WAKE, setting.length) for n in (1, 2, 3)]
        turns = parts[0] / setting.speed
        rows.append((
            _line(setting), f"{period.length:.0f}", f"{100 * period.share:.0f}",
            f"{-period.phase(0.0):+.2f}", f"{frequency:.2f}",
            *(f"{part:.2f}" for part in parts),
            f"{band.low:.2f} to {band.high:.2f}", f"{free_wave(setting):.2f}",
            f"{turns * found.spacings[found.worst]:.2f}",
            f"{turns * found.spacings[found.best]:.2f}",
        ))  # fmt: skip
    head = ("line", "period of σ² m", "of its variance %", "crest at, periods", "v / period Hz",
            "wake, 1 wave Hz", "2 waves Hz", "3 waves Hz", "swing of a span Hz",
            "v/(L (1 + v/c)) Hz", "worst at f d/v", "best at f d/v")  # fmt: skip
    return table(head, rows)


def first_order_table() -> str:
    rows = []
    for setting, found in each():
        told, worst, best = prediction(setting), found.worst, found.best
        there = {d: s for d, s in zip(found.spacings, found.trailing, strict=True)}
        rows.append((
            _line(setting), f"{told.correlation:.2f}", f"{told.error:.0f}",
            f"{told.worst:.0f}", f"{found.spacings[worst]:.0f}",
            f"{100 * there[told.worst] / found.trailing[worst]:.0f}",
            f"{told.best:.0f}", f"{found.spacings[best]:.0f}",
            f"{100 * there[told.best] / found.trailing[best]:.0f}",
        ))  # fmt: skip
    head = ("line", "correlation", "rms N", "worst, foretold m", "found m", "σ there %",
            "best, foretold m", "found m", "σ there %")  # fmt: skip
    return table(head, rows)


# Lines at which elements and steps, run-in and section are made twice what they are.
REFINED = ("en50318-ac-simple-320-planar", "norway-s25-250")


def errors_table() -> str:
    rows = []
    for name in REFINED:
        setting = Setting(name)
        found = curve(setting)
        chosen = tuple(sorted({
            float(found.spacings[found.worst]),
            float(found.spacings[found.best]),
            tsi_spacing(setting.speed),
        }))  # fmt: skip
        variants = (
            setting,
            Setting(name, is_coarse=False),
            Setting(name, before=2 * BEFORE),
            Setting(name, assessed=2 * ASSESSED),
        )
        curves = [curve(variant, chosen) for variant in variants]
        rows += [
            (_line(setting), f"{d:.0f} m", *(f"{one.trailing[i]:.1f}" for one in curves))
            for i, d in enumerate(chosen)
        ]
        rows.append((_line(setting), "alone", *(f"{one.alone:.1f}" for one in curves)))
    head = ("line", "spacing", "σ as above N", "elements and step half as long N",
            "run-in of 12 spans N", "section of 20 spans N")  # fmt: skip
    return table(head, rows)


def figure() -> str:
    """Draw σ of the trailing pantograph over the spacing, found and to first order."""
    import matplotlib as mpl
    import matplotlib.pyplot as plt

    mpl.rcParams.update({"svg.hashsalt": "arcless", "svg.fonttype": "none", "font.size": 8})
    drawn, grid = plt.subplots(5, 4, figsize=(9.0, 9.8), sharex=True, layout="constrained")
    for axes, (setting, found) in zip(grid.flat, each(), strict=False):
        spacings, sigma = first_order(setting)
        axes.axhline(1.0, color="0.45", lw=0.8, ls="--")
        axes.axvline(tsi_spacing(setting.speed), color="0.6", lw=0.8, ls=":")
        axes.plot(found.spacings, found.leading / found.alone, color="0.45", lw=1.0)
        axes.plot(spacings, sigma / found.alone, color="#2f6db0", lw=1.0)
        axes.plot(found.spacings, found.trailing / found.alone, color="#d0652a", lw=1.3, marker=".")
        axes.set_ylim(bottom=0.0)
        axes.set_title(_line(setting), loc="left", fontsize=7)
    for axes in grid.flat[len(SCENARIOS) :]:
        axes.set_axis_off()
    names = ("one alone", "TSI", "leading", "trailing, to first order", "trailing")
    drawn.legend(grid[0, 0].lines, names, loc="outside upper center", ncols=5, frameon=False)
    drawn.supxlabel("spacing of the two pantographs, m", fontsize=9)
    drawn.supylabel("σ over that of one alone", fontsize=9)
    drawn.savefig(IMAGES / "spacing-lines.svg", metadata={"Date": None})
    plt.close(drawn)
    return "![σ of the trailing one over the spacing, all lines](../images/spacing-lines.svg)"


TABLES = {
    "worst": worst_table,
    "spacing-lines-figure": figure,
    "why": why_table,
    "first-order": first_order_table,
    "errors": errors_table,
}
