"""Figures as files: whole, the same bytes every time, with words for those who do not see them."""

import re
from pathlib import Path
from xml.etree import ElementTree

import matplotlib as mpl
import pytest

from arcless.errors import FigureError, OutputError
from arcless.figures import paper
from tests.unit.figures.paper.conftest import HOSTILE, made_up, mapped

SVG = "{http://www.w3.org/2000/svg}"


@pytest.mark.parametrize("ending", ["svg", "pdf", "png"])
def test_the_same_figure_gives_the_same_bytes(ending: str, tmp_path: Path) -> None:
    first, second = tmp_path / f"1.{ending}", tmp_path / f"2.{ending}"
    paper.save(made_up(), first)
    with mpl.rc_context({"svg.hashsalt": None, "font.size": 30.0, "pdf.fonttype": 3}):
        paper.save(made_up(), second)
    assert first.read_bytes() == second.read_bytes()
    paper.save(mapped(), second)
    assert first.read_bytes() != second.read_bytes()
    assert {path.name for path in tmp_path.iterdir()} == {first.name, second.name}


def test_texts_of_an_svg(tmp_path: Path) -> None:
    figure = made_up()
    paper.save(figure, tmp_path / "f.svg")
    root = ElementTree.parse(tmp_path / "f.svg").getroot()
    by_id = {one.get("id"): one for one in root.iter()}
    assert root.get("role") == "img"
    assert by_id[root.get("aria-labelledby")].text == figure.title
    assert by_id[root.get("aria-describedby")].text == figure.alt
    texts = ["".join(one.itertext()) for one in root.iter(f"{SVG}text")]
    assert {"kind", "amount, N²/Hz", "share, %", "10²", "less", "bars", HOSTILE, "text"} <= set(
        texts
    )
    # Title and caption are in several lines: all words are there in their order.
    words = " ".join(" ".join(texts).split())
    assert " ".join(figure.caption.split()) in words
    assert figure.title in words
    assert "not shown" not in words
    assert not re.search("dc:date|matplotlib v", (tmp_path / "f.svg").read_text("utf-8"))


@pytest.mark.parametrize(("ending", "words"), [("pdf", b"/Subject"), ("png", b"Description")])
def test_alternative_text_of_other_files(ending: str, words: bytes, tmp_path: Path) -> None:
    paper.save(mapped(), tmp_path / f"f.{ending}")
    content = (tmp_path / f"f.{ending}").read_bytes()
    assert words in content
    assert b"Date" not in content


def test_width(tmp_path: Path) -> None:
    paper.save(mapped(), tmp_path / "f.svg", width_mm=100.0)
    width = ElementTree.parse(tmp_path / "f.svg").getroot().get("width", "")
    assert float(width.removesuffix("pt")) == pytest.approx(100.0 / 25.4 * 72.0)


@pytest.mark.parametrize(("name", "got"), [("f.bmp", "`.bmp`"), ("f", "no ending")])
def test_another_ending_is_refused(name: str, got: str, tmp_path: Path) -> None:
    with pytest.raises(FigureError, match=re.escape(f"got {got}, expected `.svg`, `.pdf` or")):
        paper.save(mapped(), tmp_path / name)
    assert not any(tmp_path.iterdir())


def test_a_missing_folder_is_told(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="no folder"):
        paper.save(mapped(), tmp_path / "nowhere" / "f.svg")


def test_a_failure_leaves_the_file_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "f.svg"
    path.write_text("before", encoding="utf-8")

    def fail(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("matplotlib.figure.Figure.savefig", fail)
    with pytest.raises(KeyboardInterrupt):
        paper.save(mapped(), path)
    assert path.read_text("utf-8") == "before"
    assert list(tmp_path.iterdir()) == [path]
