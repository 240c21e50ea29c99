"""A worker process: what it returns, says and hears; its end, and that of its server."""

import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from collections import deque
from collections.abc import Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.studio.answers.answers import complaint
from arcless.studio.processes.ends import Cancelled, Failed, Gone
from arcless.studio.processes.worker import Worker
from arcless.studio.processes.worker_process import LAST_S
from tests.support import studio_tasks as tasks
from tests.support.studio_server import is_there

# A worker starts in a tenth of a second; on a busy machine in ten.
PATIENCE_S = 60.0
# Time in s that a busy machine may take for what is promised, besides.
SLACK_S = 2.0


@pytest.fixture
def worker() -> Iterator[Worker]:
    found = Worker()
    yield found
    found.leave(0.0)
    found.process.wait(PATIENCE_S)


class Said(list[Any]):
    """Words of a task, and a wait for the first one."""

    def wait(self) -> None:
        end = time.monotonic() + PATIENCE_S
        while not self:
            assert time.monotonic() < end
            time.sleep(0.01)


def result(end: "Future[Any]") -> Any:
    return end.result(PATIENCE_S)


def test_tasks_are_done_one_after_the_other_by_one_process(worker: Worker) -> None:
    ends = [worker.do(tasks.add, number, 1) for number in range(50)]
    assert [result(end) for end in ends] == list(range(1, 51))
    assert result(worker.do(tasks.process)) == worker.process.pid
    assert worker.process.pid != os.getpid()


def test_what_is_said_comes_in_order_and_before_the_end(worker: Worker) -> None:
    said = Said()
    end = worker.do(tasks.echo, heard=said.append)
    for number in range(1000):
        worker.tell(number)
    worker.tell("end")
    assert result(end) == 1000
    assert said == list(range(1000))


def test_orders_are_of_the_task_that_runs(worker: Worker) -> None:
    first, said = worker.do(tasks.echo), Said()
    worker.tell("end")
    assert result(first) == 0
    second = worker.do(tasks.echo, heard=said.append)
    worker.tell("own")
    worker.tell("end")
    assert (result(second), said) == (1, ["own"])


@pytest.mark.parametrize(
    ("task", "kind", "words"),
    [
        (tasks.refuse, ModelError, "speed: got -1, expected a speed above 0"),
        (tasks.fail, Failed, "internal fault: RuntimeError: no idea; hint: please report it"),
        (tasks.no_memory, Failed, "not enough memory; hint: record less"),
        (tasks.missing, Failed, "/missing: No such file or directory"),
        (tasks.strange, Failed, "does not pickle"),
    ],
)
def test_what_is_raised_is_a_complaint_and_the_process_goes_on(
    worker: Worker, task: Any, kind: type[Exception], words: str
) -> None:
    error = worker.do(task).exception(PATIENCE_S)
    assert type(error) is kind
    assert isinstance(error, ModelError | Failed)
    assert words in str(error)
    assert complaint(error)["text"] == str(error)
    assert result(worker.do(tasks.add, 1, 1)) == 2
    assert worker.runs


def test_what_does_not_pickle_is_refused_and_the_next_task_has_its_own_answer(
    worker: Worker,
) -> None:
    with pytest.raises((pickle.PicklingError, AttributeError)):
        worker.do(lambda _: 3)
    assert result(worker.do(tasks.add, 1, 1)) == 2


def test_a_killed_one_says_why_for_all_its_tasks(worker: Worker) -> None:
    said = Said()
    ends = [worker.do(tasks.wait, heard=said.append), worker.do(tasks.add, 1, 1)]
    said.wait()
    worker.process.kill()
    for end in [*ends, worker.do(tasks.add, 1, 1)]:
        error = end.exception(PATIENCE_S)
        assert isinstance(error, Gone)
        assert "it was killed" in error.what
    assert not worker.runs


def test_one_that_leaves_the_interpreter_says_its_code(worker: Worker) -> None:
    error = worker.do(tasks.leave, 7).exception(PATIENCE_S)
    assert isinstance(error, Gone)
    assert "it ended with code 7" in str(error)


def test_cancelled_by_itself(worker: Worker) -> None:
    said = Said()
    end = worker.do(tasks.wait, heard=said.append)
    said.wait()
    worker.cancel(PATIENCE_S)
    assert isinstance(end.exception(PATIENCE_S), Cancelled)
    assert result(worker.do(tasks.add, 1, 1)) == 2  # nor is the next one cancelled


def test_cancelled_by_force(worker: Worker) -> None:
    said = Said()
    end = worker.do(tasks.deaf, heard=said.append)
    said.wait()
    since = time.monotonic()
    worker.cancel(0.3)
    assert isinstance(end.exception(PATIENCE_S), Cancelled)
    assert 0.3 <= time.monotonic() - since < 0.3 + SLACK_S


def test_a_cancelled_one_that_has_ended_is_not_killed_later(worker: Worker) -> None:
    said = Said()
    end = worker.do(tasks.wait, heard=said.append)
    said.wait()
    worker.cancel(0.2)
    assert isinstance(end.exception(PATIENCE_S), Cancelled)
    time.sleep(0.4)
    assert result(worker.do(tasks.add, 1, 1)) == 2


@pytest.mark.parametrize(("task", "within_s"), [(tasks.wait, PATIENCE_S), (tasks.deaf, 0.3)])
def test_it_leaves_whatever_it_does(worker: Worker, task: Any, within_s: float) -> None:
    said = Said()
    end = worker.do(task, heard=said.append)
    said.wait()
    since = time.monotonic()
    worker.leave(within_s)
    assert not worker.runs
    assert isinstance(end.exception(PATIENCE_S), Cancelled)
    assert time.monotonic() - since < LAST_S + SLACK_S


def test_a_stopped_one_that_is_told_much_leaves_too(worker: Worker) -> None:
    said = Said()
    end = worker.do(tasks.wait, heard=said.append)
    said.wait()
    worker.process.send_signal(signal.SIGSTOP)
    flood = threading.Thread(target=lambda: deque(map(worker.tell, range(100_000)), 0))
    flood.start()
    time.sleep(0.2)  # the line is full, and the thread waits
    worker.leave(0.1)
    assert isinstance(end.exception(PATIENCE_S), Cancelled)
    flood.join(PATIENCE_S)
    assert not flood.is_alive()


def test_what_hears_slowly_holds_up_the_one_that_speaks(worker: Worker) -> None:
    """Words are not kept in the memory of the server."""
    heard: list[int] = []

    def slow(said: bytes) -> None:
        time.sleep(0.05)
        heard.append(len(said))

    end = worker.do(tasks.speak, 10, 1_000_000, heard=slow)
    begun_s, done_s = result(end)
    assert heard == [1_000_000] * 10
    assert done_s - begun_s > 0.3  # all but the last words, which are on the line


def test_who_does_not_want_to_hear_ends_it(worker: Worker) -> None:
    def deaf(_: Any) -> None:
        raise ConnectionError("nobody listens")

    assert isinstance(worker.do(tasks.wait, heard=deaf).exception(PATIENCE_S), Gone)


def test_memory_is_that_of_the_process(worker: Worker) -> None:
    held = bytearray(b"x") * 400_000_000
    result(worker.do(tasks.add, 1, 1))
    small = worker.used
    result(worker.do(tasks.hold_memory, 300_000_000))
    assert 1_000_000 < small < len(held)
    assert worker.used - small > 250_000_000


@pytest.mark.parametrize("task", ["nothing", "wait", "deaf", "chatter"])  # at the first it starts
@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_the_server_is_gone(task: str, number: int, tmp_path: Path) -> None:
    """By Ctrl-C, which a terminal sends to the whole group, or killed: no traceback, no orphan."""
    noise = tmp_path / "noise"
    with noise.open("wb") as to:
        server = subprocess.Popen(
            [sys.executable, "-m", "tests.support.studio_worker", task],
            stdout=subprocess.PIPE, stderr=to, text=True, start_new_session=True,
        )  # fmt: skip
        assert server.stdout is not None
        process = int(server.stdout.readline())
        os.killpg(server.pid, number)
        server.wait(PATIENCE_S)
    gone = time.monotonic()
    while is_there(process) and time.monotonic() < gone + PATIENCE_S:
        time.sleep(0.02)
    assert time.monotonic() - gone < LAST_S + SLACK_S
    assert noise.read_bytes() == b""
