"""The version of the program counts the files that results depend on, and no others."""

from pathlib import Path

import pytest

from arcless.fmi.export.library import FOLDER, PLATFORMS
from arcless.study.evaluation import version

PROGRAM = {"run.py": "a", "_core.abi3.so": "b", "models/lines/one.yaml": "c"}


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(version, "_PACKAGE", tmp_path)
    write(tmp_path, PROGRAM)
    return tmp_path


def write(package: Path, files: dict[str, str]) -> None:
    for name, content in files.items():
        (package / name).parent.mkdir(parents=True, exist_ok=True)
        (package / name).write_text(content, encoding="utf-8")


def counted() -> str:
    return version.code_version.__wrapped__()


@pytest.mark.parametrize("name", [*PROGRAM, "_core.pyd", "fmi/__init__.py"])
def test_a_file_that_results_depend_on_is_another_version(package: Path, name: str) -> None:
    before = counted()
    write(package, {name: "changed"})
    assert counted() != before


def test_libraries_that_exported_fmus_carry_do_not_count(package: Path) -> None:
    before = counted()
    write(package, {f"fmi/libraries/{name}/{of.library}": name for name, of in PLATFORMS.items()})
    assert len(list(package.rglob("arcless_loop.*"))) == len(PLATFORMS)
    assert counted() == before


def test_the_libraries_are_where_the_package_has_them() -> None:
    assert FOLDER == version._PACKAGE / version._CARRIED
