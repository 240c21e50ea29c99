"""The runs below a folder as lines: numbers in columns, then the name, which may be long."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from rich.text import Text

from arcless.assess.quantities import QUANTITIES
from arcless.display.numbers import number
from arcless.results import KeptRun
from arcless.results.kept_runs.kept_run import STOPPED

# Heads and widths of the columns.
_COLUMNS = (
    ("date, UTC", -18), ("verdict", -14), ("km/h", 5), ("F_m N", 8), ("σ N", 7), ("NQ %", 7),
    ("uplift mm", 11),
)  # fmt: skip
_FORCES = ("mean_force_N", "std_force_N", "NQ_percent")
_UPLIFT = "max_uplift_at_support_mm"
_STYLES = {
    "met": "green", "not met": "bold red", "not judged": "dim", "stopped early": "yellow",
    "unreadable": "bold red",
}  # fmt: skip
_NONE = "–"


def lines(found: Sequence[KeptRun], top: Path) -> Iterator[Text]:
    """Yield a head, and for each run a line, with lines below it for what else is to be said."""
    yield Text.assemble(*(_cell(head, width) for head, width in _COLUMNS), "  run", style="bold")
    for one in found:
        worst = one.worst
        cells = [
            (one.created or _NONE)[:16].replace("T", " "),
            one.verdict,
            _NONE if one.speed_m_s is None else f"{3.6 * one.speed_m_s:.4g}",
            *(_number(key, getattr(worst, key, None)) for key in _FORCES),
            _number(_UPLIFT, one.max_uplift_at_support_mm),
        ]
        styles = ["", _STYLES[one.verdict], *[""] * len(cells[2:])]
        place = _place(one, top)
        yield Text.assemble(
            *(
                (_cell(text, width), style)
                for text, (_, width), style in zip(cells, _COLUMNS, styles, strict=True)
            ),
            f"  {_printed(place)}",
        )
        yield from (Text(f"    {_printed(line)}", "dim") for line in _more(one, place))


def _more(one: KeptRun, place: str) -> Iterator[str]:
    """Yield the scenario and the changes where the name lacks them, pantograph, and reason."""
    if one.name is not None and one.name not in place:
        yield f"scenario {one.name}"
    if not all(f"{path}=" in place for path in one.changes):
        yield "set: " + ", ".join(f"{path}={text}" for path, text in one.changes.items())
    if one.worst is not None and len(one.pantographs) > 1:
        yield f"of {len(one.pantographs)} pantographs, the numbers of {one.worst.name}"
    if one.reason:
        todo = f"; `arcless resume {one.path}` continues it" if one.verdict == STOPPED else ""
        yield f"{one.verdict}: {one.reason}{todo}"


def _place(one: KeptRun, top: Path) -> str:
    place = one.path.relative_to(top) if one.path.is_relative_to(top) else one.path
    return str(top if place == Path() else place)


def _printed(text: str) -> str:
    """Return a text with question marks for what does not print: it is from any file."""
    return "".join(one if one.isprintable() else "?" for one in text)


def _cell(text: str, width: int) -> str:
    return f"{text:<{-width}}" if width < 0 else f"{text:>{width}}"


def _number(key: str, value: float | None) -> str:
    return number(value, QUANTITIES[key].decimals)
