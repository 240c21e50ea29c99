"""The table of the page core-faults: the mutations of the core that its checks must notice."""

from tests.faults.mutations import MUTATIONS
from validation.runs import table


def mutations() -> str:
    rows = [
        (mutation.name, f"`{mutation.file}`", ", ".join(map(_short, mutation.checks)))
        for mutation in MUTATIONS
    ]
    return table(("fault", "source file", "noticed by"), rows)


def _short(check: str) -> str:
    return f"`{check.replace('test_', '').replace('.py::', ': ')}`"


QUICK = {"core-faults": {"mutations": mutations}}
