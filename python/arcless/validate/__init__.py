"""Reference cases: runs held against published ranges, and against published conclusions."""

import importlib
from typing import TYPE_CHECKING, Any

from arcless.validate.cases import SUITES, case_of, compare, reference_rows, run
from arcless.validate.reference import CASES, CLOSE, INSIDE, VERIFIED, Case, Range
from arcless.validate.rows import Row

if TYPE_CHECKING:
    from arcless.validate.evidence import Topic, recorded
    from arcless.validate.founding_paper import SOURCE as SEED_SOURCE

__all__ = [
    "CASES",
    "CLOSE",
    "INSIDE",
    "SEED_SOURCE",
    "SUITES",
    "VERIFIED",
    "Case",
    "Range",
    "Row",
    "Topic",
    "case_of",
    "compare",
    "recorded",
    "reference_rows",
    "run",
]

# Names that published ranges do without: name → module, and its name there.
_LATER = {
    "SEED_SOURCE": ("founding_paper", "SOURCE"),
    "Topic": ("evidence", "Topic"),
    "recorded": ("evidence", "recorded"),
}


def __getattr__(name: str) -> Any:
    """Import a name at its first use: a run is held against its published ranges alone."""
    if name not in _LATER:
        raise AttributeError(f"module `{__name__}` has no attribute `{name}`")
    module, there = _LATER[name]
    globals()[name] = value = getattr(importlib.import_module(f"{__name__}.{module}"), there)
    return value
