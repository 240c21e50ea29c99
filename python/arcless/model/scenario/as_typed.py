"""Values of a scenario, its line and its pantographs as they were typed: ``22 kN``."""

import hashlib
import json
from collections.abc import Mapping
from typing import Any

from arcless.model.fields.as_typed import Given, within
from arcless.model.fields.document import Document
from arcless.model.scenario.scenario_data import ScenarioData

# Provenance of a value that `Scenario.with_` or the command line gave.
SET_FOR_RUN = "set for this run"
# Fields that describe a document, and one that asks for more numbers of the same run.
_NO_CHANGE = {"name", "description", "sources", "certainty"}
# Hexadecimal digits of a digest: by chance two of 1000 sets of changes meet once in 10 000 times.
_DIGITS = 8
_WORDS = {"None": "null", "True": "true", "False": "false"}


def documents_of(scenario: ScenarioData) -> dict[str, Document]:
    """Return a scenario, its line and its pantographs by their dotted paths in it."""
    found: dict[str, Document] = {"": scenario, "line": scenario.line}
    for index, placement in enumerate(scenario.pantographs):
        found[f"pantographs.{index}.model"] = placement.model
    return found


def typed_in(scenario: ScenarioData) -> dict[str, Given]:
    """Return what was typed for a scenario, its line and its pantographs, as plain data."""
    documents = documents_of(scenario).items()
    return {path: dict(one.given) for path, one in documents if one.given is not None}


def restore(scenario: ScenarioData, typed: object) -> None:
    """Take what `typed_in` gave for a scenario that was read again; None: nothing is known."""
    known = typed if isinstance(typed, Mapping) else {}
    for path, document in documents_of(scenario).items():
        one = known.get(path)
        document.remember(dict(one) if isinstance(one, Mapping) else None)


def carry(
    before: ScenarioData, now: ScenarioData, changed: set[str], named: Mapping[str, Document]
) -> None:
    """Keep what was typed for a scenario for its changed copy.

    Parameters
    ----------
    before, now
        The scenario, and its copy from data where everything stands as a number.
    changed
        Dotted paths of what was changed or taken back.
    named
        Models that took the place of others, by their paths.
    """
    old = documents_of(before)
    for path, document in documents_of(now).items():
        if document is old.get(path) or (path and within(path, changed) and path not in named):
            continue
        base = named.get(path, old.get(path))
        start = f"{path}." if path else ""
        inside = {one.removeprefix(start) for one in changed if one.startswith(start)}
        if base is None or base.given is None:
            document.remember(None)
            continue
        fresh = document.given or {}
        stays = {one: text for one, text in base.given.items() if not within(one, inside)}
        new = {one: text for one, text in fresh.items() if within(one, inside)}
        document.remember(stays | new)


def changes_of(scenario: Mapping[str, Any]) -> dict[str, str]:
    """Return the fields of a scenario that were set for a run, by their dotted paths, as typed.

    Relative to the file, or the shipped scenario, that it was read from: what `Scenario.with_` and
    ``arcless run --set`` gave, also where that is the value of the file. A value of which no text
    was kept is in SI. Names, descriptions and `certainty` are left out.

    Parameters
    ----------
    scenario
        As plain data, of `Scenario.to_dict` or the attribute `scenario` of a result.
    """
    found = {}
    for start, data in _documents_in(scenario).items():
        paths = (path for path, of in data["provenance"].items() if of.get("note") == SET_FOR_RUN)
        for path in sorted(paths):
            if path.partition(".")[0] in _NO_CHANGE:
                continue
            given, value = data["provenance"][path].get("given"), _value_at(data, path)
            text = str(value if given is None else given)
            if value is None and text != str(None):
                continue  # a later change took it back: a speed, where a profile was given
            found[f"{start}{path}"] = _WORDS.get(text, text)
    return found


def digest_of_changes(scenario: Mapping[str, Any]) -> str:
    """Return a short hash of the name, and of the values that `changes_of` names, whole, in SI."""
    values = {path: _value_at(scenario, path) for path in changes_of(scenario)}
    text = json.dumps([scenario["name"], values], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:_DIGITS]


def _documents_in(scenario: Mapping[str, Any]) -> dict[str, Mapping[str, Any]]:
    """Return a scenario, its line and its pantographs by the starts of their paths."""
    found = {"": scenario, "line.": scenario["line"]}
    for index, placement in enumerate(scenario["pantographs"]):
        found[f"pantographs.{index}.model."] = placement["model"]
    return found


def _value_at(data: Any, path: str) -> Any:
    for part in path.split("."):
        if data is None:
            break
        data = data[int(part)] if isinstance(data, list) else data.get(part)
    return data
