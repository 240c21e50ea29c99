"""PDF files: accessible, for archives, the same bytes anywhere, users' texts as they are."""

import json
import os
import subprocess
import sys
import warnings
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.errors import OutputError
from arcless.figures.description import Axis, Curve, Figure, Map, Scale, Texts
from arcless.report.paper import typeset
from arcless.report.paper.blocks import (
    Bars,
    Cell,
    Code,
    Column,
    Document,
    Heading,
    Judgement,
    Pairs,
    Paragraph,
    Pictures,
    Points,
    Section,
    Table,
)
from arcless.report.paper.letters import MissingLettersWarning, fonts
from arcless.report.summary import Bar, Bullet, Verdict
from tests.support.pdf import facts_of, fonts_of, text_of

typst = pytest.importorskip("typst", reason="typst is not installed")
pytest.importorskip("matplotlib", reason="matplotlib is not installed")

# Every sign that means something to typst, to XML, or to JSON.
HOSTILE = '#eval("1+1") $x$ *b* _i_ `c` <a> @cite \\ #panic() // = & \' "q" </text> \\u0041'


def figure(name: str = "force", title: str = "Force") -> Figure:
    return Figure(
        name, title, Axis("position", "m"), Axis(name, "N"),
        [Curve(np.array([0.0, 1.0]), np.array([1.0, 2.0]), name=name)], alt=f"{name} rises.",
    )  # fmt: skip


def everything(text: str = "text") -> Document:
    """Return a document with each kind of block, and a text wherever one may stand."""
    verdict = Verdict("missed", "✘", text, text, [text])
    bullet = Bullet(text, text, text, "N", text, text, "not-met", text,
                    Bar([(800.0, 200.0)], 0.0, 900.0, (880.0, 920.0), 800.0))  # fmt: skip
    columns = [Column(text, 1.0, below=text), Column("number", is_number=True),
               Column("field", 1.0, is_code=True)]  # fmt: skip
    blocks = [
        Paragraph(text), Paragraph(text, soft=True), Points([text], text), Pairs([(text, text)]),
        Code(text), Table(columns, [[Cell(text, text, "met"), "1.0", text], [Cell(text, wide=3)]]),
        Judgement(verdict, [Paragraph(text)]), Bars([[bullet, bullet]]), Heading(text),
        Pictures([figure(text, text)]), Pictures([figure(), figure("other", text)]),
    ]  # fmt: skip
    return Document(
        kind="Simulation", title=text, description=text, identity=[("Line", text)],
        verdict=verdict, date="2026-03-04T05:06:07+00:00", version="1.2.3",
        sections=[Section(text, blocks), Section("on side", blocks[:2], on_side=True)],
        appendices=[Section(text, blocks[:2])],
    )  # fmt: skip


def written(document: Document, folder: Path, **fields: str) -> Path:
    file = folder / "made.pdf"
    typeset.write(document, file, fields)
    return file


def test_the_file_says_that_it_is_accessible_and_for_the_archive(tmp_path: Path) -> None:
    content = written(everything(), tmp_path, author="A. Smith").read_bytes()
    for told in (
        b"<pdfuaid:part>1<", b"<pdfaid:part>2<", b"<pdfaid:conformance>A<", b"/Lang(en)",
        b"/Marked true", b"<rdf:li>A. Smith</rdf:li>", b"text, simulation</rdf:li>",
        b"<xmp:CreateDate>2026-03-04T05:06:07",
    ):  # fmt: skip
        assert told in content, told
    assert content.startswith(b"%PDF-1.7")


def test_poppler_agrees(tmp_path: Path) -> None:
    file = written(everything(), tmp_path, author="A. Smith")
    facts = facts_of(file)
    assert (facts["Tagged"], facts["Title"], facts["Author"]) == (
        "yes", "text, simulation", "A. Smith"
    )  # fmt: skip
    assert facts["Page size"].endswith("(A4)")
    found = fonts_of(file)
    assert all(embedded for _, embedded in found)
    assert {name.partition("+")[2].partition("-")[0] for name, _ in found} == {
        "DejaVuSans", "DejaVuSansMono"
    }  # fmt: skip


def test_the_compiler_would_refuse_a_figure_without_words() -> None:
    """The standards that are asked for are a test themselves: that of alternative texts."""
    given = typeset.inputs(everything(), {})
    data = json.loads(given["data"])
    silent = json.dumps(data | {"sections": [_silent(one) for one in data["sections"]]})
    with pytest.raises(typst.TypstError, match="missing alt"):
        typst.compile(
            typeset._TEMPLATE, root=typeset._TEMPLATE.parent, sys_inputs={"data": silent},
            font_paths=[fonts()], ignore_system_fonts=True, pdf_standards=typeset.STANDARDS,
        )  # fmt: skip


def _silent(section: dict[str, Any]) -> dict[str, Any]:
    """Return a section whose figures have no alternative text."""
    blocks = [
        {**one, "figures": [{**each, "alt": None} for each in one["figures"]]}
        if one["block"] == "pictures"
        else one
        for one in section["blocks"]
    ]
    return {**section, "blocks": blocks}


def test_texts_of_users_are_no_markup(tmp_path: Path) -> None:
    document = everything(HOSTILE)
    headings = json.loads(
        typst.query(
            typeset._TEMPLATE, "heading", field="body", root=typeset._TEMPLATE.parent,
            sys_inputs=typeset.inputs(document, {"author": HOSTILE}),
        )
    )  # fmt: skip
    assert {"func": "text", "text": HOSTILE} in headings
    found = text_of(written(document, tmp_path, author=HOSTILE, project=HOSTILE))
    # Cover: title, description, identity, verdict and its rest, project, author, who prepared it.
    assert found.count(HOSTILE) >= 20  # the others are broken where columns are narrow


def test_letters_that_are_missing_are_told_once(tmp_path: Path) -> None:
    with pytest.warns(MissingLettersWarning, match="中 文") as told:
        file = written(everything("中文 \x00 \ue000"), tmp_path)
    assert len(told) == 1
    assert "�� � �" in text_of(file)


def test_nothing_is_warned_of_else(tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        written(everything(HOSTILE), tmp_path)


@pytest.mark.parametrize("text", ["x" * 500, "a_b." * 100, "a-b " * 200, " ", "\n", "x\ny"])
def test_texts_of_any_length(text: str, tmp_path: Path) -> None:
    assert written(everything(text), tmp_path).stat().st_size > 0


def test_dates(tmp_path: Path) -> None:
    from dataclasses import replace

    for date, told in (("2026-03-04T07:06:07+02:00", b"05:06:07"), ("", b"1970-01-01"),
                       ("2026-03-04T05:06:07", b"2026-03-04T05:06:07")):  # fmt: skip
        made = typeset.pdf(replace(everything(), date=date), {})
        assert b"<xmp:CreateDate>" + told in made or told in made


def test_maps_with_texts_keep_their_room() -> None:
    cells = Map(x=(0.0, 1.0), y=(0.0, 1.0), values=np.ones((2, 2)))
    texts = Texts(x=np.array([0.5]), y=np.array([0.5]), texts=["1"], colour="on_dark")
    scale = Scale("s", "", 0.0, 1.0)
    heights = []
    for layers in ([cells, texts], [cells]):
        one = Figure("m", "Map", Axis("x"), Axis("y"), layers, scale=scale)
        (made,) = typeset._drawn([one])
        heights.append(float(made["svg"].partition('height="')[2].partition("pt")[0]))
    assert heights[1] / heights[0] == pytest.approx(typeset.HEIGHT, rel=0.02)  # legends, if any


PROGRAM = """
import sys
from tests.unit.report.paper.test_typeset import everything
from arcless.report.paper import typeset
sys.stdout.buffer.write(typeset.pdf(everything("σ ≤ 0.3 F_m"), {"author": "A. Smith"}))
"""


def test_the_same_bytes_on_any_machine(tmp_path: Path) -> None:
    """Other home, locale, time zone, temporary folder, seed of hashes, settings, fonts."""
    from fontTools.ttLib import TTFont

    other = tmp_path / "other"
    for folder in (".fonts", ".config/matplotlib", ".local/share/fonts", "tmp"):
        (other / folder).mkdir(parents=True)
    settings = "xtick.direction: in\nfont.weight: bold\nsvg.fonttype: path\n"
    (other / ".config/matplotlib/matplotlibrc").write_text(settings)
    serif = TTFont(fonts() / "DejaVuSerif.ttf")  # a font that says it is the one of the document
    for record in serif["name"].names:
        record.string = str(record).replace("Serif", "Sans")
    for folder in (".fonts", ".local/share/fonts"):
        serif.save(other / folder / "DejaVuSans.ttf")
    given = {"HOME": str(tmp_path), "TZ": "UTC", "LC_ALL": "C", "PYTHONHASHSEED": "1"}
    changed = {
        "HOME": str(other), "TZ": "Asia/Tokyo", "LC_ALL": "de_DE.UTF-8", "PYTHONHASHSEED": "2",
        "TMPDIR": str(other / "tmp"), "SOURCE_DATE_EPOCH": "1", "PYTHONUTF8": "1",
    }  # fmt: skip
    first, second = (_made_under(one) for one in (given, changed))
    assert len(first) > 10_000
    assert first == second


def test_fonts_of_the_system_are_not_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: dict[str, Any] = {}
    compiled = typst.compile
    monkeypatch.setattr(
        typst, "compile", lambda *words, **named: asked.update(named) or compiled(*words, **named)
    )
    typeset.pdf(everything(), {})
    assert asked["ignore_system_fonts"] is True
    assert asked["font_paths"] == [fonts()]


def _made_under(environment: dict[str, str]) -> bytes:
    kept = {k: v for k, v in os.environ.items() if k in ("PATH", "LD_LIBRARY_PATH")}
    path = os.pathsep.join([str(Path(__file__).parents[4]), *filter(None, sys.path)])
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM], env={**kept, **environment, "PYTHONPATH": path},
        capture_output=True, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("missing", ["typst", "matplotlib"])
def test_a_package_that_is_missing_is_named_with_the_line_that_installs_it(
    missing: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        typeset, "find_spec", lambda name: None if name == missing else find_spec(name)
    )
    with pytest.raises(OutputError, match=rf"{missing}, which .*pip install 'arcless\[pdf\]'"):
        typeset.check_target(tmp_path / "made.pdf")


def test_places_that_cannot_be_written(tmp_path: Path) -> None:
    for name, told in (("made.txt", "ends in .pdf"), ("made", "without an ending"),
                       ("no/made.pdf", "no folder"), (".pdf", "without an ending")):  # fmt: skip
        with pytest.raises(OutputError, match=told):
            typeset.check_target(tmp_path / name)


def test_what_typst_refuses_leaves_the_old_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "made.pdf"
    file.write_text("old")

    def refuse(*_words: object, **_named: object) -> bytes:
        raise typst.TypstError("no such thing")

    monkeypatch.setattr(typst, "compile", refuse)
    with pytest.raises(OutputError, match="cannot be typeset: got `no such thing`"):
        typeset.write(everything(), file, {})
    assert file.read_text() == "old"
    assert [one.name for one in tmp_path.iterdir()] == ["made.pdf"]
