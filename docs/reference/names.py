"""What pages must name: every field, unit, mark, column and wire, every command."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from fragments import DOCS

import arcless
from arcless.cli.app import app
from arcless.model import Line, Pantograph, Scenario
from arcless.model.fields.document import Provenance
from arcless.model.shipped.wire_catalogue import catalogue
from arcless.study import Study
from arcless.study.definition.quantities import WORST, keys
from arcless.study.definition.study import COLUMNS, WATCHED
from arcless.study.optimisation.constraints import FALLING, RISING
from arcless.units import KINDS, spell

README = Path(__file__).parents[2] / "README.md"
COMMANDS = DOCS / "reference/commands.md"


def complaints() -> Iterator[str]:
    """Say which page lacks which name."""
    for page, names in (
        (DOCS / "reference/model-files.md", _of_models()),
        (DOCS / "reference/study-files.md", _of_studies()),
        (COMMANDS, (f"arcless {command}" for command in commands())),
    ):
        text = page.read_text(encoding="utf-8")
        for name in dict.fromkeys(names):
            # A command may have arguments.
            if f"`{name}`" not in text and f"`{name} " not in text:
                yield f"{page.name} does not name `{name}`"
    for page in (README, COMMANDS):
        text = page.read_text(encoding="utf-8")
        named = set(re.findall(r"(?:`|bin/)arcless ([a-z]+(?:-[a-z]+)*)", text))
        for command in sorted(named - commands()):
            yield f"{page.name}: there is no command `arcless {command}`"


def commands() -> set[str]:
    functions = [command.callback for command in app.registered_commands if command.callback]
    # As Typer calls the command of a function.
    found = {function.__name__.replace("_", "-") for function in functions}
    return found | {group.name for group in app.registered_groups if group.name}


def _of_models() -> Iterator[str]:
    for kind in KINDS.values():
        yield from (spell(unit) for unit in filter(None, kind.units))
    for model in models(Line, Pantograph, Scenario):
        if model is not Provenance:
            yield from model.field_names()
    yield from catalogue().wires


def _of_studies() -> Iterator[str]:
    own = [
        f.annotation for n, f in Study.model_fields.items() if n not in ("scenario", "provenance")
    ]
    for model in (Study, *models(*own)):
        for name, field in model.model_fields.items():
            yield field.alias or name
            if name in ("kind", "format", "keep"):
                yield from getattr(field.annotation, "__args__", ())
    yield from (*COLUMNS, *WATCHED, *RISING, *FALLING)
    base = arcless.load("en50318-ac-simple-320-planar")
    # Keys of one pantograph, of the worst, and numbers of a criterion: the page explains the words.
    of_each = ("P1.", f"{WORST}.")
    named = (k for k in keys(base) if not k.startswith(of_each) and k.count(".") < 2)
    yield from (k.removeprefix("criteria.") for k in named)


def models(*annotations: Any) -> list[Any]:
    """Return all models that fields of these are made of, these included."""
    found: list[Any] = []
    todo = list(annotations)
    while todo:
        item = todo.pop()
        if not hasattr(item, "model_fields"):
            todo += list(getattr(item, "__args__", ()))
        elif item not in found:
            found.append(item)
            todo += [field.annotation for field in item.model_fields.values()]
    return found
