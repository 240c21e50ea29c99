"""Designs for sensitivity, and the indices that follow from them."""

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.errors import ModelError, StudyError
from arcless.study import load, run
from arcless.study.analysis.findings import FILES
from arcless.study.analysis.sensitivity import of_output
from arcless.study.designs import Morris, SobolIndices
from arcless.study.report import html
from tests.support.bokeh_pages import document_in, mistakes_of
from tests.support.studies import QUICK, data, filled, study

NAMES = ["x1", "x2", "x3"]
Function = Callable[[Any], float]


def ishigami(u: Any) -> float:
    """sin x₁ + a sin² x₂ + b x₃⁴ sin x₁, xᵢ uniform in ±π (Ishigami and Homma 1990)."""
    x1, x2, x3 = math.pi * (2.0 * np.asarray(u) - 1.0)
    return math.sin(x1) + 7.0 * math.sin(x2) ** 2 + 0.1 * x3**4 * math.sin(x1)


def found(design: SobolIndices | Morris, function: Function, lost: tuple[int, ...] = ()) -> Any:
    points = design.points(design.total(3), 3, seed=1)
    values = [None if i in lost else function(u) for i, u in enumerate(points)]
    return of_output(design, NAMES, values, seed=1)


def test_ishigami_has_its_known_indices() -> None:
    a, b = 7.0, 0.1
    first = 0.5 * (1.0 + b * math.pi**4 / 5.0) ** 2
    second = a**2 / 8.0
    shared = b**2 * math.pi**8 * (1.0 / 18.0 - 1.0 / 50.0)
    all_ = first + second + shared
    design = SobolIndices(kind="sobol-indices", count=2048, second_order=True)
    values = found(design, ishigami)["indices"]
    exact = {"x1": (first, first + shared), "x2": (second, second), "x3": (0.0, shared)}
    for name, (alone, total) in exact.items():
        # Monte Carlo would give 1.7/√2048 = 0.04 for first order; a Sobol sequence less than that.
        assert values[name]["first"] == pytest.approx(alone / all_, abs=0.02)
        assert values[name]["total"] == pytest.approx(total / all_, abs=0.02)
        assert abs(values[name]["total"] - total / all_) < values[name]["total_interval"]
        assert abs(values[name]["first"] - alone / all_) < values[name]["first_interval"]
    # As above.
    assert values["x1"]["pairs"]["x3"]["second"] == pytest.approx(shared / all_, abs=0.04)
    assert values["x1"]["pairs"]["x2"]["second"] == pytest.approx(0.0, abs=0.04)


@pytest.mark.parametrize("seed", [0, 7])
def test_intervals_are_those_of_the_seed(seed: int) -> None:
    """A report made twice says the same: resampling is seeded, by 0 too, the default."""
    design = SobolIndices(kind="sobol-indices", count=64)
    values = [ishigami(u) for u in design.points(design.total(3), 3, seed=seed)]
    one, two = (of_output(design, NAMES, values, seed=seed) for _ in range(2))
    assert one == two


def test_a_spoilt_function_is_noticed() -> None:
    design = SobolIndices(kind="sobol-indices", count=2048)
    # x₂ over a tenth of its range only: the part that sin² gives to the variance almost goes.
    less = found(design, lambda u: ishigami([u[0], 0.5 + 0.1 * u[1], u[2]]))["indices"]
    assert less["x2"]["first"] < 0.2


def test_blocks_with_a_lost_row_are_left_out_and_counted() -> None:
    design = SobolIndices(kind="sobol-indices", count=64)
    line: Function = lambda u: float(2.0 * u[0] + u[1])  # noqa: E731
    every = found(design, line)
    some = found(design, line, lost=(7, 8, 300))
    assert (every["blocks"], every["left_out"]) == (64, 0)
    assert (some["blocks"], some["left_out"]) == (62, 2)
    # Of 2²/12 and 1/12; two of 64 blocks move the estimate by some hundredths.
    assert some["indices"]["x1"]["total"] == pytest.approx(0.8, abs=0.06)
    assert some["indices"]["x3"] == {
        "first": 0.0, "first_interval": 0.0, "total": 0.0, "total_interval": 0.0,
    }  # fmt: skip


def test_why_there_are_none() -> None:
    design = SobolIndices(kind="sobol-indices", count=8)
    assert found(design, lambda _u: 3.0)["why"] == "the output is the same everywhere"
    gone = found(design, lambda u: float(u[0]), lost=tuple(range(0, 40, 5)))
    assert (gone["blocks"], gone["why"]) == (0, "fewer than 4 whole blocks")


@pytest.mark.parametrize("levels", [2, 4, 6])
def test_effects_of_a_plane_are_its_slopes(levels: int) -> None:
    design = Morris(kind="morris", count=12, levels=levels)
    values = found(design, lambda u: float(3.0 * u[0] - 2.0 * u[1]))["indices"]
    for name, slope in (("x1", 3.0), ("x2", -2.0), ("x3", 0.0)):
        # Rounding of differences.
        assert values[name]["mu"] == pytest.approx(slope, abs=1e-12)
        assert values[name]["mu_star"] == pytest.approx(abs(slope), abs=1e-12)
        assert values[name]["sigma"] == pytest.approx(0.0, abs=1e-12)


def test_effects_that_others_matter_to() -> None:
    values = found(Morris(kind="morris", count=40), lambda u: float(u[0] * u[1]))["indices"]
    assert values["x1"]["sigma"] > 0.1
    assert values["x3"]["sigma"] == 0.0


def test_points_of_the_designs() -> None:
    design = SobolIndices(kind="sobol-indices", count=4)
    blocks = design.points(20, 3, seed=5).reshape(4, 5, 3)
    a, b = blocks[:, 0], blocks[:, -1]
    for column in range(3):
        mixed = blocks[:, 1 + column]
        assert (mixed[:, column] == b[:, column]).all()
        others = [c for c in range(3) if c != column]
        assert (mixed[:, others] == a[:, others]).all()
    paths = Morris(kind="morris", count=50).points(0, 3, seed=5).reshape(50, 4, 3)
    steps = np.abs(np.diff(paths, axis=1))
    assert ((steps == 0.0) | (steps == 0.5)).all()
    assert (steps.sum(axis=1) == 0.5).all()
    assert set(np.unique(paths)) == {0.125, 0.375, 0.625, 0.875}
    # Each level is equally likely: 150 draws, three standard deviations of √(150·3)/4.
    assert np.unique(paths[:, 0], return_counts=True)[1] == pytest.approx(37.5, abs=16)


def test_wrong_designs() -> None:
    with pytest.raises(ModelError, match=r"design.count: not a power of two: got 48.*32 or 64"):
        study(design={"kind": "sobol-indices", "count": 48})
    with pytest.raises(ModelError, match=r"design.levels: odd number of levels: got 5"):
        study(design={"kind": "morris", "count": 4, "levels": 5})


def test_mean_force_is_shared_as_the_forces_that_make_it(tmp_path: Path) -> None:
    """F_m = F₀ + a₁v² + a₂v²: shares of variance (Δᵢ)²/ΣΔ² of the widths Δ of uniform terms."""
    speed = 50.0
    widths = {"force": 40.0, "base": 20.0, "head": 10.0}
    place = "pantographs.0.model.masses"
    ends = {
        name: [0.5 * width / speed**2, 1.5 * width / speed**2] for name, width in widths.items()
    }
    variables = {
        "force": {"field": "pantographs.0.static_force", "range": ["60 N", "100 N"]},
        "base": {"field": f"{place}.0.aerodynamic", "range": ends["base"]},
        "head": {"field": f"{place}.1.aerodynamic", "range": ends["head"]},
    }
    made = load(
        data(
            set={**QUICK, "speed": speed},
            variables=variables,
            outputs={"mean": "mean_force_N"},
            design={"kind": "sobol-indices", "count": 32},
        )
    )
    run(made, tmp_path)
    values = json.loads((tmp_path / FILES["sensitivity"]).read_text())["outputs"]["mean"]
    assert (values["blocks"], values["left_out"]) == (32, 0)
    total = sum(width**2 for width in widths.values())
    for name, width in widths.items():
        one = values["indices"][name]
        # 32 blocks: a total index of 0.76 is known to about 1.5·0.76/√32, its interval is that.
        assert abs(one["total"] - width**2 / total) < max(1.5 * one["total_interval"], 0.02)
        assert abs(one["first"] - width**2 / total) < max(1.5 * one["first_interval"], 0.02)
        assert one["total_interval"] < 0.5
    page = html(made, tmp_path)
    assert "Sobol indices: the share" in page
    assert not mistakes_of(document_in(page))


def test_in_the_report(tmp_path: Path) -> None:
    shares = {"force": {"field": "pantographs.0.static_force", "range": [60, 90]}}
    made = filled(tmp_path, of=15, variables=shares, design={"kind": "morris", "count": 8})
    page = html(made, tmp_path)
    assert "7 blocks of the design are complete; 1 with a variant" in page
    assert "mean size μ*" in page
    assert not mistakes_of(document_in(page))


def test_a_missing_package_is_one_sentence(tmp_path: Path, monkeypatch: Any) -> None:
    from importlib.util import find_spec

    without = lambda name: None if name == "SALib" else find_spec(name)  # noqa: E731
    monkeypatch.setattr("importlib.util.find_spec", without)
    made = study(design={"kind": "morris", "count": 4})
    with pytest.raises(StudyError, match=r"design needs the package SALib.*pip install"):
        run(made, tmp_path / "new")
    assert not (tmp_path / "new").exists()
