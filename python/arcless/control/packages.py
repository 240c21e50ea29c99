"""Packages of the extra `control`, which nothing else of Arcless needs."""

from importlib.util import find_spec

from arcless.errors import ModelError


def is_installed(name: str) -> bool:
    """Return whether a package is installed."""
    return find_spec(name) is not None


def need(name: str) -> None:
    """Refuse to continue without a package.

    Raises
    ------
    ModelError
        It is not installed.
    """
    if not is_installed(name):
        raise ModelError(
            f"environments for control need the package {name}, which is not installed",
            hint="pip install 'arcless[control]'",
        )
