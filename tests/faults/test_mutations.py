"""Every mutation of the core's source still applies, compiles, and is noticed by its checks."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.faults.mutations import MUTATIONS
from tests.support.mutants import ROOT, Mutation, Workshop

CHECKS = sorted({check for mutation in MUTATIONS for check in mutation.nodes()})


@pytest.mark.parametrize("mutation", MUTATIONS, ids=lambda mutation: mutation.name)
def test_mutation_applies(mutation: Mutation) -> None:
    path, text = mutation.spoil(ROOT)
    assert text != path.read_text(encoding="utf-8")
    assert mutation.checks


def test_a_place_is_found_whatever_files_and_variables_are_called(tmp_path: Path) -> None:
    source = tmp_path / "crates" / "core" / "src" / "line" / "any.rs"
    source.parent.mkdir(parents=True)
    sound = """impl<const DIM: usize> Wire<'_, DIM> {
    pub fn pull(&self) -> f64 {
        let half = 0.5
            * self.parts[0].mass.abs() * g;
        half + g * g
    }
}

fn pull(x: f64) -> f64 {
    0.5 * x * g
}
"""
    source.write_text(sound, encoding="utf-8")
    mutation = Mutation("", "Wire::pull", "0.5 * A * B", "A / B", ())
    path, spoilt = mutation.spoil(tmp_path)
    assert path == source
    assert spoilt == sound.replace(
        "0.5\n            * self.parts[0].mass.abs() * g;", "self.parts[0].mass.abs() / g;"
    )
    with pytest.raises(AssertionError, match="stands 2 times"):
        Mutation("", "pull", "0.5 * A", "A", ()).spoil(tmp_path)
    with pytest.raises(AssertionError, match="stands 0 times"):
        Mutation("", "Wire::pull", "A - B", "A", ()).spoil(tmp_path)
    assert "half + 2.0 * g" in Mutation("", "Wire::pull", "A * A", "2.0 * A", ()).spoil(tmp_path)[1]


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
