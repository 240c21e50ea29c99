"""The page with the paper's figures: complete, offline, and what it says of the conclusions."""

import json
from pathlib import Path

import numpy as np
import pytest

from arcless.errors import OutputError
from arcless.model import load
from arcless.report import published_page
from arcless.results import Result
from tests.support.bokeh_pages import document_in, mistakes_of
from tests.support.synthetic import scenario_data, synthetic_dataset
from tests.unit.report.test_page import Page

ROW = {
    "quantity": "340 km/h: largest gap", "note": "at 85 m <b>", "value": 0.1042, "digits": 3,
    "unit": "mm", "limit": "> 0.001", "mark": "A", "verdict": "inside",
}  # fmt: skip


def verdict(title: str, holds: bool) -> dict:
    texts = {"title": title, "checked": "the gap", "assumption": "2.5 kg"}
    return {**texts, "holds": holds, "rows": [ROW]}


def results() -> list[Result]:
    made = []
    for speed in (50.0, 100.0):
        dataset = synthetic_dataset(
            duration_s=10.0,
            speed_m_s=speed,
            force=lambda t: 100.0 + 20.0 * np.sin(20.0 * t),
            gap=lambda t: 1e-4 * np.maximum(0.0, np.sin(5.0 * t)),
            scenario=scenario_data(speed=speed),
        )
        made.append(Result(dataset, load(json.loads(dataset.attrs["scenario"]))))
    return made


def test_the_page(tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    verdicts = [verdict("first", True), verdict("second", False)]
    published_page.write(results(), file, verdicts=verdicts, source="a paper")
    text = file.read_text("utf-8")
    drawn = text[text.rindex("const docs_json") :]
    titles = [
        "F(t) at 180 km/h: 80 to 120 N",
        "F(t) at 360 km/h",
        "d(t) at 360 km/h: at most 0.10 mm",
    ]
    assert all(title in drawn for title in titles)
    assert "d(t) at 180" not in drawn  # the paper shows gaps where there are some
    for words in (
        "1 of 2 conclusions hold", "<li>second</li>", ">0.104<", "&gt; 0.001", "at 85 m &lt;b&gt;",
        "Checked: the gap", "Assumption: 2.5 kg", "Source: a paper.",
        "arcless validate seed --report page.html",
    ):  # fmt: skip
        assert words in text, words
    for _, attributes in Page(text).tags:
        for name in ("src", "href"):
            assert (attributes.get(name) or "data:").startswith("data:")
    assert len(text) < 2_000_000
    assert not mistakes_of(document_in(text))


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(OutputError):
        published_page.write(results(), tmp_path / "no" / "page.html", verdicts=[], source="")
