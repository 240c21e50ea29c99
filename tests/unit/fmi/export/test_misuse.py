"""Mistakes of importers are refused with the variable and the time."""

import zipfile
from collections.abc import Callable
from math import inf, nan
from pathlib import Path

import pytest

from tests.support.exported import Failed, driven

Fmu = Callable[..., Path]


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("value", [nan, inf, -inf])
def test_a_number_that_is_none(fmu: Fmu, version: int, value: float) -> None:
    with driven(fmu(version)) as run:
        for _ in range(3):
            run.step()
        words = r"`P1\.contact_force` is (NaN|-?inf) at t = 0\.00\d+ s: expected a finite .* in N"
        with pytest.raises(Failed, match=words):
            run.put({"P1.contact_force": value})
        with pytest.raises(Failed, match=r"a step is asked for at t = .* after an error"):
            run.step()


def test_what_is_no_input(fmu: Fmu) -> None:
    with (
        driven(fmu(2)) as run,
        pytest.raises(Failed, match=r"`P1.wire_height` is set .* an output"),
    ):
        run.put({"P1.wire_height": 5.0})
    with driven(fmu(2)) as run:
        run.numbers["nothing"] = 10_000
        with pytest.raises(Failed, match=r"no variable 10000 at t = 0 s: their numbers are 0 to"):
            run.value("nothing")


@pytest.mark.parametrize("version", [2, 3])
def test_steps_of_another_length_or_out_of_order(fmu: Fmu, version: int) -> None:
    path = fmu(version)
    for share in (0.5, 1.01, -1.0, 0.0, nan):
        with driven(path) as run:
            run.step()
            words = r"a step of .* s at t = .* s: expected a whole number of steps of"
            with pytest.raises(Failed, match=words):
                run.attempt("doStep", run.time, share * run.h)
    for at in (0.0, 5.0, nan):
        with driven(path) as run:
            run.step()
            words = (
                r"a step from t = .* s: the device stands at t = .* s, and steps follow one another"
            )
            with pytest.raises(Failed, match=words):
                run.attempt("doStep", at, run.h)


def test_functions_out_of_order(fmu: Fmu) -> None:
    words = "the initialization begins at t = 0 s, while steps"
    with driven(fmu(2)) as run, pytest.raises(Failed, match=words):
        run.attempt("enterInitializationMode")
    with driven(fmu(2)) as run:
        run.attempt("terminate")
        with pytest.raises(Failed, match="a step is asked for at t = 0 s, after the end"):
            run.step()
    with driven(fmu(2)) as run:
        run.attempt("reset")
        with pytest.raises(
            Failed, match="a step is asked for at t = 0 s, before the initialization"
        ):
            run.step()


def test_what_is_not_offered_changes_nothing(fmu: Fmu) -> None:
    with driven(fmu(2)) as run:
        with pytest.raises(Failed, match="fmi2GetDirectionalDerivative is not offered"):
            run.attempt("getDirectionalDerivative", [1], [2], [1.0])
        with pytest.raises(Failed, match="no variable has this type, all are real numbers"):
            run.attempt("getInteger", [1])
        run.step()


def test_the_end_of_the_line(fmu: Fmu) -> None:
    """The step is discarded: what was reached stays, and a state is restored as ever."""
    with driven(fmu(2, given="control-force")) as run:
        state = run.attempt("getFMUstate")
        run.put({"speed": 3000.0})
        run.step()
        with pytest.raises(
            Failed, match=r"the step from t = .* `P1` is at .* no contact wire"
        ) as no:
            for _ in range(1000):
                run.step()
        assert "status 2" in str(no.value)  # discarded
        assert run.value("time") == pytest.approx(run.time)
        run.attempt("setFMUstate", state)
        run.steps = 0
        run.step()
    with driven(fmu(2)) as run:
        run.put({"speed": 3000.0})
        with pytest.raises(Failed, match=r"`compliance` has no value at t = .*: `P1` is at") as no:
            while True:
                run.step()
                run.value("compliance")
        assert "status 2" in str(no.value)


def _changed(path: Path, folder: Path, change: Callable[[str, bytes], bytes | None]) -> Path:
    """Return a copy of an archive with entries changed, or left out."""
    copy = folder / "changed.fmu"
    with zipfile.ZipFile(path) as old, zipfile.ZipFile(copy, "w") as new:
        for name in old.namelist():
            content = change(name, old.read(name))
            if content is not None:
                new.writestr(name, content)
    return copy


def _model(change: Callable[[bytes], bytes]) -> Callable[[str, bytes], bytes | None]:
    return lambda name, content: change(content) if name.endswith("model.loop") else content


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            lambda b: b[:2000] + bytes([b[2000] ^ 1]) + b[2001:],
            "the model was changed after its export",
        ),
        (lambda b: b[:-1], r"the model is cut off: it has \d+ bytes, expected \d+"),
        (lambda b: b[:8] + b"\x07" + b[9:], "the model has format 7, this library reads 1"),
        (lambda b: b"PK" + b[2:], "no model of `arcless fmu export`"),
        (lambda b: b"", "no model of `arcless fmu export`"),
    ],
)
def test_a_model_changed_after_its_export(
    fmu: Fmu, tmp_path: Path, change: Callable[[bytes], bytes], words: str
) -> None:
    copy = _changed(fmu(2), tmp_path, _model(change))
    with pytest.raises(Failed, match=words), driven(copy):
        pass


def test_a_model_of_another_description(fmu: Fmu, tmp_path: Path) -> None:
    with zipfile.ZipFile(fmu(2, given="control-force")) as file:
        other = file.read("resources/model.loop")
    copy = _changed(fmu(2), tmp_path, _model(lambda _: other))
    with (
        pytest.raises(Failed, match=r"the description is of the model .* the resources have"),
        driven(copy),
    ):
        pass


def test_a_model_that_is_missing(fmu: Fmu, tmp_path: Path) -> None:
    copy = _changed(fmu(3), tmp_path, lambda n, b: None if n.endswith(".loop") else b)
    with (
        pytest.raises(Failed, match=r"the model of the FMU cannot be read: .*model.loop"),
        driven(copy),
    ):
        pass


def test_an_fmu_for_another_platform(fmu: Fmu, tmp_path: Path) -> None:
    """FMPy itself says that the library is missing."""
    copy = _changed(fmu(2), tmp_path, lambda n, b: None if n.startswith("binaries") else b)
    with pytest.raises(Failed, match="linux64"), driven(copy):
        pass
