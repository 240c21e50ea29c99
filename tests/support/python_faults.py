"""Deliberate faults in Python: one function, or one list it makes, is not what it should be."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any
from unittest.mock import patch

from tests.support.faults import COLUMNS, spoiled


@contextmanager
def wrong(owner: Any, name: str, spoil: Callable[[Any], Any]) -> Iterator[None]:
    """Let `spoil` change what a function of a module or class gives back.

    Raises
    ------
    RuntimeError
        The function was not called meanwhile: the fault was never put in.
    """
    sound = getattr(owner, name)
    called = []

    def spoiled(*arguments: Any, **named: Any) -> Any:
        called.append(name)
        return spoil(sound(*arguments, **named))

    try:
        with patch.object(owner, name, spoiled):
            yield
    finally:
        if not called:
            raise RuntimeError(f"{name} was not called: the fault was never put in")


@contextmanager
def tension(factor: float = 1.0, *, more: float = 0.0) -> Iterator[None]:
    """Change the tension asked for, of all wires and of what pulls at their ends: × factor + N."""

    def spoil(arguments: dict[str, Any]) -> None:
        for kind, column in (("wires", "tension"), ("segments", "tension"), ("ends", "force")):
            table = arguments["parts"][kind][1]
            place = COLUMNS[kind].index(column)
            table[:, place] = factor * table[:, place] + more

    with spoiled(spoil):
        yield


@contextmanager
def set_gravity(value: float) -> Iterator[None]:
    """Let another gravity act, in m/s²."""

    def spoil(arguments: dict[str, Any]) -> None:
        assert arguments["gravity"] != value, "nothing to spoil"
        arguments["gravity"] = value

    with spoiled(spoil):
        yield
