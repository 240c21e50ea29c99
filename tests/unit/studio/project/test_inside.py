"""No path and no link leads out of the folder, and hidden files are nobody's."""

import os
import stat
from pathlib import Path

import pytest

from arcless.errors import ArclessError, OutputError
from arcless.studio.answers.answers import Refused
from arcless.studio.project import opening, texts
from arcless.studio.project.project import Project
from tests.unit.studio.project.conftest import CANARY

LEADING_OUT = [
    "../outside/secret.yaml", "/etc/hostname.yaml", "a/../../outside/secret.yaml", "..", ".", "",
    "./../outside/secret.yaml", "a\0.yaml", "\0", "~/x.yaml/../../..", "..\\outside\\secret.yaml",
    "C:\\x.yaml", "//etc/x.yaml", ".hidden.yaml", ".git/config.yaml", "a/.b/c.yaml",
    "x" * 300 + ".yaml", "a/" * 3000 + "x.yaml", "\ud800.yaml", "%2e%2e/outside/secret.yaml",
    "shipped:line/../../../x", "shipped:wire/x", "shipped:", "shipped:line/",
    "shipped:line/nothing",
    "shipped:lines/../scenarios/en50318-ac-simple-320",
]  # fmt: skip


@pytest.mark.parametrize("path", LEADING_OUT, ids=ascii)
def test_paths(project: Project, path: str) -> None:
    (project.folder / ".hidden.yaml").write_text(CANARY)
    with pytest.raises(ArclessError) as read:
        texts.read(project, path)
    assert CANARY not in str(read.value)
    with pytest.raises((ArclessError, Refused)):
        texts.write(project, path, "name: x\n", None)


@pytest.mark.parametrize("path", [None, 1, [], {}, True, b"my.yaml"])
def test_what_is_no_path(project: Project, path: object) -> None:
    with pytest.raises((ArclessError, Refused)):
        texts.write(project, path, "", None)


def test_links_that_lead_out(project: Project, tmp_path: Path) -> None:
    (project.folder / "link.yaml").symlink_to(tmp_path / "outside" / "secret.yaml")
    (project.folder / "folder").symlink_to(tmp_path / "outside")
    (project.folder / "loop.yaml").symlink_to("loop.yaml")
    (project.folder / "new.yaml").symlink_to(tmp_path / "outside" / "new.yaml")
    for path in ("link.yaml", "folder/secret.yaml", "loop.yaml", "new.yaml"):
        with pytest.raises(ArclessError) as refused:
            texts.read(project, path)
        assert CANARY not in str(refused.value)
        with pytest.raises(OutputError):
            texts.write(project, path, "name: x\n", None)
    assert sorted(one.name for one in (tmp_path / "outside").iterdir()) == [
        "secret.csv", "secret.json", "secret.yaml"
    ]  # fmt: skip


def test_links_that_stay_inside(project: Project) -> None:
    (project.folder / "link.yaml").symlink_to("my.yaml")
    own = texts.read(project, "my.yaml")
    linked = texts.read(project, "link.yaml")
    assert linked["text"] == own["text"]
    texts.write(project, "link.yaml", "name: other\n", linked["version"])
    assert (project.folder / "link.yaml").is_symlink()
    assert (project.folder / "my.yaml").read_text() == "name: other\n"


def test_a_link_that_is_put_there_after_the_look(project: Project, tmp_path: Path) -> None:
    """Between the look at the path and the opening of the file somebody swaps it for a link."""
    deep = project.folder / "deep"
    deep.mkdir()
    (deep / "secret.yaml").write_text("name: own\n")
    looked_at = project.inside("deep/secret.yaml")
    deep.rename(project.folder / "away")
    deep.symlink_to(tmp_path / "outside")
    with pytest.raises(OutputError):
        opening.read_bytes(project, looked_at, "deep/secret.yaml")
    last = project.inside("my.yaml")
    last.unlink()
    last.symlink_to(tmp_path / "outside" / "secret.yaml")
    with pytest.raises(OutputError):
        opening.read_bytes(project, last, "my.yaml")


def test_what_is_no_regular_file(project: Project) -> None:
    os.mkfifo(project.folder / "pipe.yaml")
    (project.folder / "folder.yaml").mkdir()
    (project.folder / "device.yaml").symlink_to("/dev/zero")
    for path in ("pipe.yaml", "folder.yaml", "device.yaml"):
        with pytest.raises(OutputError):  # at once: a pipe is not waited for
            texts.read(project, path)
        with pytest.raises(OutputError):
            texts.write(project, path, "name: x\n", None)
    assert stat.S_ISFIFO((project.folder / "pipe.yaml").stat().st_mode)


@pytest.mark.parametrize("name", ["x.py", "x.csv", "x.nc", "x.html", "x", "x.yaml.py", "yaml"])
def test_only_model_files(project: Project, name: str) -> None:
    (project.folder / name).write_text(CANARY)
    with pytest.raises(OutputError):
        texts.read(project, name)
    with pytest.raises(OutputError):
        texts.write(project, name, "", None)


def test_a_file_that_is_too_large(project: Project) -> None:
    with (project.folder / "large.yaml").open("wb") as file:
        file.truncate(6_000_000)
    with pytest.raises(ArclessError, match=r"6\.0 MB, expected at most 5 MB"):
        texts.read(project, "large.yaml")


def test_no_folder(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="no such folder"):
        Project.of(tmp_path / "nothing")
