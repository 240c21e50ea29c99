"""The short line of the tests of `arcless.simulate`."""

from tests.unit.simulate.conftest import placement, run, short

__all__ = ["placement", "run", "short"]
