"""The page of faults in the core lists the mutations that are tried."""

import pytest

from tests.faults.mutations import MUTATIONS
from tests.support.pages import cells, from_docs, renewed, table

HEAD = ("fault", "source file", "noticed by")


def short(check: str) -> str:
    return f"`{check.replace('test_', '').replace('.py::', ': ')}`"


def test_the_page_lists_the_mutations(request: pytest.FixtureRequest) -> None:
    rows = [
        (mutation.name, f"`{mutation.file}`", ", ".join(map(short, mutation.checks)))
        for mutation in MUTATIONS
    ]
    made = from_docs("runs").table(HEAD, rows)
    if request.config.getoption("--publish"):
        renewed("core-faults", "mutations", made)
    assert cells(table("core-faults", "mutations")) == [list(row) for row in rows]
