"""Deliberate faults: context managers that spoil what goes to the core, one thing at a time."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager
from copy import deepcopy
from functools import partial
from inspect import signature
from typing import Any
from unittest.mock import patch

import numpy as np

from arcless.equilibrium import equilibrium
from arcless.mesh.tables.columns import COLUMNS
from arcless.validate.evidence import NoticedFault
from tests.support.evidence import Evidence, OutsideError

# Columns by the names that faults call them by.
SHORT = {
    "EA": "axial_stiffness", "EI": "bending_stiffness", "length": "rest_length",
    "tension": "design_tension", "damping": "viscosity",
}  # fmt: skip
# False where there was nothing to spoil.
Spoil = Callable[[dict[str, Any]], bool | None]
# A context manager that is a decorator too, and so can be entered again: those of `contextmanager`
# and of `unittest.mock.patch` are.
Broken = Callable[[Callable[[], NoticedFault]], Callable[[], NoticedFault]]


class Fault:
    """One thing broken and a check that must notice it: a line of FAULTS in a verification file.

    `broken` is one context manager or several, entered in this order. Arguments of the check are
    `given`; those that are not are fixtures. `make test` tries the first fault of a table that is
    not slow, `make evidence` all of them.
    """

    def __init__(
        self, what: str, broken: Broken | Iterable[Broken], check: Callable[..., None], *,
        slow: bool = False, **given: Any,
    ) -> None:  # fmt: skip
        self.what, self.check, self.slow, self.given = what, check, slow, given
        self.broken = (broken,) if callable(broken) else tuple(broken)

    @property
    def name(self) -> str:
        """Name of the test: the check and, in brackets, the fault and what else is said."""
        said = [value for value in self.given.values() if isinstance(value, str)]
        more = [value for value in said if value not in self.what]
        return f"{self.check.__name__}[{', '.join([self.what, *more])}]"

    def noticed(self, fixture: Callable[[str], Any]) -> NoticedFault:
        """Break it, and return what the check says.

        Raises
        ------
        AssertionError
            The check notices nothing.
        """
        known = {"evidence": Evidence(), **self.given}
        wanted = signature(self.check).parameters
        arguments = {name: known[name] if name in known else fixture(name) for name in wanted}

        def notice() -> NoticedFault:
            name = self.check.__name__
            try:
                self.check(**arguments)
            except OutsideError as error:
                row = error.row
                found = row.what, f"{row.value:.4g}; {row.allowed}"
            except AssertionError as error:
                found = name.replace("_", " "), str(error).strip().partition("\n")[0][:80]
            else:
                raise AssertionError(f"{name} does not notice: {self.what}")
            return NoticedFault(self.what, *found, self.name, self.slow)

        for broken in reversed(self.broken):
            # `patch` marks a function that it decorates; `partial` keeps that from the next one.
            notice = broken(partial(notice))
        return notice()


@contextmanager
def forgotten(*remembering: Any) -> Iterator[None]:
    """Let functions with a cache forget, so that no sound run is taken for a broken one."""
    for function in remembering:
        function.cache_clear()
    try:
        yield
    finally:
        for function in remembering:
            function.cache_clear()


@contextmanager
def kept(function: Callable[..., object], *arguments: Any) -> Iterator[None]:
    """Let a function with a cache answer before something is broken."""
    function(*arguments)
    yield


@contextmanager
def spoiled(spoil: Spoil) -> Iterator[None]:
    """Let `spoil` change what every `_core.Equilibrium` is given: `parts`, `gravity`, options, ….

    Raises
    ------
    RuntimeError
        Nothing was spoiled meanwhile: the fault was never put in.
    """
    core = equilibrium._core
    built: list[int] = []

    def build(**arguments: Any) -> Any:
        arguments = deepcopy(arguments)  # a mesh is used again
        if spoil(arguments) is not False:
            built.append(len(built))
        return core.Equilibrium(**arguments)

    class Spoiled:
        Equilibrium = staticmethod(build)

        def __getattr__(self, name: str) -> Any:
            return getattr(core, name)

    try:
        with patch.object(equilibrium, "_core", Spoiled()):
            yield
    finally:
        if not built:  # a failure that has nothing to do with the fault is no notice
            raise RuntimeError("the fault was never put in")


@contextmanager
def without(option: str) -> Iterator[None]:
    """Take an option from what asks for it: `fitted_bends`, `residual_flexibility`, …."""

    def spoil(arguments: dict[str, Any]) -> bool:
        before, arguments[option] = arguments[option], False
        return bool(before)

    with spoiled(spoil):
        yield


@contextmanager
def scaled(
    kind: str, column: str, factor: float, rows: slice | list[int] = slice(None)
) -> Iterator[None]:
    """Multiply a column of a table (see `arcless.mesh.tables.columns`), in all rows or in some."""

    def spoil(arguments: dict[str, Any]) -> bool:
        # Wires are cubic elements or chains.
        is_chain = kind == "wires" and not len(arguments["parts"]["wires"])
        own = "segments" if is_chain else kind
        values = arguments["parts"][own][SHORT.get(column, column)]
        before = values.copy()
        values[rows] *= factor
        return bool(np.any(values != before))

    with spoiled(spoil):
        yield


@contextmanager
def curve_as_a_load() -> Iterator[None]:
    """Let curves pull by the tension of the drawing, on wires that stretch as they seem to bend."""

    def spoil(arguments: dict[str, Any]) -> bool:
        parts = arguments["parts"]
        elements = parts["wires"] if len(parts["wires"]) else parts["segments"]
        angles = parts["turns"]["angle"]
        if not angles.any():
            return False
        parts["wire_loads"] = np.zeros(len(elements), COLUMNS["wire_loads"])
        pull = elements["design_tension"] * angles / elements["rest_length"]
        parts["wire_loads"]["force"][:, 1] = pull
        parts["turns"] = np.zeros_like(parts["turns"])
        return True

    with spoiled(spoil):
        yield


@contextmanager
def gravity(factor: float) -> Iterator[None]:
    """Multiply gravity: -1 turns it round."""

    def spoil(arguments: dict[str, Any]) -> bool:
        arguments["gravity"] *= factor
        return bool(arguments["gravity"] != 0.0)

    with spoiled(spoil):
        yield


@contextmanager
def misbuilt(change: str, spoil: Callable[[Any], Any]) -> Iterator[None]:
    """Spoil one of the changes that make a designed line one as built (`mesh.alteration`)."""
    known = equilibrium.alteration
    changed = []

    def alteration(*arguments: Any) -> dict[str, Any]:
        changes = known(*arguments)
        before = np.array(changes[change])
        changes[change] = np.asarray(spoil(before.copy()))
        changed.append(np.any(changes[change] != before))
        if change != "load":
            changes[change] = changes[change].tolist()
        return changes

    with patch.object(equilibrium, "alteration", alteration):
        yield
    if not any(changed):
        raise RuntimeError("the fault was never put in")


def expansion(factor: float) -> AbstractContextManager[None]:
    """Multiply what heat adds to the length of wires."""
    return misbuilt("length_factor", lambda given: 1.0 + factor * (given - 1.0))
