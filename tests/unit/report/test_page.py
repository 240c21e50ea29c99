"""The report as a file: complete, bounded, offline, and safe against what names may hold."""

import json
import re
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from arcless import report
from arcless.assess import assess
from arcless.errors import OutputError
from arcless.model import load
from arcless.results import Result
from tests.support.bokeh_pages import document_in, mistakes_of
from tests.support.synthetic import scenario_data, synthetic_dataset

MAX_BYTES = 2_000_000
FIGURES = [
    "Contact force after the 20 Hz low-pass, and unfiltered",
    "Height of the contact point",
    "Uplift of the contact wire at supports",
    "Range of the dropper forces",
    "Dropper forces in span 6",
    "Initial configuration, side view",
    "Contact force in the section; lines: mean, mean ± 3σ",
    "Spectrum of the unfiltered contact force in the section",
    "Elasticity of the contact wire at rest (non-uniformity 14 %)",
    "Terms that are not zero throughout",
]


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
        self._inside = ""
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        self._inside = tag

    def handle_endtag(self, tag):
        self._inside = ""

    def handle_data(self, data):
        (self.scripts if self._inside == "script" else self.words).append(data)

    @property
    def text(self) -> str:
        return " ".join(" ".join(self.words).split())


def figures_in(text: str) -> str:
    """The figures' JSON: the text between quotes that bokeh hands to its own script."""
    scripts = "".join(Page(text).scripts)
    return scripts[scripts.rindex("const docs_json") :]


def escaped(text: str) -> str:
    """Text as it stands there: JSON, its backslashes doubled once more."""
    return json.dumps(text).strip('"').replace("\\", "\\\\")


@pytest.mark.parametrize("title", FIGURES)
def test_every_figure_is_there(page: str, title: str) -> None:
    assert escaped(title) in figures_in(page)


def test_every_section_is_there(page: str) -> None:
    text = Page(page).text
    for words in (
        "7 of 8 judged criteria met; 1 could not be judged;",
        "1 not met by limits that are not verified",
        "this run was drawn, not computed",
        "real-time factor 50.0",
        "highest uplift at a support 40.0 mm",
        "standard deviation σ",
        "from memory, not found in a readable source",
        "contact_wire.tension",
        "S1 a drawing",
        "arcless run synthetic",
        "Arcless 0.0.0",
    ):
        assert words in text, words


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


def test_reference_rows_stand_beside_ours(rich: str) -> None:
    assert "mean force 143.2 141.5 146.5 inside C* a draft" in Page(rich).text
    assert "C* from memory; a quick computation agrees with it" in Page(rich).text


def test_another_assessment_is_reported_when_given(rich: str) -> None:
    assert "250 to 350 m" in Page(rich).text


def test_a_staggered_line_is_also_drawn_from_above(page: str, rich: str) -> None:
    assert "Initial configuration, from above" in figures_in(rich)
    assert "Initial configuration, from above" not in figures_in(page)


def test_pantographs_have_a_colour_each(rich: str) -> None:
    for name, colour in zip(NAMES, ("#1f5a92", "#d0652a", "#3b8a5a"), strict=True):
        assert name in figures_in(rich)
        assert colour in figures_in(rich)


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
    assert "$$x^2$$" not in figures_in(text)  # bokeh would look for a formula renderer


GAP = "Gap between collector strip and contact wire"


def test_the_gap_is_drawn_where_contact_is_lost_or_rigid(page: str) -> None:
    assert GAP not in figures_in(page)
    lost = synthetic_dataset(force=lambda t: np.where(t > 12.0, 0.0, 100.0))
    assert GAP in figures_in(report.html(result_of(lost)))
    rigid = synthetic_dataset(scenario=scenario_data(contact__law="rigid"))
    assert GAP in figures_in(report.html(result_of(rigid)))


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
    assert figures_in(again) == figures_in(page)


def test_a_silent_force_has_a_report() -> None:
    dataset = synthetic_dataset(force=lambda t: 0.0 * t)
    assert "Spectrum" in figures_in(report.html(result_of(dataset)))


# An hour with eight pantographs: nothing in the file may grow with the run.
def test_an_hour_stays_under_two_megabytes(tmp_path: Path) -> None:
    rng = np.random.default_rng(2)
    dataset = synthetic_dataset(
        duration_s=3600.0,
        step_s=5e-3,
        line_every=200,
        speed_m_s=10.0,
        pantographs=tuple(f"pantograph {i}" for i in range(8)),
        distance_m=20.0,
        force=lambda t: 100.0 + rng.normal(scale=20.0, size=t.size),
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
