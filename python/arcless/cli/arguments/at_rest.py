"""Mistakes of a model that show only where its line is found at rest."""

from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def faults_of(file: str, *, model_alone: bool = False) -> Iterator[None]:
    """Say of a line without equilibrium that its file is wrong, and which one it is.

    Parameters
    ----------
    file
        The model, as it was named on the command line.
    model_alone
        True where nothing but the model is asked about: a search without an end counts as well.

    Raises
    ------
    ModelError
        The line is loose, or a dropper or a steady arm would have to push.
    NotConvergedError
        The search failed, and the model is not said to be wrong.
    """
    from arcless.errors import EquilibriumError, ModelError, NotConvergedError

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
