"""Tables that `docs/make_validation.py` makes: still what the program finds.

All of them take twenty minutes, so `make evidence` compares them, and with `--publish` renews what
changed; `make test` compares those that records of the evidence hold, and what single rows say.
"""

import re

import pytest

from tests.support.pages import DOCS, alike, cells, maker, renewed, table

MAKER = maker()
ALL = [(page, name) for page, tables in MAKER.TABLES.items() for name in tables]


@pytest.mark.evidence
@pytest.mark.parametrize(("page", "name"), ALL, ids=lambda word: word)
def test_table_is_current(page: str, name: str, request: pytest.FixtureRequest) -> None:
    made = MAKER.TABLES[page][name]()
    text = made if isinstance(made, str) else MAKER.table(*made)
    if request.config.getoption("--publish"):
        renewed(page, name, text)
    now, then = cells(text), cells(table(page, name))
    if not now:  # figures
        assert text.strip() == table(page, name)
    assert len(now) == len(then)
    for row, printed in zip(now, then, strict=True):
        assert len(row) == len(printed)
        for cell, shown in zip(row, printed, strict=True):
            assert alike(cell, shown), f"{page}, {name}: {cell} in {row}, printed {shown}"


@pytest.mark.parametrize("page", MAKER.TABLES)
def test_pages_say_how_they_were_made(page: str) -> None:
    text = (DOCS / "validation" / f"{page}.md").read_text(encoding="utf-8")
    assert f"python docs/make_validation.py {page}" in text
    assert set(re.findall(r"<!-- table: ([\w-]+) -->", text)) == set(MAKER.TABLES[page])
    assert text.count("<!-- table: ") == text.count("<!-- end -->") > 0


@pytest.mark.parametrize(
    ("cell", "shown", "same"),
    [
        ("12.3", "12.4", True),  # a unit of the last digit
        ("12.3", "12.9", False),
        ("1.05e-12", "3.1e-13", True),  # rounding errors: of no size
        ("115.2!", "115.2", False),  # another verdict
        ("10 to 20", "10 to 21", True),
        ("inside", "outside", False),
        ("200.0", "203.0", True),  # 2 %: contact that is lost a step later
        ("200.0", "210.0", False),
        ("+0.31", "-0.31", False),
    ],
)
def test_cells_are_compared_as_they_are_printed(cell: str, shown: str, same: bool) -> None:
    assert alike(cell, shown) is same
