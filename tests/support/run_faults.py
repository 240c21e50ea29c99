"""Deliberate faults of a run: what goes to the core when a line is prepared and run upon."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from copy import deepcopy
from typing import Any
from unittest.mock import patch

from arcless.equilibrium import equilibrium
from tests.support.schemes import Member

WATCHING = ("observe", "take")
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
    """Let functions change the arguments of every `prepare` and `run`.

    Raises
    ------
    RuntimeError
        Nothing was spoiled meanwhile: the fault was never put in.
    """
    core = equilibrium._core
    spoilt: list[Spoil] = []

    def changed(arguments: dict[str, Any], spoil: Spoil | None) -> dict[str, Any]:
        if spoil is not None:
            # Matrices and plans are used again; who watches stays who it is.
            own = {name: value for name, value in arguments.items() if name not in WATCHING}
            arguments |= deepcopy(own)
            if spoil(arguments) is not False:
                spoilt.append(spoil)
        return arguments

    def build(**arguments: Any) -> Any:
        found = core.Equilibrium(**arguments)

        def prepare(**arguments: Any) -> Any:
            model = found.prepare(**changed(arguments, preparing))

            def run(**arguments: Any) -> Any:
                return model.run(**changed(arguments, running))

            return _Watched(model, run=run)

        return _Watched(found, prepare=prepare)

    try:
        with patch.object(equilibrium, "_core", _Watched(core, Equilibrium=build)):
            yield
    finally:
        if not spoilt:  # a failure that has nothing to do with the fault is no notice
            raise RuntimeError("the fault was never put in")


@contextmanager
def pantograph_scaled(matrix: str, factor: float) -> Iterator[None]:
    """Multiply the mass, damping or stiffness matrix of every pantograph."""

    def spoil(arguments: dict[str, Any]) -> bool:
        before = arguments["pantographs"]
        arguments["pantographs"] = [
            one._replace(**{matrix: [factor * value for value in getattr(one, matrix)]})
            for one in before
        ]
        return bool(arguments["pantographs"] != before)

    with spoiled(running=spoil):
        yield


@contextmanager
def start_force(factor: float) -> Iterator[None]:
    """Multiply the contact force at the start, from which each preload follows."""

    def spoil(arguments: dict[str, Any]) -> None:
        arguments["pantographs"] = [
            one._replace(start_force=factor * one.start_force) for one in arguments["pantographs"]
        ]

    with spoiled(running=spoil):
        yield


@contextmanager
def last_behind(distance: float) -> Iterator[None]:
    """Let the last pantograph of two or more press so many metres behind where it stands."""

    def spoil(arguments: dict[str, Any]) -> bool:
        *others, last = arguments["pantographs"]
        strips = [strip._replace(offset=strip.offset + distance) for strip in last.strips]
        arguments["pantographs"] = [*others, last._replace(strips=strips)]
        return len(others) > 0

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
