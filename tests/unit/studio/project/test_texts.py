"""Texts are saved as they were typed, and never over what another program wrote."""

import hashlib
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from arcless.errors import ArclessError, OutputError
from arcless.studio.answers.answers import Refused
from arcless.studio.project import texts
from arcless.studio.project.project import Project

BOM = b"\xef\xbb\xbf"


def test_a_text_and_its_version(project: Project) -> None:
    content = (project.folder / "my.yaml").read_bytes()
    found = texts.read(project, "my.yaml")
    assert found == {
        "path": "my.yaml", "kind": "scenario", "text": content.decode(), "writable": True,
        "version": hashlib.sha256(content).hexdigest(),
    }  # fmt: skip


def test_a_shipped_model_is_read_only(project: Project) -> None:
    path = "shipped:line/ac-simple-55-3d"
    found = texts.read(project, path)
    assert (found["kind"], found["writable"]) == ("line", False)
    with pytest.raises(OutputError, match="shipped model cannot be written"):
        texts.write(project, path, "x", found["version"])


def test_saved_and_read_again(project: Project) -> None:
    before = texts.read(project, "my.yaml")
    saved = texts.write(project, "my.yaml", before["text"] + "# σ\n", before["version"])
    after = texts.read(project, "my.yaml")
    assert after["version"] == saved["version"] != before["version"]
    assert after["text"] == before["text"] + "# σ\n"


def test_another_program_was_faster(project: Project) -> None:
    before = texts.read(project, "my.yaml")
    (project.folder / "my.yaml").write_text("name: theirs\n")
    with pytest.raises(Refused) as refused:
        texts.write(project, "my.yaml", "name: mine\n", before["version"])
    theirs = hashlib.sha256(b"name: theirs\n").hexdigest()
    assert refused.value.status == 409
    assert refused.value.more == {"current": {"text": "name: theirs\n", "version": theirs}}
    assert (project.folder / "my.yaml").read_text() == "name: theirs\n"


def test_a_file_that_is_gone_or_there_already(project: Project) -> None:
    before = texts.read(project, "my.yaml")
    with pytest.raises(Refused) as refused:
        texts.write(project, "my.yaml", "name: new\n", None)
    assert refused.value.status == 409
    (project.folder / "my.yaml").unlink()
    with pytest.raises(Refused) as refused:
        texts.write(project, "my.yaml", "name: new\n", before["version"])
    assert refused.value.more == {"current": None}
    texts.write(project, "my.yaml", "name: new\n", None)
    assert (project.folder / "my.yaml").read_text() == "name: new\n"


@pytest.mark.parametrize("version", ["", "x", 1, [], {}, True])
def test_what_is_no_version(project: Project, version: object) -> None:
    with pytest.raises(Refused):
        texts.write(project, "my.yaml", "name: x\n", version)


def test_of_two_tabs_one_wins(project: Project) -> None:
    before = texts.read(project, "my.yaml")["version"]
    start = threading.Barrier(8)

    def save(number: int) -> bool:
        start.wait()
        try:
            texts.write(project, "my.yaml", f"name: of {number}\n", before)
        except Refused:
            return False
        return True

    with ThreadPoolExecutor(8) as pool:
        won = list(pool.map(save, range(8)))
    assert won.count(True) == 1
    assert (project.folder / "my.yaml").read_text() == f"name: of {won.index(True)}\n"


@pytest.mark.parametrize("mark", [b"", BOM])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_line_ends_and_byte_order_mark_stay(project: Project, mark: bytes, end: str) -> None:
    file = project.folder / "my.yaml"
    file.write_bytes(mark + f"name: a{end}description: b{end}".encode())
    found = texts.read(project, "my.yaml")
    # An editor in a browser knows one kind of line end.
    text = found["text"].replace("\r\n", "\n").replace("name: a", "name: c")
    saved = texts.write(project, "my.yaml", text, found["version"])
    assert file.read_bytes() == mark + f"name: c{end}description: b{end}".encode()
    assert saved["version"] == texts.read(project, "my.yaml")["version"]


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o664])
def test_rights_stay(project: Project, mode: int) -> None:
    file = project.folder / "my.yaml"
    file.chmod(mode)
    texts.write(project, "my.yaml", "name: x\n", texts.read(project, "my.yaml")["version"])
    assert file.stat().st_mode & 0o7777 == mode


def test_half_a_character(project: Project) -> None:
    before = texts.read(project, "my.yaml")
    with pytest.raises(Refused, match="half a character"):
        texts.write(project, "my.yaml", "name: \ud800\n", before["version"])
    assert texts.read(project, "my.yaml") == before


def test_a_folder_that_is_not_there(project: Project) -> None:
    with pytest.raises(OutputError):
        texts.write(project, "nowhere/my.yaml", "name: x\n", None)


def test_what_is_no_text(project: Project) -> None:
    (project.folder / "bad.yaml").write_bytes(b"name: \xff\n")
    with pytest.raises(ArclessError, match=r"bad\.yaml:1: not a text file"):
        texts.read(project, "bad.yaml")


def test_nothing_unfinished_stays(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_: object, __: object) -> None:
        raise OSError(28, "No space left on device")

    before = texts.read(project, "my.yaml")
    names = sorted(one.name for one in project.folder.iterdir())
    monkeypatch.setattr(texts.os, "fchmod", full)
    with pytest.raises(OutputError, match="No space left on device"):
        texts.write(project, "my.yaml", "name: x\n", before["version"])
    assert texts.read(project, "my.yaml") == before
    assert sorted(one.name for one in Path(project.folder).iterdir()) == names
