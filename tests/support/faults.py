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
from arcless.validate.evidence import Noticed
from tests.support.evidence import Evidence, OutsideError

# Float columns of the tables in `arcless.mesh.tables.mesh_types.Mesh`.
COLUMNS = {
    "wires": ("length", "EA", "EI", "mass", "alpha", "beta", "tension"),
    "segments": ("length", "EA", "mass", "alpha", "beta", "tension"),
    "bends": ("EI", "beta"),
    "links": ("length", "stiffness", "damping", "alpha", "beta", "mass"),
    "springs": ("stiffness", "damping", "rest"),
    "masses": ("mass", "alpha"),
    "ends": ("force",),
    "loads": ("force",),
    "wire_loads": ("along", "across", "up"),
    "turns": ("turn",),
}
# False where there was nothing to spoil.
Spoil = Callable[[dict[str, Any]], bool | None]
# A context manager that is a decorator too, and so can be entered again: those of `contextmanager`
# and of `unittest.mock.patch` are.
Broken = Callable[[Callable[[], Noticed]], Callable[[], Noticed]]


class Fault:
    """One thing broken and a check that must notice it: a line of FAULTS in a verification file.

    `broken` is one context manager or several, entered in this order. Arguments of the check are
    `given`; those that are not are fixtures. A slow fault is left to `make evidence`.
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

    def noticed(self, fixture: Callable[[str], Any]) -> Noticed:
        """Break it, and return what the check says.

        Raises
        ------
        AssertionError
            The check notices nothing.
        """
        known = {"evidence": Evidence(), **self.given}
        wanted = signature(self.check).parameters
        arguments = {name: known[name] if name in known else fixture(name) for name in wanted}

        def notice() -> Noticed:
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
            return Noticed(self.what, *found, name, self.slow)

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

    def build(dim: int, *arguments: Any, **options: bool) -> Any:
        named = dict(zip(("positions", "slopes", "parts", "gravity"), arguments, strict=True))
        named = deepcopy(named) | options  # a mesh is used again
        if spoil(named) is not False:
            built.append(dim)
        return core.Equilibrium(dim, **named)

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
    """Multiply a column of a table of parts, in all rows or in some."""

    def spoil(arguments: dict[str, Any]) -> bool:
        # Wires are cubic elements or chains.
        is_chain = kind == "wires" and not len(arguments["parts"]["wires"][0])
        own = "segments" if is_chain else kind
        table, place = arguments["parts"][own][1], COLUMNS[own].index(column)
        before = table[rows, place].copy()
        table[rows, place] *= factor
        return bool(np.any(table[rows, place] != before))

    with spoiled(spoil):
        yield


@contextmanager
def curve_as_a_load() -> Iterator[None]:
    """Let curves pull by the tension of the drawing, on wires that stretch as they seem to bend."""

    def spoil(arguments: dict[str, Any]) -> bool:
        parts = arguments["parts"]
        kind = "wires" if len(parts["wires"][0]) else "segments"
        floats, (rows, turns) = parts[kind][1], parts["turns"]
        if not turns.any():
            return False
        load = np.zeros((len(floats), 3))
        load[:, 1] = floats[:, COLUMNS[kind].index("tension")] * turns[:, 0] / floats[:, 0]
        parts["wire_loads"] = (rows, load)
        parts["turns"] = (rows, np.zeros_like(turns))
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
