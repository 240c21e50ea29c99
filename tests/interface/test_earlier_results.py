"""A result of an earlier version is read by all that follows from a run.

`data/earlier` was written by the code of 2026-11-23, commit f257e1e, from `data/short.yaml` with
six spans: before supports, pages, lateral positions and fields as typed were recorded.
"""

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

import arcless as library

EARLIER = Path(__file__).parent / "data" / "earlier"
Arcless = Callable[..., Result]


@pytest.fixture
def earlier(tmp_path: Path) -> Path:
    shutil.copytree(EARLIER, tmp_path / "earlier")
    return tmp_path / "earlier"


def test_its_numbers_are_those_it_had(earlier: Path) -> None:
    then = json.loads((earlier / "assessment.json").read_text("utf-8"))["pantographs"][0]
    (now,) = library.open(earlier).assessment.pantographs
    # The filter starts by another formula since then: last bits of sums of some hundred newtons.
    for key in ("mean_force_N", "std_force_N", "max_force_N", "min_force_N"):
        assert getattr(now, key) == pytest.approx(then[key], abs=1e-9), key


@pytest.mark.parametrize(
    ("words", "made"),
    [
        ("assess earlier --json", ""),
        ("assess earlier --from=100m --to=150m", ""),
        ("report earlier", "earlier/report.html"),
        ("report earlier --pdf earlier.pdf", "earlier.pdf"),
        ("explain earlier --out explained.html", "explained.html"),
        ("stress earlier --exponent 5", ""),
        ("measure earlier --to measured.csv", "measured.csv"),
        ("export earlier --to earlier.csv", "earlier.csv"),
        ("export earlier --to earlier.xlsx", "earlier.xlsx"),
        ("export earlier --to earlier.mat", "earlier.mat"),
        ("export earlier --to earlier.parquet", "earlier.parquet"),
        ("runs . --json", ""),
    ],
)
def test_commands_after_the_run_read_it(
    arcless: Arcless, earlier: Path, words: str, made: str
) -> None:
    done = arcless(*words.split())
    assert done.exit_code in (0, 3), done.output  # 3: a criterion is not met
    if made:
        assert (earlier.parent / made).stat().st_size > 0


def test_it_is_compared_with_a_run_of_today(
    arcless: Arcless, earlier: Path, finished: Path
) -> None:
    done = arcless("compare", "earlier", finished, "--out", "two.html", "--pdf", "two.pdf")
    assert done.exit_code == 0, done.output
    assert (earlier.parent / "two.html").is_file()
    assert (earlier.parent / "two.pdf").is_file()


def test_objects_of_it_show_themselves(earlier: Path) -> None:
    result = library.open(earlier)
    assert "earlier" in result._repr_html_()
    assert result.to_dataframe().shape[0] == result.dataset.sizes["time"]
    assert result.filtered_force().attrs["units"] == "N"
