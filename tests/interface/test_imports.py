"""Imports go one way: rooms, modules and packages without circles, in the order of the house.

A room is a folder of the package; each module that stands beside them in `arcless` is one too.
Every import counts, wherever it stands: at the top of a module, in a function, for types alone.
`from a.b import name` imports the module `a.b.name` if there is one, otherwise names of `a.b`: of a
module, or of the `__init__` of a package, which belongs to its folder. That Python runs the
`__init__` of a package when a module inside is imported does not count: nothing is taken from it.
"""

import ast
from collections.abc import Iterable, Mapping
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import arcless

PACKAGE = Path(arcless.__file__).parent
# Packages and modules of the top folder; each imports only from itself and from its left.
ORDER = (
    "errors", "units", "platforms", "storage", "display", "model", "pantograph", "mesh",
    "equilibrium", "lcp", "dataset", "assess", "explanation", "figures", "report", "results",
    "measurements", "comparison", "simulate", "control", "fmi", "study", "validate", "studio",
    "cli",
)  # fmt: skip
CORE = "arcless._core"
CORE_USERS = {"equilibrium", "lcp", "assess", "simulate", "fmi"}
# The top package has all others, and none has it.
TOP = {"arcless", "arcless.__main__"}
MOST_MODULES = 12


@cache
def modules() -> dict[str, Path]:
    """Return the modules of the package by their names."""
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        parts = ["arcless", *path.relative_to(PACKAGE).with_suffix("").parts]
        found[".".join(parts).removesuffix(".__init__")] = path
    return found


@cache
def imported(name: str) -> frozenset[str]:
    """Return the modules of the package that a module imports, and the compiled core."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(modules()[name].read_text("utf-8"))):
        if isinstance(node, ast.Import):
            found |= {each.name for each in node.names} & modules().keys()
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{name}: imports are absolute"
            source = str(node.module)
            wholes = {f"{source}.{each.name}" for each in node.names}
            inside = {whole for whole in wholes if whole in modules() or whole == CORE}
            found |= inside
            if source in modules() and inside != wholes:
                found.add(source)
    return frozenset(found)


def room(name: str) -> str:
    """Return the room of a module: its folder, or itself where it stands in the top folder."""
    path = modules()[name].relative_to(PACKAGE)
    return path.stem if len(path.parts) == 1 else path.parent.as_posix()


def place(name: str) -> str:
    """Return what the order has of a module: `model` of `arcless.model.line.line`."""
    return name.split(".")[1]


def check_no_circle(graph: Mapping[str, Iterable[str]]) -> None:
    """Fail with the circle where a graph has one."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(" imports ".join(reversed(error.args[1])))


def test_rooms_import_one_another_in_one_direction() -> None:
    graph: dict[str, set[str]] = {room(name): set() for name in modules()}
    for name in modules():
        graph[room(name)] |= {room(each) for each in imported(name) - {CORE}}
    check_no_circle({own: others - {own} for own, others in graph.items()})


def test_modules_import_one_another_in_one_direction() -> None:
    check_no_circle({name: imported(name) - {name, CORE} for name in modules()})


def test_every_module_has_a_place_in_the_order() -> None:
    assert {place(name) for name in modules() if name not in TOP} == set(ORDER)


@pytest.mark.parametrize("name", [name for name in modules() if name not in TOP])
def test_imports_come_from_the_left(name: str) -> None:
    for target in imported(name):
        assert target not in TOP, f"{name} imports names of the top package"
        if target == CORE:
            assert place(name) in CORE_USERS, f"{name} imports the compiled core"
        else:
            left = ORDER[: ORDER.index(place(name)) + 1]
            assert place(target) in left, f"{name} imports {target}"


def test_no_folder_is_a_drawer() -> None:
    count: dict[Path, int] = {}
    for path in modules().values():
        count[path.parent] = count.get(path.parent, 0) + 1
    crowded = {path.relative_to(PACKAGE): n for path, n in count.items() if n > MOST_MODULES}
    assert not crowded


def test_public_names_exist() -> None:
    for name in arcless.__all__:
        assert getattr(arcless, name) is not None, name


def test_public_names_have_types() -> None:
    tree = ast.parse((PACKAGE / "__init__.pyi").read_text("utf-8"))
    lists = [ast.literal_eval(n.value) for n in tree.body if isinstance(n, ast.Assign)]
    assert lists == [arcless.__all__]


def test_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute `nothing`"):
        _ = arcless.nothing
