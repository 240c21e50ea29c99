"""Cards for notebooks: HTML that holds by itself, in which no text becomes markup."""

from xml.etree import ElementTree

import pytest

from arcless.display import cards

HOSTILE = '<img src=x onerror="alert(1)">&amp;</td>'


def read(html: str) -> ElementTree.Element:
    """Read a card as XML, which refuses what is not closed or not escaped."""
    return ElementTree.fromstring(html)


def test_texts_are_texts() -> None:
    html = cards.card(
        HOSTILE,
        cards.verdict(cards.Badge("met", HOSTILE), HOSTILE),
        cards.facts([(HOSTILE, HOSTILE)]),
        cards.table([HOSTILE], [[HOSTILE], [cards.Badge("open", HOSTILE)]]),
        cards.folded(HOSTILE, cards.listed([HOSTILE])),
        about=HOSTILE,
    )
    made = read(html)
    assert "<img" not in html
    assert "".join(made.itertext()).count(HOSTILE) == 11
    assert not {one.tag for one in made.iter()} & {"img", "script", "link"}


def test_a_verdict_is_told_without_colour() -> None:
    for state, sign in cards.SIGNS.items():
        assert f"{sign} not met" in cards.verdict(cards.Badge(state, "not met"))


def test_facts_without_words_are_left_out() -> None:
    rows = read(cards.facts([("speed", "320 km/h"), ("height", "")])).iter("tr")
    assert ["".join(row.itertext()) for row in rows] == ["speed320 km/h"]


def test_a_long_table_says_how_much_is_left_out() -> None:
    rows = [[str(number)] for number in range(cards.MOST_ROWS + 3)]
    made = [row for row in read(cards.table(["number"], rows)).iter("tr")]
    assert len(made) == 1 + cards.MOST_ROWS + 1
    assert "".join(made[-1].itertext()) == "… and 3 more"


def test_numbers_are_flush_right() -> None:
    made = read(cards.table(["name", "value"], [["a", "1"]], numbers=["value"]))
    assert [cell.get("class") for cell in made.iter("td")] == [None, "arcless-n"]


def test_a_row_has_a_cell_for_each_column() -> None:
    with pytest.raises(ValueError, match="zip"):
        cards.table(["one", "two"], [["1"]])


def _luminance(colour: str) -> float:
    """Return the relative luminance of a colour, by WCAG 2.1."""
    parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    red, green, blue = (
        one / 12.92 if one <= 0.04045 else ((one + 0.055) / 1.055) ** 2.4 for one in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def test_badges_are_readable() -> None:
    style = cards.card("").partition("<style>")[2]
    for state in cards.SIGNS:
        colour = style.partition(f".arcless-{state}{{background:")[2][:7]
        # White on it, against 4.5 which WCAG 2.1 asks for.
        assert 1.05 / (_luminance(colour) + 0.05) > 4.5, state


def test_style_reaches_nothing_outside() -> None:
    style = cards.card("").partition("<style>")[2].partition("</style>")[0]
    selectors = [one for rule in style.split("}")[:-1] for one in rule.split("{")[0].split(",")]
    assert all(one.startswith(".arcless-card") for one in selectors)
