"""Names of supports that hold wires: ``support 4``, and the tension length where that fits two."""

from typing import NamedTuple

from arcless.model.line.line import Line


class SupportName(NamedTuple):
    """A support by its number, from 1.

    The tension length is None where there is but one or it is not said.
    """

    support: int
    tension_length: int | None = None

    def __str__(self) -> str:
        """Return the name as it stands in results."""
        front = "" if self.tension_length is None else f"tension length {self.tension_length} "
        return f"{front}support {self.support}"


def supports_called(line: Line, name: SupportName) -> list[SupportName]:
    """Return the inner supports of a line that a name fits, each with its full name.

    At both ends of a tension length its wires are anchored.
    """
    lengths = line.tension_length_list()
    return [
        SupportName(name.support, number if len(lengths) > 1 else None)
        for number, one in enumerate(lengths, start=1)
        if one.from_span < name.support <= one.to_span and name.tension_length in {None, number}
    ]
