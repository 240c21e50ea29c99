"""Facts that the criteria of each variant are judged by, from the scenario and its values."""

import re
from dataclasses import dataclass
from typing import Any

from arcless.assess.facts import criteria_facts
from arcless.assess.rules import Facts
from arcless.errors import ArclessError
from arcless.model import Scenario
from arcless.simulate.runs.mean_force import TOLERANCE
from arcless.study.definition.study import Study
from arcless.study.journal.row import Row

# A scenario takes a millisecond; more different ones than this are not made for a page.
MOST_SCENARIOS = 5000
_FORCE = re.compile(r"pantographs\.(\d+)\.mean_force")
# Fields that no limit depends on.
_FREE = re.compile(
    r"pantographs\.\d+\.(static_force|mean_force|distance)$"
    r"|(speed|as_built|contact|solver|travel|analysis|wear)(\.|$)"
)


@dataclass(frozen=True)
class Scene:
    """Facts of a variant, and the mean forces that its pantographs are to reach, in N."""

    facts: Facts
    targets: tuple[float | None, ...]


# Distance of a mean force that was searched for from the one that was asked for, in N.
TARGET_MET_N = TOLERANCE


class Scenes:
    """Facts of the variants of a study; of those that share them, made once."""

    def __init__(self, study: Study) -> None:
        self._study = study
        self._scenarios: dict[str, Scenario | None] = {}
        self._facts: dict[tuple[str, float], Facts] = {}
        self._matter = [axis.name for axis in study.axes if not _FREE.match(axis.field)]
        as_built = any(axis.field.startswith("as_built") for axis in study.axes)
        self._wave_known = not as_built
        self._speeds = [axis.name for axis in study.axes if axis.field == "speed"]
        self._forces = {
            int(found[1]): axis.name
            for axis in study.axes
            if (found := _FORCE.fullmatch(axis.field)) is not None
        }

    def of(self, row: Row, speed_m_s: float | None = None) -> Scene | None:
        """Return the scene of a row; None where its speed, or its scenario, cannot be told.

        Parameters
        ----------
        row
            Of a variant that was computed.
        speed_m_s
            Mean speed in the section, where an output is that.
        """
        key = repr([row.values[name] for name in self._matter])
        if key not in self._scenarios:
            self._scenarios[key] = self._made(row)
        scenario = self._scenarios[key]
        if scenario is None:
            return None
        for name in self._speeds:
            speed_m_s = float(row.values[name])
        if speed_m_s is None:
            if scenario.speed is None or scenario.speed_profile is not None:
                return None
            speed_m_s = float(scenario.speed)
        targets = tuple(
            float(row.values[self._forces[place]]) if place in self._forces else placed.mean_force
            for place, placed in enumerate(scenario.pantographs)
        )
        if (key, speed_m_s) not in self._facts:
            self._facts[key, speed_m_s] = self._facts_of(scenario, speed_m_s)
        return Scene(self._facts[key, speed_m_s], targets)

    def _made(self, row: Row) -> Scenario | None:
        if not self._matter:
            return self._study.base
        if len(self._scenarios) >= MOST_SCENARIOS:
            return None
        values = tuple(row.values[axis.name] for axis in self._study.axes)
        fields = [axis.field for axis in self._study.axes if axis.name in self._matter]
        try:
            changes = self._study.changes_of(values)
            kept = {path: v for path, v in changes.items() if path.startswith(tuple(fields))}
            return self._study.base.with_(**kept)
        except ArclessError:  # a study file that was changed since
            return None

    def _facts_of(self, scenario: Scenario, speed: float) -> Facts:
        data: dict[str, Any] = {"scenario": scenario.to_dict()}
        if not self._wave_known:
            data["scenario"]["line"]["contact_wire"]["tension"] = None
        return criteria_facts(data, [speed], None)
