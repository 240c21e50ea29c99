"""Processes that answer one page's questions about lines at rest, the newest first.

A question that has not begun when a newer one comes is dropped: nobody waits for it any more.
"""

import asyncio
import json
from functools import cache
from typing import TYPE_CHECKING, Any

from arcless.errors import ArclessError
from arcless.studio.answers.answers import Refused, complaint
from arcless.studio.at_rest.question import Question
from arcless.studio.processes import worker
from arcless.studio.processes.ends import Cancelled, Failed
from arcless.studio.processes.talk import Talk

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
        self.process: worker.Worker | None = None

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
                return await self._answer(question)
            finally:
                self.is_at_slow_one = False

    def close(self) -> None:
        """End the process."""
        if self.process is not None:
            self.process.leave(LAST_ANSWER)

    async def _answer(self, question: Question) -> Answer:
        if self.process is None or not self.process.runs:
            self.process = worker.Worker()
        try:
            answer: Answer = await asyncio.wrap_future(self.process.do(answered, question))
        except (Failed, Cancelled):
            raise Refused(500, "The process that computes lines at rest broke down") from None
        return answer


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


@cache
def _bench() -> "Bench":
    """Return the bench of this process."""
    from arcless.studio.at_rest.bench import Bench

    return Bench()


def answered(_talk: Talk, question: Question) -> Answer:
    """Return the answer as JSON, or what is wrong with the model."""
    value: Any
    try:
        value = _bench().answer(question)
    except ArclessError as error:
        # An answer as well: half of what is typed is no line yet.
        value = {"question": question.number, "errors": [complaint(error)]}
    return json.dumps(value, allow_nan=False, ensure_ascii=False).encode()
