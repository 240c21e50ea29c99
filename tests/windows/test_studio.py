"""The studio's server on Windows: it answers, its worker processes compute, and nothing stays."""

import shutil
import sys
import time
from pathlib import Path

import pytest

import arcless
from arcless.model import parse_override
from arcless.storage.hidden_files import PREFIX
from tests.support.studio_server import PAGE, Server

pytestmark = pytest.mark.skipif(sys.platform != "win32", reason="this is not Windows")
ROOT = Path(__file__).parents[2]
SHORT = ROOT / "tests" / "interface" / "data" / "short.yaml"
QUICK = ("travel={start: 50 m, end: 200 m}", "analysis={from: 60 m, to: 190 m}")
PATIENCE_S = 300.0


def test_a_run_is_computed_and_kept(tmp_path: Path) -> None:
    folder = tmp_path / "project"
    folder.mkdir()
    shutil.copy(SHORT, folder / "short.yaml")
    with Server(folder, tmp_path) as server:
        assert server.ask("GET", "/").body.decode("utf-8") == PAGE
        asked = {"path": "short.yaml", "want": ["line"], "question": 1}
        answer = server.ask("POST", "/api/statics", asked, timeout=PATIENCE_S)
        assert answer.status == 200, answer.body
        changes = dict(parse_override(text) for text in QUICK)
        begun = server.ask("POST", "/api/runs", {"scenario": "short.yaml", "changes": changes})
        assert begun.status == 200, begun.body
        name, deadline = begun.json()["job"]["id"], time.monotonic() + PATIENCE_S
        while True:
            [job] = [one for one in server.ask("GET", "/api/jobs").json() if one["id"] == name]
            if job["state"] not in ("waiting", "running"):
                break
            assert time.monotonic() < deadline, job
            time.sleep(0.2)
        assert job["state"] == "done", job
    [result] = folder.rglob("result.nc")
    assert arcless.open(result).dataset["contact_force"].values.max() > 0.0
    assert not list(folder.rglob(f"{PREFIX}*"))
