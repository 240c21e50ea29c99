"""Rules for changes of the height of the contact wire."""

from arcless.errors import ModelError
from arcless.model.line.line_data import LineData


def check_heights(line: LineData) -> None:
    """Raise `ModelError` for the first change of height that does not fit the line."""
    count, end = len(line.support_positions()), 1
    for index, change in enumerate(line.geometry.height_changes):
        field = ("geometry", "height_changes", index)
        if change.to_support <= change.from_support:
            raise ModelError(
                "empty stretch",
                got=f"support {change.from_support} to support {change.to_support}",
                expected="an end behind its start",
                field=(*field, "to_support"),
            )
        if change.from_support < end:
            raise ModelError(
                "stretches overlap or are out of order",
                got=f"a start at support {change.from_support} before the end of the last one,"
                f" support {end}",
                expected="stretches along the track, one behind the other",
                field=(*field, "from_support"),
            )
        if change.to_support > count:
            raise ModelError(
                "change of height outside the line",
                got=f"support {change.to_support}",
                expected=f"a support from 1 to {count}",
                field=(*field, "to_support"),
            )
        end = change.to_support
