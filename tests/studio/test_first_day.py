"""A first day in the studio: example, run, watch, change, compare, and a server that dies."""

import json
import signal
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

from arcless import study
from tests.browser.kinds import arcless
from tests.studio.studio import DESK, PHONE, Studio, Window

Start = Callable[[Path], Studio]
# In ms: a run of the example takes a second or two of one core, and workers start before it.
RUN = 60_000
SHIPPED = "en50318-ac-simple-320-planar"
COPY = f"my-{SHIPPED}"
# Short, so that a variant takes a tenth of a second, and long enough to be explained.
SHORT = """format: arcless-scenario/1
name: short
base: en50318-ac-simple-275-planar
set:
  line.spans: [{type: standard, count: 8}]
  travel: {start: 60 m, end: 380 m}
  analysis: {from: 100 m, to: 340 m}
  pantographs.0.static_force: 130 N
"""


def ran(page: Window, count: int = 1) -> None:
    """Wait for so many runs in the tree, and the verdict of the last one in the bar."""
    page.until(f"document.querySelectorAll('.run-entry').length === {count}", RUN)
    page.wait(".verdict-of .numbers")


def test_an_empty_folder_to_a_verdict_in_one_click(studio: Start, tmp_path: Path) -> None:
    page = studio(tmp_path).open()
    page.click("text=Copy and run it")
    ran(page)
    assert "not met" in page.text(".verdict-of")
    assert "limit" in page.text(".verdict-of")
    scenario = yaml.safe_load((tmp_path / f"{COPY}.yaml").read_text("utf-8"))
    assert scenario["name"] == COPY
    assert len(list((tmp_path / "runs").glob(f"{COPY}*/result.nc"))) == 1
    # Verdict by word and shape, not by colour alone.
    assert "✖" in page.text(".run-entry .verdict-word")
    # It can be watched at once: the player stands below, and the clock goes on.
    # What was computed is followed to its end first: until then the key would pause.
    page.wait(".transport button[aria-label=Play]")
    page.press("Space")
    where = page.text(".transport .where")
    page.until(f"document.querySelector('.transport .where').innerText !== {where!r}")


@pytest.mark.evidence
def test_keys_alone_lead_from_a_shipped_line_to_a_verdict(studio: Start, tmp_path: Path) -> None:
    page = studio(tmp_path).open()
    page.wait(".start")
    page.press("Control+k")
    page.wait("dialog input")
    page.type("library")
    page.press("Enter")
    page.wait("dialog input", "hidden")  # then the focus is back where it was
    page("focus", ".start .search")
    page.type(SHIPPED)
    page.until("document.querySelectorAll('.template').length === 1")
    page.press("Tab", "Enter")
    # Its name is asked for, and can be another one.
    page.until("document.activeElement.name === 'name'")
    assert page.js("document.activeElement.value") == COPY
    page.press("Enter")
    page.wait(".form input")
    page("focus", ".run-bar .speed")
    page.press("Control+a")
    page.type("300 km/h")
    page.press("Enter")
    page.wait("text=Variant of")
    page.press("Control+Enter")
    ran(page)
    assert "300 km/h" in page.text(".run-entry")
    assert list((tmp_path / "runs").glob("*speed=300_km-h"))


@pytest.mark.evidence
def test_a_variant_is_compared_and_kept(studio: Start, tmp_path: Path) -> None:
    arcless("new", "line", "--from", SHIPPED, "--to", tmp_path)
    arcless("run", tmp_path / "line.yaml", "--out", tmp_path / "runs" / "line", "--quiet")
    page = studio(tmp_path).open()
    page.wait(".speed")
    page.type("300 km/h", into=".run-bar .speed")
    page.press("Enter")
    page.click(".run-bar button.run")
    ran(page, 2)
    assert page.text(".run-entry .differs") == "Speed 300 km/h"
    for place in range(2):
        page("check", f".run-entry input >> nth={place}")
    page.click("role=tab[name=Compare]")
    page.wait("main table")
    assert "300 km/h" in page.text("main [role=tabpanel]")
    assert page.axe() == []
    page.click("text=Save as scenario")
    page.type("faster", into=".variant input")
    page.press("Enter")
    page.wait('nav >> text="faster"')
    # Only the difference is written.
    kept = yaml.safe_load((tmp_path / "faster.yaml").read_text("utf-8"))
    assert kept["base"] == "line.yaml"
    assert kept["set"] == {"speed": "300 km/h"}


@pytest.mark.evidence
def test_a_copied_scenario_is_run_and_a_verdict_says_of_what_it_is(
    studio: Start, tmp_path: Path
) -> None:
    (tmp_path / "short.yaml").write_text(SHORT)
    arcless("run", tmp_path / "short.yaml", "--quiet", "--no-report", "--out", tmp_path / "runs/a")
    page = studio(tmp_path).open(DESK)
    page.click(".run-entry .name")
    page.wait(".verdict-of .numbers")
    assert page.text(".verdict-of .of") == "short"
    assert page.count(".verdict-of .mark") == 0
    # Values of the bar, and of the file, are others than those of the run.
    page.type("300 km/h", into=".run-bar .speed")
    page.press("Enter")
    page.wait('.verdict-of >> text="of another variant"')
    page.click('role=button[name="Take back"]')
    page.wait(".verdict-of .mark", "hidden")
    (tmp_path / "short.yaml").write_text(SHORT.replace("130 N", "140 N"))
    page.wait('.verdict-of >> text="outdated: changed since"')
    # A copy of a shipped scenario is the one that is run, whatever was before.
    page.click('nav >> role=button[name="New …"]')
    page.type(SHIPPED, into=".start .search")
    page.until("document.querySelectorAll('.template').length === 1")
    page.click(".template .name")
    page.type("mine", into=".copy-form input")
    page.press("Enter")
    page.until("document.querySelector('.run-bar .scenario select').value === 'mine.yaml'")
    page.wait('.verdict-of >> text="of another scenario"')
    assert page.axe() == []
    # A line that is open and not part of it is seen; a click on the scenario chooses it.
    page.click('nav >> text="mine-line"')
    assert page.count(".beside") == 0
    page.click('nav >> text="short" >> nth=0')
    page.click('nav >> text="mine-line"')
    page.wait(".beside")
    page.click('role=button[name="Open the scenario"]')
    page.wait(".beside", "hidden")
    # What is ticked and played is there after the page was read anew.
    page("reload")
    page.wait(".run-entry input:checked, .run-entry.here")
    page.wait('.verdict-of >> text="outdated: changed since"')


@pytest.mark.evidence
def test_a_slider_becomes_a_variant_and_a_schedule_of_droppers(
    studio: Start, tmp_path: Path
) -> None:
    arcless("new", "line", "--from", SHIPPED, "--to", tmp_path)
    page = studio(tmp_path).open()
    page.click(".run-bar button.run")
    ran(page)
    page.click("role=tab[name=Statics]")
    page.click("text=Open the line")
    page.wait(".slider")
    page.type("24", into='[aria-label="Contact wire: Tension, number"]')
    page.press("Tab")
    page.js(
        "(() => { const make = URL.createObjectURL; URL.createObjectURL = (blob) => {"
        " void blob.text().then((text) => { window.saved = text; }); return make(blob); }; })()"
    )
    page.click("text=Dropper schedule as CSV")
    page.until("window.saved !== undefined")
    tried, file, out = tmp_path / "tried", tmp_path / "line-line.yaml", tmp_path / "d.csv"
    before = file.read_text("utf-8")
    tried.mkdir()
    (tried / file.name).write_text(before.replace("22 kN", "24 kN", 1), "utf-8")
    arcless("statics", tried / file.name, "--droppers", out)
    assert page.js("window.saved").splitlines() == out.read_text("utf-8").splitlines()
    page.click('.statics >> role=button[name="Run as variant"]')
    ran(page, 2)
    # Both are ticked, and only the difference is in a name; no file was changed.
    assert "24 kN" in page.text(".run-entry >> nth=0")
    assert page.count(".run-entry input:checked") == 2
    assert file.read_text("utf-8") == before
    page.click("role=tab[name=Compare]")
    page.wait("main table")
    assert "Line contact wire: tension" in page.text("main [role=tabpanel]")


@pytest.mark.evidence
def test_a_study_finds_a_better_variant_which_is_run(studio: Start, tmp_path: Path) -> None:
    (tmp_path / "short.yaml").write_text(SHORT)
    page = studio(tmp_path).open()
    page.click('nav >> text="short" >> nth=0')
    page.click('role=tab[name="Studies"]')
    for words, field, low, high in (
        ("static force", "pantographs.0.static_force", "100", "160"),
        ("contact tension", "line.contact_wire.tension", "20", "26"),
    ):
        page.type(words, into=".fields input[type=search]")
        page.click(f".fields label[title^='{field}.'] input")
        own = f".varied:has(code:text-is('{field}'))"
        page.type(low, into=f"{own} input >> nth=1")
        page.type(high, into=f"{own} input >> nth=2")
    page.wait("text=25 variants")
    page.click('role=button[name="Save and start"]')
    # Rows come in, and are seen in parallel coordinates.
    page.until("document.querySelectorAll('.rows tbody tr').length > 0")
    page.wait(".parallel canvas")
    page.until(
        "document.querySelector('.state [role=status]')?.innerText.startsWith('25 of 25')", RUN
    )
    page.click('.rows thead >> text="Standard deviation σ"')
    page.click(".rows tbody tr:nth-child(1)")
    number = int(page.text(".picked strong").removeprefix("Variant "))
    rows = {row.variant: row for row in study.open(tmp_path / "runs/studies/short-study").rows()}
    assert number == min(rows, key=lambda one: rows[one].outputs["std_force_N"])
    # As a scenario, which holds only the difference, and which is run.
    page.click('role=button[name="Open as scenario"]')
    page.wait(f".run-bar select >> text=short-study-{number}", "attached")
    page.click(".run-bar button.run")
    ran(page)
    kept = yaml.safe_load((tmp_path / f"short-study-{number}.yaml").read_text("utf-8"))
    assert kept["base"] == "short.yaml"
    assert {*kept["set"]} == {"pantographs.0.static_force", "line.contact_wire.tension"}
    (result,) = (tmp_path / "runs").glob(f"short-study-{number}*/assessment.json")
    told = json.loads(result.read_text("utf-8"))["pantographs"][0]
    assert told["std_force_N"] == rows[number].outputs["std_force_N"]


@pytest.mark.evidence
def test_two_tabs_and_a_file_changed_outside(studio: Start, tmp_path: Path) -> None:
    arcless("new", "line", "--from", SHIPPED, "--to", tmp_path)
    server = studio(tmp_path)
    one = server.open()
    two = server.open(beside=one)
    for page in (one, two):
        page.wait(".speed")
    file = tmp_path / "line.yaml"
    file.write_text(file.read_text("utf-8").replace("320 km/h", "310 km/h"), "utf-8")
    for page in (one, two):
        page.until("document.querySelector('.run-bar .speed').value === '310 km/h'")
    one.press("Control+Enter")
    for page in (one, two):
        page.until("document.querySelectorAll('.run-entry').length === 1", RUN)


@pytest.mark.evidence
def test_a_server_that_dies_in_a_run_leaves_no_half_of_it(studio: Start, tmp_path: Path) -> None:
    arcless("new", "line", "--from", SHIPPED, "--to", tmp_path)
    server = studio(tmp_path)
    page = server.open()
    page.wait(".speed")
    page.press("Control+Enter")
    page.wait(".running progress")
    server.signal(signal.SIGKILL)
    page.wait("text=The server does not answer")
    files = [path for path in tmp_path.rglob("*") if path.is_file()]
    # A result is whole, or it is not there.
    for result in [path for path in files if path.name == "result.nc"]:
        arcless("assess", result)
    server.start(server.port)
    beside = server.open(beside=page)
    beside.wait(".speed")
    page.wait(".lost", "hidden")
    page.server_is_gone()
    page.press("Control+Enter")
    ran(page)


def test_a_phone(studio: Start, tmp_path: Path) -> None:
    arcless("new", "line", "--from", SHIPPED, "--to", tmp_path)
    page = studio(tmp_path).open(PHONE)
    page.click(".run-bar button.run")
    ran(page)
    assert page.axe() == []
    assert page.js("document.documentElement.scrollWidth") <= PHONE["width"]


@pytest.mark.evidence
def test_main_views_are_accessible(studio: Start, tmp_path: Path) -> None:
    arcless("new", "line", "--from", SHIPPED, "--to", tmp_path)
    for name in ("a", "b"):
        arcless("run", tmp_path / "line.yaml", "--out", tmp_path / "runs" / name, "--quiet")
    server = studio(tmp_path)
    for dark in (False, True):
        page = server.open(DESK, dark=dark)
        page.click(".run-entry .name >> nth=0")
        page.wait(".verdict-of .numbers")
        for place in range(2):
            page("check", f".run-entry input >> nth={place}")
        tabs = page.js("[...document.querySelectorAll('main [role=tab]')].map((tab) => tab.id)")
        assert len(tabs) >= 7
        for tab in tabs:
            page.click(f"#{tab.replace(' ', chr(92) + ' ')}")
            page("waitForLoadState", "networkidle")
            assert page.axe() == [], tab
