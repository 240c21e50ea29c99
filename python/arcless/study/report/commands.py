"""The command that computes a variant again, as `arcless run` would be called by hand."""

import json
import os
import shlex
from functools import cached_property
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError
from arcless.model import Scenario, load, parse_override
from arcless.model.files.yaml_reader import Origin
from arcless.model.scenario.references import read
from arcless.study.definition.quantities import is_number
from arcless.study.definition.study import Study
from arcless.study.evaluation.variants import scenario, variant
from arcless.study.variables.variables import Axis
from arcless.units import KINDS, to_si, written_in
from arcless.units.kinds import canonical

# Significant digits that are tried for a number: as people write it, then to its last bit.
_DIGITS = (6, 9, 12, 15, 16, 17)


class Commands:
    """The commands of a study's variants.

    `arcless run` with what is changed, where that gives the very scenario of a variant, which is
    tried once. Otherwise, as where a scenario stands in the study file itself, the variant's
    scenario is written to a file first.
    """

    def __init__(self, study: Study) -> None:
        self._study = study
        self._folder = Path(study.file or ".").parent

    def again(self, number: int) -> str:
        """Return the command for a variant, from 1; empty for a study without a file."""
        if self._study.file is None:
            return ""
        direct = self._direct(number)
        if direct is not None and self._is_exact:
            return shlex.join(direct)
        file = f"variant-{number}.yaml"
        first = ["arcless", "study", "variant", self._study.file, str(number), "--to", file]
        return f"{shlex.join(first)} && arcless run {file}"

    @cached_property
    def _scenario(self) -> str | None:
        """The scenario as `arcless run` takes it; None where it stands in the study itself."""
        if Path(str(self._study.file)).is_dir():  # a study that was named by its folder
            return None
        data, _ = read(Path(str(self._study.file)), Origin())
        name = data.get("scenario")
        return self._place(name) if isinstance(name, str) else None

    @cached_property
    def _is_exact(self) -> bool:
        """True when the command of the first valid variant gives that variant."""
        for number in range(1, self._study.plan.count + 1):
            try:
                wanted = scenario(self._study, number)
            except ArclessError:
                continue
            words = self._direct(number)
            if words is None:
                return False
            try:
                changes = dict(parse_override(text) for text in words[4::2])
                return bool(_numbers(load(words[2]).with_(**changes)) == _numbers(wanted))
            except ArclessError:
                return False
        return False

    def _direct(self, number: int) -> list[str] | None:
        made = variant(self._study, number)
        named = {axis.field: made.values[axis.name] for axis in self._study.axes}
        fields = any(one.random_field is not None for one in self._study.variables.values())
        if self._scenario is None or fields or set(made.changes) != set(named):
            return None
        amounts = {axis.field: amount_of(self._study, axis, made.values[axis.name])
                   for axis in self._study.axes}  # fmt: skip
        settings = []
        for path, value in {**self._study.changes, **named}.items():
            amount = amounts.get(path)
            text = f"{path}={amount or self._text(value)}"
            plain = amount is None and not isinstance(value, str)
            if plain and _read(text) != json.loads(json.dumps(value)):
                return None
            settings += ["--set", text]
        return ["arcless", "run", self._scenario, *settings]

    def _text(self, value: Any) -> str:
        return self._place(value) if isinstance(value, str) else json.dumps(value)

    def _place(self, name: str) -> str:
        """Return a name that a study file uses as the current folder sees it."""
        file = self._folder / name
        return os.path.relpath(file) if name and file.is_file() else name


def amount_of(study: Study, axis: Axis, value: Any) -> str | None:
    """Return a number with a unit that is read as the same bits; None for what has no unit.

    As typed in the study file, otherwise with the fewest digits in the unit used there, or
    else in SI.
    """
    unit = canonical(axis.unit)
    if not is_number(value) or unit not in KINDS or unit == "1":
        return None
    variable = study.variables[axis.name]
    given = [*(variable.values or ()), *(variable.range or ())]
    typed = [one.strip() for one in given if written_in(one, unit) is not None]
    typed += [f"{value / axis.scale:.{n}g} {axis.typed_unit}" for n in _DIGITS]
    typed += [f"{value!r} {axis.unit}"]
    return next((text for text in typed if to_si(text, unit) == value), None)


def _read(text: str) -> Any:
    try:
        return json.loads(json.dumps(parse_override(text)[1]))
    except ArclessError:
        return None


def _numbers(made: Scenario) -> Any:
    """Return the data that decide a run: no words, no sources."""
    return _without(json.loads(json.dumps(made.to_dict())))


def _without(data: Any) -> Any:
    if isinstance(data, list):
        return [_without(item) for item in data]
    if not isinstance(data, dict):
        return data
    words = ("provenance", "sources", "description")
    return {key: _without(value) for key, value in data.items() if key not in words}
