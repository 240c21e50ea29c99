"""Texts: saved whole, unless somebody else was faster; line ends, marks and rights stay."""

import codecs
import hashlib
import os
import threading
import time
from pathlib import Path
from typing import Any

import httpx
import pytest
from starlette.testclient import TestClient

from arcless.studio.project import texts

OK, BAD, CONFLICT = 200, 400, 409
BEFORE, AFTER = "format: arcless-line/1\nname: before\n", "format: arcless-line/1\nname: after\n"


def version(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def put(client: TestClient, text: Any, base: Any, path: Any = "a.yaml") -> httpx.Response:
    return client.put("/api/file", json={"path": path, "text": text, "version": base})


def test_read_save_read(client: TestClient, folder: Path) -> None:
    (folder / "a.yaml").write_text(BEFORE, "utf-8")
    read = client.get("/api/file", params={"path": "a.yaml"}).json()
    assert read == {"path": "a.yaml", "kind": "line", "text": BEFORE, "writable": True,
                    "version": version(BEFORE.encode())}  # fmt: skip
    saved = put(client, AFTER, read["version"])
    assert saved.json() == {"version": version(AFTER.encode())}
    assert (folder / "a.yaml").read_text("utf-8") == AFTER
    assert [one.name for one in folder.iterdir()] == ["a.yaml"]


def test_a_conflict_answers_the_text_of_the_disk_and_writes_nothing(
    client: TestClient, folder: Path
) -> None:
    (folder / "a.yaml").write_text(BEFORE, "utf-8")
    for base in (version(AFTER.encode()), None, 5, "", version(BEFORE.encode()).upper()):
        found = put(client, AFTER, base)
        assert found.status_code == CONFLICT
        current = {"text": BEFORE, "version": version(BEFORE.encode())}
        assert found.json()["current"] == current
        assert "a.yaml" in found.json()["error"]["text"]
    assert (folder / "a.yaml").read_text("utf-8") == BEFORE


def test_a_file_that_went_is_a_conflict(client: TestClient, folder: Path) -> None:
    found = put(client, AFTER, version(BEFORE.encode()))
    assert (found.status_code, found.json()["current"]) == (CONFLICT, None)
    assert list(folder.iterdir()) == []


def test_a_new_file_must_not_be_there(client: TestClient, folder: Path) -> None:
    assert put(client, AFTER, None).status_code == OK
    assert put(client, BEFORE, None).status_code == CONFLICT
    assert (folder / "a.yaml").read_text("utf-8") == AFTER


@pytest.mark.parametrize("mark", [b"", codecs.BOM_UTF8])
@pytest.mark.parametrize("end", [b"\n", b"\r\n"])
def test_line_ends_and_the_mark_stay(
    client: TestClient, folder: Path, mark: bytes, end: bytes
) -> None:
    file = folder / "a.yaml"
    file.write_bytes(mark + BEFORE.encode().replace(b"\n", end))
    saved = put(client, AFTER, version(file.read_bytes()))
    assert file.read_bytes() == mark + AFTER.encode().replace(b"\n", end)
    assert saved.json()["version"] == version(file.read_bytes())


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o664])
def test_rights_stay(client: TestClient, folder: Path, mode: int) -> None:
    file = folder / "a.yaml"
    file.write_text(BEFORE, "utf-8")
    file.chmod(mode)
    assert put(client, AFTER, version(BEFORE.encode())).status_code == OK
    assert file.stat().st_mode & 0o777 == mode


def test_a_link_to_a_file_of_the_folder_stays_a_link(client: TestClient, folder: Path) -> None:
    (folder / "b.yaml").write_text(BEFORE, "utf-8")
    (folder / "a.yaml").symlink_to("b.yaml")
    assert put(client, AFTER, version(BEFORE.encode())).status_code == OK
    assert (folder / "a.yaml").is_symlink()
    assert (folder / "b.yaml").read_text("utf-8") == AFTER


def test_two_who_save_at_once(
    client: TestClient, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One of them is told of the other: nothing is lost."""
    replace = texts._replace

    def slowly(*given: Any, **named: Any) -> None:
        time.sleep(0.02)
        replace(*given, **named)

    monkeypatch.setattr(texts, "_replace", slowly)
    (folder / "a.yaml").write_text(BEFORE, "utf-8")
    base, answers = version(BEFORE.encode()), list[int]()

    def save(number: int) -> None:
        answers.append(put(client, f"{AFTER}# {number}\n", base).status_code)

    threads = [threading.Thread(target=save, args=(number,)) for number in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(answers) == [OK] + 7 * [CONFLICT]


@pytest.mark.parametrize("given", [
    {"path": None, "text": "x"}, {"path": "a.yaml", "text": None}, {"path": 5, "text": "x"},
    {"path": "a.yaml", "text": 5}, {},
])  # fmt: skip
def test_what_is_no_file(client: TestClient, folder: Path, given: dict[str, Any]) -> None:
    assert client.put("/api/file", json=given).status_code == BAD
    assert list(folder.iterdir()) == []


def test_half_a_character_is_refused(client: TestClient, folder: Path) -> None:
    body = b'{"path": "a.yaml", "text": "\\ud800", "version": null}'
    assert client.put("/api/file", content=body).status_code == BAD
    assert list(folder.iterdir()) == []


def test_a_shipped_model_is_read_and_not_written(client: TestClient) -> None:
    path = "shipped:line/ac-simple-55"
    read = client.get("/api/file", params={"path": path}).json()
    assert (read["kind"], read["writable"]) == ("line", False)
    found = put(client, AFTER, read["version"], path)
    assert found.status_code == BAD
    assert "shipped" in found.json()["error"]["text"]


def test_no_folder_to_write_into(client: TestClient) -> None:
    found = put(client, AFTER, None, "none/a.yaml")
    assert found.status_code == BAD
    assert "none" in found.json()["error"]["text"]


@pytest.mark.parametrize("content", [b"\xff\xfe\x00", b"name: \x00", b"caf\xe9"])
def test_a_file_that_is_no_text(client: TestClient, folder: Path, content: bytes) -> None:
    (folder / "a.yaml").write_bytes(content)
    assert client.get("/api/file", params={"path": "a.yaml"}).status_code == BAD
    assert put(client, AFTER, None).status_code == BAD
    assert (folder / "a.yaml").read_bytes() == content


def test_what_ends_the_writing_leaves_the_file(
    client: TestClient, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "a.yaml").write_text(BEFORE, "utf-8")

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    found = put(client, AFTER, version(BEFORE.encode()))
    assert found.status_code == BAD
    assert "No space left" in found.json()["error"]["text"]
    assert (folder / "a.yaml").read_text("utf-8") == BEFORE
    assert [one.name for one in folder.iterdir()] == ["a.yaml"]


def test_versions_are_those_of_bytes() -> None:
    # SHA-256 of "abc", FIPS 180-2, appendix B.1.
    abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    assert texts.version_of(b"abc") == abc
