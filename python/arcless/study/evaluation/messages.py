"""Whom executors tell what a user should know."""

from collections.abc import Callable

Note = Callable[[str], None]
