"""A study file, validated: variables, their sampling, and outputs."""

import re
from collections.abc import Mapping
from functools import cached_property
from typing import Annotated, Any, Literal

from pydantic import Field, PrivateAttr, ValidationInfo, model_validator

from arcless.errors import ModelError
from arcless.model import Line, Scenario
from arcless.model.fields.document import Document, dotted
from arcless.model.fields.part import Part
from arcless.model.scenario.overrides import field_of
from arcless.study.definition.expressions import Expression
from arcless.study.definition.quantities import is_number, keys
from arcless.study.designs import Design, Plan
from arcless.study.optimisation.optimise import Optimise
from arcless.study.variables.random_fields import errors
from arcless.study.variables.variables import Axis, Variable, axis
from arcless.units import show

FORMAT: Literal["arcless-study/1"] = "arcless-study/1"
# Columns of the table that are always there.
COLUMNS = ("variant", "status", "error", "wall_time_s", "arcless_version")
# Columns that are there where runs are watched while they step.
WATCHED = ("pruned_at_m", "pruned_after_s", "steps_taken", "so_far")
_NAME = re.compile(r"[^\W\d][\w.]*")


class StudyOutput(Part):
    """An output: a column of the table."""

    expression: str = Field(description="A key of the assessment, or an expression of keys.")
    unit: str = Field(default="", description="Unit of the value, for tables and plots.")
    description: str = Field(default="", description="What it stands for, in a sentence.")


class Execution(Part):
    """Execution settings: the executor and its workers."""

    kind: Literal["threads", "dask"] = Field(
        default="threads", description="In this process, or by Dask."
    )
    workers: int | None = Field(
        default=None, description="Threads or worker processes; all cores without.", ge=1, le=1024
    )
    scheduler: str | None = Field(
        default=None,
        description="Address of a Dask scheduler that runs already, such as tcp://host:8786.",
        pattern=r"^(tcp|tls|ws|wss|ucx|inproc)://.+",
    )

    @model_validator(mode="after")
    def _check_scheduler(self) -> "Execution":
        if self.scheduler is not None and self.kind != "dask":
            expected = "kind: dask next to it"
            raise ModelError("scheduler without Dask", expected=expected, field=("scheduler",))
        if self.scheduler is not None and self.workers is not None:
            raise ModelError(
                "both scheduler and workers given",
                expected="one of them: a scheduler has workers of its own",
                field=("workers",),
            )
        return self


class Study(Document):
    """A study: a scenario, variables, a design and outputs."""

    format: Literal["arcless-study/1"] = Field(default=FORMAT, description="Format and version.")
    scenario: Scenario = Field(
        description="Scenario: shipped name, file relative to this one, or written here.",
        json_schema_extra={"reference": "scenario"},
    )
    changes: dict[str, Any] = Field(
        default_factory=dict,
        alias="set",
        description="Other values of fields, the same in all variants, by dotted path.",
    )
    variables: dict[str, Variable] = Field(description="Variables by name.", min_length=1)
    design: Annotated[Design | Optimise, Field(discriminator="kind")] = Field(
        description="Which combinations are computed."
    )
    outputs: dict[str, StudyOutput] = Field(
        description="Keys of the assessment, or expressions of them by name.", min_length=1
    )
    keep: Literal["none", "results"] = Field(
        default="none", description="Whether the whole result of every variant is kept, too."
    )
    executor: Execution = Field(default_factory=Execution, description="What computes.")
    seed: int = Field(default=0, description="Seed of a sample.", ge=0, le=2**63 - 1)

    _models: dict[str, Any] = PrivateAttr(default_factory=dict)
    _file: str | None = PrivateAttr(default=None)

    @classmethod
    def prepare(cls, data: dict[str, Any]) -> dict[str, Any]:
        """Write outputs out that are given as a list, or as bare expressions."""
        outputs = data.get("outputs")
        if isinstance(outputs, list | tuple) and all(isinstance(key, str) for key in outputs):
            outputs = {key: key for key in outputs}
        if isinstance(outputs, Mapping):
            outputs = {
                name: {"expression": given} if isinstance(given, str) else given
                for name, given in outputs.items()
            }
        return data if outputs is None else {**data, "outputs": outputs}

    @model_validator(mode="after")
    def _check(self, info: ValidationInfo) -> "Study":
        context = info.context or {}
        self._file, self._models = context.get("file"), context.get("models", {})
        _ = self.base
        self._check_columns()
        _ = self.axes, self.plan, self.expressions
        if isinstance(self.design, Optimise):
            expressions = {name: output.expression for name, output in self.outputs.items()}
            self.design.check(expressions, self.base, [varied.field for varied in self.axes])
        return self

    @cached_property
    def base(self) -> Scenario:
        """The scenario with the changes that all variants share."""
        changes = {path: self._model(value) for path, value in self.changes.items()}
        try:
            return self.scenario.with_(**changes) if changes else self.scenario
        except ModelError as error:
            at = dotted(error.field)
            paths = [path for path in changes if at.startswith(path) or f"{path}:" in error.what]
            raise _moved(error, ("set", *paths[:1])) from None

    @cached_property
    def axes(self) -> list[Axis]:
        """The variables made ready."""
        found = []
        for name, variable in self.variables.items():
            try:
                whole, unit = field_of(self.base, variable.field)
            except ModelError as error:
                raise _moved(error, ("variables", name, "field")) from None
            try:
                found.append(axis(name, variable, whole, unit))
            except ModelError as error:
                error.field = ("variables", name, *error.field)
                raise
        return found

    @cached_property
    def plan(self) -> Plan:
        """The combinations, counted."""
        return self.design.plan(self.axes, self.seed)

    @property
    def watched(self) -> bool:
        """True when a monitor observes its runs while they step."""
        return isinstance(self.design, Optimise) and self.design.watched

    @property
    def columns(self) -> tuple[str, ...]:
        """The columns of the table that are neither variables nor outputs."""
        return (*COLUMNS, *WATCHED) if self.watched else COLUMNS

    @cached_property
    def expressions(self) -> dict[str, Expression]:
        """The outputs, parsed."""
        known = self.known_keys()
        found = {}
        for name, output in self.outputs.items():
            try:
                found[name] = Expression(output.expression, known)
            except ModelError as error:
                error.field = ("outputs", name)
                raise
        return found

    def known_keys(self) -> list[str]:
        """Return the names an output may use: keys of the assessment, and numeric variables."""
        numeric = [
            axis.name
            for axis in self.axes
            if axis.levels is None or all(is_number(value) for value in axis.levels)
        ]
        return [*keys(self.base), *numeric]

    def changes_of(self, values: tuple[Any, ...]) -> dict[str, Any]:
        """Return the changes of the scenario by a combination, by dotted path, groups first."""
        chosen = list(zip(self.axes, values, strict=True))
        changes = {one.field: self._model(value) for one, value in chosen if not one.is_drawn}
        changes |= {path: self._model(self.changes[path]) for path in self._set_inside}
        drawn = [(one, value) for one, value in chosen if one.is_drawn]
        line = self._line_with(changes) if drawn else self.base.line
        for one, value in drawn:
            field = self.variables[one.name].random_field
            assert field is not None
            changes[one.field] = errors(one.field, field, line, value)
        return dict(sorted(changes.items(), key=lambda change: change[0].count(".")))

    @cached_property
    def _set_inside(self) -> list[str]:
        """Fields set inside of a varied group: each variant has to set them again."""
        groups = tuple(f"{varied.field}." for varied in self.axes)
        return [path for path in self.changes if self._whole(path).startswith(groups)]

    def _whole(self, path: str) -> str:
        return field_of(self.base, path)[0]

    @property
    def file(self) -> str | None:
        """The file that the study was read from, if it was one."""
        return self._file

    def model_contents(self) -> dict[str, Any]:
        """Return the lines and pantographs that values name, as plain data."""
        return self._models

    def _line_with(self, changes: Mapping[str, Any]) -> Line:
        """Return the line whose droppers and supports have the errors of a variant."""
        if not any(path.partition(".")[0] == "line" for path in changes):
            return self.base.line
        try:
            return self.base.with_(**changes).line
        except ModelError:
            return self.base.line  # the variant is invalid, and its row will say so

    def _model(self, value: Any) -> Any:
        return self._models.get(value, value) if isinstance(value, str) else value

    def _check_columns(self) -> None:
        taken: dict[str, str] = dict.fromkeys(self.columns, "a column that every table has")
        taken |= dict.fromkeys(keys(self.base), "a key of the assessment")
        fields = {self._whole(path): "set has it, too" for path in self.changes}
        for varied in self.axes:
            place = ("variables", varied.name)
            _check_name(varied.name, taken, place, dots=False)
            if varied.field in fields:
                raise ModelError(
                    "two values for one field",
                    got=show(self.variables[varied.name].field),
                    expected=f"each field once; {fields[varied.field]}",
                    field=(*place, "field"),
                )
            fields[varied.field] = f"variable {varied.name} has it already"
        taken = dict.fromkeys(self.columns, "a column that every table has")
        taken |= dict.fromkeys(self.variables, "a variable")
        for name in self.outputs:
            _check_name(name, taken, ("outputs", name), dots=True)


def _check_name(name: str, taken: dict[str, str], place: tuple[str, ...], *, dots: bool) -> None:
    if not _NAME.fullmatch(name) or ("." in name and not dots):
        expected = "letters, digits and _, a letter first"
        raise ModelError("name of a column", got=show(name), expected=expected, field=place)
    if name in taken:
        expected = f"another name; this is {taken[name]}"
        raise ModelError("name of a column", got=show(name), expected=expected, field=place)


def _moved(error: ModelError, field: tuple[str, ...]) -> ModelError:
    """Return an error of the changed scenario as one of the field that changes it."""
    return ModelError(
        error.what, got=error.got, expected=error.expected, hint=error.hint, field=field
    )
