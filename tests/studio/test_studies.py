"""Studies as somebody at the window makes them: define, watch, pick, open as a scenario."""

import itertools
from collections.abc import Callable
from pathlib import Path

import pytest

import arcless
from arcless import study
from arcless.study.report.data.judge import judge
from arcless.study.report.data.judged import VERDICTS
from arcless.study.report.data.record import Record
from tests.browser import kinds
from tests.studio.studio import DESK, PHONE, Studio, Window

Start = Callable[[Path], Studio]
# Short, so that a variant takes some hundredths of a second.
SCENARIO = """format: arcless-scenario/1
name: short
base: en50318-ac-simple-275-planar
set:
  line.spans: [{type: standard, count: 5}]
  travel: {start: 60 m, end: 180 m}
  analysis: {from: 100 m, to: 170 m}
  pantographs.0.static_force: 130 N
"""
FORCE = """format: arcless-study/1
name: force
scenario: short.yaml
variables:
  force: {field: pantographs.0.static_force, values: [100 N, 130 N, 160 N, -1 N]}
design: {kind: grid}
outputs: [mean_force_N, std_force_N, passed]
"""
ROWS = "document.querySelectorAll('.rows tbody tr:not([aria-hidden])').length"
CANVAS = "document.querySelector('.parallel canvas')"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with a short scenario."""
    (tmp_path / "short.yaml").write_text(SCENARIO)
    return tmp_path


def defining(studio: Start, folder: Path) -> Window:
    """Return a window in which two fields are ticked, each with three values."""
    page = studio(folder).open(DESK)
    page.click('nav >> text="short" >> nth=0')
    page.click('role=tab[name="Studies"]')
    for words, label in (("contact tension", "contact wire: tension"), ("speed", "speed")):
        page.type(words, into=".fields input[type=search]")
        page.click(f".fields label:has-text('{label}') input")
    page.until("document.querySelectorAll('.varied').length === 2")
    for number in (1, 2):
        page.type("3", into=f".varied:nth-of-type({number}) input[type=number]")
        page.press("Tab")
    page.wait("text=9 variants")
    return page


def test_a_study_is_defined_watched_and_a_variant_opened(studio: Start, folder: Path) -> None:
    page = defining(studio, folder)
    assert page.axe() == []
    page.click('role=button[name="Save and start"]')
    page.until("document.querySelector('.state [role=status]')?.innerText.startsWith('9 of 9')")
    page.until(f"{ROWS} === 9")
    loaded = study.load(folder / "short-study.yaml")
    assert loaded.plan.count == 9
    page.click(".rows tbody tr:nth-child(4)")
    page.wait("text=Variant 4 >> nth=0")
    assert page.axe() == []
    page.click('role=button[name="Open as scenario"]')
    page.wait("text=is the scenario short-study-4.yaml")
    made = arcless.load(folder / "short-study-4.yaml")
    assert "base: short.yaml" in (folder / "short-study-4.yaml").read_text()
    # The fourth of a grid of three by three: the second tension, the first speed.
    assert made.line.contact_wire.tension == pytest.approx(22e3)
    assert made.speed == pytest.approx(0.9 * 275 / 3.6)


def test_a_study_has_the_changes_of_the_run_bar(studio: Start, folder: Path) -> None:
    page = studio(folder).open(DESK)
    page.click('nav >> text="short" >> nth=0')
    page.type("250 km/h", into=".run-bar .speed")
    page.press("Enter")
    page.click('role=tab[name="Studies"]')
    page.type("contact tension", into=".fields input[type=search]")
    page.click(".fields label:has-text('contact wire: tension') input")
    page.wait("text=With the changes of the run bar: Speed 250 km/h")
    page.wait("text=5 variants")
    page.click('role=button[name="Save and start"]')
    page.until(f"{ROWS} === 5")
    assert study.load(folder / "short-study.yaml").changes == {"speed": "250 km/h"}
    page.click(".rows tbody tr:nth-child(2)")
    page.click('role=button[name="Open as scenario"]')
    page.wait("text=is the scenario short-study-2.yaml")
    assert arcless.load(folder / "short-study-2.yaml").speed == pytest.approx(250 / 3.6)


def test_brushes_by_mouse_and_by_keyboard(studio: Start, folder: Path) -> None:
    page = defining(studio, folder)
    page.click('role=button[name="Save and start"]')
    page.until(f"{ROWS} === 9")
    page.type("21", into='[aria-label="Lowest Line contact wire: tension"]')
    page.press("Tab")
    page.until(f"{ROWS} === 6")
    page.type("23", into='[aria-label="Highest Line contact wire: tension"]')
    page.press("Tab")
    page.until(f"{ROWS} === 3")
    page.click('role=button[name="Show all"]')
    page.until(f"{ROWS} === 9")
    # The first axis stands below the middle of its head.
    x, y = page.js(
        f"(() => {{ const head = document.querySelector('.head').getBoundingClientRect();"
        f" return [head.x + head.width / 2, {CANVAS}.getBoundingClientRect().y]; }})()"
    )
    page("mouse.move", x, y + 8)
    page("mouse.down")
    page("mouse.move", x, y + 60)
    page("mouse.up")
    page.until(f"{ROWS} === 3")  # the highest tension alone
    # A click on an axis that is brushed shows all again; the next one picks the nearest point.
    page("mouse.move", x, y + 40)
    page("mouse.down")
    page("mouse.up")
    page.until(f"{ROWS} === 9")
    page("mouse.down")
    page("mouse.up")
    page.wait(".picked strong")
    page.click(".rows")
    page.press("ArrowDown")
    page.wait(".picked strong")


def test_what_is_wrong_is_said_before_anything_is_saved(studio: Start, folder: Path) -> None:
    page = defining(studio, folder)
    page.type("10 bananas", into=".varied:nth-of-type(1) .how input >> nth=0")
    # It stands where it is, without the path of a file that is not there yet.
    page.wait(".varied:nth-of-type(1) .problem")
    assert page.count(".define .problem") == 1
    assert page.text(".define .problem").startswith('Got "10 bananas", expected a force')
    page.type("22", into=".varied:nth-of-type(1) .how input >> nth=0")
    page.type("22", into=".varied:nth-of-type(1) .how input >> nth=1")
    page.wait("text=Empty range")
    assert page.count(".varied:nth-of-type(1) .problem") == 1
    assert page.js("[...document.querySelectorAll('.define button.main')].every((b) => b.disabled)")
    assert not (folder / "short-study.yaml").exists()


def test_failed_variants_are_listed_with_their_sentence(studio: Start, folder: Path) -> None:
    (folder / "bad.yaml").write_text(
        """format: arcless-study/1
name: bad
scenario: short.yaml
variables:
  force: {field: pantographs.0.static_force, values: [130 N, -1 N]}
design: {kind: grid}
outputs: [mean_force_N]
"""
    )
    page = studio(folder).open(PHONE)
    page.part("Project")
    page.click('nav >> text="short" >> nth=0')
    page.click('role=tab[name="Studies"]')
    page.click('.studies >> role=button[name="Watch"]')
    page.click('.choice >> role=button[name="Start"]')
    page.click(".failed summary")
    assert "static_force" in page.text(".failed li")
    page.click(".failed li button")
    page.wait(".picked .problem")
    assert page.js("document.documentElement.scrollWidth") <= PHONE["width"]


def test_rows_have_verdicts_and_axes_the_limits_by_word_and_shape(
    studio: Start, folder: Path
) -> None:
    page = defining(studio, folder)
    page.click('role=button[name="Save and start"]')
    page.until(f"{ROWS} === 9")
    record = Record(*_begun(folder))
    wanted = [VERDICTS[code] for code in judge(record).codes]
    assert {"met", "not met"} <= {*wanted}
    cells = "[...document.querySelectorAll('.rows tbody tr')].map((row) => row.cells[1].innerText)"
    assert [one[2:] for one in page.js(cells)] == wanted
    heads = page.js(
        "[...document.querySelectorAll('.rows thead th')].map((head) => head.innerText)"
    )
    assert "Standard deviation σ N" in heads
    assert "Line contact wire: tension kN" in heads
    limits = page.js("[...document.querySelectorAll('.head .limit')].map((one) => one.innerText)")
    assert len(limits) == 2  # of the mean force and of σ; the uplift of this line has none
    page("check", ".watch >> text=Only met")
    page.until(f"{ROWS} === {wanted.count('met')}")


def _begun(folder: Path) -> tuple[study.Study, Path]:
    place = study.open(folder / "runs" / "studies" / "short-study")
    return place.study, place.path


def test_a_search_for_the_best_is_defined_and_run(studio: Start, folder: Path) -> None:
    page = defining(studio, folder)
    page.click("text=Search for the best")
    page.type("6", into=".ways input[type=number]")
    page.press("Tab")
    page.wait("text=6 variants")
    assert page.axe() == []
    page.click('role=button[name="Save and start"]')
    page.until("document.querySelector('.state [role=status]')?.innerText.startsWith('6 of 6')")
    design = study.load(folder / "short-study.yaml").design
    assert isinstance(design, study.Optimise)
    assert (design.trials, design.objectives) == (6, {"std_force_N": "minimise"})
    assert [(one.output, one.at_least) for one in design.constraints] == [("passed", 1.0)]


def test_a_study_that_was_begun_is_not_written_over(studio: Start, folder: Path) -> None:
    page = defining(studio, folder)
    page.click('role=button[name="Save and start"]')
    page.until(f"{ROWS} === 9")
    text = (folder / "short-study.yaml").read_text()
    page.click('.studies >> role=button[name="Define"]')
    page.wait('role=button[name="Go on with it"]')
    page.type("20", into=".varied:nth-of-type(1) .how input >> nth=0")
    page.wait("text=was begun with other values")
    page.click('role=button[name="Save as short-study-2 and start"]')
    page.until("document.querySelector('.watch strong')?.innerText === 'short-study-2'")
    page.until(f"{ROWS} === 9")
    assert (folder / "short-study.yaml").read_text() == text
    assert "20 kN" in (folder / "short-study-2.yaml").read_text()


def test_a_study_goes_on_while_the_page_is_read_anew(studio: Start, folder: Path) -> None:
    page = defining(studio, folder)
    page.type("400", into=".varied:nth-of-type(1) input[type=number]")
    page.press("Tab")
    page.wait("text=1200 variants")
    page.click('role=button[name="Save and start"]')
    page.until(f"{ROWS} > 0")
    page("reload")
    page.wait("text=being computed")
    page.until(f"{ROWS} > 0")
    page.click('.state >> role=button[name="Stop"]')
    page.wait('.state >> role=button[name="Go on"]')
    place = study.open(folder / "runs" / "studies" / "short-study")
    assert 0 < sum(1 for _ in place.rows()) < 1200


def test_fields_are_varied_from_the_form_of_a_line(studio: Start, folder: Path) -> None:
    kinds.arcless("new", "own", "--from", "en50318-ac-simple-275-planar", "--to", folder)
    page = studio(folder).open(DESK)
    page.click('nav >> text="own" >> nth=0')
    button = 'role=button[name="Vary Speed in a study"]'
    page.wait(button)
    page("focus", button)
    page.press("Enter")
    page.wait('.varied code:text-is("speed")')
    page.click('role=button[name="Do not vary Speed in the study"]')
    page.wait(".varied", "hidden")
    assert page.axe() == []


def test_a_study_with_rows_is_accessible(studio: Start, folder: Path) -> None:
    (folder / "force.yaml").write_text(FORCE)
    study.run(study.load(folder / "force.yaml"), folder=folder / "runs" / "studies" / "force")
    server = studio(folder)
    for size, dark in itertools.product((DESK, PHONE), (False, True)):
        page = server.open(size, dark=dark)
        page.part("Project")
        page.click('nav >> text="short" >> nth=0')
        page.click('role=tab[name="Studies"]')
        page.click('.studies >> role=button[name="Watch"]')
        page.click('.choice >> text="force" >> nth=0')
        page.until(f"{ROWS} === 4")
        page.click(".rows tbody tr:nth-child(2)")
        page.wait(".picked strong")
        assert page.axe() == []
        page.click("text=Two columns")
        assert page.axe() == []
        page.click('.studies >> role=button[name="Define"]')
        page.click(".fields label >> nth=0")
        page.click("text=Search for the best")
        page.wait(".aims")
        assert page.axe() == []
        assert page.js("document.documentElement.scrollWidth") <= size["width"]
