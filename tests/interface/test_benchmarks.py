"""Programs of benchmarks/: the same model is compared, what was measured is printed."""

import sys
from pathlib import Path

import numpy as np
import pytest
from benchmarks import kernels, limits, studies, tables, watched_runs
from benchmarks.accuracy import finer
from benchmarks.floor import floor
from benchmarks.plain_scipy import Plain
from benchmarks.run import PARTS
from benchmarks.whole_runs import SOLVED

import arcless
from arcless.equilibrium import equilibrium

# What divan 0.1 prints, shortened.
PRINTED = """\
Timer precision: 20 ns
kernels                      fastest       │ slowest       │ median        │ mean     │ samples
├─ lcp_warm                                │               │               │          │
│  ╰─ 2                      500.6 ns      │ 2.774 µs      │ 510.6 ns      │ 543.9 ns │ 100
╰─ planar                                  │               │               │          │
   ╰─ solve                  21.22 µs      │ 4.133 ms      │ 23.68 µs      │ 65.23 µs │ 100
"""


def test_plain_scipy_gives_the_same_forces() -> None:
    scenario = arcless.load("en50318-ac-simple-320-planar").with_(**{
        "line.spans": [{"type": "standard", "count": 4}],
        "travel": {"start": 55.0, "end": 110.0},
        "analysis.spans": None,
        "pantographs.0.static_force": 200.0,
        **SOLVED,
        "solver.period_correction": False,  # which the plain program does not have
    })  # fmt: skip
    data = arcless.run(scenario).dataset
    record = Plain(scenario, equilibrium.find(scenario)).run(200.0, data.attrs["steps"])
    assert record.slack == data.attrs["slack_droppers_max"] > 0
    apart = np.abs(record.force - data.contact_force.values[:, 0])
    # Rounding of positions, 1e-13 m, times 50 kN/m of the contact; the force deviates by 50 N.
    assert apart.max() < 1e-6


def test_kernels_are_read_from_what_is_printed() -> None:
    assert kernels.read(PRINTED) == [
        ["complementarity problem: contact and droppers, 2", "0.501 µs", "0.511 µs"],
        ["solve, planar", "21.2 µs", "23.7 µs"],
    ]


def test_a_study_is_measured_in_its_parts() -> None:
    took = studies.once(1, count=2)
    assert took.rate > 0.0
    assert 0.0 < took.core < took.processor
    assert 0.0 < took.kept < took.python


def test_a_number_is_compared_with_its_limit() -> None:
    assert limits.most("a", 100, 100.4, "ms") == ["a", "≤ 100 ms", "100 ms", "**no**", ""]
    assert limits.most("a", 500, 44.44, "ms") == ["a", "≤ 500 ms", "44.4 ms", "yes", ""]
    assert limits.least("a", 50, 60.0, "/s", "b") == ["a", "≥ 50 /s", "60 /s", "yes", "b"]
    assert limits.least("a", 50, 49.9, "/s")[3] == "**no**"
    assert limits.told("a", 1234.5, "s") == ["a", "", "1234 s", "", ""]


def test_runs_are_compared_within_their_round() -> None:
    took = [
        {"alone": watched_runs.Took(s, s, s), "watched": watched_runs.Took(r * s, 2 * s, s)}
        for s, r in ((1.0, 1.1), (10.0, 1.0), (3.0, 1.3))
    ]
    assert watched_runs.ratios(took, "watched", "thread") == pytest.approx((1.1, 1.0, 1.3))
    assert watched_runs.ratios(took, "watched", "process") == (2.0, 2.0, 2.0)


@pytest.mark.parametrize("way", watched_runs.WAYS)
def test_a_run_is_measured_in_each_way(way: str) -> None:
    before = sys.getswitchinterval()
    try:
        took = watched_runs.take(way, 26)
    finally:
        sys.setswitchinterval(before)
    assert 0.0 < took.thread <= took.process
    assert took.steps > 0.0


def test_floor_of_one_block() -> None:
    least = floor(nodes=2, blocks=1, entries=4, width=1)
    # 4 entries with two products and sums each, 2 blocks and 2 inverses, the new state.
    assert least.operations == 4 * 4 + 2 * (2 + 2) + 22 * 2
    assert least.matrices == 2 * 16 + 2 * 8 + 4 * 24
    assert least.bytes == least.matrices + 19 * 8 * 2


def test_reference_is_four_times_finer() -> None:
    solver = finer(arcless.load("en50318-ac-simple-320-planar").with_(**SOLVED)).solver
    assert (solver.contact_wire_element_m, solver.time_step) == (1.45 / 4, 0.25e-3)


def test_tables_go_between_their_marks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = tmp_path / "page.md"
    page.write_text("a\n<!-- bench: x -->\nold\n<!-- end: x -->\nb\n", "utf-8")
    monkeypatch.setattr(tables, "PAGE", page)
    tables.put("x", tables.table(("n",), [["1"]]))
    expected = "a\n<!-- bench: x -->\n\n| n |\n| --- |\n| 1 |\n\n<!-- end: x -->\nb\n"
    assert page.read_text("utf-8") == expected


def test_page_has_a_place_for_every_part() -> None:
    page = tables.PAGE.read_text("utf-8")
    for name in PARTS:
        assert page.count(f"<!-- bench: {name} -->") == page.count(f"<!-- end: {name} -->") == 1
