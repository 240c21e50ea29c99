"""Results on the page: verdict, figures, comparison, a measurement, why σ, space–time view."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import arcless
from arcless.results import open as open_result
from tests.studio.studio import PHONE, Studio, Window

SCENARIO = "en50318-ac-simple-320-planar"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project with two runs of one scenario, the second one slower."""
    found = tmp_path_factory.mktemp("project")
    for name, speed in (("fast", "320 km/h"), ("slow", "300 km/h")):
        place = found / "runs" / name
        place.mkdir(parents=True)
        arcless.run(arcless.load(SCENARIO).with_(speed=speed)).save(place / "result.nc")
    return found


TITLES = "[...document.querySelectorAll('figure.chart h4')].map((one) => one.textContent)"
SHARES = (
    "[...document.querySelectorAll('.shares .number')].map((one) => parseFloat(one.textContent))"
)
MAP, BARS = "Dropper forces while the train passes", "Standard deviation in each span"


def of(title: str) -> str:
    """Return the selector of a figure by its title."""
    return f'figure.chart:has(h4:text-is("{title}"))'


def tick(page: Window, *names: str) -> None:
    """Tick runs in the list that the comparison offers while there is nothing to compare."""
    show(page, "Compare")
    for name in names:
        page.click(f".run-list label:has([title$='{name}']) input")


def show(page: Window, title: str) -> None:
    page.click(f'role=tab[name="{title}"]')


def drawn(page: Window, title: str) -> str:
    """Wait until the figure of a title is drawn; return the selector of its frame."""
    page.wait(of(title), state="attached")
    page.js(f"""[...document.querySelectorAll('figure.chart')].find((one) =>
        one.querySelector('h4').textContent === {title!r}).scrollIntoView()""")
    frame = f"{of(title)} .chart-frame"
    page.wait(f"{frame} canvas")
    return frame


def ink(page: Window, title: str) -> int:
    """Return how many pixels of a figure are drawn."""
    return int(
        page.js(f"""(() => {{
        const figure = [...document.querySelectorAll('figure.chart')].find((one) =>
            one.querySelector('h4').textContent === {title!r});
        const drawn = figure.querySelector('canvas'), canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [drawn.width, drawn.height];
        const copy = canvas.getContext('2d', {{willReadFrequently: true}});
        copy.drawImage(drawn, 0, 0);
        const data = copy.getImageData(0, 0, canvas.width, canvas.height).data;
        let count = 0;
        for (let k = 3; k < data.length; k += 4) count += data[k] > 0;
        return count;
    }})()""")
    )


def test_nothing_is_ticked(studio: Callable[[Path], Studio], tmp_path: Path) -> None:
    page = studio(tmp_path).open()
    for title, said in (
        ("Results", "There is no run yet"),
        ("Compare", "Nothing is ticked"),
        ("Why σ", "There is no run yet"),
        ("Space–time", "There is no run yet"),
    ):
        show(page, title)
        page.wait(f"text={said}")
    assert page.axe() == []


def test_a_run_has_its_verdict_and_all_figures_of_its_report(
    studio: Callable[[Path], Studio], folder: Path
) -> None:
    page = studio(folder).open()
    tick(page, "fast")
    show(page, "Results")
    page.wait(".result-verdict")
    result = open_result(folder / "runs" / "fast")
    assert result.assessment.headline.text in page.text(".result-verdict")
    titles = page.js(TITLES)
    assert sorted(titles) == sorted(f.title for group in result.figures.values() for f in group)
    for title in ("Contact force", MAP, BARS):
        drawn(page, title)
        assert ink(page, title) > 1000
    assert page.axe() == []


def test_figures_along_the_track_are_zoomed_together_and_by_keys(
    studio: Callable[[Path], Studio], folder: Path
) -> None:
    page = studio(folder).open()
    tick(page, "fast")
    show(page, "Results")
    frame = drawn(page, "Contact force")
    page("focus", frame)
    page.press("+", "+", "+")
    page.wait(f'{of("Contact force")} button:text-is("Show all")')
    drawn(page, "Height of the contact point")
    page.wait(f'{of("Height of the contact point")} button:text-is("Show all")')
    page("focus", frame)
    page.press("Shift+ArrowRight")
    page.wait("output.chart-readout:text-matches('force .* N')")
    page.press("0")
    page.wait(".chart-head button", "hidden")


def test_a_legend_hides_a_curve(studio: Callable[[Path], Studio], folder: Path) -> None:
    page = studio(folder).open()
    tick(page, "fast")
    show(page, "Results")
    drawn(page, "Contact force")
    before = ink(page, "Contact force")
    page.click(f'{of("Contact force")} .chart-legend button:has-text("unfiltered")')
    page.wait(".chart-legend button[aria-pressed=false]")
    assert ink(page, "Contact force") < before


def test_ticked_runs_are_overlaid_with_what_differs_alone(
    studio: Callable[[Path], Studio], folder: Path
) -> None:
    page = studio(folder).open()
    tick(page, "fast", "slow")
    show(page, "Compare")
    drawn(page, "Contact force")
    legend = page.text(f"{of('Contact force')} .chart-legend")
    names = {f"{SCENARIO}, speed {speed} km/h" for speed in (320, 300)}
    assert {*names, "support"} == set(legend.split("\n"))
    fields = page.js("""[...document.querySelectorAll('table')].find((one) =>
        one.caption.textContent === 'What differs').tBodies[0].innerText""")
    assert fields.split("\t") == ["Speed", "320 km/h", "300 km/h"]
    assert page.axe() == []


def test_a_measurement_is_placed_and_judged(
    studio: Callable[[Path], Studio], folder: Path, tmp_path: Path
) -> None:
    data = open_result(folder / "runs" / "fast").dataset
    rows = np.column_stack([
        data["time"].values, data["position"].values[:, 0] + 7.0, data["contact_force"].values[:, 0]
    ])  # fmt: skip
    text = "time [s],position [m],contact_force [N]\n"
    text += "\n".join(",".join(f"{one:.5f}" for one in row) for row in rows[::2])
    page = studio(folder).open()
    tick(page, "fast")
    show(page, "Compare")
    file = tmp_path / "line-test.csv"
    file.write_text(text)
    page("setInputFiles", "input[type=file]", str(file))
    page.wait("text=Placement of the measurement")
    placed = page.js("""[...document.querySelectorAll('table')].find((one) =>
        one.caption.textContent.startsWith('Placement of the measurement')).tBodies[0].innerText""")
    assert "−7.00" in placed
    page.wait("text=Simulation against line test")
    assert "± 20 % (C)" in page.text("article.results")
    assert (folder / "measured" / "line-test.csv").is_file()


def test_a_worst_place_sets_the_clock_a_second_before(
    studio: Callable[[Path], Studio], folder: Path
) -> None:
    page = studio(folder).open()
    tick(page, "fast")
    show(page, "Why σ")
    page.wait("button.place")
    shares = page.js(SHARES)
    # Four numbers with one decimal each.
    assert sum(shares) == pytest.approx(100.0, abs=0.2)
    page.click("button.place")
    assert page.axe() == []


def test_a_run_without_motion_offers_it(studio: Callable[[Path], Studio], folder: Path) -> None:
    page = studio(folder).open()
    tick(page, "fast")
    show(page, "Space–time")
    page.wait('button:text-is("Run again with its motion")')


def test_a_damaged_run_is_said_to_be_one(studio: Callable[[Path], Studio], tmp_path: Path) -> None:
    place = tmp_path / "runs" / "broken"
    place.mkdir(parents=True)
    (place / "result.nc").write_bytes(b"no result")
    page = studio(tmp_path).open()
    tick(page, "broken")
    show(page, "Results")
    page.wait("role=alert")
    assert "result file" in page.text("[role=alert]")
    page("events")  # what the browser says of the refusal by itself


def test_on_a_phone_nothing_is_cut(studio: Callable[[Path], Studio], folder: Path) -> None:
    page = studio(folder).open(PHONE)
    tick(page, "fast")
    show(page, "Results")
    drawn(page, "Contact force")
    assert page.js("document.documentElement.scrollWidth") <= PHONE["width"]
