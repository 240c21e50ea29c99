"""Number of times that a run is repeated, to say how sure its numbers are."""

from collections.abc import Mapping
from typing import Any

from pydantic import Field

from arcless.model.fields.part import Part

STARTS = 8
# Of one there is no spread.
FEWEST_STARTS = 2
# Half a metre apart in a span of 50 m, about an element: more would tell nothing new.
MOST_STARTS = 100


class Certainty(Part):
    """Additional runs that tell how sure the assessed numbers are."""

    starts: int = Field(
        default=STARTS,
        ge=FEWEST_STARTS,
        le=MOST_STARTS,
        strict=True,
        description="Starts within a span, that of the run among them.",
    )
    other_family: bool = Field(
        default=True,
        strict=True,
        description="Run once by the other family of elements, refined, too.",
    )


def spelt_out(data: dict[str, Any]) -> dict[str, Any]:
    """Return the data of a scenario with `certainty: 8` as a mapping."""
    given = data.get("certainty")
    if given is None or isinstance(given, Mapping | Certainty):
        return data
    return {**data, "certainty": {"starts": given}}
