"""Deliberate faults in Python: one function, or one list it makes, is not what it should be."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager
from importlib import import_module
from typing import Any
from unittest.mock import patch

from arcless.simulate.recording import record
from tests.support.faults import spoiled


def _called_through(
    owner: Any, name: str, through: Callable[..., Any]
) -> AbstractContextManager[None]:
    """Call a function of a module, or of what is named like one, through another one.

    Raises
    ------
    AttributeError
        At once, when tests are collected: there is no such function. A slow fault would only be
        missed by `make evidence`.
    RuntimeError
        The function was not called meanwhile: the fault was never put in.
    """
    owner = import_module(owner) if isinstance(owner, str) else owner
    sound = getattr(owner, name)

    @contextmanager
    def put_in() -> Iterator[None]:
        called = []

        def call(*arguments: Any, **named: Any) -> Any:
            called.append(name)
            return through(sound, *arguments, **named)

        try:
            with patch.object(owner, name, call):
                yield
        finally:
            if not called:
                raise RuntimeError(f"{name} was not called: the fault was never put in")

    return put_in()


def wrong(owner: Any, name: str, spoil: Callable[[Any], Any]) -> AbstractContextManager[None]:
    """Let `spoil` change what a function of a module or class gives back."""
    return _called_through(owner, name, lambda sound, *given, **more: spoil(sound(*given, **more)))


def misled(
    owner: Any, name: str, spoil: Callable[..., Iterable[Any]]
) -> AbstractContextManager[None]:
    """Let `spoil` change the positional arguments of a function of a module or class."""
    return _called_through(owner, name, lambda sound, *given, **more: sound(*spoil(*given), **more))


def press_late(owner: Any) -> AbstractContextManager[None]:
    """Let `tests.support.pushing.press` push half a step behind the place asked for."""

    def late(line: Any, force: Any, positions: Any, speed: float, step: float) -> tuple[Any, ...]:
        return line, force, positions - 0.5 * speed * step, speed, step

    return misled(owner, "press", late)


def not_booked(term: str, share: float = 1.0) -> AbstractContextManager[None]:
    """Leave a term of the energies out of the record, or a share of it."""

    def spoil(found: dict[str, Any]) -> dict[str, Any]:
        if not found[term].any():
            raise RuntimeError(f"{term}: there is nothing to leave out")
        return found | {term: (1.0 - share) * found[term]}

    return wrong(record, "dynamic_variables", spoil)


@contextmanager
def tension(factor: float = 1.0, *, more: float = 0.0) -> Iterator[None]:
    """Change the tension asked for, of all wires and of what pulls at their ends: × factor + N."""

    def spoil(arguments: dict[str, Any]) -> None:
        pulls = {"wires": "design_tension", "segments": "design_tension", "ends": "force"}
        for kind, column in pulls.items():
            table = arguments["parts"][kind]
            table[column] = factor * table[column] + more

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
