"""Counted instructions: what is complained of, and what is only said."""

import importlib.util
import json
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[2]
PROGRAM = ROOT / "benchmarks/counts.py"


@pytest.fixture
def counts() -> ModuleType:
    spec = importlib.util.spec_from_file_location("counts", PROGRAM)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_what_is_stored_covers_every_case(counts: ModuleType) -> None:
    stored = json.loads(counts.STORED.read_text("utf-8"))
    assert set(stored["instructions"]) == set(counts.CASES)
    assert all(number > 0 for number in stored["instructions"].values())
    assert stored["compiler"].startswith("rustc 1.")


def test_more_than_the_margin_is_complained_of(counts: ModuleType) -> None:
    stored = {"compiler": "rustc 1", "instructions": {"lcp-1": 1000, "lcp-8": 1000}}
    found = {"lcp-1": 1029, "lcp-8": 1031}
    ((complaint,), _) = counts.judge(found, stored, "rustc 1")
    assert "seven links: 1031 instructions, 1000 are stored" in complaint
    assert "make counts RENEW=1" in complaint
    # Another compiler has more room.
    none, notes = counts.judge(found, stored, "rustc 2")
    assert none == []
    assert "stored with rustc 1, counted with rustc 2" in notes
    assert counts.judge({"lcp-1": 1151}, stored, "rustc 2")[0]


def test_less_is_said_and_no_failure(counts: ModuleType) -> None:
    stored = {"compiler": "rustc 1", "instructions": {"lcp-1": 1000}}
    complaints, notes = counts.judge({"lcp-1": 500}, stored, "rustc 1")
    assert complaints == []
    assert any("has become cheaper" in note for note in notes)
    complaints, _ = counts.judge({"lcp-8": 500}, stored, "rustc 1")
    assert "no count is stored" in complaints[0]


def test_without_valgrind_it_is_a_sentence(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, PROGRAM],
        env={"PATH": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 0
    assert done.stdout == "make counts: valgrind is missing, so nothing is counted\n"
    assert done.stderr == ""
