"""An overhead line whose parts fit together."""

from typing import Any

from pydantic import ConfigDict, model_validator

from arcless.display import cards
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

    def in_words(self) -> list[str]:
        """Return number of spans and length, in words."""
        count = len(self.span_list())
        return [f"{count} {'span' if count == 1 else 'spans'}, {self.total_length:g} m"]

    def card_parts(self) -> list[str]:
        """Return what the line is, and its wires, as parts of a card."""
        lengths = [span.length for span in self.span_list()]
        low, high = f"{min(lengths):g}", f"{max(lengths):g}"
        height, system = self.geometry.contact_wire_height, self.geometry.encumbrance
        lengths_of_wire = len(self.tension_length_list())
        speed = self.wave_speed
        rows = [
            ("Length", self.in_words()[0]),
            ("Span length", f"{' – '.join(dict.fromkeys([low, high]))} m"),
            ("Tension lengths", f"{lengths_of_wire}" if lengths_of_wire > 1 else ""),
            ("Height of the contact wire above rail", "" if height is None else f"{height:g} m"),
            ("Encumbrance", "" if system is None else f"{system:g} m"),
            ("Wave speed of the contact wire", "" if speed is None else f"{3.6 * speed:.0f} km/h"),
            ("Supply", self.design.supply or "not given"),
        ]  # fmt: skip
        titles = ("wire", "tension, kN", "mass, kg/m")
        wires = [
            (name.replace("_", " "), f"{1e-3 * wire.tension:g}", f"{wire.mass:g}")
            for name, wire in self.wires()
        ]
        return [cards.facts(rows), cards.table(titles, wires, numbers=titles[1:])]

    def _repr_html_(self) -> str:
        return cards.card(f"Line {self.name}", *self.card_parts(), about=self.description)

    @model_validator(mode="after")
    def _check(self) -> "Line":
        for check in RULES:
            check(self)
        return self
