"""The order of the house: a module imports only from what stands to its left."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import arcless

PACKAGE = Path(arcless.__file__).parent
ORDER = (
    "errors", "units", "storage", "model", "mesh", "equilibrium", "lcp", "dataset", "results",
    "assess", "simulate", "report", "study", "validate", "cli",
)  # fmt: skip
CORE_USERS = {"equilibrium", "lcp", "assess", "simulate"}
# A result offers what follows from it (`result.assessment`), imported when asked for.
LATER = {("results", "assess"), ("results", "report")}


def modules() -> Iterator[tuple[str, Path]]:
    """Yield every module with the name of its place in the order."""
    for path in sorted(PACKAGE.rglob("*.py")):
        place = path.relative_to(PACKAGE).parts[0].removesuffix(".py")
        if place not in ("__init__", "__main__"):
            yield place, path


def imports(tree: ast.AST) -> Iterator[tuple[str, bool]]:
    """Yield what is imported from this package, and whether at import time."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            continue
        names = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports are absolute"
            inside = [f"{node.module}.{alias.name}" for alias in node.names]
            names = inside if node.module == "arcless" else [str(node.module)]
        yield from ((name.split(".")[1], True) for name in names if name.startswith("arcless."))
        late = isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        yield from ((name, now and not late) for name, now in imports(node))


def test_every_module_has_a_place_in_the_order() -> None:
    assert {place for place, _ in modules()} <= set(ORDER)


@pytest.mark.parametrize(
    ("place", "path"),
    list(modules()),
    ids=lambda value: value.stem if isinstance(value, Path) else value,
)
def test_imports_come_from_the_left(place: str, path: Path) -> None:
    for target, now in imports(ast.parse(path.read_text("utf-8"))):
        if target == "_core":
            assert place in CORE_USERS, f"{path} imports the compiled core"
        elif target in ORDER and ((place, target) not in LATER or now):
            assert ORDER.index(target) <= ORDER.index(place), f"{path} imports arcless.{target}"


def test_public_names_exist() -> None:
    for name in arcless.__all__:
        assert getattr(arcless, name) is not None, name


def test_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute `nothing`"):
        _ = arcless.nothing
