"""Task of an environment: which pantograph on which line, seen how, moved how, rewarded how."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from math import ceil
from pathlib import Path
from typing import Any

from arcless.control import settings, signals
from arcless.control.places import Spans, starts
from arcless.control.reward import Weights
from arcless.control.signals import Reader, Signal
from arcless.model import Scenario, load
from arcless.model.pantograph.controller import Controller
from arcless.simulate.session.shared_line import SharedLine

SCENARIO = "en50318-ac-simple-320-planar"


@dataclass(frozen=True)
class Task:
    """Task of an environment, checked and with its line prepared; made by `task`.

    Attributes
    ----------
    scenario
        Scenario, with the actuator as the controller of the pantograph and static forces found.
    line
        Its line, prepared for sessions.
    pantograph
        Number of the pantograph that is controlled, from 0.
    controller
        The actuator: sample time, delay, limits.
    signals, reader
        What the controller sees, and how it is read.
    action_unit_N
        Force of the action 1, N.
    weights, target_force_N
        Weights of the reward, and the mean contact force wanted, N.
    spans, lead_in_spans, window_spans
        Spans of an episode, those before it without control, and those of the reward's window.
    spans_of_line, begin_between
        Spans of the line, and between which counts of them episodes begin.
    """

    scenario: Scenario
    line: SharedLine
    pantograph: int
    controller: Controller
    signals: tuple[Signal, ...]
    reader: Reader
    action_unit_N: float  # noqa: N815 - the unit is spelt as in every result
    weights: Weights
    target_force_N: float  # noqa: N815
    spans: int
    lead_in_spans: int
    window_spans: int
    spans_of_line: Spans
    begin_between: tuple[float, float]

    @property
    def sample_time_s(self) -> float:
        """Time between two samples, s."""
        return self.controller.sample_time

    @property
    def sample_m(self) -> float:
        """Way between two samples, m."""
        return self.line.speed_m_s * self.controller.sample_time

    @property
    def window(self) -> int:
        """Number of samples in the window of the reward."""
        low, _ = self.begin_between
        length = self._length(low + self.lead_in_spans, self.window_spans)
        return max(1, round(length / self.sample_m))

    def lengths(self, begin: float) -> tuple[int, int]:
        """Return the numbers of samples before and in the scored part of an episode.

        Parameters
        ----------
        begin
            Where it begins, counted in spans.
        """
        lead_in = self._length(begin, self.lead_in_spans)
        scored = self._length(begin + self.lead_in_spans, self.spans)
        return ceil(lead_in / self.sample_m - 1e-9), max(1, round(scored / self.sample_m))

    def describe(self) -> dict[str, Any]:
        """Return all that defines the task, as plain data with units in the names."""
        placement = self.scenario.pantographs[self.pantograph]
        low, high = self.begin_between
        place_at = self.spans_of_line.place_at
        return {
            "scenario": self.scenario.name,
            "changes": self.scenario.changes,
            "pantograph": placement.name,
            "static_force_N": placement.start_force,
            "speed_m_s": self.line.speed_m_s,
            "time_step_s": self.line.time_step_s,
            "action_unit_N": self.action_unit_N,
            "actuator": self.controller.model_dump(exclude={"pid", "function"}),
            "observe": [
                {"name": one.name, "unit": one.unit, "measured_by": one.measured_by}
                for one in self.signals
            ],
            "weights": asdict(self.weights),
            "target_force_N": self.target_force_N,
            "low_pass_Hz": self.scenario.analysis.low_pass,
            "spans": self.spans,
            "lead_in_spans": self.lead_in_spans,
            "window_spans": self.window_spans,
            "begin_between_m": [place_at(low), place_at(high)],
        }

    def _length(self, begin: float, spans: float) -> float:
        place_at = self.spans_of_line.place_at
        return place_at(begin + spans) - place_at(begin)


def task(
    scenario: Scenario | str | Path = SCENARIO,
    *,
    pantograph: str | None = None,
    observe: Sequence[str] = signals.DEFAULT,
    actuator: Mapping[str, Any] | None = None,
    action_in: str = "limit",
    weights: Weights | Mapping[str, float] | None = None,
    target_force_N: float | None = None,
    spans: int = 4,
    lead_in_spans: int = 2,
    window_spans: int = 1,
    stretch_m: tuple[float, float] | None = None,
) -> Task:
    """Check the settings of an environment, and prepare its line.

    Parameters
    ----------
    scenario
        Scenario, its file, or the name of a shipped one; at one speed. With `mean_force` the
        static force is found by a run without control, once.
    pantograph
        Name of the one that is controlled; the first without. On the others no force acts.
    observe
        Names of signals, see `arcless.control.SIGNALS`.
    actuator
        Fields of a scenario's `controller`, without `pid` and `function`. Without it those of the
        scenario, or of `ACTUATOR` if it has none. Limits are needed.
    action_in
        Unit of the action: "limit", the larger limit of the actuator, so that actions are within
        −1 and 1 as learners like them; or "N".
    weights
        Weights of the reward; those not named have their defaults.
    target_force_N
        Mean contact force wanted in N; without it the `mean_force` of the scenario, or static force
        and lift.
    spans, lead_in_spans, window_spans
        Whole spans: of an episode, before it without control, and of the window in which the reward
        takes σ, which lies within the lead-in at first.
    stretch_m
        Part of the line in which episodes are scored, from and to, m; the travel without.

    Raises
    ------
    ModelError
        A setting that does not fit.
    MeshError, EquilibriumError, ContactError
        The line cannot be prepared, or its mean force is not reached.
    """
    loaded = scenario if isinstance(scenario, Scenario) else load(scenario)
    number = settings.number_of(loaded, pantograph)
    settings.check_spans(spans=spans, lead_in_spans=lead_in_spans, window_spans=window_spans)
    controlled = settings.with_actuator(loaded, number, actuator)
    placement = controlled.pantographs[number]
    assert placement.controller is not None
    seen = signals.chosen(observe, placement.model)
    weighed, unit = Weights.of(weights), settings.action_unit_N(placement.controller, action_in)
    target = settings.target_of(controlled, number, target_force_N)
    speed = settings.speed_of(controlled)
    spans_of_line = Spans(controlled.line.support_positions())
    way, stretch = speed * placement.controller.sample_time, settings.stretch_of(stretch_m)
    between = starts(controlled, spans_of_line, (lead_in_spans, spans), stretch, 2.0 * way)
    line = SharedLine(controlled)
    sensor = None
    if any(one.name == "strip_force_N" for one in seen):
        sensor = signals.sensor_of(placement.model, speed)
    return Task(
        scenario=line.scenario,
        line=line,
        pantograph=number,
        controller=placement.controller,
        signals=seen,
        reader=Reader(placement.controller.sample_time, sensor),
        action_unit_N=unit,
        weights=weighed,
        target_force_N=target,
        spans=spans,
        lead_in_spans=lead_in_spans,
        window_spans=window_spans,
        spans_of_line=spans_of_line,
        begin_between=between,
    )
