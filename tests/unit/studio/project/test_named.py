"""Changes for a run name no files."""

import pytest

from arcless.errors import ModelError
from arcless.studio.project.named import check_named


@pytest.mark.parametrize(
    "changes",
    [{"line": "/etc/passwd"}, {"line": "my-line.yaml"}, {"pantographs.0.model": "../p.yaml"},
     {"pantographs": [{"model": "../p.yaml"}]}, {"as_built.gusts": "/etc/passwd"},
     {"as_built": {"measured_heights": "/etc/passwd"}}, {"line": {"value": "/x"}},
     {"pantographs.0.controller": {"function": "/tmp/x.py:f"}},
     {"pantographs.0.roof_motion": {"file": {"value": "/etc/passwd"}}}],
)  # fmt: skip
def test_files(changes: dict[str, object]) -> None:
    with pytest.raises(ModelError, match="not in a change"):
        check_named(changes)


def test_shipped_models_and_values() -> None:
    check_named({"line": "ac-simple-55", "speed": "300 km/h", "line.contact_wire.tension": 22e3,
                 "name": "a/b.yaml", "as_built.gusts": None, "pantographs": [1, None]})  # fmt: skip
