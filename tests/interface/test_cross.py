"""Builds for other systems: what is missing is named, and what wine lacks is written in C."""

import shutil

import pytest
from cross.toolchain import MissingError, need
from cross.wine_libraries import _MATH, _RUNTIME, _complex


def test_a_missing_command_names_its_package(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda _: None)
    with pytest.raises(
        MissingError, match="`wine64` is missing; on Debian: apt-get install wine64"
    ):
        need("wine64", "wine64")


def test_a_command_that_is_there() -> None:
    assert need("sh", "dash") == shutil.which("sh")


@pytest.mark.parametrize("names", [_MATH, _RUNTIME])
def test_names_are_exchanged_in_place(names: tuple[str, str]) -> None:
    assert len(names[0]) == len(names[1])


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("creal", "double my_creal(double complex z) { return creal(z); }"),
        ("creall", "double my_creall(double complex z) { return creal(z); }"),
        ("cabsf", "float my_cabsf(float complex z) { return cabsf(z); }"),
        ("csqrtf", "float complex my_csqrtf(float complex z) { return csqrtf(z); }"),
        ("_FCbuild", "float complex my__FCbuild(float a, float b) { return a + b * I; }"),
        ("ceil", None),
        ("cosf", None),
        ("cbrt", None),
    ],
)
def test_functions_of_complex_numbers(name: str, text: str | None) -> None:
    assert _complex(name) == text
