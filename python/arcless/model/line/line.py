"""An overhead line whose parts fit together."""

from typing import Any

from pydantic import ConfigDict, model_validator

from arcless.model.line.height_rules import check_heights
from arcless.model.line.line_data import LineData
from arcless.model.line.mass_and_insert_rules import check_on_wires
from arcless.model.line.midpoint_rules import check_midpoint
from arcless.model.line.span_rules import check_span_types, check_spans
from arcless.model.line.stitch_and_auxiliary_rules import check_wires
from arcless.model.line.suspension_rules import check_suspension
from arcless.model.line.tension_length_rules import check_tension_lengths
from arcless.model.line.track_rules import check_track
from arcless.model.shipped.wire_catalogue import with_catalogue

# Rules that a line is held against, in this order: later ones rely on earlier ones.
RULES = (
    check_span_types,
    check_suspension,
    check_spans,
    check_tension_lengths,
    check_wires,
    check_heights,
    check_track,
    check_on_wires,
    check_midpoint,
)


class Line(LineData):
    """An overhead line: spans, and the wires over them in one or several tension lengths."""

    model_config = ConfigDict(defer_build=False)

    @classmethod
    def prepare(cls, data: dict[str, Any]) -> dict[str, Any]:
        """Return the data with the wires that are named instead of written out."""
        return with_catalogue(cls, data)

    @model_validator(mode="after")
    def _check(self) -> "Line":
        for check in RULES:
            check(self)
        return self
