"""Figures for documents: drawings without title and caption, which the document sets itself."""

import re

import numpy as np
import pytest

from arcless.figures import paper
from arcless.figures.description import Axis, Curve, Figure, Layer, Map, Rules, Scale, Texts

X, Y = np.array([0.0, 1.0]), np.array([1.0, 2.0])


def figure(*layers: Layer, scale: Scale | None = None) -> Figure:
    curve = Curve(X, Y, name="entry of the legend")
    return Figure("f", "Title", Axis("x"), Axis("y"), [curve, *layers], "Caption.", "Words.",
                  scale=scale)  # fmt: skip


def height(svg: str) -> float:
    return float(re.findall(r'<svg[^>]* height="([0-9.]+)pt"', svg)[0])


def test_only_the_drawing_has_words() -> None:
    made = paper.svg(figure())
    for said in ("Title", "Caption.", "Words."):
        assert said not in made
    assert made == paper.svg(figure())


def test_the_legend_has_its_room() -> None:
    made = paper.svg(figure())
    (place,) = re.findall(r' y="([0-9.]+)"[^>]*>entry of the legend', made)
    size = 7.5  # pt of the legend's letters, which stand on that place
    assert size < float(place) < 0.2 * height(made)


def test_width_and_height() -> None:
    made = paper.svg(figure(), width_mm=100.0)
    assert float(re.findall(r'width="([0-9.]+)pt"', made)[0]) == pytest.approx(100 / 25.4 * 72)
    whole, half = paper.svg(figure()), paper.svg(figure(), factor=0.5)
    # The legend is as high in both; the rest has 0.75 pt for a px of a page.
    assert height(whole) - height(half) == pytest.approx(0.5 * figure().height * 0.75, abs=0.01)


def test_lines_too_many_to_be_told_apart_are_left_out() -> None:
    def drawn(count: int, axis: str = "x") -> bool:
        rules = Rules(axis=axis, at=np.linspace(0.0, 1.0, count), name="support")  # type: ignore[arg-type]
        return "support" in paper.svg(figure(rules))

    assert drawn(paper.MOST_RULES)
    assert not drawn(paper.MOST_RULES + 1)
    assert drawn(paper.MOST_RULES + 1, axis="y")


def test_texts_for_a_colour_below_them_stand_on_no_patch() -> None:
    cells = Map(x=(0.0, 1.0), y=(0.0, 1.0), values=np.ones((2, 2)))
    scale = Scale("s", "", 0.0, 1.0)

    def patches(colour: str) -> int:
        texts = Texts(x=X, y=Y, texts=["1", "2"], colour=colour)
        drawing = paper.draw(figure(cells, texts, scale=scale))
        return sum(text.get_bbox_patch() is not None for text in drawing.axes[0].texts)

    assert (patches("on_dark"), patches("on_bright"), patches("ink")) == (0, 0, 2)
