"""The checks of stitched lines notice a stitch wire that is not there."""

from collections.abc import Callable
from unittest.mock import patch

from arcless.simulate import StaticsResult
from tests.verification.references import test_stitched_lines as checks

Noticed = Callable[..., None]


def test_stitch_wire_forgotten(noticed: Noticed) -> None:
    known: dict[str, StaticsResult] = {}

    def plain(line: str, **_: object) -> StaticsResult:
        if line not in known:
            known[line] = sound(line, stitch_wire=None)
        return known[line]

    sound = checks.at_rest
    with patch.object(checks, "at_rest", plain):
        noticed("stitch wires forgotten", checks.test_elasticity, line="norway-s25")
