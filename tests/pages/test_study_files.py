"""The guide and the reference of studies are true."""

import re
from pathlib import Path

import pytest

from arcless.model.files.yaml_reader import parse
from arcless.study import Study, load, run, status
from arcless.study.optimisation.optimise import Optimise
from tests.support.studies import rows

DOCS = Path(__file__).parents[2] / "docs"
GUIDE = (DOCS / "guide/studies.md").read_text("utf-8")
REFERENCE = (DOCS / "reference/study-files.md").read_text("utf-8")
PAGE = (DOCS / "guide/optimisation.md").read_text("utf-8")
EXAMPLES = dict(re.findall(r"```yaml\n# (\S+\.yaml)\n(.*?)```", GUIDE + PAGE, re.DOTALL))


UNCERTAINTY = (DOCS / "guide/uncertainty.md").read_text("utf-8")
SCATTER = dict(re.findall(r"```yaml\n# (\S+\.yaml)\n(.*?)```", UNCERTAINTY, re.DOTALL))


def example(name: str, folder: Path) -> Study:
    (folder / name).write_text(EXAMPLES[name], "utf-8")
    return load(folder / name)


@pytest.mark.parametrize(
    ("name", "count"),
    [("force-and-tension.yaml", 9), ("scatter.yaml", 8), ("least-scatter.yaml", 12)],
)
def test_the_examples_run(tmp_path: Path, name: str, count: int) -> None:
    made = example(name, tmp_path)
    assert run(made, tmp_path / "out").computed == count
    found = rows(tmp_path / "out" / "table.parquet")
    assert [row["status"] for row in found] == ["done"] * count
    assert all(row[name] is not None for row in found for name in made.outputs)
    assert status(made, tmp_path / "out").done == count


@pytest.mark.parametrize("name", SCATTER)
def test_each_scatter_of_the_guide_reaches_its_outputs(tmp_path: Path, name: str) -> None:
    data, _ = parse(SCATTER[name], "guide")
    assert load(data).plan.count == data["design"]["count"]
    # As the guide has them, but fewer and shorter.
    spans = {"line.spans": [{"type": "standard", "count": 6}], "solver.time_step": "2 ms",
             "travel": {"start": "60 m", "end": "160 m"}, "pantographs.0.static_force": "120 N",
             "analysis": {"from": "80 m", "to": "150 m"}}  # fmt: skip
    if "as_built.contact_wire_wear" in data["set"]:
        data["set"]["as_built.contact_wire_wear"][0]["to"] = "330 m"
    for varied in data["variables"]:
        only = {**data, "set": data["set"] | spans, "design": {**data["design"], "count": 2}}
        only["variables"] = {varied: data["variables"][varied]}
        run(load(only), tmp_path / varied)
        found = rows(tmp_path / varied / "table.parquet")
        assert [row["status"] for row in found] == ["done", "done"]
        assert found[0]["std_force_N"] != found[1]["std_force_N"]


def test_the_difference_is_shown_as_in_the_guide(tmp_path: Path) -> None:
    from arcless.errors import StudyError
    from arcless.study import StudyFolder

    name = "force-and-tension.yaml"
    place = StudyFolder(example(name, tmp_path), tmp_path / "out")
    place.make()
    place.write_state("")
    (tmp_path / name).write_text(EXAMPLES[name].replace("100 N", "90 N"), "utf-8")
    with pytest.raises(StudyError) as caught:
        StudyFolder(load(tmp_path / name), tmp_path / "out").check_same()
    said = str(caught.value).replace(str(tmp_path / name), name)
    said = said.replace(str(tmp_path / "out"), "runs/studies/force-and-tension")
    assert f"error: {said}\n" in GUIDE


def test_the_example_of_pruning_is_one(tmp_path: Path) -> None:
    made = example("least-scatter-early.yaml", tmp_path)
    assert isinstance(made.design, Optimise) and made.design.watched
    (bound,) = made.design.constraints
    assert bound.hard and made.design.pruning is not None
