"""Laws of control: from what is seen to a force, the same in an environment and in a run.

`FilteredLaw` is the small law that `examples/control_baselines.py` learns. With y_s the signals,
x_s what is new in them against their slow mean, and z_sj low-passes of that with the time
constants τ_j,

    x_s = (y_s − ȳ_s)/Y_s,   ȳ_s ← ȳ_s + (1 − e^(−T/τ_w)) (y_s − ȳ_s)
    z_sj ← z_sj + (1 − e^(−T/τ_j)) (x_s − z_sj)
    u = U Σ_sj g_sj z_sj

Y_s is the scale of the signal, U 50 N, T the time between samples. The slow mean is taken out so
that the law has none itself: it cannot press more or less for long, which a static force would do
as well. A law that sees `asked_force_N` can: its own force fed back makes the slow mean slower.
"""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from arcless.control.actuator import Actuators
from arcless.control.places import Spans
from arcless.control.signals import SIGNALS, Reader, Sample, Sensor, observation
from arcless.control.task import Task
from arcless.errors import ControlError, ModelError, ResultFormatError
from arcless.model.pantograph.controller import Controller
from arcless.simulate import ControlInput
from arcless.storage.whole_files import write_bytes

Floats = NDArray[np.float64]
FORMAT = "arcless-law/1"
# Force of a law for gain and signal of 1, N.
FORCE_N = 50.0
# Time constants in s of the low-passes, and of the slow mean: from two samples of 5 ms to the time
# of half a span, and some spans.
TIME_CONSTANTS_S = (0.01, 0.05, 0.2)
MEAN_OVER_S = 2.0
# Times are numbers of steps times their length: what is left of a difference is rounding.
ROUNDING_S = 1e-9
ROW = np.array([0], dtype=np.intp)


class Law(Protocol):
    """Law of control: what is seen of several episodes, a row for each → forces in N."""

    def begin(self) -> None:
        """Forget all that was seen."""

    def __call__(self, seen: Floats) -> Floats:
        """Return the force of each episode, N."""


class FilteredLaw:
    """Law of gains on low-passed signals.

    Parameters
    ----------
    observe
        Names of the signals.
    gains
        Gains g, a row for each signal and a column for each time constant; with one more dimension
        in front, those of each of several episodes.
    sample_time_s
        Time between samples, s.
    time_constants_s, mean_over_s
        Those of the low-passes and of the slow mean, s.

    Raises
    ------
    ModelError
        Gains of the wrong shape, or not finite.
    """

    def __init__(
        self,
        observe: Sequence[str],
        gains: Any,
        sample_time_s: float,
        *,
        time_constants_s: Sequence[float] = TIME_CONSTANTS_S,
        mean_over_s: float = MEAN_OVER_S,
    ) -> None:
        for name in observe:
            if name not in SIGNALS:
                known = ", ".join(SIGNALS)
                raise ModelError(
                    "unknown signal",
                    where="observe",
                    got=repr(name)[:80],
                    expected=f"one of {known}",
                )
        self.gains = np.asarray(gains, dtype=np.float64)
        shape = len(observe), len(time_constants_s)
        if self.gains.shape[-2:] != shape or not np.isfinite(self.gains).all():
            raise ModelError(
                "gains of a law",
                where="gains",
                got=f"shape {self.gains.shape}",
                expected=f"finite numbers of the shape {shape}: signals × time constants",
            )
        self.observe, self.sample_time_s = tuple(observe), sample_time_s
        self.time_constants_s, self.mean_over_s = tuple(time_constants_s), mean_over_s
        self._scales = np.array([SIGNALS[name].scale for name in observe])
        self._shares = -np.expm1(-sample_time_s / np.array(time_constants_s))
        self._slow = float(-np.expm1(-sample_time_s / mean_over_s))
        self.begin()

    def begin(self) -> None:
        """Forget all that was seen."""
        self._mean: Floats | None = None
        self._passed = np.zeros((1, *self.gains.shape[-2:]))

    def __call__(self, seen: Floats) -> Floats:
        """Return the force of each episode, N."""
        if self._mean is None:
            self._mean = seen.copy()
        self._mean = self._mean + self._slow * (seen - self._mean)
        new = ((seen - self._mean) / self._scales)[:, :, None]
        self._passed = self._passed + self._shares * (new - self._passed)
        return np.asarray(FORCE_N * (self.gains * self._passed).sum(axis=(-2, -1)))

    def data(self) -> dict[str, Any]:
        """Return the law as plain data."""
        return {
            "observe": list(self.observe),
            "gains": self.gains.tolist(),
            "sample_time_s": self.sample_time_s,
            "time_constants_s": list(self.time_constants_s),
            "mean_over_s": self.mean_over_s,
        }


class LawController:
    """Controller of `arcless.run` by a law, which sees there what it saw in its environment.

    Parameters
    ----------
    law
        The law.
    observe
        Names of the signals that it sees.
    controller
        The actuator, which limits what the law asks for.
    sensor, supports_m
        Force sensor below the strips, and positions of the supports in m, for the signals that need
        them.

    coordinates
        Number of coordinates of the pantograph that the law was made for.

    Attributes
    ----------
    law
        The law; another one that takes the same may be put in its place.
    actuator
        The actuator as fields of `controller` in a scenario.
    """

    def __init__(
        self,
        law: Law,
        observe: Sequence[str],
        controller: Controller,
        *,
        coordinates: int,
        sensor: Sensor | None = None,
        supports_m: Sequence[float] = (),
    ) -> None:
        self.law = law
        self.actuator: dict[str, Any] = controller.model_dump(exclude_none=True)
        self.actuator = {k: v for k, v in self.actuator.items() if k not in ("pid", "function")}
        self._coordinates = coordinates
        self._signals = [SIGNALS[name] for name in observe]
        self._reader = Reader(controller.sample_time, sensor)
        self._spans = Spans(supports_m or [0.0, 1.0])
        self._actuator = Actuators(controller, controller.sample_time, 1)
        self._before: ControlInput | None = None
        self._start_force = np.zeros(1)

    def __call__(self, sample: ControlInput) -> float:
        """Return the force in N for a sample.

        Raises
        ------
        ControlError
            The pantograph has other coordinates, or samples come more or less often, than in the
            environment of the law.
        """
        if sample.sample_number == 0:
            self.law.begin()
            self._actuator.begin(ROW)
            self._before, self._start_force = None, np.array([sample.contact_force_N])
        before = self._before or sample
        self._check(sample, before)
        seen = Sample(
            contact_force_N=np.array([sample.contact_force_N]),
            displacement_m=np.array([sample.displacements_m]),
            velocity_m_s=np.array([sample.velocities_m_s]),
            displacement_before_m=np.array([before.displacements_m]),
            velocity_before_m_s=np.array([before.velocities_m_s]),
            start_force_N=self._start_force,
            asked_force_N=self._actuator.asked_N.copy(),
            speed_m_s=sample.speed_m_s,
            span_position=self._spans.within(np.array([sample.position_m])),
        )
        self._before = sample
        wanted = self.law(observation(self._signals, seen, self._reader))
        self._actuator.ask(ROW, wanted)
        return float(self._actuator.asked_N[0])

    def _check(self, sample: ControlInput, before: ControlInput) -> None:
        if len(sample.displacements_m) != self._coordinates:
            raise ControlError(
                "a law of another pantograph",
                got=f"{len(sample.displacements_m)} coordinates",
                expected=f"{self._coordinates}, as where it was made",
            )
        apart, wanted = sample.time_s - before.time_s, self._reader.sample_time_s
        if sample is not before and abs(apart - wanted) > ROUNDING_S:
            raise ControlError(
                "a law that is sampled at other intervals",
                got=f"{1e3 * apart:.6g} ms",
                expected=f"{1e3 * wanted:.6g} ms, as where it was made",
                hint="give the pantograph the `controller` that `actuator` of this law holds",
            )

    @classmethod
    def of(cls, law: Law, task: Task) -> "LawController":
        """Return the controller for runs of the scenario of a task."""
        return cls(
            law,
            [signal.name for signal in task.signals],
            task.controller,
            coordinates=task.scenario.pantographs[task.pantograph].model.size,
            sensor=task.reader.sensor,
            supports_m=task.scenario.line.support_positions(),
        )


def save_law(
    file: str | Path, law: FilteredLaw, task: Task, about: Mapping[str, Any] | None = None
) -> None:
    """Write a law to a file, with the task that it was made for.

    Parameters
    ----------
    file
        The file, JSON.
    law, task
        The law, and its task.
    about
        More to keep, such as how it was learnt.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    sensor = task.reader.sensor
    data = {
        "format": FORMAT,
        "law": law.data(),
        "actuator": task.controller.model_dump(exclude={"pid", "function"}),
        "coordinates": task.scenario.pantographs[task.pantograph].model.size,
        "sensor": None if sensor is None else asdict(sensor),
        "supports_m": list(task.scenario.line.support_positions()),
        "task": task.describe(),
        "about": dict(about or {}),
    }
    write_bytes(file, (json.dumps(data, indent=1, ensure_ascii=False) + "\n").encode())


def load_law(file: str | Path) -> LawController:
    """Return the controller for `arcless.run` from a file of `save_law`.

    Raises
    ------
    ResultFormatError
        The file cannot be read, or is no law.
    """
    try:
        data = json.loads(Path(file).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ResultFormatError(
            "no law can be read", where=str(file), got=str(error), expected="a file of save_law"
        ) from error
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        found = data.get("format") if isinstance(data, dict) else type(data).__name__
        raise ResultFormatError(
            "not a law", where=str(file), got=repr(found)[:80], expected=f"format: {FORMAT}"
        )
    try:
        law = FilteredLaw(**data["law"])
        controller = Controller(**data["actuator"])
        sensor = None if data["sensor"] is None else Sensor(**data["sensor"])
        return LawController(
            law,
            law.observe,
            controller,
            coordinates=int(data["coordinates"]),
            sensor=sensor,
            supports_m=data["supports_m"],
        )
    except (KeyError, TypeError, ValueError) as error:
        raise ResultFormatError(
            "a damaged law", where=str(file), got=str(error)[:200], expected="a file of save_law"
        ) from error
