"""The benchmark of whole runs goes through; its numbers are nobody's limit."""

import importlib.util
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]


def test_a_whole_run_is_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    spec = importlib.util.spec_from_file_location("benchmark", ROOT / "benchmarks/run.py")
    assert spec is not None
    assert spec.loader is not None
    benchmark = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(benchmark)
    monkeypatch.setattr(benchmark, "REPEATS", 1)
    row = benchmark.measure(str(ROOT / "tests/interface/data/short.yaml"), "always")
    assert len(row) == len(benchmark.HEAD) - 1
    assert all(float(value) >= 0.0 for value in row)
