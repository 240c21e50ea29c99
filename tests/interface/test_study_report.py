"""`arcless study report` and `arcless study variant` as a user meets them."""

import json
from collections.abc import Callable
from pathlib import Path

from typer.testing import Result

from arcless.model import load as load_scenario
from arcless.study import load
from arcless.study.evaluation.variants import scenario
from arcless.study.report.commands import Commands
from tests.support.studies import filled, study, written

Arcless = Callable[..., Result]


def test_a_scenario_in_the_file_is_written_first(arcless: Arcless, tmp_path: Path) -> None:
    file = written(tmp_path, scenario=study().scenario.to_dict())
    made = load(file)
    assert Commands(made).again(2) == (
        f"arcless study variant {file} 2 --to variant-2.yaml && arcless run variant-2.yaml"
    )
    assert arcless("study", "variant", file, 2, "--to", "variant-2.yaml").exit_code == 0
    assert load_scenario("variant-2.yaml").to_dict() == scenario(made, 2).to_dict()


def test_commands_of_the_report(arcless: Arcless, tmp_path: Path) -> None:
    file = written(tmp_path)
    assert arcless("study", "report", file).exit_code == 2
    filled(tmp_path / "here")
    done = arcless("study", "report", file, "--out", "here", "--to", "page.html")
    assert done.stdout == "wrote page.html\n"
    assert (tmp_path / "page.html").stat().st_size > 1e5
    shown = arcless("study", "variant", file, 1)
    assert json.loads(shown.stdout)["pantographs"][0]["static_force"] == 70.0
    wrong = arcless("study", "variant", file, 7)
    assert "no such variant: got 7, expected a number from 1 to 6" in wrong.stderr
    invalid = arcless("study", "variant", file, 3)
    assert invalid.exit_code == 2
    assert "pantographs.0.static_force: got -5.0" in invalid.stderr
