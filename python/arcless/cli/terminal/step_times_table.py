"""Times of steps as a table and bars."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from rich.table import Table
from rich.text import Text

from arcless.simulate.session.step_times import StepTimes, Times, histograms

if TYPE_CHECKING:
    from rich.console import RenderableType

_ROWS = (
    ("a step: computing", "steps", "computing"),
    ("a step: due to done", "steps", "response"),
    ("empty loop: due to done", "empty", "response"),
)
_MICRO = 1e6
# Width of the longest bar, in characters; a class that has one value has a shorter mark.
_WIDTH, _FEW = 40, "·"


def blocks(found: StepTimes, about: dict[str, Any]) -> "Iterator[RenderableType]":
    """Yield what is printed: circumstances, table, misses, histogram of the response."""
    step_ms = 1e3 * about["time_step_s"]
    yield Text(
        f"{about['scenario']}, a step of {step_ms:g} ms; {', '.join(about['circumstances'])}"
    )
    yield Text(about["system"], "dim")
    table = Table(box=None, pad_edge=False)
    table.add_column("time, µs")
    for head in found.steps.percentiles("response"):
        table.add_column(head, justify="right")
    for name, loop, of in _ROWS:
        times: Times = getattr(found, loop)
        values = times.percentiles(of)  # type: ignore[arg-type]
        table.add_row(name, *(f"{_MICRO * value:.1f}" for value in values.values()))
    yield table
    for name, times in (("steps", found.steps), ("empty loop", found.empty)):
        count = len(times.response_s)
        yield Text(
            f"{name}: {times.misses} of {count} not done when the next one was due"
            f" ({100.0 * times.misses / count:.3g} %)"
        )
    yield Text()
    yield from _bars(found)


def _bars(found: StepTimes) -> Iterator[Text]:
    """Yield a line for each class of response times that has any."""
    edges, counts = histograms(found)
    steps, empty = counts["steps response"], counts["empty loop response"]
    yield Text(f"{'due to done, µs':>17} {'steps':>9} {'empty loop':>10}", "bold")
    most = max(steps.max(), empty.max())
    for low, high, own, idle in zip(edges[:-1], edges[1:], steps, empty, strict=True):
        if own or idle:
            bar = "█" * round(_WIDTH * own / most) or (_FEW if own else "")
            place = f"{_MICRO * low:.0f} … {_MICRO * high:.0f}"
            yield Text(f"{place:>17} {own:>9} {idle:>10}  {bar}")
