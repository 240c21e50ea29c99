"""Groups of waiting members of a batch that share a line; it is made once."""

import copy
import threading
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

from arcless.errors import ArclessError
from arcless.model import Scenario
from arcless.simulate.runs.job import Line, ready_line


@dataclass(frozen=True, slots=True)
class Member:
    """A scenario with its place in the batch, and its fingerprint where one is needed."""

    index: int
    scenario: Scenario
    key: str


@dataclass
class Group:
    """Members that share a line; the first one that needs it makes it, for all."""

    waiting: deque[Member] = field(default_factory=deque)
    at_work: int = 0
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _line: Line | None = None
    _error: ArclessError | None = None
    _beside: tuple[str, Line] | None = None

    def line(self, scenario: Scenario) -> Line:
        """Return the line of the group.

        Raises
        ------
        MeshError, EquilibriumError
            As `arcless.run`; the same for every member.
        """
        with self._lock:
            if self._error is not None:
                raise copy.copy(self._error)
            if self._line is None:
                try:
                    self._line = ready_line(scenario, lambda _fraction, _text: None)
                except ArclessError as error:
                    self._error = error
                    raise
            return self._line

    def beside(self, key: str, scenario: Scenario) -> Line:
        """Return the line of an additional run next to members; the last one is kept.

        Raises
        ------
        MeshError, EquilibriumError
            As `arcless.run`.
        """
        with self._lock:
            if self._beside is None or self._beside[0] != key:
                self._beside = key, ready_line(scenario, lambda _fraction, _text: None)
            return self._beside[1]


class Groups:
    """All members that wait.

    A line that nobody waits for or runs on is released, except the last one: so members that come
    one at a time share it, too.
    """

    def __init__(self, shared_key: Callable[[Scenario], str]) -> None:
        self._shared_key = shared_key
        self._groups: dict[str, Group] = {}
        self._change = threading.Condition()
        self._closed = False

    def put(self, member: Member, line: Line | None = None) -> None:
        """Let a member wait; with its line, where that is there already."""
        key = self._shared_key(member.scenario)
        with self._change:
            self._groups.setdefault(key, Group(_line=line)).waiting.append(member)
            self._change.notify()

    def close(self) -> None:
        """Say that no more members come."""
        with self._change:
            self._closed = True
            self._change.notify_all()

    def empty(self) -> None:
        """Take away all members that wait, and say that no more come."""
        with self._change:
            for group in self._groups.values():
                group.waiting.clear()
        self.close()

    def choose(self) -> Group | None:
        """Return the group to work for next, waiting for one; None when all is done.

        A worker that is given one calls `leave` when it does no more for it. Lines that nobody has
        begun come first: two workers on one line would wait for each other while it is made.
        """
        with self._change:
            while True:
                waiting = [group for group in self._groups.values() if group.waiting]
                if waiting:
                    group = min(waiting, key=lambda each: each.at_work)
                    group.at_work += 1
                    return group
                if self._closed:
                    return None
                self._change.wait()

    def next_of(self, group: Group) -> Member | None:
        """Take a member of a group; None when none waits."""
        with self._change:
            return group.waiting.popleft() if group.waiting else None

    def leave(self, group: Group) -> None:
        """Stop working for a group."""
        with self._change:
            group.at_work -= 1
            idle = [
                k for k, g in self._groups.items() if not (g.waiting or g.at_work or g is group)
            ]
            for key in idle:
                del self._groups[key]
