"""Every kind of error, with an example of its message: the list that users meet."""

import pickle

import pytest

from arcless import errors
from arcless.errors import (
    ArclessError,
    ComparisonError,
    ContactError,
    ControlError,
    EquilibriumError,
    ExecutorError,
    ExplanationError,
    FigureError,
    FitError,
    FmuError,
    MachineError,
    MeasurementError,
    MeshError,
    ModelError,
    NotConvergedError,
    OutputError,
    ResultFormatError,
    StudyError,
)

EXAMPLES = [
    (
        ModelError(
            "contact_wire.tension",
            where="lines/foo.yaml:12",
            got='"22 kg"',
            expected="a force (N, kN)",
            hint="kg is the unit of a mass",
        ),
        'lines/foo.yaml:12: contact_wire.tension: got "22 kg", expected a force (N, kN);'
        " hint: kg is the unit of a mass",
        2,
    ),
    (
        MeshError("elements", got="0.001 m", expected="elements longer than 0.05 m"),
        "elements: got 0.001 m, expected elements longer than 0.05 m",
        2,
    ),
    (
        OutputError("folder cannot be written", where="runs/x", hint="choose another with --out"),
        "runs/x: folder cannot be written; hint: choose another with --out",
        2,
    ),
    (
        ExplanationError("the contact force is constant", where="pantograph P1", got="σ = 0 N"),
        "pantograph P1: the contact force is constant: got σ = 0 N",
        2,
    ),
    (
        NotConvergedError("no static equilibrium was found", got="3 N after 50 iterations"),
        "no static equilibrium was found: got 3 N after 50 iterations",
        1,
    ),
    (
        EquilibriumError("no equilibrium", where="iteration 50", got="a residual of 3 N"),
        "iteration 50: no equilibrium: got a residual of 3 N",
        1,
    ),
    (
        ContactError("not solved", where="step 812, t = 0.812 s, span 3 dropper 5"),
        "step 812, t = 0.812 s, span 3 dropper 5: not solved",
        1,
    ),
    (
        ControlError("the controller failed", where="pantograph P1, t = 0.5 s", got="KeyError: 1"),
        "pantograph P1, t = 0.5 s: the controller failed: got KeyError: 1",
        1,
    ),
    (
        FmuError("the FMU is gone", where="pantograph P1, t = 0.5 s", got="it crashed"),
        "pantograph P1, t = 0.5 s: the FMU is gone: got it crashed",
        1,
    ),
    (
        ResultFormatError("not a result", where="x.nc", expected="a file of arcless run"),
        "x.nc: not a result: expected a file of arcless run",
        2,
    ),
    (
        StudyError("a study was begun here already", where="runs/studies/x", got="rows of it"),
        "runs/studies/x: a study was begun here already: got rows of it",
        2,
    ),
    (
        ComparisonError("too few runs", got="1", expected="two or more"),
        "too few runs: got 1, expected two or more",
        2,
    ),
    (
        FigureError("unknown key of a figure", got="`leed`", expected="one of `lead`, `force`"),
        "unknown key of a figure: got `leed`, expected one of `lead`, `force`",
        2,
    ),
    (
        MachineError("the system gives no locked memory", got="Operation not permitted"),
        "the system gives no locked memory: got Operation not permitted",
        2,
    ),
    (
        MeasurementError("time goes back", where="run.csv:7", got="0.03 s after 0.04 s"),
        "run.csv:7: time goes back: got 0.03 s after 0.04 s",
        2,
    ),
    (
        FitError("the fit misses the data", where="a.csv", got="12 %", expected="at most 10 %"),
        "a.csv: the fit misses the data: got 12 %, expected at most 10 %",
        1,
    ),
    (
        ExecutorError("the scheduler does not answer", where="tcp://localhost:1"),
        "tcp://localhost:1: the scheduler does not answer",
        1,
    ),
]


@pytest.mark.parametrize(("error", "message", "code"), EXAMPLES, ids=lambda e: type(e).__name__)
def test_message_and_exit_code(error: ArclessError, message: str, code: int) -> None:
    assert str(error) == message
    assert error.exit_code == code


def test_every_kind_has_an_example() -> None:
    kinds = {
        value
        for value in vars(errors).values()
        if isinstance(value, type) and issubclass(value, ArclessError) and value is not ArclessError
    }
    assert kinds == {type(error) for error, _, _ in EXAMPLES}


def test_further_mistakes_follow_on_their_own_lines() -> None:
    second = ModelError("b", where="x.yaml:2", expected="a length (m)")
    first = ModelError("a", where="x.yaml:1", expected="a force (N)", also=[second])
    assert str(first).splitlines() == [
        "x.yaml:1: a: expected a force (N)",
        "x.yaml:2: b: expected a length (m)",
    ]


def test_errors_survive_the_way_from_a_worker_process() -> None:
    error = EXAMPLES[0][0]
    assert str(pickle.loads(pickle.dumps(error))) == str(error)


def test_what_the_system_refuses_to_write_is_said_in_one_way() -> None:
    full = OSError(28, "No space left on device")
    error = OutputError.of(full, "the file cannot be written", "runs/x.nc", "choose another place")
    assert str(error) == (
        "runs/x.nc: the file cannot be written: got No space left on device, expected a folder that"
        " exists or can be made, is not read-only, and has room on its disk;"
        " hint: choose another place"
    )
