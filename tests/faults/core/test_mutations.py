"""Every mutation of the core's source still applies, compiles, and is noticed by its checks."""

import ast
from collections.abc import Iterator

import pytest

from tests.faults.core.mutations import MUTATIONS
from tests.support.mutants import ROOT, Mutation, Workshop

CHECKS = sorted({check for mutation in MUTATIONS for check in mutation.nodes()})


@pytest.mark.parametrize("mutation", MUTATIONS, ids=lambda mutation: mutation.name)
def test_mutation_applies(mutation: Mutation) -> None:
    path, text = mutation.spoil(ROOT)
    assert text != path.read_text(encoding="utf-8")
    assert mutation.checks


@pytest.mark.parametrize("check", CHECKS)
def test_check_exists_and_is_not_slow(check: str) -> None:
    file, _, function = check.partition("::")
    tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
    (found,) = (
        node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == function
    )
    assert "mark.evidence" not in [ast.unparse(mark) for mark in found.decorator_list]


def test_names_are_unique() -> None:
    assert len({mutation.name for mutation in MUTATIONS}) == len(MUTATIONS) > 20


@pytest.fixture(scope="module")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Workshop]:
    """A copy of the sources; its sound core passes all checks."""
    made = Workshop(tmp_path_factory.mktemp("workshop"))
    made.build()
    failing = [check for check, fails in made.fails(CHECKS).items() if fails]
    assert not failing, "checks that fail without any fault show nothing"
    yield made


@pytest.mark.evidence
@pytest.mark.parametrize("mutation", MUTATIONS, ids=lambda mutation: mutation.name)
def test_mutation_is_noticed(workshop: Workshop, mutation: Mutation) -> None:
    overlooked = [
        check
        for check, fails in workshop.with_fault(mutation, mutation.nodes()).items()
        if not fails
    ]
    assert not overlooked, f"{mutation.name}: not noticed by {overlooked}"
