"""`arcless step-times`: times of steps on this machine, computing and lateness."""

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from arcless.cli.arguments.scenario import (
    JsonOption,
    QuietOption,
    ScenarioArgument,
    SetOption,
    SpeedOption,
    load,
)
from arcless.cli.terminal import console
from arcless.errors import ModelError, OutputError

if TYPE_CHECKING:
    from arcless.simulate.session.step_times import StepTimes

_ENDINGS = (".csv", ".json")
# A day: nobody waits for more, and a million steps take 32 MB.
LONGEST_S = 86_400.0


class Waiting(StrEnum):
    """Ways to wait for the time of a step."""

    sleep = "sleep"
    spin = "spin"


def step_times(
    scenario: ScenarioArgument,
    *,
    seconds: Annotated[
        float,
        typer.Option(metavar="SECONDS", help="Time to measure steps, and the same without steps."),
    ] = 30.0,
    simulated: Annotated[
        bool, typer.Option("--simulated", help="With the pantographs inside; without, force in.")
    ] = False,
    wait: Annotated[
        Waiting, typer.Option(help="How to wait for a step: sleep, or look at the clock.")
    ] = Waiting.sleep,
    fifo: Annotated[
        int | None,
        typer.Option(
            metavar="PRIORITY", show_default=False, min=1, max=99,
            help="Use the real-time priority SCHED_FIFO, 1 to 99; 49 is usual.",
        ),
    ] = None,
    lock_memory: Annotated[
        bool, typer.Option("--lock-memory", help="Keep all memory of the process from the disk.")
    ] = False,
    core: Annotated[
        int | None,
        typer.Option(metavar="NUMBER", min=0, show_default=False, help="Stay on this processor."),
    ] = None,
    to: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", show_default=False,
            help="Write the histograms as .csv, or everything as .json.",
        ),
    ] = None,
    speed: SpeedOption = None,
    changes: SetOption = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:  # fmt: skip
    """Measure how long the steps of a line take on this machine.

    A step is due each time step of the clock, as on a test bench. The command measures the time
    from wake-up to completion, the time from the due time to completion, and how many steps were
    not complete when the next one was due. An empty loop alternates with the steps and shows the
    share of the operating system.
    """
    _check(seconds, to)
    given = load(scenario, speed=speed, changes=changes, quiet=quiet)
    from arcless.platforms import real_time
    from arcless.simulate import realtime
    from arcless.simulate.session import step_times as measuring

    loop = realtime(given, simulated=simulated)
    circumstances = [
        *([real_time.stay_on(core)] if core is not None else []),
        *([real_time.lock_memory()] if lock_memory else []),
        # Last: what comes before is not to be done at the cost of others.
        real_time.ask_priority(fifo) if fifo is not None else "ordinary priority",
        {"sleep": "sleeping between steps", "spin": "looking at the clock between steps"}[wait],
    ]
    end_m = given.travel_range()[1]
    with console.progress(quiet=quiet) as advance:
        found = measuring.measure(loop, end_m, seconds, wait=wait.value, progress=advance)
    about = {
        "scenario": given.name, "time_step_s": loop.time_step_s,
        "circumstances": circumstances, "system": _system(),
    }  # fmt: skip
    if to is not None:
        _write(to, found, about)
    if json:
        console.data(console.json_text(_plain(found, about)))
        return
    from arcless.cli.terminal import step_times_table

    console.show(*step_times_table.blocks(found, about))


def _check(seconds: float, to: Path | None) -> None:
    if not 0.0 < seconds <= LONGEST_S:
        raise ModelError("--seconds", got=f"{seconds:g}", expected=f"above 0, up to {LONGEST_S:g}")
    if to is None:
        return
    from arcless.storage.whole_files import check_writable

    if to.suffix.lower() not in _ENDINGS:
        raise OutputError("--to", got=str(to), expected=f"a file {' or '.join(_ENDINGS)}")
    check_writable(to)


def _system() -> str:
    """Return name and version of the system, and its processor."""
    import platform

    return f"{platform.system()} {platform.release()} {platform.version()}, {platform.machine()}"


def _write(to: Path, found: "StepTimes", about: dict[str, Any]) -> None:
    from arcless.storage.csv_files import Column, write_csv
    from arcless.storage.whole_files import write_bytes

    if to.suffix.lower() == ".json":
        write_bytes(to, f"{console.json_text(_plain(found, about))}\n".encode())
        return
    edges, counts = _histograms(found)
    columns = [Column("from", "s", edges[:-1]), Column("to", "s", edges[1:])]
    columns += [Column(name, "", numbers) for name, numbers in counts.items()]
    write_csv(to, columns)


def _histograms(found: "StepTimes") -> tuple[Any, dict[str, Any]]:
    """Return edges in s and, by name, how many times lie between them."""
    from arcless.simulate.session.step_times import histograms

    return histograms(found)


def _plain(found: "StepTimes", about: dict[str, Any]) -> dict[str, Any]:
    """Return everything as plain data."""
    edges, counts = _histograms(found)
    loops = {
        name: {
            "steps": len(times.response_s),
            "deadline_misses": times.misses,
            "computing_s": times.percentiles("computing"),
            "response_s": times.percentiles("response"),
        }
        for name, times in (("steps", found.steps), ("empty_loop", found.empty))
    }
    table = {"edges_s": edges.tolist()} | {name: each.tolist() for name, each in counts.items()}
    return {**about, **loops, "histograms": table}
