"""Shipped scenarios, each run once however many tests look at it."""

from tests.verification.conftest import at_rest, run_once

__all__ = ["at_rest", "run_once"]
