"""The sheet of a figure: nothing lies over anything else, and nothing of the user's is changed."""

from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from itertools import pairwise
from typing import Any

import matplotlib as mpl
import pytest
from matplotlib.figure import Figure as Drawing
from matplotlib.transforms import Affine2D

from arcless.figures import paper
from arcless.figures.description import Figure
from arcless.figures.description.tokens import colour
from tests.unit.figures.paper.conftest import Both, made_up

# Settings that would be seen in every figure.
OWN = {"font.size": 30.0, "axes.grid": True, "lines.linewidth": 9.0, "svg.fonttype": "path",
       "text.color": "red", "figure.dpi": 33.0, "savefig.bbox": "tight"}  # fmt: skip
# Points: less than is seen between two things, more than the rounding of places.
NOTHING = 0.5


@contextmanager
def own_settings() -> Iterator[None]:
    with mpl.rc_context(OWN):
        before = dict(mpl.rcParams)
        yield
        assert dict(mpl.rcParams) == before


def boxes(sheet: Any) -> dict[str, Any]:
    """Return the place of each part of a sheet that has its own, from above, in points.

    At 300 dots an inch: at few dots the height of a text is rounded by a tenth of it.
    """
    sheet.set_dpi(300)
    sheet.draw_without_rendering()
    axes = sheet.axes[0]
    found = {"title": axes._left_title.get_window_extent()}
    if axes.get_legend() is not None:
        found["legend"] = axes.get_legend().get_window_extent()
    found["frame"] = axes.get_window_extent()
    found["label"] = axes.xaxis.label.get_window_extent()
    found |= {f"caption {i}": text.get_window_extent() for i, text in enumerate(sheet.texts)}
    return {name: box.transformed(Affine2D().scale(72.0 / 300.0)) for name, box in found.items()}


def check_places(figure: Figure, sheet: Any) -> None:
    """Fail where a part lies over the next one, or beyond the sheet."""
    found = boxes(sheet)
    width, height = 72.0 * sheet.get_size_inches()
    for name, box in found.items():
        assert box.x0 >= -NOTHING, (figure.key, name)
        assert box.x1 <= width + NOTHING, (figure.key, name)
        assert -NOTHING <= box.y0 < box.y1 <= height + NOTHING, (figure.key, name)
    order = [name for name, box in found.items() if box.height]
    for above, below in pairwise(order):
        gap = found[above].y0 - found[below].y1
        assert gap >= -NOTHING, (figure.key, above, below)


def test_no_part_lies_over_another_one(everything: list[Both]) -> None:
    for both in everything:
        check_places(both.figure, both.sheet)


def test_in_a_column_neither(everything: list[Both]) -> None:
    for both in everything[::3]:
        sheet = paper.draw(both.figure, width_mm=paper.COLUMN_MM)
        check_places(both.figure, sheet)
        assert sheet.get_size_inches()[0] == pytest.approx(paper.COLUMN_MM / 25.4)


def test_the_height_of_a_page_is_that_on_paper(everything: list[Both]) -> None:
    for both in everything:
        frame, label = (boxes(both.sheet)[name] for name in ("frame", "label"))
        # Of 290 px, 96 an inch, the frame has all but ticks, label and edge, 0.2 to 0.6 inches.
        missing = both.figure.height / 96.0 - (frame.y1 - label.y0) / 72.0
        assert 0.0 <= missing < 0.25, both.figure.key


def test_no_settings_are_changed_and_none_are_heeded() -> None:
    plain = picture(paper.draw(made_up()))
    with own_settings():
        sheet = paper.draw(made_up())
        found = sheet._repr_png_()
        assert found.startswith(b"\x89PNG")
    assert picture(sheet) == plain


def picture(sheet: Any) -> bytes:
    written = BytesIO()
    sheet.savefig(written, format="png", dpi=72)
    return written.getvalue()


def test_axes_of_another_figure() -> None:
    drawing = Drawing(layout="constrained")
    left, right = drawing.subplots(1, 2)
    assert paper.draw(made_up(), left) is drawing
    assert left.get_title(loc="left").startswith("Everything")
    assert left.get_legend() is not None
    assert not right.get_children()[0].get_gid()
    assert not drawing.texts  # the caption is for the text around it


def test_dark_colours() -> None:
    axes = paper.draw(made_up(), scheme="dark").axes[0]
    curve = next(line for line in axes.lines if line.get_gid() == "layer-2")
    assert curve.get_color() == colour("series_1", "dark") != colour("series_1")
    assert mpl.colors.to_hex(axes.get_facecolor()) == colour("paper", "dark")


def test_powers_of_ten_and_decimals_are_text() -> None:
    found = {text.get_text() for text in paper.draw(made_up()).axes[0].get_yticklabels()}
    assert {"10⁰", "10¹", "10²"} <= found
