"""Letters of documents: all of the typeface stay, all others are shown as missing and told."""

import pytest

pytest.importorskip("matplotlib", reason="matplotlib is not installed")

from arcless.report.paper.letters import INSTEAD, lacking, settable, texts_of


@pytest.mark.parametrize(
    "text",
    [
        "F_m − 3σ ≤ 0.3 F_m ✔ ✘ ≈ ± µ² √(T/μ) m³/km 1\u202f000\u00a0N",
        '#eval("1") $x$ *b* <a> @cite \\ `c` // # = - +',
        "\u05e9\u05dc\u05d5\u05dd é q\u0301",
        "one\ntwo",
    ],
)
def test_letters_of_the_typeface_stay(text: str) -> None:
    assert settable(text) == text
    assert lacking([text]) == ""


@pytest.mark.parametrize(
    "letter", ["\x00", "\x1b", "\u202e", "\u200b", "\ue000", "\u2028", "\ufdd0", "\ud800"]
)
def test_what_is_no_letter_is_not_set(letter: str) -> None:
    assert settable(f"a{letter}b") == f"a{INSTEAD}b"


def test_tabs_are_blanks() -> None:
    assert settable("a\tb\rc") == "a b c"


def test_letters_of_other_faces_are_told_once_each() -> None:
    assert settable({"name": ["中文", 1.5, None, True]}) == {"name": [INSTEAD * 2, 1.5, None, True]}
    assert lacking(texts_of({"a": "中文中", "b": ["文", 3]})) == "中文"
