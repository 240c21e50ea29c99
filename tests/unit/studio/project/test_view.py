"""The folder at a glance, and changes of it."""

import os
from pathlib import Path
from typing import Any

import pytest

from arcless.results.kept_runs.kept_run import KeptRun
from arcless.studio.project import view as view_module
from arcless.studio.project.project import Project
from arcless.studio.project.tree import MOST_FOLDERS, Tree
from arcless.studio.project.view import View
from arcless.studio.project.watch import Watch

KEYS = {"name", "folder", "version", "is_whole", "models", "library", "runs", "studies", "measured"}


def seen(project: Project) -> dict[str, Any]:
    view = View(project)
    view.tree.look()
    view.models.check(view.tree.files)
    return view.read()


def test_models_and_the_library(project: Project) -> None:
    found = seen(project)
    assert found.keys() == KEYS
    assert (found["name"], found["folder"]) == ("project", str(project.folder))
    assert [(one["path"], one["kind"], one["name"]) for one in found["models"]] == [
        ("my-line.yaml", "line", "my-line"), ("my.yaml", "scenario", "my")
    ]  # fmt: skip
    assert not any("error" in one for one in found["models"])
    shipped = {one["path"] for one in found["library"]}
    assert {"shipped:line/ac-simple-55-3d", "shipped:scenario/en50318-ac-simple-320"} <= shipped
    assert not any("wire/" in path for path in shipped)


def test_broken_files_are_listed_with_their_error(project: Project) -> None:
    (project.folder / "syntax.yaml").write_text("format: arcless-line/1\nname: [\n")
    (project.folder / "field.yaml").write_text("format: arcless-line/1\nname: a\nspam: 1\n")
    (project.folder / "bytes.yaml").write_bytes(b"\xff")
    (project.folder / "other.yaml").write_text("services: [web]\n")
    (project.folder / "package.json").write_text("{")
    errors = {one["path"]: one.get("error") for one in seen(project)["models"]}
    assert errors.keys() == {"my.yaml", "my-line.yaml", "syntax.yaml", "field.yaml", "bytes.yaml"}
    assert errors["my.yaml"] is None
    assert errors["syntax.yaml"].startswith("syntax.yaml:3: not valid YAML")
    assert "field.yaml:3: spam: unknown field" in errors["field.yaml"]
    assert errors["bytes.yaml"].startswith("bytes.yaml:1: not a text file")


def test_a_scenario_is_broken_with_its_line(project: Project) -> None:
    view = View(project)
    view.tree.look()
    assert not view.models.check(view.tree.files)
    line = project.folder / "my-line.yaml"
    good = line.read_text()
    line.write_text(good.replace("contact_wire:", "contact_wires:"))
    view.tree.look()
    assert view.models.check(view.tree.files)
    assert all("error" in one for one in view.read()["models"])
    line.write_text(good)
    view.tree.look()
    assert view.models.check(view.tree.files)
    assert not any("error" in one for one in view.read()["models"])


def test_a_reference_that_leads_out_is_an_error(project: Project, tmp_path: Path) -> None:
    text = (project.folder / "my.yaml").read_text()
    (tmp_path / "outside" / "my-line.yaml").write_bytes(
        (project.folder / "my-line.yaml").read_bytes()
    )
    away = text.replace("line: my-line.yaml", "line: ../outside/my-line.yaml")
    assert away != text
    (project.folder / "my.yaml").write_text(away)
    errors = {one["path"]: one.get("error") for one in seen(project)["models"]}
    assert "file outside of the folder" in errors["my.yaml"]


def test_runs_studies_and_measured_files(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    reads: list[Path] = []

    def read(file: Path) -> KeptRun:
        reads.append(file)
        return KeptRun(file.parent, "unreadable", "no result")

    monkeypatch.setattr(view_module, "read_run", read)
    run = project.folder / "runs" / "a"
    run.mkdir(parents=True)
    (run / "result.nc").write_bytes(b"x")
    (run / "assessment.json").write_text('{"format: arcless-line/1": 1}')
    study = project.folder / "runs" / "studies" / "b"
    study.mkdir(parents=True)
    (study / "study.json").write_text("{}")
    (study / "study.yaml").write_text("format: arcless-study/1\n")
    (project.folder / "measured").mkdir()
    (project.folder / "measured" / "c.csv").write_text("a,b\n")
    (project.folder / "d.csv").write_text("time [s],Force [N]\n")
    (project.folder / "e.csv").write_text("span,length\n")
    view = View(project)
    view.tree.look()
    found = view.read()
    assert [(one["path"], one["verdict"]) for one in found["runs"]] == [("runs/a", "unreadable")]
    assert found["studies"][0]["path"] == "runs/studies/b"
    assert "cannot be read" in found["studies"][0]["error"]
    assert found["measured"] == [
        {"path": "d.csv", "bytes": 19}, {"path": "measured/c.csv", "bytes": 4}
    ]  # fmt: skip
    assert len(found["models"]) == 2
    view.read()
    assert len(reads) == 1  # kept until it changes
    (run / "result.nc").write_bytes(b"xy")
    view.read()
    assert len(reads) == 2


def test_changes_are_told(project: Project) -> None:
    told: list[dict[str, Any]] = []
    view = View(project)
    view.tree.look()
    watch = Watch(view, told.append)
    watch.look()
    assert told == []
    file = project.folder / "my.yaml"
    text = file.read_text()
    with file.open("w") as opened:  # where it stands, as many editors do
        opened.write(text + "# more\n")
    watch.look()
    assert [one["topic"] for one in told] == ["file", "project"]
    assert told[0]["path"] == "my.yaml"
    assert len(told[0]["version"]) == 64
    told.clear()
    file.rename(project.folder / "new.yaml")
    watch.look()
    versions = {one["path"]: one["version"] for one in told if one["topic"] == "file"}
    assert versions["my.yaml"] is None
    assert len(versions["new.yaml"]) == 64
    told.clear()
    watch.look()
    assert told == []


def test_a_change_of_the_same_length_and_a_touch(project: Project) -> None:
    tree, file = Tree(project.folder), project.folder / "my.yaml"
    tree.look()
    state = file.stat()
    file.write_text(file.read_text().replace("my", "mi", 1))
    os.utime(file, ns=(state.st_atime_ns, state.st_mtime_ns + 1))
    assert tree.look() == {file}
    assert tree.look() == set()


def test_folders_come_and_go(project: Project) -> None:
    tree = Tree(project.folder)
    tree.look()
    deep = project.folder / "a" / "b"
    deep.mkdir(parents=True)
    (deep / "c.yaml").write_text("x")
    assert tree.look() == {deep / "c.yaml"}
    deep.parent.rename(project.folder / "z")
    assert tree.look() == {deep / "c.yaml", project.folder / "z" / "b" / "c.yaml"}
    assert project.folder / "z" / "b" / "c.yaml" in tree.files


def test_hidden_foreign_and_linked_folders_are_left_out(project: Project, tmp_path: Path) -> None:
    for name in (".git", "node_modules", ".venv"):
        (project.folder / name).mkdir()
        (project.folder / name / "a.yaml").write_text("x")
    (project.folder / "link").symlink_to(tmp_path / "outside")
    (project.folder / "loop").symlink_to(project.folder)
    tree = Tree(project.folder)
    tree.look()
    assert {path.name for path in tree.files} == {"my.yaml", "my-line.yaml", "arcless.schema.json"}


def test_a_disk_is_not_looked_through(tmp_path: Path) -> None:
    for number in range(MOST_FOLDERS + 5):
        (tmp_path / f"{number}").mkdir()
    tree = Tree(tmp_path)
    tree.look()
    assert not tree.is_whole
