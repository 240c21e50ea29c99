"""Processes that answer one page's questions about lines at rest, the newest first.

A question that has not begun when a newer one comes is dropped: nobody waits for it any more.
"""

import asyncio
import json
import signal
from contextlib import suppress
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from typing import TYPE_CHECKING, Any

from anyio import CapacityLimiter
from anyio.to_thread import run_sync

from arcless.errors import ArclessError
from arcless.studio.answers.answers import Refused, complaint
from arcless.studio.at_rest.question import Question

if TYPE_CHECKING:
    from arcless.studio.at_rest.bench import Bench

# JSON as bytes, ready to be sent.
Answer = bytes
# Of a question that was dropped. No refusal: it happens with every move of a slider.
DROPPED: Answer = b'{"dropped": true, "errors": []}'
# Time that a process may take to end by itself, in s. Longer, and the server ends late; shorter,
# and one in the middle of a line is ended by force, which loses nothing but an answer.
LAST_ANSWER = 0.2


class Worker:
    """A process, started with the first question, and again where it broke down."""

    def __init__(self) -> None:
        self._turn = asyncio.Lock()
        self._newest = 0
        self.is_at_slow_one = False
        self._line: Connection | None = None
        self._process: SpawnProcess | None = None
        # A thread of its own waits for the answer: other questions do not take its place.
        self._waiting = CapacityLimiter(1)

    @property
    def is_free(self) -> bool:
        """True where a question would begin at once."""
        return not self._turn.locked()

    async def ask(self, question: Question) -> Answer:
        """Return the answer to a question; see `Desk.ask`."""
        self._newest += 1
        mine = self._newest
        async with self._turn:
            if mine != self._newest:
                return DROPPED
            self.is_at_slow_one = question.is_slow
            try:
                return await run_sync(self._exchange, question, limiter=self._waiting)
            finally:
                self.is_at_slow_one = False

    def close(self) -> None:
        """End the process."""
        line, process, self._line, self._process = self._line, self._process, None, None
        if line is not None:
            line.close()
        if process is not None:
            process.join(LAST_ANSWER)
            process.kill()

    def _exchange(self, question: Question) -> Answer:
        line = self._line or self._started()
        try:
            line.send(question)
            answer: Answer = line.recv()
        except (EOFError, OSError):
            self.close()
            raise Refused(500, "The process that computes lines at rest broke down") from None
        return answer

    def _started(self) -> Connection:
        # A new interpreter: a fork of a server with threads may hang.
        context = get_context("spawn")
        self._line, other = context.Pipe()
        process = context.Process(target=serve, args=(other,), daemon=True)
        process.start()
        other.close()
        self._process = process
        return self._line


class Desk:
    """Two processes for a page: what follows a slider takes turns, and never waits for a slow one.

    A line in space of 20 spans takes 0.1 s: one process follows a slider 7 to 10 times a second,
    two almost twice as often.
    """

    def __init__(self) -> None:
        self._first, self._second = Worker(), Worker()

    async def ask(self, question: Question) -> Answer:
        """Return the answer to a question, `DROPPED` where a newer one came before it began.

        Raises
        ------
        Refused
            The process broke down.
        """
        return await self._worker(question).ask(question)

    def _worker(self, question: Question) -> Worker:
        if question.is_slow:
            return self._second
        is_other_better = not self._first.is_free and not self._second.is_at_slow_one
        return self._second if is_other_better else self._first

    def close(self) -> None:
        """End both processes."""
        self._first.close()
        self._second.close()


def serve(line: Connection) -> None:
    """Answer the questions that come, until the other end is closed."""
    from arcless.studio.at_rest.bench import Bench

    # Ctrl-C in a terminal goes to all processes; the server ends this one.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    bench = Bench()
    with suppress(EOFError, OSError):
        while True:
            line.send(answered(bench, line.recv()))


def answered(bench: "Bench", question: Question) -> Answer:
    """Return the answer of a bench as JSON, or what is wrong with the model."""
    value: Any
    try:
        value = bench.answer(question)
    except ArclessError as error:
        # An answer as well: half of what is typed is no line yet.
        value = {"question": question.number, "errors": [complaint(error)]}
    return json.dumps(value, allow_nan=False, ensure_ascii=False).encode()
