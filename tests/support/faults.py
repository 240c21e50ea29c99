"""Deliberate faults: context managers that spoil what goes to the core, one thing at a time."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from copy import deepcopy
from typing import Any
from unittest.mock import patch

import numpy as np

from arcless.equilibrium import equilibrium

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
def plain_chains() -> Iterator[None]:
    """Take from chains what makes their points, and what is between them, yield like the wire."""

    def spoil(arguments: dict[str, Any]) -> bool:
        before, arguments["fitted_bends"] = arguments["fitted_bends"], False
        return bool(before)

    with spoiled(spoil):
        yield


@contextmanager
def unflexible() -> Iterator[None]:
    """Leave residual flexibility out."""

    def spoil(arguments: dict[str, Any]) -> bool:
        before, arguments["residual_flexibility"] = arguments["residual_flexibility"], False
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
