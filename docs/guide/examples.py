"""What the programs of examples/ print, for the guides that show it."""

import importlib.util
from collections.abc import Callable
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

from validation.runs import table

EXAMPLES = Path(__file__).parents[2] / "examples"


def printed(name: str, *arguments: str) -> list[str]:
    """Run `main` of an example, and return the lines that it prints."""
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    with redirect_stdout(StringIO()) as output:
        module.main(*([arguments] if arguments else []))
    return output.getvalue().rstrip().splitlines()


def as_table(name: str, *head: str, arguments: tuple[str, ...] = ()) -> str:
    """Return lines of a name and numbers as a table."""
    lines = printed(name, *arguments)[1:]
    rows = [line.rsplit(maxsplit=len(head)) for line in lines]
    return table(("", *head), rows)


def signals() -> str:
    """Return the signals of an environment as a table."""
    from arcless import control

    rows = [
        (
            f"`{name}`",
            signal.unit,
            signal.what,
            signal.measured_by,
            "yes" * (name in control.DEFAULT),
        )
        for name, signal in control.SIGNALS.items()
    ]
    return table(("signal", "unit", "meaning", "what measures it", "observed by default"), rows)


QUICK: dict[str, dict[str, Callable[[], str]]] = {"learning-control": {"signals": signals}}
SLOW: dict[str, dict[str, Callable[[], str]]] = {
    "tension-study": {
        "output": lambda: "\n".join(["```text", *printed("tension_coupling"), "```"])
    },
    "control": {"controllers": lambda: as_table("controlled", "mean N", "σ N", "min N")},
    "learning-control": {
        "laws": lambda: as_table(
            "control_baselines", "mean N", "σ N", "min N", "lost %", "effort N"
        ),
        "elsewhere": lambda: as_table(
            "control_baselines",
            "none",
            "PID",
            "learnt",
            "with noise",
            arguments=("--others", "--case", "en50318-ac-simple-320-planar"),
        ),
    },
    "realtime": {"bench": lambda: as_table("bench_in_the_loop", "mean N", "σ N", "min N", "max N")},
}
