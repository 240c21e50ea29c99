"""Findings at the border of the compiled module, called without the layers before it."""

import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from types import FrameType
from typing import Any

import numpy as np
import pytest

from arcless import _core
from arcless.equilibrium import equilibrium
from arcless.mesh.tables.columns import COLUMNS
from arcless.simulate.setup.core_data import (
    ActuatorData,
    BaseMotion,
    BumpStopData,
    CollectorData,
    Excitation,
    ForceHistory,
    LoadData,
    PantographData,
    PiecewiseForceData,
    RecordingWindow,
    RecordPlan,
    SessionStart,
    Stations,
    StripData,
)
from tests.support.small import small


@cache
def line() -> equilibrium.Equilibrium:
    return equilibrium.find(small(**{"solver.scheme": "generalised-alpha"}))


@pytest.mark.parametrize("count", [1001, 10**6, 2**63, 2**64 - 1])
def test_too_many_frequencies_are_refused(count: int) -> None:
    with pytest.raises(_core.NativeError, match="at most 1000"):
        line().core.frequencies(count)


def test_frequencies_can_be_interrupted() -> None:
    def stop(_number: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, stop)
    began = time.monotonic()
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    try:
        with pytest.raises(KeyboardInterrupt):
            line().core.frequencies(1000)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    assert time.monotonic() - began < 10.0


@pytest.mark.parametrize("step_s", [1e308, 1e100, 1e-200, 0.0, -1e-3, float("nan")])
def test_steps_that_no_line_takes_are_refused(step_s: float) -> None:
    scheme = ("trapezoidal", [])
    with pytest.raises(_core.NativeError, match="solver"):
        line().core.prepare(
            lanes=line().mesh.lanes, scheme=scheme, step=step_s, contact_stiffness=5e4,
            updated=False,
        )  # fmt: skip


def found(*, missing: str = "", **tables: Any) -> dict[str, Any]:
    """Bring the line to rest with some of its tables replaced, or one missing."""
    mesh = line().mesh
    parts: Any = {kind: table for kind, table in mesh.parts.items() if kind != missing} | tables
    core = _core.Equilibrium(
        dimension=mesh.dimension, positions=mesh.positions, slopes=mesh.slopes, parts=parts,
        gravity=mesh.gravity, design=True,
    )  # fmt: skip
    return core.arrays()


def table(kind: str, *columns: tuple[Any, ...]) -> Any:
    """Return a table of the line with columns of its own: name, type and width."""
    given = line().mesh.parts[kind]  # type: ignore[literal-required]
    made = np.zeros(len(given), np.dtype(list(columns), align=True))
    for name in made.dtype.names:
        made[name] = given[name]
    return made


def columns(kind: str, **other: tuple[Any, ...]) -> list[tuple[Any, ...]]:
    """Return names, types and widths of the columns of a table, some of them changed."""
    fields = COLUMNS[kind].fields or {}
    own = {name: (form.base, form.shape) for name, (form, *_) in fields.items()}
    return [(name, *form) for name, form in (own | other).items()]


def test_columns_are_found_by_their_names() -> None:
    expected = found()
    for kind in ("links", "springs", "struts", "wires"):
        turned_round = found(**{kind: table(kind, *reversed(columns(kind)))})
        for name, values in expected.items():
            np.testing.assert_array_equal(turned_round[name], values, err_msg=f"{kind}: {name}")


def test_a_table_or_a_column_that_is_not_there_is_refused() -> None:
    for kind, form in COLUMNS.items():
        with pytest.raises(ValueError, match=f"no table {kind}"):
            found(missing=kind)
        for name in form.names or ():
            # The name that a caller might take for it.
            other = [(f"{one}_" if one == name else one, *rest) for one, *rest in columns(kind)]
            with pytest.raises(ValueError, match=f"table {kind}: column {name}: there is none"):
                found(**{kind: np.zeros(3, np.dtype(other, align=True))})


@pytest.mark.parametrize(
    ("kind", "name", "form"),
    [
        ("links", "stiffness", (np.float32, ())),
        ("links", "stiffness", (np.int64, ())),
        ("links", "stiffness", (np.float64, (1,))),
        ("links", "unilateral", (np.int64, ())),
        ("links", "nodes", (np.int32, (2,))),
        ("links", "nodes", (np.float64, (2,))),
        ("springs", "node", (np.float64, ())),
        ("struts", "direction", (np.float64, (2,))),
        ("struts", "adjust", (np.float64, ())),
    ],
)
def test_other_numbers_in_a_column_are_refused(kind: str, name: str, form: Any) -> None:
    wrong = np.zeros(3, np.dtype(columns(kind, **{name: form}), align=True))
    with pytest.raises(ValueError, match=f"table {kind}: column {name}: expected"):
        found(**{kind: wrong})


def test_numbers_that_mean_nothing_are_refused() -> None:
    springs = line().mesh.parts["springs"].copy()
    springs["mode"][-1] = 3
    with pytest.raises(ValueError, match="table springs: column mode: expected 0, 1 or 2"):
        found(springs=springs)
    springs["mode"][-1], springs["node"][-1] = 0, -1
    with pytest.raises(ValueError, match="table springs: column node: a number is negative"):
        found(springs=springs)


@pytest.mark.parametrize(
    "wrong",
    [
        np.zeros((3, 6)),
        np.zeros((3, 2), COLUMNS["springs"]),
        np.zeros((), COLUMNS["springs"]),
        {name: np.zeros(2) for name in COLUMNS["springs"].names or ()},
        {"node": np.zeros(6, np.int64)} | {name: np.zeros(6) for name in ("rest", "stiffness")},
        [(0, 0, 0, 1.0, 0.0, 0.0)],
        None,
    ],
)
def test_what_is_no_table_is_refused(wrong: Any) -> None:
    with pytest.raises((ValueError, TypeError)):
        found(springs=wrong)


def test_rows_at_odd_places_in_memory_are_read_or_refused() -> None:
    form = np.dtype([("odd", np.uint8), *columns("springs")])  # packed: nothing is aligned
    packed = table("springs", *[(name, *rest) for name, *rest in columns("springs")])
    odd = np.zeros(len(packed), form)
    for name in packed.dtype.names:
        odd[name] = packed[name]
    with pytest.raises(ValueError, match="table springs: column node"):
        found(springs=odd)
    # Every other row of a longer table is a table as well.
    every_other = np.repeat(packed, 2)[::2]
    expected = found()["spring_force"]
    np.testing.assert_array_equal(found(springs=every_other)["spring_force"], expected)


class Half:
    """Stand-in for a named tuple that lacks one of its fields."""

    def __init__(self, whole: Any, missing: str) -> None:
        vars(self).update({name: one for name, one in whole._asdict().items() if name != missing})


@cache
def model() -> _core.WireModel:
    return line().core.prepare(
        lanes=line().mesh.lanes, scheme=("trapezoidal", []), step=1e-3, contact_stiffness=5e4,
        updated=False,
    )  # fmt: skip


PANTOGRAPH = PantographData(
    mass=[10.0], damping=[0.0], stiffness=[0.0],
    strips=[StripData(0.0, 0.5, [0.0], [[1.0]])], preload=[1.0], lift=[0.0], start_force=100.0,
    excitation=Excitation(
        [ForceHistory([1.0], [0.0] * 3)], BaseMotion([1.0], [0.0] * 3, [0.0] * 3)
    ),
    stops=[BumpStopData([1.0], 1.0, 1e5)],
    piecewise_forces=[PiecewiseForceData([1.0], True, [(-1.0, -1.0), (1.0, 1.0)])],
    actuator=ActuatorData([1.0], 1, 0),
)  # fmt: skip
PLAN = RecordPlan(
    contact_every=1, line_every=1, links=True, nodes=[], supports=[], points=[], ledger=False,
    ledger_every=1,
    near=RecordingWindow(50.0, Stations([0], [10.0], 1), Stations([], [], 0)),
)  # fmt: skip
START = SessionStart(60.0, 50.0, 0.0)


def stepped(**other: Any) -> dict[str, Any]:
    """Take two steps, some arguments given otherwise."""
    arguments: dict[str, Any] = {
        "pantographs": [PANTOGRAPH], "distances": [0.0], "positions": [60.0, 60.05, 60.1],
        "speeds": [50.0] * 3, "friction": 0.0, "loads": [LoadData([(1, 1, 1.0)], [0.0] * 3)],
        "plan": PLAN, "observe": lambda _step: True,
    }  # fmt: skip
    return model().run(**(arguments | other))


def places(value: Any) -> Iterator[tuple[str, ...]]:
    """Yield the way to each field of named tuples in one another; a list has one of them."""
    inside = value[0] if isinstance(value, list) and value else value
    if hasattr(inside, "_fields"):
        for name in inside._fields:
            yield (name,)
            yield from ((name, *way) for way in places(getattr(inside, name)))


def lacking(value: Any, way: tuple[str, ...]) -> Any:
    """Return named tuples without the field at the end of a way."""
    if isinstance(value, list):
        return [lacking(value[0], way)]
    if len(way) == 1:
        return Half(value, way[0])
    return value._replace(**{way[0]: lacking(getattr(value, way[0]), way[1:])})


@contextmanager
def missing(name: str) -> Iterator[None]:
    """Expect an error that tells, at the end of its causes, which field is not there."""
    with pytest.raises((AttributeError, TypeError)) as caught:
        yield
    error: BaseException = caught.value
    while error.__cause__ is not None:
        error = error.__cause__
    assert isinstance(error, AttributeError)
    assert error.args[0].endswith(f"has no attribute '{name}'")


def test_two_steps_are_taken_with_every_field() -> None:
    assert len(stepped()["time"]) == 2


@pytest.mark.parametrize("way", list(places(PANTOGRAPH)), ids=".".join)
def test_a_pantograph_lacks_no_field(way: tuple[str, ...]) -> None:
    other: Any = lacking(PANTOGRAPH, way)
    with missing(way[-1]):
        stepped(pantographs=[other])
    with missing(way[-1]):
        _core.Session.with_pantographs(
            line=model(), pantographs=[other], distances=[0.0], start=START
        )


@pytest.mark.parametrize("way", list(places(PLAN)), ids=".".join)
def test_a_plan_lacks_no_field(way: tuple[str, ...]) -> None:
    with missing(way[-1]):
        stepped(plan=lacking(PLAN, way))


def test_a_load_a_collector_or_a_start_lacks_no_field() -> None:
    collector: Any = CollectorData(0.0, 0.5)
    for name in LoadData._fields:
        with missing(name):
            stepped(loads=[Half(LoadData([], [0.0] * 3), name)])
    for whole in (collector, START):
        for name in whole._fields:
            half: Any = Half(whole, name)
            start, own = (START, half) if whole is collector else (half, collector)
            with missing(name):
                _core.Session.with_forces(
                    line=model(), collectors=[own], forces=[100.0], start=start
                )


def test_arguments_go_by_their_names() -> None:
    mesh: Any = line().mesh
    with pytest.raises(TypeError, match="positional"):
        _core.Equilibrium(2, mesh.positions, mesh.slopes, mesh.parts, 9.81, True)
    with pytest.raises(TypeError, match="positional"):
        line().core.prepare(mesh.lanes, ("trapezoidal", []), 1e-3, 5e4, False)
