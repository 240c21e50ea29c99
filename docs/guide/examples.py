"""What the programs of examples/ print, for the guides that show it."""

import importlib.util
from collections.abc import Callable
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

from validation.runs import table

EXAMPLES = Path(__file__).parents[2] / "examples"


def printed(name: str) -> list[str]:
    """Run `main` of an example, and return the lines that it prints."""
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    with redirect_stdout(StringIO()) as output:
        module.main()
    return output.getvalue().rstrip().splitlines()


def as_table(name: str, *head: str) -> str:
    """Return lines of a name and numbers as a table."""
    lines = printed(name)[1:]
    rows = [line.rsplit(maxsplit=len(head)) for line in lines]
    return table(("", *head), rows)


SLOW: dict[str, dict[str, Callable[[], str]]] = {
    "tension-study": {
        "output": lambda: "\n".join(["```text", *printed("tension_coupling"), "```"])
    },
    "control": {"controllers": lambda: as_table("controlled", "mean N", "σ N", "min N")},
    "realtime": {"bench": lambda: as_table("bench_in_the_loop", "mean N", "σ N", "min N", "max N")},
}
