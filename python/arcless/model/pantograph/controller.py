"""A force on a pantograph that is decided on during the run."""

from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.document import printed
from arcless.model.fields.part import Part, Path, Unit
from arcless.model.fields.rule_errors import both_given
from arcless.model.files.yaml_reader import Origin, is_file
from arcless.units import show

SUFFIX = ".py"


class Pid(Part):
    """A controller of the contact force: proportional, integral, derivative."""

    target: Annotated[float, Unit("N", minimum=0, maximum=2000)] = Field(
        description="Contact force wanted."
    )
    proportional: Annotated[float, Unit("1", minimum=0, maximum=1000)] = Field(
        default=0.0, description="Force over what is missing of the contact force."
    )
    integral: Annotated[float, Unit("1/s", minimum=0, maximum=1e5)] = Field(
        default=0.0, description="Rate of the force over what is missing."
    )
    derivative: Annotated[float, Unit("s", minimum=0, maximum=10)] = Field(
        default=0.0, description="Force over the rate of what is missing."
    )
    filter: Annotated[float, Unit("s", minimum=0, maximum=10)] = Field(
        default=0.0, description="Time constant of a low-pass on the measured force; 0: none."
    )


class Controller(Part):
    """A controlled force on a pantograph: sampled, delayed, held between samples."""

    sample_time: Annotated[float, Unit("s", above=0, maximum=10)] = Field(
        description="Time from sample to sample, a multiple of the time step."
    )
    delay: Annotated[float, Unit("s", minimum=0, maximum=10)] = Field(
        default=0.0, description="Time until a force acts, a multiple of the time step."
    )
    mass: Annotated[int, Field(ge=1, strict=True)] | None = Field(
        default=None,
        description="Number of the mass it acts on, from the base; where the preload acts without.",
    )
    minimum_force: Annotated[float, Unit("N", minimum=-10_000, maximum=10_000)] | None = Field(
        default=None, description="Lowest force, upwards positive; no limit without."
    )
    maximum_force: Annotated[float, Unit("N", minimum=-10_000, maximum=10_000)] | None = Field(
        default=None, description="Highest force; no limit without."
    )
    rate_limit: Annotated[float, Unit("N/s", above=0, maximum=extremes.RATE)] | None = Field(
        default=None, description="Most that the force changes in a second; no limit without."
    )
    pid: Pid | None = Field(default=None, description="Controller of the contact force.")
    function: str | None = Field(
        default=None,
        description="Function in a Python file, file.py:name, relative to this file; excludes pid.",
    )

    @model_validator(mode="after")
    def _check(self) -> "Controller":
        if self.pid is not None and self.function is not None:
            raise both_given("pid", "function")
        low, high = self.minimum_force, self.maximum_force
        if low is not None and high is not None and low > high:
            raise ModelError(
                "limits out of order",
                got=f"{low:g} N and {high:g} N",
                expected="minimum_force up to maximum_force",
                field=("maximum_force",),
            )
        if self.function is not None:
            _split(self.function)
        return self

    @property
    def place(self) -> tuple[str, str]:
        """File and name of the function."""
        return _split(self.function or "")


def _split(function: str) -> tuple[str, str]:
    file, _, name = function.rpartition(":")
    if not file.endswith(SUFFIX) or not name.isidentifier():
        raise ModelError(
            "not a function in a file",
            got=show(function),
            expected=f"file{SUFFIX}:name",
            field=("function",),
        )
    return file, name


def with_function(data: Mapping[str, Any], origin: Origin, path: Path) -> dict[str, Any]:
    """Return the data of a controller with the place of its function as seen from here.

    A scenario in a file is told when the Python file is missing; it is not run here.
    """
    given = data.get("function")
    text = given.get("value") if isinstance(given, Mapping) else given
    if not isinstance(text, str):
        return dict(data)
    try:
        name, function = _split(text)
    except ModelError:
        return dict(data)
    file = origin.file(name)
    if origin.label is not None and not is_file(file):
        raise ModelError(
            f"{printed((*path, 'function'))}: file not found",
            where=origin.where((*path, "function")),
            got=show(name),
            expected=f"a file {file}",
            field=(*path, "function"),
        )
    found = f"{file.as_posix()}:{function}"
    return {**data, "function": {**given, "value": found} if isinstance(given, Mapping) else found}
