"""Changes of the folder by other programs, and what the page is told of them."""

import os
import time
from pathlib import Path
from typing import Any

import pytest

from arcless.studio.project import tree as tree_module
from arcless.studio.project.project import Project
from arcless.studio.project.texts import version_of
from arcless.studio.project.tree import Tree
from arcless.studio.project.view import View
from arcless.studio.project.watch import EVERY_S, Watch

MODEL = b"format: arcless-line/1\nname: a\n"


class Watched:
    def __init__(self, folder: Path) -> None:
        self.heard: list[dict[str, Any]] = []
        self.view = View(Project.of(folder))
        self.watch = Watch(self.view, self.heard.append)
        self.watch.look()
        self.heard.clear()

    def looked(self) -> list[dict[str, Any]]:
        self.heard.clear()
        self.watch.look()
        return self.heard


@pytest.fixture
def watched(folder: Path) -> Watched:
    (folder / "deep").mkdir()
    (folder / "deep" / "a.yaml").write_bytes(MODEL)
    return Watched(folder)


def file_message(content: bytes | None, path: str = "deep/a.yaml") -> dict[str, Any]:
    found = None if content is None else version_of(content)
    return {"topic": "file", "path": path, "version": found}


def test_nothing_is_told_of_what_stays(watched: Watched) -> None:
    assert watched.looked() == []


def test_a_text_written_where_it_stands(watched: Watched, folder: Path) -> None:
    with (folder / "deep" / "a.yaml").open("ab") as file:
        file.write(b"# more\n")
    assert file_message(MODEL + b"# more\n") in watched.looked()
    assert {"topic": "project"} in watched.heard
    assert watched.looked() == []


def test_a_text_replaced_by_one_of_the_same_size(watched: Watched, folder: Path) -> None:
    other = folder / "deep" / "b.tmp"
    other.write_bytes(MODEL.replace(b"name: a", b"name: b"))
    other.replace(folder / "deep" / "a.yaml")
    assert file_message(MODEL.replace(b"name: a", b"name: b")) in watched.looked()


def test_files_and_folders_made_and_removed(watched: Watched, folder: Path) -> None:
    (folder / "b.yaml").write_bytes(MODEL)
    assert file_message(MODEL, "b.yaml") in watched.looked()
    (folder / "new" / "er").mkdir(parents=True)
    (folder / "new" / "er" / "c.yaml").write_bytes(MODEL)
    assert file_message(MODEL, "new/er/c.yaml") in watched.looked()
    (folder / "new" / "er" / "c.yaml").unlink()
    assert file_message(None, "new/er/c.yaml") in watched.looked()
    (folder / "deep").rename(folder / ".deep")
    assert file_message(None) in watched.looked()


def test_hidden_files_and_those_of_other_kinds(watched: Watched, folder: Path) -> None:
    for name in (".b.yaml", "b.txt", ".git/c.yaml", "node_modules/d.yaml"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(MODEL)
    assert watched.looked() == []


def test_links_out_of_the_folder_and_loops_are_not_followed(
    watched: Watched, folder: Path, tmp_path: Path
) -> None:
    (tmp_path / "secret.yaml").write_bytes(MODEL)
    (folder / "out").symlink_to(tmp_path)
    (folder / "loop").symlink_to(folder)
    watched.looked()
    found = {path.name for path in watched.view.tree.files}
    assert found == {"a.yaml"}
    os.mkfifo(folder / "pipe.yaml")
    watched.looked()
    assert {path.name for path in watched.view.tree.files} == {"a.yaml"}


def test_the_page_is_told_of_a_model_that_is_wrong_and_mended(
    watched: Watched, folder: Path
) -> None:
    (folder / "deep" / "a.yaml").write_bytes(MODEL + b"none: 1\n")
    watched.looked()
    (entry,) = watched.view.read()["models"]
    assert "deep/a.yaml" in entry["error"]
    assert entry["name"] == "a"


def test_a_folder_with_too_many_folders_says_so(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in range(6):
        (folder / str(number)).mkdir()
    found = Tree(folder)
    found.look()
    assert found.is_whole
    monkeypatch.setattr(tree_module, "MOST_FOLDERS", 5)
    found.look()
    assert not found.is_whole


def test_a_look_costs_little(folder: Path) -> None:
    """Twice a second; 500 models in 100 folders may take a tenth of that on a busy machine."""
    for number in range(500):
        place = folder / str(number % 100)
        place.mkdir(exist_ok=True)
        (place / f"{number}.yaml").write_bytes(MODEL)
    found = Tree(folder)
    found.look()
    times = []
    for _ in range(5):
        started = time.process_time()
        assert found.look() == set()
        times.append(time.process_time() - started)
    assert min(times) < EVERY_S / 10
