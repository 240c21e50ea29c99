"""Values of a line or a pantograph that are from memory, in sentences for the head of a report."""

from arcless.model.line.line import Line
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.scenario.scenario import Scenario

FROM_MEMORY = ("C", "C*")
# Fields without effect on contact forces of a line as designed at its own temperature: tensioning
# devices, and the width of a head, whose mark is that of its criterion.
_WITHOUT_EFFECT = ("ends", "end_ratio", "end_efficiency", "head_width", "lateral_range")
# So many fields are named.
_MOST_NAMED = 4


def unverified_data(scenario: Scenario) -> list[str]:
    """Return a sentence for each pantograph, and for the line, with values that are from memory."""
    found: dict[str, Line | Pantograph] = {
        f"pantograph {one.model.name}": one.model for one in scenario.pantographs
    }
    found[f"line {scenario.line.name}"] = scenario.line
    return [text for title, document in found.items() if (text := _sentence(title, document))]


def _sentence(title: str, document: Line | Pantograph) -> str:
    fields = [
        path
        for path, origin in document.provenance.items()
        if origin.mark in FROM_MEMORY and path.rpartition(".")[2] not in _WITHOUT_EFFECT
    ]
    if not fields:
        return ""
    count = "1 value is" if len(fields) == 1 else f"{len(fields)} values are"
    named = ", ".join(fields[:_MOST_NAMED])
    more = len(fields) - _MOST_NAMED
    also = f" and {more} more" if more > 0 else ""
    marks = " and ".join(dict.fromkeys(str(document.provenance[one].mark) for one in fields))
    return f"{title}: {count} from memory, unverified (mark {marks}): {named}{also}"
