"""Figures of two short runs, of one pantograph and of two with a stagger, and some made up."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from arcless.figures import paper
from arcless.figures.description import (
    Area,
    Axis,
    Bars,
    Curve,
    Figure,
    Map,
    Points,
    Rules,
    Scale,
    Segments,
    Strip,
    Texts,
)
from arcless.report.drawing.bokeh_figure import Drawing, Drawn
from arcless.results import Result
from tests.unit.simulate.conftest import placement, run, short

__all__ = ["placement", "run", "short"]

# A name with markup, a formula, quotes and letters from right to left.
HOSTILE = "<b>\"a\" & 'b'</b> $x^2$ \u05d0\u05d1"


@pytest.fixture(scope="session")
def one(run: Callable[..., Result]) -> Result:
    """Run one pantograph."""
    return run()


@pytest.fixture(scope="session")
def two(run: Callable[..., Result], placement: dict[str, Any]) -> Result:
    """Run two pantographs on a line with stagger."""
    stagger = [0.2, -0.2]
    return run(
        **{
            "line.geometry.stagger_contact_wire": stagger,
            "line.geometry.stagger_messenger_wire": stagger,
            "pantographs": [
                {**placement, "name": "front"},
                {**placement, "distance": 40.0, "name": HOSTILE},
            ],
        }
    )


def made_up() -> Figure:
    """Make a figure with every kind of layer, a logarithmic axis, categories and hidden layers."""
    x = np.array([0.0, 1.0, np.nan, 2.0])
    y = np.array([1.0, 10.0, 5.0, 100.0])
    two_x, two_y = x[[0, 1]], y[[0, 1]]
    return Figure(
        "made-up",
        f"Everything of {HOSTILE}",
        Axis("kind", "", categories=("low", "", HOSTILE)),
        Axis("amount", "N²/Hz", logarithmic=True),
        [
            Strip(axis="x", low=0.2, high=0.4, colour="section", alpha=0.1),
            Strip(axis="y", low=2.0, high=3.0, colour="section", name="band"),
            Curve(x, y, colour="series_1", name=HOSTILE, dash="dashed"),
            Curve(x, 1e6 * y, colour="series_2", name="not shown", hidden=True),
            Area(two_x, two_y, 2.0 * two_y, colour="series_3", name="area", alpha=0.3),
            Points(x, y, colour="limit", name="points", shape="triangle"),
            Points(x, y, values=np.arange(4.0), shape="tick"),
            Segments(two_x, two_y, two_x, 3.0 * two_y, colour="dropper", name="pieces"),
            Bars(two_x - 0.1, two_x + 0.1, two_y, 2.0 * two_y, colour="series_4", name="bars"),
            Rules(axis="y", at=np.array([4.0, 7.0]), colour="mean", name="rule", dash="dotted"),
            Texts(two_x, two_y, ["text", HOSTILE], colour="highlight"),
        ],
        caption="A caption that is long enough to be broken into lines. " * 4,
        alt=f"Numbers from 1 to 100 of {HOSTILE}.",
        scale=Scale("share", "%", 1.0, 3.0, under="slack", under_label="less"),
    )


def mapped() -> Figure:
    """Make a map with a hole, and rules over it."""
    values = np.array([[0.0, 1.0, 2.0], [3.0, np.nan, 5.0]])
    return Figure(
        "mapped", "Map", Axis("place", "m"), Axis("row", "", -0.5, 1.5, form="0"),
        [Rules(axis="x", at=np.array([1.0]), name="rule"), Map((0.0, 3.0), (-0.5, 1.5), values)],
        scale=Scale("force", "N", 1.0, 5.0, under="slack"),
    )  # fmt: skip


@dataclass(frozen=True)
class Both:
    """A figure, drawn by Bokeh and by matplotlib."""

    figure: Figure
    bokeh: Drawn
    sheet: Any

    @property
    def axes(self) -> Any:
        return self.sheet.axes[0]


@pytest.fixture(scope="session")
def everything(one: Result, two: Result) -> list[Both]:
    """Return all figures of both runs, and those made up, drawn."""
    found = [made_up(), mapped()]
    for result in (one, two):
        found += [figure for several in result.figures.values() for figure in several]
    return [Both(figure, Drawing().draw(figure), paper.draw(figure)) for figure in found]
