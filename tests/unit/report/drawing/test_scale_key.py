"""Scale of colours of a figure as its page shows it."""

import pytest

from arcless.figures.description import Scale
from arcless.figures.description.tokens import shades
from arcless.report.drawing.scale_key import scale_key


@pytest.mark.parametrize(
    ("low", "high", "texts"),
    [
        (-5.0, 35.0, ["0", "10", "20", "30"]),
        (0.29, 291.0, ["100", "200"]),
        (-21.0, 19.0, ["\u221220", "\u221210", "0", "10"]),
        (0.0, 1.0, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]),
        (0.0, 12.0, ["0.0", "2.5", "5.0", "7.5", "10.0"]),
        (0.2, 1.1, ["0.2", "0.4", "0.6", "0.8", "1.0"]),
        (3.0, 3.0, ["3"]),
    ],
)
def test_numbers_are_round_and_stand_at_their_colours(
    low: float, high: float, texts: list[str]
) -> None:
    key = scale_key(Scale("force", "N", low, high))
    assert [text for _, text in key.ticks] == texts
    for place, text in key.ticks:
        value = float(text.replace("\u2212", "-"))
        # A hundredth of a per cent of the scale, to which places are rounded.
        assert low + 0.01 * place * (high - low) == pytest.approx(value, abs=1e-4 * (high - low))


def test_the_strip_has_the_colours_of_the_map_and_the_meaning_of_what_lies_below() -> None:
    scale = Scale("dropper force", "N", 0.3, 300.0, under="slack", under_label="slack")
    key = scale_key(scale)
    ends = shades("sequential")
    assert key.gradient.startswith(f"linear-gradient(to right, {ends[0]}, ")
    assert key.gradient.endswith(f", {ends[-1]})")
    assert (key.title, key.under, key.under_label) == ("dropper force, N", "slack", "slack")
    assert key.words == "Colours of dropper force: from 0.3 to 300 N"
