"""`--certainty` as a user meets it: numbers with ±, verdicts nobody can tell, wrong numbers."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from typer.testing import Result

import arcless as package
from arcless.cli.arguments.certainty import spelt_out

Arcless = Callable[..., Result]
# Eight spans with a run-in of two.
ROOM = [
    "--set", "travel={start: 60 m, end: 340 m}", "--set", "analysis={from: 160 m, to: 310 m}",
]  # fmt: skip


def run(arcless: Arcless, short: Path, *words: str) -> Result:
    return arcless("run", short, *ROOM, *words, "--quiet", "--no-report")


def test_a_number_may_be_left_out() -> None:
    option = "--certainty"
    assert spelt_out(["x", option]) == ["x", "--certainty=8"]
    assert spelt_out(["x", option, "--json"]) == ["x", "--certainty=8", "--json"]
    assert spelt_out([option, "en50318-ac-simple-320-planar"]) == [
        "--certainty=8",
        "en50318-ac-simple-320-planar",
    ]
    assert spelt_out(["x", option, "5", "--json"]) == ["x", option, "5", "--json"]
    assert spelt_out(["x", option, "-3"]) == ["x", option, "-3"]
    assert spelt_out(["x", "--certainty=5"]) == ["x", "--certainty=5"]
    assert spelt_out([]) == []


def test_numbers_come_with_what_follows_their_sign(
    arcless: Arcless, short: Path, tmp_path: Path
) -> None:
    done = run(arcless, short, "--certainty", "3", "--out", "out")
    assert done.exit_code in (0, 3), done.output
    table, _, rest = done.stdout.partition("Criteria")
    statistics = [line for line in table.splitlines() if " ± " in line]
    assert any("standard deviation σ" in row for row in statistics)
    assert " ± " in rest
    assert len({row.index("±") for row in statistics}) == 1  # one below the other
    shown = " ".join(done.stdout.split())
    assert "standard deviations of 3 runs that begin between " in shown
    assert "s of computing" in shown
    saved = json.loads((tmp_path / "out" / "assessment.json").read_text("utf-8"))
    [own] = saved["pantographs"]
    assert set(own["certainty"]["std_force_N"]) == {"spread", "discretisation"}
    assert saved["certainty"]["max_uplift_at_support_mm"]["spread"] > 0.0
    opened = package.open(tmp_path / "out" / "result.nc")
    assert opened.assessment.to_dict() == saved
    assert opened.metadata["command"].endswith("--certainty 3")
    again = arcless("assess", tmp_path / "out" / "result.nc", "--json")
    assert json.loads(again.stdout) == saved
    other = arcless("assess", tmp_path / "out" / "result.nc", "--from", "200 m")
    assert " ± " not in other.stdout


def test_a_criterion_too_close_to_tell_sets_no_exit_code(
    arcless: Arcless, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The force of a short run is held against a law that lies between its draws."""
    from arcless.assess import criteria
    from arcless.assess.rules import Limit, Rule

    short = Path(__file__).parent / "data" / "short.yaml"
    plain = json.loads(run(arcless, short, "--json", "--out", "a").stdout)
    value = plain["pantographs"][0]["statistical_max_N"]
    rule = Rule(
        name="statistical_max", title="statistical maximum", unit="N",
        quantity="statistical_max_N", relation="<=", limit=Limit(constant=value - 1e-4),
        mark="A", source="this test",
    )  # fmt: skip
    monkeypatch.setattr(criteria, "RULES", (rule,))
    missed = run(arcless, short, "--json", "--out", "b")
    assert missed.exit_code == 3
    [item] = json.loads(missed.stdout)["criteria"]
    assert (item["passed"], item["reason"]) == (False, None)
    done = run(arcless, short, "--certainty", "3", "--json", "--out", "c")
    assert done.exit_code == 0, done.output
    [item] = json.loads(done.stdout)["criteria"]
    assert item["passed"] is None
    assert item["reason"].startswith("too close to tell: 0.0001 N from the limit")
    shown = run(arcless, short, "--certainty", "3", "--out", "d").stdout
    assert "too close to tell" in shown
    target = tmp_path / "page.html"
    package.open(tmp_path / "c" / "result.nc").write_report(target)
    page = target.read_text("utf-8")
    assert "is-too-close-to-tell" in page
    assert "Too close to tell: all 1 criteria" in page
    assert "Certainty of the numbers" in page
    assert "standard deviations of 3 runs" in page


def test_a_report_without_certainty_says_nothing_of_it(finished: Path) -> None:
    page = (finished / "report.html").read_text("utf-8")
    assert "Certainty of the numbers" not in page
    # Nothing behind a number; F_m ± 3σ, and limits to both sides, are no certainty. Contributions
    # to σ have a ± of their own, that of the length of the section.
    page, count = re.subn(r'<section id="contributions">.*?</section>', "", page, flags=re.DOTALL)
    assert count == 1
    assert not re.search(r"\d ± \d", page)


@pytest.mark.parametrize(
    "number", ["0", "1", "-3", "1e9", "1000000000", "2.5", "=many", "=", "101"]
)
def test_wrong_numbers_of_starts(
    arcless: Arcless, short: Path, tmp_path: Path, number: str
) -> None:
    words = [f"--certainty{number}"] if number.startswith("=") else ["--certainty", number]
    done = run(arcless, short, *words)
    assert done.exit_code == 2, done.output
    assert "certainty" in done.stderr
    assert done.stdout == ""
    assert list(tmp_path.iterdir()) == []
    done = arcless("validate", "en50318", *words)
    assert done.exit_code == 2, done.output
    assert "expected" in done.stderr


def test_a_word_is_no_number(arcless: Arcless, short: Path) -> None:
    done = run(arcless, short, "--certainty", "many")
    assert done.exit_code == 2
    assert "many" in done.stderr


def test_a_run_that_stops_early_has_nothing_to_be_sure_of(
    arcless: Arcless, short: Path, tmp_path: Path
) -> None:
    done = run(arcless, short, "--certainty", "3", "--until", "100 m")
    assert done.exit_code == 2
    assert "not together with `--until`" in done.stderr
    assert "arcless resume" in done.stderr
    assert list(tmp_path.iterdir()) == []
    asked = ("--set", "certainty=3", "--out", "part")
    assert run(arcless, short, *asked, "--until", "100 m").exit_code == 0
    done = arcless("resume", tmp_path / "part" / "result.nc", "--json", "--no-report", "--quiet")
    assert done.exit_code in (0, 3)
    assert json.loads(done.stdout)["certainty_method"]["runs"] == 3


def test_no_room_for_other_starts_is_told_before_the_run(
    arcless: Arcless, short: Path, tmp_path: Path
) -> None:
    near = ("--set", "travel.start=11 m", "--set", "analysis={from: 20 m, to: 310 m}")
    done = run(arcless, short, *near, "--certainty", "3")
    assert done.exit_code == 2
    assert "no room for other starts" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_validation_says_how_sure_its_values_are(
    arcless: Arcless, monkeypatch: pytest.MonkeyPatch
) -> None:
    from arcless.validate import Range, cases
    from tests.interface.test_validate import middle

    asked: list[Any] = []
    case = cases.CASES[0]
    found = middle(case)
    [own] = found["pantographs"]
    own["certainty"] = {key: {"spread": 0.5, "discretisation": 0.25} for key in own}
    own["certainty"]["contact_loss_percent"] = {"spread": 0.0, "discretisation": None}
    own["std_force_N"] = 31.5  # outside by less than 0.75
    own["min_force_N"] = 50.5  # inside by less
    own["max_force_N"] = 174.0  # outside by more

    class Assessed:
        @staticmethod
        def to_dict() -> dict[str, Any]:
            return found

    def simulated(scenario: Any, *, certainty: Any = None, **_: object) -> Any:
        asked.append(certainty)
        return type("R", (), {"assessment": Assessed})

    monkeypatch.setattr("arcless.simulate.run", simulated)
    monkeypatch.setattr(cases, "CASES", (case,))
    monkeypatch.setattr(cases, "_dropper_rows", lambda _progress: [])
    done = arcless("validate", "en50318", "--json")
    rows = {row["key"]: row for row in json.loads(done.stdout)}
    assert done.exit_code == 3  # the highest force alone
    assert rows["std_force_N"]["verdict"] == "outside, too close to tell"
    assert rows["min_force_N"]["verdict"] == "inside, too close to tell"
    assert rows["max_force_N"]["verdict"] == "outside"
    assert rows["mean_force_N"]["verdict"] == "inside"
    assert rows["mean_force_N"]["uncertainty"] == 0.75
    own["max_force_N"] = 200.0
    done = arcless("validate", "en50318", "--certainty", "4")
    assert done.exit_code == 0
    assert "6 of 8 values are inside the verified ranges, 2 too close to tell" in done.stdout
    assert " ± " in done.stdout
    assert arcless("validate", "en50318", "--once").exit_code == 0
    assert asked == [8, 4, None]
    assert arcless("validate", "en50318", "--once", "--certainty", "4").exit_code == 2
    assert Range("k", "l", "N", 0.0, 0.0, "A").verdict(0.0, 0.0) == "inside"


def test_a_study_leaves_out_what_is_too_close_to_tell(tmp_path: Path) -> None:
    from arcless.study.definition.quantities import reasons, values

    short = Path(__file__).parent / "data" / "short.yaml"
    scenario = package.load(short).with_(
        travel={"start": "60 m", "end": "340 m"}, analysis={"from": "160 m", "to": "310 m"},
        **{"pantographs.0.static_force": "80 N"},
    )  # fmt: skip
    found = package.run(scenario, certainty=2).assessment
    from dataclasses import replace

    close = "too close to tell: 1 N from the limit, and sure to 2 N only (spread 2)"
    items = [
        replace(item, passed=None, reason=close) if item.name == "statistical_max" else item
        for item in found.criteria
    ]
    told = replace(found, criteria=items)
    assert values(told)["criteria.statistical_max"] is None
    missed = any(item.passed is False for item in items)
    assert values(told)["passed"] == (0.0 if missed else None)
    assert values(found)["criteria.statistical_max"] is not None
    assert reasons(told)["criteria.statistical_max"] == f"criteria.statistical_max is {close}"
    assert reasons(found) == {} or "criteria.statistical_max" not in reasons(found)
