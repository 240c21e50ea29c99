"""The FMUs of a line and of a pantograph, coupled as stiffly as they are inside, or not."""

from collections.abc import Callable
from pathlib import Path

import pytest

import arcless
from examples.coupled_fmus import BOUND, by_compliance, by_strip, plain
from tests.support.exported import driven
from tests.unit.fmi.conftest import GIVEN, Short

Fmu = Callable[..., Path]
STEPS = 1000
