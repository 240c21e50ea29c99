"""The check of two pantographs far apart notices when they are not: the leading one's wake."""

from collections.abc import Callable
from unittest.mock import patch

from tests.verification.conservation import test_far_apart as checks

Noticed = Callable[..., None]


def test_in_the_wake(noticed: Noticed) -> None:
    with patch.object(checks, "APART", 110.0):
        noticed("110 m apart, not 6 km", checks.test_trailing)
