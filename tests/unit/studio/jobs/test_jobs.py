"""Jobs in worker processes: done, refused, crashed, cancelled, waiting; nothing stays behind."""

import asyncio
import itertools
import signal
import time
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.studio.answers.answers import Refused
from arcless.studio.jobs import pool
from arcless.studio.jobs.entry import Entry
from arcless.studio.jobs.job import Job, Task
from arcless.studio.jobs.jobs import BETWEEN_S, CANCEL_S, Jobs
from tests.support import studio_tasks as tasks

# A worker starts in a second; on a busy machine in ten.
PATIENCE_S = 60.0


class Heard(list[dict[str, Any]]):
    """Messages about jobs, and when they came."""

    def __init__(self) -> None:
        super().__init__()
        self.times: list[float] = []

    def __call__(self, message: dict[str, Any]) -> None:
        assert message["topic"] == "job"
        self.append(message["job"])
        self.times.append(time.monotonic())


def with_jobs(act: Callable[[Jobs, Heard], Awaitable[Any]], most: int | None = None) -> Any:
    async def whole() -> Any:
        heard = Heard()
        jobs = Jobs(heard, most)
        async with jobs.at_work():
            return await asyncio.wait_for(act(jobs, heard), PATIENCE_S)

    return asyncio.run(whole())


async def ended(jobs: Jobs, job: Job) -> Job:
    entry = jobs.entry(job.id)
    await asyncio.wait([entry.end])
    return job


async def begun(jobs: Jobs, job: Job) -> Entry:
    """Wait until the function of a job runs and has told something."""
    while not job.doing:
        await asyncio.sleep(0.01)
    return jobs.entry(job.id)


def run(function: Callable[..., Any], *arguments: Any, **of_task: Any) -> Job:
    async def act(jobs: Jobs, _: Heard) -> Job:
        return await ended(jobs, jobs.start("run", "a job", Task(function, arguments, **of_task)))

    job: Job = with_jobs(act)
    return job


def test_what_a_function_returns() -> None:
    job = run(tasks.add, 1, 2)
    assert (job.state, job.fraction, job.outcome, job.error) == ("done", 1.0, 3, None)


def test_what_a_function_tells() -> None:
    async def act(jobs: Jobs, heard: Heard) -> tuple[Job, Heard]:
        job = jobs.start("run", "talks", Task(tasks.tell, (100_000,)))
        return await ended(jobs, job), heard

    job, heard = with_jobs(act)
    assert job.notes == ["A warning."]
    assert [heard[0]["state"], heard[1]["state"], heard[-1]["state"]] == [
        "waiting", "running", "done",
    ]  # fmt: skip
    running = [at for one, at in zip(heard, heard.times, strict=True) if one["doing"]]
    # Timers come a little early or late by the clock of the event loop.
    gaps = [late - early for early, late in itertools.pairwise(running)]
    assert all(gap > 0.8 * BETWEEN_S for gap in gaps[:-1])


FAILURES: list[tuple[Callable[..., Any], tuple[Any, ...], str]] = [
    (tasks.refuse, (), "speed: got -1, expected a speed above 0"),
    (tasks.fail, (), "internal fault: RuntimeError: no idea"),
    (tasks.no_memory, (), "not enough memory"),
    (tasks.strange, (), "does not pickle"),
    (tasks.kill, (signal.SIGKILL,), "it was killed"),
    (tasks.kill, (signal.SIGSEGV,), "it crashed (segmentation fault)"),
]


def test_failures_are_sentences() -> None:
    async def act(jobs: Jobs, _: Heard) -> list[Job]:
        begun = [jobs.start("run", "fails", Task(one, given)) for one, given, _ in FAILURES]
        return [await ended(jobs, job) for job in begun]

    failed = with_jobs(act)
    for job, (_, _, words) in zip(failed, FAILURES, strict=True):
        assert (job.state, job.path) == ("failed", None)
        assert words in (job.error or {})["text"]
    assert (failed[0].error["what"], failed[0].error["expected"]) == ("speed", "a speed above 0")


def test_a_crash_stops_no_other_job() -> None:
    async def act(jobs: Jobs, _: Heard) -> list[str]:
        crash = jobs.start("run", "crash", Task(tasks.kill, (signal.SIGKILL,)))
        good = jobs.start("run", "good", Task(tasks.add, (1, 1)))
        later = jobs.start("run", "later", Task(tasks.add, (1, 1)))
        return [(await ended(jobs, one)).state for one in (crash, good, later)]

    assert with_jobs(act, most=1) == ["failed", "done", "done"]


def test_cancelled() -> None:
    async def act(jobs: Jobs, _: Heard) -> tuple[Job, float]:
        job = jobs.start("run", "waits", Task(tasks.wait), path="runs/x")
        await begun(jobs, job)
        since = time.monotonic()
        jobs.cancel(job.id)
        await ended(jobs, job)
        return job, time.monotonic() - since

    job, took = with_jobs(act)
    assert (job.state, job.path, job.error) == ("cancelled", None, None)
    assert took < CANCEL_S


def test_one_that_is_deaf_is_killed_and_leaves_nothing(tmp_path: Path) -> None:
    async def act(jobs: Jobs, _: Heard) -> tuple[Job, float]:
        task = Task(tasks.hold, (tmp_path / "out",), folder=tmp_path / "out")
        job = jobs.start("run", "holds", task)
        await begun(jobs, job)
        assert list(tmp_path.iterdir())
        since = time.monotonic()
        jobs.cancel(job.id)
        await ended(jobs, job)
        return job, time.monotonic() - since

    job, took = with_jobs(act)
    assert job.state == "cancelled"
    assert took < 1.0  # the promise to the user
    assert not list(tmp_path.iterdir())


def test_a_killed_one_leaves_nothing(tmp_path: Path) -> None:
    async def act(jobs: Jobs, _: Heard) -> Job:
        task = Task(tasks.hold, (tmp_path / "out",), folder=tmp_path / "out")
        job = jobs.start("run", "holds", task)
        entry = await begun(jobs, job)
        assert entry.worker is not None
        entry.worker.process.kill()
        return await ended(jobs, job)

    assert with_jobs(act).state == "failed"
    assert not list(tmp_path.iterdir())


def test_the_end_of_the_server_ends_all(tmp_path: Path) -> None:
    async def act(jobs: Jobs, _: Heard) -> list[Any]:
        task = Task(tasks.hold, (tmp_path / "out",), folder=tmp_path / "out")
        entries = [await begun(jobs, jobs.start("run", "holds", task))]
        entries.append(await begun(jobs, jobs.start("run", "waits", Task(tasks.wait))))
        jobs.start("run", "never begins", Task(tasks.add, (1, 1)))
        return [one.worker.process for one in entries if one.worker]

    since = time.monotonic()
    processes = with_jobs(act, most=2)
    assert all(process.poll() is not None for process in processes)
    assert not list(tmp_path.iterdir())
    assert time.monotonic() - since < PATIENCE_S


def test_the_rest_waits_its_turn() -> None:
    async def act(jobs: Jobs, _: Heard) -> list[str]:
        first = jobs.start("run", "first", Task(tasks.wait))
        second = jobs.start("run", "second", Task(tasks.wait))
        third = jobs.start("run", "third", Task(tasks.add, (1, 1)))
        await begun(jobs, first)
        states = [first.state, second.state, third.state]
        jobs.cancel(second.id)
        states.append(second.state)
        jobs.cancel(first.id)
        await ended(jobs, third)
        return [*states, first.state, third.state]

    assert with_jobs(act, most=1) == [
        "running", "waiting", "waiting", "cancelled", "cancelled", "done",
    ]  # fmt: skip


def test_two_jobs_do_not_write_one_folder() -> None:
    async def act(jobs: Jobs, _: Heard) -> None:
        jobs.start("run", "one", Task(tasks.wait), path="runs/x")
        with pytest.raises(Refused, match="is being computed already"):
            jobs.start("run", "two", Task(tasks.wait), path="runs/x")

    with_jobs(act)


async def _processes(jobs: Jobs, _: Heard) -> list[int]:
    return [await jobs.compute(tasks.process) for _ in range(5)]


def test_processes_are_used_again() -> None:
    assert len(set(with_jobs(_processes))) == 1


def test_what_the_server_uses_does_not_count_for_its_processes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The highest memory that getrusage tells of a new process is that of the one it came from."""
    monkeypatch.setattr(pool, "_LARGE", 400_000_000)
    held = bytearray(b"x") * 500_000_000
    assert len(set(with_jobs(_processes))) == 1
    assert len(held) > 400_000_000


def test_questions_do_not_wait_for_jobs() -> None:
    async def act(jobs: Jobs, heard: Heard) -> None:
        jobs.start("run", "waits", Task(tasks.wait))
        assert await jobs.compute(tasks.add, 1, 2) == 3
        assert {one["title"] for one in heard} == {"waits"}
        with pytest.raises(ModelError, match="a speed above 0"):
            await jobs.compute(tasks.refuse)
        with pytest.raises(Refused, match="no idea"):
            await jobs.compute(tasks.fail)

    with_jobs(act, most=1)


def test_a_question_that_nobody_waits_for_is_cancelled() -> None:
    async def act(jobs: Jobs, _: Heard) -> int:
        # Both places for questions; were they not given back, the third would never begin.
        for _ in range(2):
            with pytest.raises(TimeoutError):
                await asyncio.wait_for(jobs.compute(tasks.wait), 0.05)
        found: int = await jobs.compute(tasks.add, 1, 2)
        return found

    assert with_jobs(act) == 3


def test_a_job_that_is_not_there() -> None:
    async def act(jobs: Jobs, _: Heard) -> None:
        with pytest.raises(Refused, match="no such job"):
            jobs.cancel("x")

    with_jobs(act)


@pytest.mark.parametrize("begin_again", [False, True])
def test_motion_reaches_the_server(begin_again: bool) -> None:
    async def act(jobs: Jobs, _: Heard) -> list[Any]:
        job = jobs.start("run", "moves", Task(tasks.move, (100, begin_again), shows=True))
        entry = jobs.entry(job.id)
        await entry.opened.wait()
        await ended(jobs, job)
        motion = entry.motion
        assert motion is not None
        assert (motion.final, motion.end_s) == (True, pytest.approx(99 * tasks.EVERY_S))
        return [(m[0].time_s, m[0].values[0]) for m in motion.moments(0.0, 9.0, 0.0)]

    assert with_jobs(act) == [(n * tasks.EVERY_S, n) for n in range(100)]


def test_without_motion_nobody_waits_for_it() -> None:
    async def act(jobs: Jobs, _: Heard) -> bool:
        job = jobs.start("run", "is still", Task(tasks.add, (1, 1), shows=True))
        await jobs.entry(job.id).opened.wait()
        return jobs.entry(job.id).motion is None

    assert with_jobs(act)
