"""The report as a file: complete, bounded, offline, and safe against what names may hold."""

import json
import re
from base64 import b64encode
from hashlib import sha256
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from arcless import report
from arcless.assess import assess
from arcless.errors import OutputError
from arcless.figures.description import Axis, Figure
from arcless.model import load
from arcless.report.drawing.bokeh_figure import Drawing
from arcless.report.drawing.bokeh_objects import document
from arcless.report.template import shown_figures
from arcless.results import Result
from tests.support.bokeh_pages import data_in, document_in, mistakes_of
from tests.support.synthetic import scenario_data, synthetic_dataset

# The limits that a report is promised to keep: of one kilometre, and of fifty.
MAX_BYTES_KILOMETRE, MAX_BYTES = 2_000_000, 4_000_000
FIGURES = [
    "Contact force around the worst place",
    "Contact force",
    "Height of the contact point",
    "Uplift of the contact wire at supports",
    "Uplift while the train passes a support",
    "Range of the dropper forces",
    "Dropper forces while the train passes",
    "Contact force over the span",
    "Standard deviation in each span",
    "Distribution of the contact force",
    "Spectrum of the unfiltered contact force",
    "Spectrogram of the unfiltered contact force",
    "Line at rest, side view",
    "Elasticity of the contact wire at rest, non-uniformity 14 %",
    "Energy balance",
]
SECTIONS = [
    "Criteria, AC 25 kV", "Numbers", "Contact force along the track", "Contact force by span",
    "Distribution and spectrum", "Contact wire and uplift", "Droppers", "Line at rest",
    "Model data", "Computation",
]  # fmt: skip


def result_of(dataset) -> Result:
    return Result(dataset, load(json.loads(dataset.attrs["scenario"])))


@pytest.fixture(scope="module")
def page() -> str:
    return report.html(result_of(synthetic_dataset()))


class Page(HTMLParser):
    """Return the content that a browser shows: tags with attributes, and text outside scripts."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict]] = []
        self.words: list[str] = []
        self.scripts: list[str] = []
        self.titles: list[str] = []
        self._inside, self._class = "", ""
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        self._inside, self._class = tag, dict(attrs).get("class") or ""

    def handle_endtag(self, tag):
        self._inside = ""

    def handle_data(self, data):
        if self._inside == "wbr":  # the word goes on
            data = self.words.pop() + data
        (self.scripts if self._inside == "script" else self.words).append(data)
        if self._class in ("figure-title", "title") or self._inside == "h2":
            self.titles.append(data.strip())

    @property
    def text(self) -> str:
        return " ".join(" ".join(self.words).split())


@pytest.mark.parametrize("title", FIGURES)
def test_every_figure_is_there(page: str, title: str) -> None:
    assert title in Page(page).titles


def test_every_section_is_there_and_in_the_contents(page: str) -> None:
    seen = Page(page)
    assert [title for title in seen.titles if title in SECTIONS] == SECTIONS
    ids = {attributes.get("id") for _, attributes in seen.tags}
    targets = [a["href"] for tag, a in seen.tags if tag == "a" and a["href"].startswith("#")]
    assert {target[1:] for target in targets} <= ids
    assert len(targets) > len(SECTIONS)


def test_contributions_are_a_section_where_there_is_something_to_tell(page: str) -> None:
    def force(t: np.ndarray) -> np.ndarray:
        return 100.0 + 20.0 * np.sin(0.8 * np.pi * t) + 5.0 * np.sin(1.1 * t)

    seen = Page(report.html(result_of(synthetic_dataset(force=force))))
    assert "Contributions to σ" in seen.titles
    assert "Contributions to the variance of the contact force" in seen.titles
    assert "the largest share of its variance is span passing" in seen.text
    assert "Contributions to σ" not in Page(page).titles  # its force is constant


def test_the_first_screen_says_what_was_run_and_what_came_of_it(page: str) -> None:
    before = Page(page[: page.index('id="criteria"')]).text
    for words in (
        "Line drawn line",
        "Pantograph drawn",
        "Speed 72 km/h",
        "Supply AC 25 kV",
        "Arcless 0.0.0",
        "Beyond a limit that is not verified: 1 of 9 criteria 7 met, 2 of them against unverified"
        " limits; 1 not judged",
        "mean contact force F_m, upper limit: 100.0 N, limit ≤ 92.4 N, tolerance 1 N,"
        " 7.6 N above it (8 %); the limit is not verified, mark C",
        "Worst place: ",
        "this run was drawn, not computed",
        "limit ≤ 30.0 N",
    ):
        assert words in before, words


def test_everything_else_is_there(page: str) -> None:
    text = Page(page).text
    for words in (
        "real-time factor, simulated over wall time 50.0",
        "maximum uplift at a support 40.0 mm",
        "standard deviation σ",
        "from memory, not found in a readable source",
        "contact_wire.tension",
        "S1 a drawing",
        "arcless run synthetic",
    ):
        assert words in text, words


def test_a_caption_that_figures_share_is_said_once() -> None:
    captions = {"lead": ("one", "one", "two", "two", "one"), "force": ("one",)}
    figures = {
        name: [
            Figure(f"{name}-{i}", name, Axis("x"), Axis("y"), [], caption=caption)
            for i, caption in enumerate(given)
        ]
        for name, given in captions.items()
    }
    drawing = Drawing()
    drawn = {name: [drawing.draw(one) for one in found] for name, found in figures.items()}
    written = document([one.plot for found in drawn.values() for one in found])
    said = {
        name: [one.caption for one in shown_figures(found, written)]
        for name, found in drawn.items()
    }
    assert said == {"lead": ["one", "", "two", "", "one"], "force": ["one"]}


def test_every_figure_has_an_alternative_text(page: str) -> None:
    plots = [a for _, a in Page(page).tags if a.get("class") == "plot"]
    assert len(plots) == len(FIGURES)
    for attributes in plots:
        assert attributes["role"] == "img"
        assert (
            re.search(r"\d", attributes["aria-label"]) or "Line at rest" in attributes["aria-label"]
        )


def test_the_policy_allows_the_page_own_scripts_alone(page: str) -> None:
    seen = Page(page)
    (policy,) = [a["content"] for _, a in seen.tags if "http-equiv" in a]
    scripts = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    hashes = [b64encode(sha256(text.encode()).digest()).decode() for text in scripts]
    assert len(hashes) == 2  # Bokeh's and the page's own
    (allowed,) = [part for part in policy.split("; ") if part.startswith("script-src ")]
    assert allowed.split()[1:] == [f"'sha256-{one}'" for one in hashes]
    assert policy.startswith("default-src 'none'; ")
    handlers = [name for _, attributes in seen.tags for name in attributes if name.startswith("on")]
    assert handlers == []


def test_nothing_is_loaded_from_elsewhere(page: str) -> None:
    for tag, attributes in Page(page).tags:
        for name in ("src", "href", "data", "action", "poster", "srcset"):
            target = attributes.get(name) or ""
            assert not re.match(r"(https?:)?//", target.strip()), (tag, target)
            assert target == "" or target.startswith(("data:", "#")), (tag, target)
    assert not re.search(r"url\(\s*['\"]?(https?:)?//", page)
    assert "@import" not in page
    assert "default-src 'none'" in page


REFERENCE = {
    "quantity": "mean force",
    "value": 143.2,
    "low": 141.5,
    "high": 146.5,
    "verdict": "inside",
    "mark": "C*",
    "source": "a draft",
}
NAMES = ("front", "middle", "rear")


@pytest.fixture(scope="module")
def rich() -> str:
    """Three pantographs, a staggered line, another section, and reference values."""
    dataset = synthetic_dataset(pantographs=NAMES, stagger_m=0.2)
    return report.html(
        result_of(dataset),
        assessment=assess(dataset, section=(250.0, 350.0)),
        reference_rows=[REFERENCE],
    )


def test_reference_rows_stand_next_to_ours(rich: str) -> None:
    assert "mean force 143.2 141.5 146.5 inside C* a draft" in Page(rich).text
    assert "C* from memory; a quick computation agrees with it" in Page(rich).text


def test_another_assessment_is_reported_when_given(rich: str) -> None:
    assert "250 to 350 m" in Page(rich).text


def test_a_staggered_line_is_also_drawn_from_above(page: str, rich: str) -> None:
    assert "Line at rest, from above" in Page(rich).titles
    assert "Line at rest, from above" not in Page(page).titles


def test_pantographs_have_figures_and_colours_each(rich: str) -> None:
    titles, colours = Page(rich).titles, data_in(rich)["colours"]
    for number, name in enumerate(NAMES, start=1):
        assert f"Contact force, {name}" in titles
        assert colours[f"pantograph_{number}"]


def test_figures_along_the_track_share_range_and_cross_hair(rich: str) -> None:
    data = data_in(rich)
    (document,) = [document_in(rich)]
    track = data["groups"]["track"]
    along = [root for root in document.roots if root.x_range.id == track["range"]]
    # Force, height, spectrogram of each pantograph; uplift, range of droppers, two views.
    assert len(along) == 3 * len(NAMES) + 4
    for root in along:
        (cross,) = [
            tool for tool in root.toolbar.tools if tool.__class__.__name__ == "CrosshairTool"
        ]
        assert track["cross"] in [span.id for span in cross.overlay]


def test_every_colour_of_a_figure_is_a_token(rich: str) -> None:
    """So that each has another value in dark pages."""
    data = data_in(rich)
    listed = {
        (name, attribute) for places in data["colours"].values() for name, attribute in places
    }
    found = set()
    for model in document_in(rich).models:
        for name, value in model.properties_with_values(include_defaults=False).items():
            plain = value if isinstance(value, str) else getattr(value, "value", None)
            if isinstance(plain, str) and plain.startswith("#"):
                found.add((model.id, name))
    assert found
    assert found <= listed


EVIL = "</script><script>alert(1)</script><img src=x onerror=alert(2)>'\"&"


def test_names_cannot_become_markup(rich: str) -> None:
    data = scenario_data(name=EVIL, description=EVIL, line__name=EVIL)
    dataset = synthetic_dataset(
        scenario=data,
        pantographs=(EVIL, "$$x^2$$"),
        attrs={"command": EVIL, "warnings": [EVIL], "arcless_version": EVIL},
    )
    text = report.html(result_of(dataset))
    seen = Page(text)
    assert "alert(1)" in seen.text  # shown as it is …
    assert "img" not in {tag for tag, _ in seen.tags}  # … and not obeyed
    scripts = [[tag for tag, _ in one.tags].count("script") for one in (seen, Page(rich))]
    assert scripts[0] == scripts[1]
    assert "$$x^2$$" not in json.dumps(data_in(text))  # Bokeh would look for a formula renderer


def test_names_keep_their_direction_to_themselves() -> None:
    """A right-to-left name turns nothing around it: it stands in an element of its own."""
    name = "שלום"
    text = report.html(
        result_of(synthetic_dataset(scenario=scenario_data(name=name, line__name=name)))
    )
    assert text.count(f"<bdi>{name}</bdi>") >= 3  # contents, title, line
    assert f">{name}<" not in text.replace(f"<bdi>{name}</bdi>", "").replace("<title>", "")


GAP = "Gap between contact strip and contact wire"


def test_the_gap_is_drawn_where_contact_is_lost_or_rigid(page: str) -> None:
    assert GAP not in Page(page).titles
    lost = synthetic_dataset(force=lambda t: np.where(t > 12.0, 0.0, 100.0))
    assert GAP in Page(report.html(result_of(lost))).titles
    rigid = synthetic_dataset(scenario=scenario_data(contact__law="rigid"))
    assert GAP in Page(report.html(result_of(rigid))).titles


BARE = (
    "contact_lateral", "mass_displacement", "dropper_force", "support_uplift", "slack_droppers",
    "support_uplift_max", "dropper_force_min", "dropper_force_max", "dropper_x", "dropper_span",
    "dropper_length", "dropper_force_static", "support_x", "support_force_static",
    "contact_wire_node_x", "contact_wire_node_y", "contact_wire_node_z",
    "messenger_wire_node_x", "messenger_wire_node_y", "messenger_wire_node_z",
    "elasticity", "natural_frequency",
)  # fmt: skip


def test_a_record_with_little_in_it_still_has_a_report() -> None:
    attrs = {"command": None, "warnings": None, "setup_time_s": None, "slack_droppers_max": None}
    text = report.html(result_of(synthetic_dataset(without=BARE, attrs=attrs)))
    assert "max_uplift_at_support_mm is not in the record" in Page(text).text


def test_bokeh_finds_no_mistake_in_a_page(page: str, rich: str) -> None:
    """Its script looks for none: it would draw something else."""
    rigid = report.html(result_of(synthetic_dataset(scenario=scenario_data(contact__law="rigid"))))
    for text in (page, rich, rigid):
        assert not mistakes_of(document_in(text))


def test_the_same_result_has_the_same_figures(page: str) -> None:
    again = report.html(result_of(synthetic_dataset()))
    assert data_in(again) == data_in(page)


def test_a_silent_force_has_a_report() -> None:
    dataset = synthetic_dataset(force=lambda t: 0.0 * t)
    assert (
        "Spectrum of the unfiltered contact force" in Page(report.html(result_of(dataset))).titles
    )


def noise(t: np.ndarray) -> np.ndarray:
    """A force that no compression makes small."""
    return 100.0 + np.random.default_rng(2).normal(scale=20.0, size=t.size)


def test_a_kilometre_stays_under_two_megabytes() -> None:
    dataset = synthetic_dataset(
        duration_s=40.0, speed_m_s=25.0, pantographs=("front", "rear"), force=noise,
        section=(200.0, 800.0), stagger_m=0.2,
    )  # fmt: skip
    assert len(report.html(result_of(dataset)).encode()) < MAX_BYTES_KILOMETRE


# An hour with eight pantographs: nothing in the file may grow with the run.
def test_a_long_run_stays_under_four_megabytes(tmp_path: Path) -> None:
    dataset = synthetic_dataset(
        duration_s=3600.0,
        step_s=5e-3,
        line_every=200,
        speed_m_s=10.0,
        pantographs=tuple(f"pantograph {i}" for i in range(8)),
        distance_m=20.0,
        force=noise,
        section=(5_000.0, 30_000.0),
        stagger_m=0.2,
    )
    path = tmp_path / "report.html"
    result_of(dataset).write_report(path)
    assert path.stat().st_size < MAX_BYTES


def test_the_file_is_there_whole_or_not_at_all(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    result = result_of(synthetic_dataset())
    with pytest.raises(OutputError):
        report.write(result, tmp_path / "file" / "report.html")
    assert [p.name for p in tmp_path.iterdir()] == ["file"]
    report.write(result, tmp_path / "report.html")
    assert (tmp_path / "report.html").read_text(encoding="utf-8").rstrip().endswith("</html>")
