"""`arcless show` and `arcless new`: shipped models as text, and own models."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

from arcless.model import load
from arcless.model.files.yaml_reader import parse
from arcless.model.own_copy import HEADER, copies, text_of
from arcless.model.shipped.library import shipped

Command = Callable[..., Result]
TWO = ("new", "mine", "--two-pantographs")


@pytest.mark.parametrize("kind", ["scenario", "line", "pantograph", "study"])
def test_every_shipped_model_is_shown_as_it_stands(kind: str) -> None:
    for name, file in shipped(kind).items():
        assert text_of(f"{kind}/{name}") == file.read_text("utf-8")


def test_show_prints_the_text_and_nothing_else(arcless: Command) -> None:
    done = arcless("show", "norway-s25")
    assert done.stdout == shipped("line")["norway-s25"].read_text("utf-8")
    assert (done.exit_code, done.stderr) == (0, "")
    # A scenario and a line have this name.
    assert arcless("show", "china-stitched-350").stdout.startswith("format: arcless-scenario/1")
    assert arcless("show", "line/china-stitched-350").stdout.startswith("format: arcless-line/1")


def test_show_takes_a_file(arcless: Command, short: Path) -> None:
    assert arcless("show", short).stdout == short.read_text("utf-8")


def test_what_is_shown_is_a_model_file(arcless: Command) -> None:
    Path("mine.yaml").write_text(arcless("show", "norway-s25-250").stdout, "utf-8")
    assert arcless("check", "mine.yaml").exit_code == 0


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["show", "norway-s2"], "did you mean norway-s25 or"),
        (["show", "zzzz"], "arcless library lists the names"),
        (["show", "absent.yaml"], "absent.yaml"),
        (["show", "other.yaml"], "format"),
        (["new", "mine", "--from", "norway-s25-25"], "did you mean norway-s25-250"),
        (["new", "mine", "--from", "dsa-250", "--with-pantographs"], "begin with a scenario"),
        (["new", "mine", "--from", "pantograph/norway-s25"], "did you mean norway-s25"),
        (["new", "mine", "--from", "other.yaml"], "the file other.yaml"),
        (["new", "mine", "--from", "norway-s25", "--with-pantographs"], "begin with a scenario"),
        (["new", "mine", "--from", "norway-s25", "--to", "absent"], "no folder"),
        (["new", "a/b", "--from", "norway-s25"], "--to names a folder"),
        (["new", "mine.yaml", "--from", "norway-s25"], "leave the ending out"),
        (["new", "", "--from", "norway-s25"], "letters, digits"),
        (["new", "norway-s25", "--from", "norway-s25"], "such as my-norway-s25"),
        ([*TWO, "tsi", "--from", "speed-sweep"], "begin with a scenario"),
        ([*TWO, "tsi", "--from", "ac-simple-320-two-pantographs"], "change pantographs.1.distance"),
        ([*TWO, "far", "--from", "norway-s25-250"], 'distance: got "far"'),
        ([*TWO, "2 km", "--from", "norway-s25-250"], "--two-pantographs 2 km: travel: no travel"),
        (
            ["new", "mine", "--from", "dsa-250", "--scenario", "norway-s25-250"],
            "begin with a study",
        ),
    ],
)
def test_bad_input_is_told_and_nothing_is_written(
    arcless: Command, words: list[str], told: str
) -> None:
    Path("other.yaml").write_text("one: 1\n")
    done = arcless(*words)
    assert done.exit_code == 2
    assert told in done.stderr
    assert [path.name for path in Path().iterdir()] == ["other.yaml"]


@pytest.mark.parametrize("name", ["mine", "123", "true", "überholt-2.1"])
def test_every_shipped_scenario_and_line_is_copied(name: str) -> None:
    for source in shipped("scenario"):
        made = copies(name, f"scenario/{source}", with_pantographs=True)
        assert {f"{name}.yaml", f"{name}-line.yaml"} < set(made)
        # Header, names, references and the description differ: comments, order and sources stay.
        old = shipped("scenario")[source].read_text("utf-8").splitlines()
        new = made[f"{name}.yaml"].splitlines()
        assert new[0] + "\n" == HEADER
        changed = [line for line, was in zip(new[1:], old, strict=True) if line != was]
        own = ("name:", "description:", "line:", "model:")
        assert all(line.strip(" -{").startswith(own) for line in changed)
    for kind in ("line", "pantograph", "study"):
        for source, file in shipped(kind).items():
            ((own, text),) = copies(name, f"{kind}/{source}").items()
            assert own == f"{name}.yaml"
            assert text.startswith(HEADER)
            new, old = (parse(each, source)[0] for each in (text, file.read_text("utf-8")))
            assert {key for key in old if old[key] != new[key]} <= {"name", "description"}
            assert set(new) == set(old)


@pytest.mark.parametrize("kind", ["scenario", "line", "pantograph", "study"])
def test_no_copy_is_described_as_the_shipped_model(kind: str) -> None:
    # A description is on the cover of a report that is signed: it must not be another line's.
    for source in shipped(kind):
        for text in copies("mine", f"{kind}/{source}").values():
            data = parse(text, source)[0]
            if kind in ("scenario", "line", "pantograph") or "description" in data:
                assert data["description"].startswith("Own ")
                assert data["description"].endswith(", to be described")


def test_a_copy_names_the_model_that_it_follows() -> None:
    made = copies("mine", "norway-s25-250", with_pantographs=True)
    told = {file: parse(text, file)[0]["description"] for file, text in made.items()}
    assert told == {
        "mine.yaml": "Own scenario after norway-s25-250, to be described",
        "mine-line.yaml": "Own line after norway-s25, to be described",
        "mine-dsa-250.yaml": "Own pantograph after dsa-250, to be described",
    }


@pytest.mark.parametrize("extra", [[], ["--with-pantographs"]])
def test_a_copy_has_the_assessment_of_the_shipped_one(arcless: Command, extra: list[str]) -> None:
    source = "en50318-ac-simple-320-planar"
    made = arcless("new", "mine", "--from", source, *extra)
    assert made.exit_code == 0
    assert "next: edit it, then arcless check mine.yaml\nand: arcless run mine.yaml" in made.stdout
    assert arcless("check", "mine.yaml").exit_code == 0
    told = []
    for scenario in (source, "mine.yaml"):
        done = arcless("run", scenario, "--json", "--quiet", "--no-report", "--out", scenario[:4])
        told.append(json.loads(done.stdout))
    for one in told:
        for key in ("scenario", "setup_time_s", "wall_time_s", "real_time_factor"):
            del one[key]
    assert told[0] == told[1]


def test_a_line_is_copied_and_checked(arcless: Command) -> None:
    Path("lines").mkdir()
    made = arcless("new", "mine", "--from", "norway-s25", "--to", "lines")
    assert "line: mine.yaml" in made.stdout
    assert arcless("check", "lines/mine.yaml").exit_code == 0


def test_a_pantograph_is_copied_and_checked(arcless: Command) -> None:
    made = arcless("new", "mine", "--from", "dsa-250")
    assert "pantographs: [{model: mine.yaml}]" in made.stdout
    assert arcless("check", "mine.yaml").exit_code == 0


def test_a_study_is_copied_and_checked(arcless: Command) -> None:
    made = arcless("new", "mine", "--from", "speed-sweep")
    assert "and: arcless study run mine.yaml" in made.stdout
    assert arcless("check", "mine.yaml").exit_code == 0


def test_the_schema_stands_beside_and_editors_find_it(arcless: Command) -> None:
    arcless("new", "mine", "--from", "norway-s25-250")
    head = Path("mine.yaml").read_text("utf-8").splitlines()[0]
    schema = Path(head.rpartition("$schema=")[2])
    assert schema.read_text("utf-8") == arcless("schema").stdout


def test_nothing_is_replaced(arcless: Command) -> None:
    Path("mine-line.yaml").write_text("my own")
    Path("arcless.schema.json").write_text("{}")
    done = arcless("new", "mine", "--from", "norway-s25-250")
    assert done.exit_code == 2
    assert "mine-line.yaml: the file exists" in done.stderr
    assert Path("mine-line.yaml").read_text() == "my own"
    assert not Path("mine.yaml").exists()
    # A schema that is there stays, and no name is wrong because of it.
    assert arcless("new", "other", "--from", "norway-s25-250").exit_code == 0
    assert Path("arcless.schema.json").read_text() == "{}"


@pytest.mark.parametrize(
    ("source", "spacing", "metres"),
    [
        ("norway-s25-250", "tsi", 200.0),
        ("germany-re-200-200", "tsi", 85.0),
        ("trolley-bridles-60", "tsi", 8.0),
        ("norway-s25-250", "0.1 km", 100.0),
    ],
)
def test_a_second_pantograph_equals_the_first(
    arcless: Command, source: str, spacing: str, metres: float
) -> None:
    assert arcless(*TWO, spacing, "--from", source).exit_code == 0
    assert arcless("check", "mine.yaml").exit_code == 0
    first, second = load("mine.yaml").pantographs
    assert (first.name, second.name, second.distance) == ("leading", "trailing", metres)
    assert (second.model, second.start_force) == (first.model, first.start_force)
    assert (second.static_force, second.mean_force) == (first.static_force, first.mean_force)
    assert (load(source).pantographs[0].model, load(source).speed) == (
        first.model,
        load("mine.yaml").speed,
    )


def test_the_spacing_of_the_rule_follows_the_speed(arcless: Command) -> None:
    arcless(*TWO, "tsi", "--from", "germany-re-200-200", "--with-pantographs")
    mine = load("mine.yaml")
    spacings = [mine.with_(speed=f"{v} km/h").pantographs[1].distance for v in (80, 120, 200, 250)]
    assert spacings == [8.0, 15.0, 85.0, 200.0]  # TSI ENE, table 4.2.13, column B


def test_a_study_over_the_spacing_of_a_scenario_of_ones_own(arcless: Command) -> None:
    arcless(*TWO, "tsi", "--from", "germany-re-200-200")
    made = arcless("new", "gaps", "--from", "study/spacing", "--scenario", "mine.yaml")
    assert "and: arcless study run gaps.yaml" in made.stdout
    assert arcless("check", "gaps.yaml").exit_code == 0
    assert "scenario: mine.yaml\n" in Path("gaps.yaml").read_text("utf-8")
    arcless("new", "one", "--from", "study/spacing", "--scenario", "norway-s25-250")
    told = arcless("check", "one.yaml")
    assert told.exit_code == 2
    assert "--two-pantographs tsi` makes a scenario with two" in told.stderr
