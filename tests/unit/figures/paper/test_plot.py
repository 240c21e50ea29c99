"""`Result.figures` and `Result.plot`: any figure of a run by its key."""

import importlib.util
import re
from typing import Any

import pytest
from matplotlib.figure import Figure as Drawing

from arcless.errors import FigureError
from arcless.figures import paper
from arcless.figures.run import FIGURES
from arcless.results import Result
from tests.unit.figures.paper.conftest import HOSTILE


def title(drawing: Any) -> str:
    """Return the title of a drawing, its lines joined."""
    found: str = drawing.axes[0].get_title(loc="left")
    return found.replace("\n", " ")


def test_every_key_is_there(one: Result) -> None:
    assert list(one.figures) == list(FIGURES)
    assert one.figures["lateral"] == []
    assert [figure.key for figure in one.figures["lead"]] == ["lead-1"]


@pytest.mark.parametrize(
    ("key", "number"), [("lead", 0), ("lead-1", 0), ("lead-2", 1), ("lead_2", 1)]
)
def test_a_key_of_several_figures(two: Result, key: str, number: int) -> None:
    assert title(two.plot(key)) == two.figures["lead"][number].title
    assert HOSTILE in title(two.plot("lead-2"))


@pytest.mark.parametrize("key", ["uplift_passages", "uplift-passages"])
def test_a_key_of_two_words(one: Result, key: str) -> None:
    assert title(one.plot(key)) == one.figures["uplift_passages"][0].title


def test_what_is_drawn_without_a_key(one: Result) -> None:
    assert title(one.plot()) == title(one.plot("lead"))


def test_looks(one: Result) -> None:
    axes = Drawing().subplots()
    assert one.plot("force", axes) is axes.figure
    assert one.plot("force", width_mm=50.8).get_size_inches()[0] == pytest.approx(2.0)
    light, dark = (one.plot("force", scheme=scheme) for scheme in ("light", "dark"))
    assert light.get_facecolor() != dark.get_facecolor()


def test_an_unknown_key_says_the_known_ones(one: Result) -> None:
    words = "unknown key of a figure: got `nothing`, expected one of `lead`, `force`, `height`"
    with pytest.raises(FigureError, match=re.escape(words)):
        one.plot("nothing")


def test_a_key_without_a_figure(one: Result) -> None:
    words = "there is no figure of this key: nothing that it shows was recorded or is assessed:"
    with pytest.raises(FigureError, match=re.escape(f"{words} got `lateral`, expected one of")):
        one.plot("lateral")
    with pytest.raises(FigureError, match=r"got `lead`$"):
        paper.plot({"lead": []}, "lead")


def test_without_matplotlib(one: Result, monkeypatch: pytest.MonkeyPatch) -> None:
    find = importlib.util.find_spec
    hidden = lambda name, *more: None if name == "matplotlib" else find(name, *more)  # noqa: E731
    monkeypatch.setattr(importlib.util, "find_spec", hidden)
    with pytest.raises(FigureError, match=re.escape("hint: pip install 'arcless[plots]'")):
        one.plot()
    assert one.figures["lead"]  # the descriptions need no library
