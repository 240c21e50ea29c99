"""Checks of a model without a run: advice, and the line at rest."""

from collections.abc import Iterator
from contextlib import contextmanager

from arcless.errors import EquilibriumError, ModelError, NotConvergedError
from arcless.model import Line, Pantograph, Scenario, line_warnings, scenario_warnings
from arcless.model.advice.speeds import check_speed
from arcless.simulate.statics import check_at_rest


def advice(checked: Scenario | Line | Pantograph, file: str) -> list[str]:
    """Return one sentence for each thing that is allowed but probably not meant.

    Parameters
    ----------
    checked
        The model.
    file
        Its file, for the message.

    Raises
    ------
    ModelError
        The speed looks like one in km/h.
    """
    if isinstance(checked, Scenario):
        check_speed(checked, file)
        return scenario_warnings(checked)
    return line_warnings(checked) if isinstance(checked, Line) else []


def check_rest(checked: Scenario | Line | Pantograph, file: str) -> None:
    """Find the line of a model at rest, if it has one.

    Raises
    ------
    ModelError
        There is no equilibrium, or none is found: the model is wrong.
    MeshError
        The line cannot be divided into elements as asked.
    """
    if not isinstance(checked, Pantograph):
        with faults_of(file, model_alone=True):
            check_at_rest(checked)


@contextmanager
def faults_of(file: str, *, model_alone: bool = False) -> Iterator[None]:
    """Say of a line without equilibrium that its file is wrong, and which one it is.

    Parameters
    ----------
    file
        The model, as it was named by the user.
    model_alone
        True where nothing but the model is asked about: a search without an end counts as well.

    Raises
    ------
    ModelError
        The line is loose, or a dropper or a steady arm would have to push.
    NotConvergedError
        The search failed, and the model is not said to be wrong.
    """
    try:
        yield
    except EquilibriumError as error:
        where = file if error.where is None else f"{file}: {error.where}"
        if isinstance(error, NotConvergedError) and not model_alone:
            error.where = where
            raise
        raise ModelError(
            error.what, where=where, got=error.got, expected=error.expected, hint=error.hint
        ) from error
