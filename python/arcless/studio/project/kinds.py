"""Kind of a model file, read off its format without validating it."""

import re

KINDS = ("line", "pantograph", "scenario", "study")
_FORMAT = re.compile(r"""^["']?format["']?\s*:\s*["']?arcless-(\w+)/""", re.MULTILINE)


def kind_of(text: str) -> str | None:
    """Return the kind that a text says to be; None where it is no model."""
    found = _FORMAT.search(text)
    return found[1] if found and found[1] in KINDS else None
