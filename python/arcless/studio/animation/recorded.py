"""Recorded motion of a result."""

from arcless.dataset.plain_dataset import Dataset
from arcless.errors import OutputError
from arcless.studio.animation.rows import Motion
from arcless.studio.at_rest.plain_geometry import Geometry


def recorded(data: Dataset, geometry: Geometry) -> Motion:
    raise OutputError("the run has no recorded motion", hint="x")
