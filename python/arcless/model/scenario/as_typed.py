"""Values of a scenario, its line and its pantographs as they were typed: ``22 kN``."""

from collections.abc import Mapping

from arcless.model.fields.as_typed import Given, within
from arcless.model.fields.document import Document
from arcless.model.scenario.scenario_data import ScenarioData


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
