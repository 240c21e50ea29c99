"""An FMU driven by FMPy, with variables by their names and messages kept."""

import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Self

import fmpy
from fmpy.fmi1 import FMICallException


class Failed(Exception):  # noqa: N818 - what happened to an FMU
    """A function of an FMU failed: its status is kept by FMPy, its message is here."""


class Driven:
    """An instance of an FMU that stands before its first step."""

    def __init__(self, folder: str, start_time: float = 0.0) -> None:
        self.description = fmpy.read_model_description(folder)
        self.is_fmi3 = self.description.fmiVersion.startswith("3")
        self.messages: list[str] = []
        self.numbers = {v.name: v.valueReference for v in self.description.modelVariables}
        try:
            self.fmu: Any = fmpy.instantiate_fmu(folder, self.description, logger=self._hear)
        except Exception as error:
            raise Failed(self.last or str(error)) from error
        self._begin(start_time)
        self.h = float(self.description.defaultExperiment.stepSize)
        self.start_time, self.steps = start_time, 0

    def _begin(self, start_time: float) -> None:
        if self.is_fmi3:
            self.fmu.enterInitializationMode(startTime=start_time)
        else:
            self.fmu.setupExperiment(startTime=start_time)
            self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def _hear(self, *arguments: Any) -> None:
        self.messages.append(arguments[-1].decode())

    @property
    def last(self) -> str:
        """Last message, empty without one."""
        return self.messages[-1] if self.messages else ""

    @property
    def time(self) -> float:
        """Time as the importer counts it, s."""
        return self.start_time + self.steps * self.h

    def set(self, **values: float) -> None:
        """Set inputs; two underscores in a name stand for a point."""
        self.put({name.replace("__", "."): value for name, value in values.items()})

    def put(self, values: Mapping[str, float]) -> None:
        """Set inputs by their names."""
        call = self.fmu.setFloat64 if self.is_fmi3 else self.fmu.setReal
        self._try(call, [self.numbers[name] for name in values], list(values.values()))

    def get(self, *names: str) -> list[float]:
        """Return values by their names."""
        call = self.fmu.getFloat64 if self.is_fmi3 else self.fmu.getReal
        found: list[float] = list(self._try(call, [self.numbers[name] for name in names]))
        return found

    def value(self, name: str) -> float:
        """Return a value by its name."""
        return self.get(name)[0]

    def step(self, length: float | None = None, at: float | None = None) -> None:
        """Take a communication step: of the length of a step, from where the FMU stands."""
        length = self.h if length is None else length
        self._try(self.fmu.doStep, self.time if at is None else at, length)
        self.steps += round(length / self.h)

    def attempt(self, function: str, *arguments: Any) -> Any:
        """Call a function of FMPy by its name."""
        return self._try(getattr(self.fmu, function), *arguments)

    def _try(self, call: Any, *arguments: Any) -> Any:
        try:
            return call(*arguments)
        except FMICallException as error:
            raise Failed(f"{self.last} (status {error.status})") from error

    def inputs(self) -> Iterable[str]:
        """Return the names of the inputs."""
        return [v.name for v in self.description.modelVariables if v.causality == "input"]

    def outputs(self) -> list[str]:
        """Return the names of the outputs."""
        return [v.name for v in self.description.modelVariables if v.causality == "output"]

    def close(self) -> None:
        """Free the instance."""
        self.fmu.freeInstance()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@contextmanager
def driven(path: Path, *, start_time: float = 0.0) -> Iterator[Driven]:
    """Give an instance of an FMU in a file."""
    with tempfile.TemporaryDirectory() as folder:
        fmpy.extract(str(path), folder)
        with Driven(folder, start_time) as fmu:
            yield fmu
