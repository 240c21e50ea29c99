"""Words of the page: verdict, what tells runs apart, errors of files, first screens."""

import re
from collections.abc import Callable
from pathlib import Path
from shutil import copytree

import pytest

from tests.browser.kinds import arcless
from tests.studio.studio import PHONE, SMALL, Studio, Window

Start = Callable[[Path], Studio]
SHIPPED = "en50318-ac-simple-320-planar"
TWO = "shipped:scenario/ac-simple-320-two-pantographs"
NARROW = {"width": 1000, "height": 720}
# In ms: a run of a second or two, and a worker that starts before it.
RUN = 60_000
# A bar of one row of fields of 26 px, with 5 px above and below: two rows would be 66 px.
ONE_ROW = 40


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with two runs: only the mean force of the newer one is missed."""
    folder = tmp_path_factory.mktemp("kept")
    arcless("new", "line", "--from", SHIPPED, "--to", folder)
    quiet = ("--quiet", "--no-report", "--out")
    arcless("run", folder / "line.yaml", *quiet, folder / "runs" / "a")
    changed = ("--set", "speed=210 km/h", "--set", "pantographs.0.mean_force=150 N")
    arcless("run", folder / "line.yaml", *changed, *quiet, folder / "runs" / "b")
    return folder


def chosen(page: Window, place: int) -> str:
    """Open a run of the tree, the newest first; return the words of its verdict in one line."""
    page.click(f".run-entry .name >> nth={place}")
    page.wait(".verdict-of .numbers")
    page.until("document.querySelector('.verdict-of .criterion') !== null")
    return " ".join(page.text(".verdict-of").split())


def test_the_verdict_names_what_is_missed_and_sigma_else(studio: Start, kept: Path) -> None:
    page = studio(kept).open()
    page.wait(".run-entry")
    chosen(page, 0)
    page.until("/mean contact/.test(document.querySelector('.verdict-of .criterion')?.innerText)")
    missed = " ".join(page.text(".verdict-of").split())
    assert re.search(r"not met mean contact force F_m, upper limit 150\.0 N", missed)
    page.until("document.querySelector('.run-entry.here .differs').innerText.includes('210')")
    page.click(".run-entry .name >> nth=1")
    page.until("document.querySelector('.verdict-of .criterion')?.innerText === 'σ'")
    worst = " ".join(page.text(".verdict-of").split())
    assert re.search(r"not met σ 60\.\d N \(limit ≤ 50\.\d N\) and 2 more", worst)


@pytest.mark.parametrize("size", [SMALL, NARROW])
def test_the_bar_is_one_row_also_with_two_pantographs(
    studio: Start, kept: Path, size: dict[str, int]
) -> None:
    page = studio(kept).open(size)
    page.wait(".run-entry")
    chosen(page, 0)  # the longest words that a verdict has
    page("selectOption", ".run-bar .scenario select", TWO)
    page.until("document.querySelectorAll('.run-bar > label').length === 4")
    found = page.js("""(() => { const bar = document.querySelector(".run-bar");
      return [bar.clientHeight, bar.scrollWidth - bar.clientWidth]; })()""")
    assert found[0] <= ONE_ROW
    assert found[1] <= 0
    # Numbers are whole: nothing of them is cut.
    right = "document.querySelector('.verdict-of{}').getBoundingClientRect().right"
    assert page.js(f"{right.format(' .numbers')} - {right.format('')}") <= 0
    assert page.axe() == []


def test_a_phone_opens_the_newest_run_and_an_empty_one_says_what_to_do(
    studio: Start, kept: Path, tmp_path: Path
) -> None:
    page = studio(kept).open(PHONE)
    page.wait(".verdict-of .numbers")
    assert "mean contact force" in page.text(".verdict-of")
    assert page.js("document.documentElement.scrollWidth") <= PHONE["width"]
    arcless("new", "line", "--from", SHIPPED, "--to", tmp_path)
    page = studio(tmp_path).open(PHONE)
    page.click("role=tab[name=Results]")
    page.wait("text=There is no run yet. Choose a scenario at the top and press Run")


def test_a_broken_line_is_told_once_by_its_path_in_the_folder(
    studio: Start, tmp_path: Path
) -> None:
    (tmp_path / "lines").mkdir()
    (tmp_path / "lines" / "a.yaml").write_text("format: arcless-line/1\nname: [a\n", "utf-8")
    (tmp_path / "b.yaml").write_text(
        "format: arcless-scenario/1\nname: b\nline: lines/a.yaml\n", "utf-8"
    )
    page = studio(tmp_path).open()
    page.until("document.querySelectorAll('nav .broken').length === 2")
    of_scenario, of_line = page.js(
        "[...document.querySelectorAll('nav .broken')].map((one) => one.innerText)"
    )
    assert of_scenario == "names lines/a.yaml, which cannot be read"
    assert of_line.startswith("lines/a.yaml:")
    assert str(tmp_path) not in page.text("nav")
    page.events  # noqa: B018 - the browser says that the broken line was refused


@pytest.mark.evidence
def test_a_line_is_opened_from_statics_and_run_as_a_variant(studio: Start, tmp_path: Path) -> None:
    arcless("new", "line", "--from", SHIPPED, "--to", tmp_path)
    arcless("run", tmp_path / "line.yaml", "--quiet", "--no-report", "--out", tmp_path / "runs/a")
    before = (tmp_path / "line-line.yaml").read_text("utf-8")
    page = studio(tmp_path).open()
    page.click("role=tab[name=Statics]")
    page.click('role=button[name="Open the line"]')
    slider = 'input[type=range][id="slider-contact_wire.tension"]'
    page.wait(slider)
    page("focus", slider)
    page.press(*["ArrowRight"] * 5)
    page.click('.statics >> role=button[name="Run as variant"]')
    page.until("document.querySelectorAll('.run-entry').length === 2", RUN)
    assert page.text(".run-entry .differs") == "Line contact wire: tension 23 kN"
    assert list((tmp_path / "runs").glob("*tension=23_kN"))
    assert (tmp_path / "line-line.yaml").read_text("utf-8") == before
    assert page.axe() == []


def test_runs_on_other_lines_are_told_apart(studio: Start, kept: Path, tmp_path: Path) -> None:
    for name in ("line.yaml", "line-line.yaml"):
        (tmp_path / name).write_bytes((kept / name).read_bytes())
    (tmp_path / "runs").mkdir()
    copytree(kept / "runs" / "a", tmp_path / "runs" / "a")
    line = tmp_path / "line-line.yaml"
    line.write_text(line.read_text("utf-8").replace("22 kN", "24 kN"), "utf-8")
    run = ("run", tmp_path / "line.yaml", "--quiet", "--no-report", "--out")
    arcless(*run, tmp_path / "runs" / "c")
    line.write_text(line.read_text("utf-8").replace("24 kN", "25 kN"), "utf-8")
    arcless(*run, tmp_path / "runs" / "d")
    page = studio(tmp_path).open()
    page.until("document.querySelectorAll('.run-entry .differs').length >= 2")
    told = page.js("[...document.querySelectorAll('.run-entry .differs')].map((o) => o.innerText)")
    assert len(set(told)) == len(told)
    assert all(re.fullmatch(r"line \S+, version \d of \d", text) for text in told)


def test_a_measurement_of_a_run_lies_on_it_and_has_its_name(
    studio: Start, kept: Path, tmp_path: Path
) -> None:
    for name in ("line.yaml", "line-line.yaml"):
        (tmp_path / name).write_bytes((kept / name).read_bytes())
    (tmp_path / "runs").mkdir()
    copytree(kept / "runs" / "a", tmp_path / "runs" / "a")
    (tmp_path / "measured").mkdir()
    arcless("measure", tmp_path / "runs" / "a", "--to", tmp_path / "measured" / "site-7.csv")
    page = studio(tmp_path).open()
    page("check", ".run-entry input")
    page("check", "nav input[aria-label$='site-7.csv']")
    page.click("role=tab[name=Compare]")
    page.wait('[aria-label="Placement of the measurement"] tbody')
    placed = page.text('[aria-label="Placement of the measurement"] tbody')
    assert "site-7 (measured)" in placed
    assert "correlation of the height" in placed
    # The amplifier delays by 3.2 ms at 88.9 m/s; samples are 0.18 m apart.
    offset = re.search(r"−(0\.\d\d)\s*m", placed)
    assert offset is not None
    assert float(offset[1]) == pytest.approx(0.28, abs=0.18)
    assert "--" not in page.text('[aria-label="Remarks"]')
