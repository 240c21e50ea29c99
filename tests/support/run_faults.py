"""Deliberate faults of a run: what goes to the core when a line is prepared and run upon."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from copy import deepcopy
from typing import Any
from unittest.mock import patch

from arcless.equilibrium import equilibrium
from tests.support.schemes import Member

PREPARED = ("lanes", "scheme", "step", "contact_stiffness", "updated", "corrected")
RUN = (
    "riders", "distances", "positions", "speeds", "friction", "loads", "plan", "observe",
    "state", "until",
)  # fmt: skip
# Where `arcless.simulate.setup.pantographs.RiderData` keeps its matrices.
RIDER = {"mass": 0, "damping": 1, "stiffness": 2}
START_FORCE = 6
# False where there was nothing to spoil.
Spoil = Callable[[dict[str, Any]], bool | None]


class _Watched:
    """Something of the core whose methods are called through others."""

    def __init__(self, core: Any, **methods: Callable[..., Any]) -> None:
        self._core, self._methods = core, methods

    def __getattr__(self, name: str) -> Any:
        return self._methods.get(name) or getattr(self._core, name)


@contextmanager
def spoiled(*, preparing: Spoil | None = None, running: Spoil | None = None) -> Iterator[None]:
    """Let functions change the arguments of every `prepare` (PREPARED) and `run` (RUN).

    Raises
    ------
    RuntimeError
        Nothing was spoiled meanwhile: the fault was never put in.
    """
    core = equilibrium._core
    spoilt: list[Spoil] = []

    def changed(names: tuple[str, ...], values: tuple[Any, ...], spoil: Spoil | None) -> list[Any]:
        named = dict(zip(names[: len(values)], values, strict=True))
        if spoil is not None:
            # Matrices and plans are used again; who watches stays who it is.
            named |= deepcopy({name: value for name, value in named.items() if name != "observe"})
            if spoil(named) is not False:
                spoilt.append(spoil)
        return list(named.values())

    def build(*arguments: Any, **named: Any) -> Any:
        found = core.Equilibrium(*arguments, **named)

        def prepare(*arguments: Any) -> Any:
            prepared = found.prepare(*changed(PREPARED, arguments, preparing))

            def run(*arguments: Any) -> Any:
                return prepared.run(*changed(RUN, arguments, running))

            return _Watched(prepared, run=run)

        return _Watched(found, prepare=prepare)

    try:
        with patch.object(equilibrium, "_core", _Watched(core, Equilibrium=build)):
            yield
    finally:
        if not spoilt:  # a failure that has nothing to do with the fault is no notice
            raise RuntimeError("the fault was never put in")


@contextmanager
def rider_scaled(matrix: str, factor: float) -> Iterator[None]:
    """Multiply the mass, damping or stiffness matrix of every rider."""

    def spoil(arguments: dict[str, Any]) -> bool:
        before = arguments["riders"]
        arguments["riders"] = [
            tuple(
                [factor * value for value in part] if number == RIDER[matrix] else part
                for number, part in enumerate(rider)
            )
            for rider in before
        ]
        return bool(arguments["riders"] != before)

    with spoiled(running=spoil):
        yield


@contextmanager
def start_force(factor: float) -> Iterator[None]:
    """Multiply the contact force at the start, which the preload of every rider follows from."""

    def spoil(arguments: dict[str, Any]) -> None:
        arguments["riders"] = [
            (*rider[:START_FORCE], factor * rider[START_FORCE], *rider[START_FORCE + 1 :])
            for rider in arguments["riders"]
        ]

    with spoiled(running=spoil):
        yield


@contextmanager
def prepared_with(**changes: Any) -> Iterator[None]:
    """Prepare every line with another scheme, step or contact stiffness: functions of the old."""

    def spoil(arguments: dict[str, Any]) -> bool:
        before = dict(arguments)
        arguments |= {name: change(before[name]) for name, change in changes.items()}
        return arguments != before

    with spoiled(preparing=spoil):
        yield


def contact_scaled(factor: float) -> AbstractContextManager[None]:
    """Multiply the stiffness of every contact."""
    return prepared_with(contact_stiffness=lambda stiffness: factor * stiffness)


def stepped_by(member: Member) -> AbstractContextManager[None]:
    """Step by one scheme, whatever is asked for."""
    return prepared_with(scheme=lambda _: (member.name, list(member.numbers)))
