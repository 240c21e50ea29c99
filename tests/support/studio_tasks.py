"""Tasks for worker processes of the studio: what may happen to a job, made to happen."""

import itertools
import os
import signal
import threading
import time
from collections import deque
from pathlib import Path

import numpy as np

from arcless.errors import ModelError
from arcless.studio.jobs.spooling import spooled
from arcless.studio.motion.layout import RowLayout, WirePart
from arcless.studio.motion.spool import SpoolWriter
from arcless.studio.processes.talk import Talk

# Beyond what any test waits for.
LONG_S = 60.0
NODES, EVERY_S = 50, 0.01


def add(_talk: Talk, one: int, other: int) -> int:
    return one + other


def process(_talk: Talk) -> int:
    return os.getpid()


def tell(talk: Talk, times: int) -> None:
    for number in range(times):
        talk.progress(number / times, f"step {number}")
    talk.note("A warning.")


def refuse(_talk: Talk) -> None:
    raise ModelError("speed", got="-1", expected="a speed above 0")


def fail(_talk: Talk) -> None:
    raise RuntimeError("no idea")


def no_memory(_talk: Talk) -> None:
    raise MemoryError


def strange(_talk: Talk) -> object:
    return lambda: None


def kill(_talk: Talk, number: int) -> None:
    os.kill(os.getpid(), number)
    time.sleep(LONG_S)


def wait(talk: Talk) -> None:
    """Wait until it is cancelled."""
    talk.progress(0.5, "waiting")
    if not talk.cancelled.wait(LONG_S):
        raise AssertionError("nobody cancelled it")
    raise KeyboardInterrupt


def deaf(talk: Talk) -> None:
    """Do something that nobody can interrupt."""
    talk.say("begun")
    time.sleep(LONG_S)


def chatter(talk: Talk) -> None:
    """Speak from another thread, as the one that writes motion does."""
    threading.Thread(target=lambda: deque(map(talk.say, itertools.count()), 0), daemon=True).start()
    time.sleep(LONG_S)


def echo(talk: Talk) -> int:
    """Say each order again until there is an end; return how many there were."""
    count = 0
    while (order := talk.order(LONG_S)) != "end":
        talk.say(order)
        count += 1
    return count


def speak(talk: Talk, times: int, size: int) -> tuple[float, float]:
    """Say much; return when it began and when all was said, in s."""
    begun = time.monotonic()
    for _ in range(times):
        talk.say(bytes(size))
    return begun, time.monotonic()


def missing(_talk: Talk) -> None:
    Path("/missing").read_text()


def leave(_talk: Talk, code: int) -> None:
    os._exit(code)


def hold_memory(_talk: Talk, size: int) -> int:
    return len(bytearray(b"x") * size)


def hold(talk: Talk, folder: Path) -> None:
    """Hold a folder as a run does, deaf to who cancels."""
    from arcless.storage.output_folder import OutputFolder

    with OutputFolder(folder, "result.nc") as output:
        output.file("result.nc").write_text("half of it")
        talk.progress(0.5, "holding")
        time.sleep(LONG_S)


def stopped(_talk: Talk) -> None:
    os.kill(os.getpid(), signal.SIGSTOP)


GEOMETRY = {
    "name": "one wire", "spatial": False, "height_m": 5.0, "spans": [], "droppers": [],
    "wires": [{
        "name": "contact wire", "kind": "contact", "first": 0,
        "x": [float(node) for node in range(NODES)], "y": [0.0] * NODES, "z": [5.0] * NODES,
    }],
    "supports": [],
}  # fmt: skip
LAYOUT = RowLayout(
    wires=(WirePart("contact_wire", (range(NODES),), NODES),), dropper_order=np.zeros(0, np.int64),
    dropper_count=0, pantographs=(("P1", 1),), spatial=False,
)  # fmt: skip


def rows_of(first: int, count: int) -> np.ndarray:
    """Return rows whose every number is that of the row."""
    rows = np.zeros(count, LAYOUT.type)
    numbers = np.arange(first, first + count)
    rows["time"] = numbers * EVERY_S
    rows["up"] = numbers[:, None]
    rows["pantograph 0"] = numbers[:, None]
    return rows


def spool_of(talk: Talk, end_s: float) -> SpoolWriter:
    return spooled(talk, LAYOUT, GEOMETRY, every_s=EVERY_S, end_s=end_s)


def move(talk: Talk, count: int, begin_again: bool) -> None:
    """Spool rows; before that some of another attempt, where it begins again."""
    if begin_again:
        spool_of(talk, count * EVERY_S).append(rows_of(1000, 7))
    spool = spool_of(talk, count * EVERY_S)
    for first in range(0, count, 10):
        spool.append(rows_of(first, min(10, count - first)))
    spool.finish()
