"""Callback type for messages of executors to the user."""

from collections.abc import Callable

Note = Callable[[str], None]
