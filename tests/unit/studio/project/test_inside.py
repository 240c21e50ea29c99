"""No path and no link leads out of the folder; only models, measured runs and runs are served."""

import json
import os
import socket
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import httpx
import pytest
from starlette.testclient import TestClient

import arcless
from arcless.dataset.netcdf.store import save
from arcless.errors import OutputError
from arcless.studio.project import opening, project
from arcless.studio.project.project import Project
from tests.support.synthetic import synthetic_dataset

CANARY = "a secret that stands outside of the folder"
MODEL = "format: arcless-line/1\nname: {}\n"
ERRORS = range(400, 500)
Question = Callable[[TestClient, str], httpx.Response]


# Written through a link that stays in the folder.
AT_HOME = {"loop/x.yaml"}


def text_of(path: str) -> dict[str, Any]:
    return {"path": path, "text": MODEL.format("x")}


def sent(client: TestClient, method: str, path: str, value: Any) -> httpx.Response:
    """Send JSON in which half a character is an escape, which httpx refuses."""
    return client.request(method.upper(), path, content=json.dumps(value))


QUESTIONS: dict[str, Question] = {
    "read": lambda client, path: client.get("/api/file", params={"path": path}),
    "write": lambda client, path: sent(
        client, "put", "/api/file", {**text_of(path), "version": None}
    ),
    "check": lambda client, path: sent(client, "post", "/api/check", text_of(path)),
    "form": lambda client, path: sent(client, "post", "/api/form", text_of(path)),
    "patch": lambda client, path: sent(
        client, "post", "/api/patch", {**text_of(path), "changes": {}}
    ),
    "variant": lambda client, path: sent(
        client, "post", "/api/variant", {"scenario": path, "name": "v", "changes": {}}
    ),
    "statics": lambda client, path: sent(
        client,
        "post",
        "/api/statics",
        {"path": path, "text": None, "changes": {}, "want": ["line"]},
    ),
    "run": lambda client, path: client.get("/api/run", params={"path": path}),
    "line": lambda client, path: client.get("/api/run/line", params={"path": path}),
    "report": lambda client, path: client.get("/api/run/report", params={"path": path}),
    "series": lambda client, path: client.get(
        "/api/series", params={"run": path, "name": "contact_force"}
    ),
    "figures": lambda client, path: client.get("/api/figures", params={"run": path}),
    "explain": lambda client, path: client.get("/api/explain", params={"run": path}),
    "compare": lambda client, path: sent(
        client, "post", "/api/compare", {"subjects": [path, path]}
    ),
    "measurement": lambda client, path: sent(client, "post", "/api/measurement", {"path": path}),
    "runs": lambda client, path: sent(
        client, "post", "/api/runs", {"scenario": path, "changes": {}}
    ),
}
IN_ADDRESS = {"read", "run", "line", "report", "series", "figures", "explain"}
PATHS = [
    "../canary.yaml", "a/../../canary.yaml", "./../canary.yaml", "/etc/passwd", "//etc/passwd",
    "..\\canary.yaml", "C:\\canary.yaml", "%2e%2e/canary.yaml", "..%2fcanary.yaml", "",  ".", "..",
    "/", "~/canary.yaml", "a\0.yaml", "../canary.yaml\0.yaml", ".hidden.yaml", ".git/config.yaml",
    "a/.hidden/b.yaml", "x" * 5000 + ".yaml", "d/" * 3000 + "x.yaml", "\ud800.yaml", "shipped:",
    "shipped:line/../../canary", "shipped:../canary", "shipped:line/", "shipped:none/x",
    "shipped:line//etc/passwd", "link.yaml", "out/canary.yaml", "out", "loop.yaml", "loop/x.yaml",
    "pipe.yaml", "socket.yaml", "device.yaml", "proc/self/environ", "proc/version.yaml",
]  # fmt: skip


# Devices, streams of a file, a file by another name: what Windows would open for them.
OF_WINDOWS = [
    "nul.yaml", "CON", "a/aux/x.yaml", "com1.yaml", "line.yaml:stream", "C:line.yaml", "line.yaml.",
    "line.yaml ", "folder./line.yaml",
]  # fmt: skip


@pytest.mark.parametrize("path", OF_WINDOWS)
def test_names_that_windows_has_for_something_else(
    path: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if sys.platform != "win32":  # elsewhere they are names like others
        assert Project(folder).inside(path) == folder / path
    monkeypatch.setattr(project, "sys", SimpleNamespace(platform="win32"))
    with pytest.raises(OutputError, match="no file of this folder"):
        Project(folder).inside(path)


@pytest.fixture
def outside(folder: Path, tmp_path: Path) -> Iterator[Path]:
    """Return what is next to the folder: a canary, to which links in the folder lead."""
    (tmp_path / "canary.yaml").write_text(MODEL.format(CANARY), "utf-8")
    for hidden in (folder / ".git", folder / "a" / ".hidden"):
        hidden.mkdir(parents=True)
        (hidden / "config.yaml").write_text(MODEL.format(CANARY), "utf-8")
        (hidden / "b.yaml").write_text(MODEL.format(CANARY), "utf-8")
    (folder / ".hidden.yaml").write_text(MODEL.format(CANARY), "utf-8")
    (folder / "link.yaml").symlink_to(tmp_path / "canary.yaml")
    (folder / "out").symlink_to(tmp_path)
    (folder / "loop.yaml").symlink_to("loop.yaml")
    (folder / "loop").symlink_to(".")
    (folder / "proc").symlink_to("/proc")
    (folder / "device.yaml").symlink_to("/dev/zero")
    os.mkfifo(folder / "pipe.yaml")
    # The path of a socket is short on every system, and that of a test is not.
    with socket.socket(socket.AF_UNIX) as made, within(folder):
        made.bind("socket.yaml")
        yield tmp_path


@contextmanager
def within(folder: Path) -> Iterator[None]:
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


def everything(folder: Path) -> dict[str, bytes]:
    """Return the content of all regular files below a folder; links are not followed."""
    return {
        str(path): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and not path.is_symlink()
    }


@pytest.mark.parametrize("question", QUESTIONS)
def test_no_path_leads_out(client: TestClient, outside: Path, question: str) -> None:
    before = everything(outside)
    for path in PATHS:
        if "\ud800" in path and question in IN_ADDRESS:
            continue  # no browser and no address can say it
        found = QUESTIONS[question](client, path)
        assert CANARY not in found.text, path
        assert "root:" not in found.text, path
        assert found.status_code in ERRORS or path in AT_HOME or not told(found), (
            path,
            found.text[:200],
        )
    after = everything(outside)
    assert {path: after.pop(path) for path in before} == before
    assert [Path(path).name for path in after] in ([], ["x.yaml"], ["v.yaml"])


def told(found: httpx.Response) -> bool:
    """Return whether an answer is more than errors: a text that is typed is read anywhere."""
    answer = found.json()
    plain = {"kind", "warnings", "fields", "errors", "groups", "question", "text", "path"}
    return not set(answer) <= plain or bool(answer.get("groups"))


def test_the_page_is_no_way_out(client: TestClient, outside: Path) -> None:
    for path in ("/../canary.yaml", "/%2e%2e/canary.yaml", "/..%2f..%2fcanary.yaml", "//etc/passwd",
                 "/%2fetc%2fpasswd", "/%00", "/assets/../../canary.yaml", "/..%5ccanary.yaml",
                 "/project/link.yaml", "/" + "a" * 5000):  # fmt: skip
        found = client.get(path)
        assert CANARY not in found.text
        assert "root:" not in found.text


def test_references_stay_inside(client: TestClient, folder: Path, outside: Path) -> None:
    for name in ("../canary.yaml", "/etc/passwd", "link.yaml", "out/canary.yaml", "proc/version"):
        text = f"format: arcless-scenario/1\nname: x\nline: {name}\nspeed: 100 km/h\n"
        asked = {"path": "s.yaml", "text": text}
        found = sent(client, "post", "/api/check", asked).json()
        assert any("outside" in one["text"] for one in found["errors"]), (name, found["errors"])
        found = sent(client, "post", "/api/statics", {**asked, "changes": {}, "want": ["line"]})
        assert CANARY not in found.text
        assert "root:" not in found.text


@pytest.mark.parametrize("name", [
    "a.py", "a.sh", "a.txt", "a", "a.yaml.py", "a.html", "a.js", "a.csv", "result.nc", "a.yaml/",
])  # fmt: skip
def test_only_models_are_written_and_read(client: TestClient, folder: Path, name: str) -> None:
    if not name.endswith("/"):
        (folder / name).write_text(CANARY, "utf-8")
        assert CANARY not in client.get("/api/file", params={"path": name}).text
        (folder / name).unlink()
    asked = {"path": name, "text": "x", "version": None}
    found = sent(client, "put", "/api/file", asked)
    assert found.status_code in ERRORS or name.endswith("/")
    assert not (folder / "a.py").exists()


def test_names_of_new_files(client: TestClient, folder: Path, outside: Path) -> None:
    before = everything(outside)
    bad = ["../x", "/x", ".x", "a/../../x", "a/b/../../../x", "", "x\0", "\ud800", "x" * 300, 5,
           None, ["x"], "out/x", "con/\n"]  # fmt: skip
    for name in bad:
        asked = {"name": name, "from": "shipped:line/ac-simple-55", "with_pantographs": False}
        assert sent(client, "post", "/api/new", asked).status_code in ERRORS, name
        asked = {"scenario": "shipped:scenario/en50318-ac-simple-320-planar", "name": name,
                 "changes": {}}  # fmt: skip
        assert sent(client, "post", "/api/variant", asked).status_code in ERRORS, name
        if isinstance(name, str) and "\ud800" not in name:
            found = client.post("/api/measured", params={"name": f"{name}.csv"}, content=b"x")
            assert found.status_code in ERRORS or name == "", name
    added = {path for path in everything(outside) if path not in before}
    assert added <= {str(folder / "measured" / ".csv")}
    assert all(everything(outside)[path] == content for path, content in before.items())


@pytest.mark.parametrize("changes", [
    {"line": "../canary.yaml"}, {"line": "link.yaml"}, {"line": "/etc/passwd"},
    {"pantographs.0.model": "../canary.yaml"}, {"pantographs.0.model": "/proc/self/environ"},
    {"pantographs.0.controller": {"sample_time": "10 ms", "function": "../own.py:control"}},
])  # fmt: skip
def test_changes_name_no_file_outside(
    client: TestClient, outside: Path, changes: dict[str, Any]
) -> None:
    ran = outside / "made"
    (outside / "own.py").write_text(f"open({str(ran)!r}, 'w')\ndef control(_): return 0.0\n")
    scenario = "shipped:scenario/en50318-ac-simple-320-planar"
    asked = {"scenario": scenario, "changes": changes}
    found = sent(client, "post", "/api/runs", asked)
    assert found.status_code in ERRORS
    assert CANARY not in found.text
    asked = {"path": scenario, "text": None, "changes": changes, "want": ["line"], "question": 1}
    found = sent(client, "post", "/api/statics", asked)
    assert found.json()["errors"]
    assert CANARY not in found.text
    asked = {"scenario": scenario, "name": "v", "changes": changes}
    assert sent(client, "post", "/api/variant", asked).status_code in ERRORS
    assert not ran.exists()


@pytest.mark.parametrize("name", ["result.nc", "report.html", "report.pdf", ""])
def test_a_run_of_which_a_part_is_a_link(
    client: TestClient, folder: Path, outside: Path, name: str
) -> None:
    """Neither read nor written: the whole run, its result, its report."""
    place, elsewhere = folder / "runs" / "a", outside / "elsewhere"
    save(synthetic_dataset(force=lambda t: 100.0 + 0.0 * t), made(elsewhere) / "result.nc")
    (elsewhere / "report.html").write_text(CANARY, "utf-8")
    (elsewhere / "report.pdf").write_text(CANARY, "utf-8")
    if name:
        save(synthetic_dataset(force=lambda t: 100.0 + 0.0 * t), made(place) / "result.nc")
        (place / name).unlink(missing_ok=True)
        (place / name).symlink_to(elsewhere / name)
    else:
        made(place.parent)
        place.symlink_to(elsewhere)
    before = everything(elsewhere)
    asked = {"path": "runs/a", "pdf": name == "report.pdf"}
    assert sent(client, "post", "/api/run/report", asked).status_code in ERRORS
    if name != "report.pdf":
        found = client.get("/api/run/report", params={"path": "runs/a"})
        assert found.status_code in ERRORS
        assert CANARY not in found.text
    assert everything(elsewhere) == before


def made(folder: Path) -> Path:
    folder.mkdir(parents=True)
    return folder


def test_a_folder_of_measured_runs_that_is_a_link(client: TestClient, folder: Path) -> None:
    elsewhere = folder.parent / "elsewhere"
    elsewhere.mkdir()
    (folder / "measured").symlink_to(elsewhere)
    found = client.post("/api/measured", params={"name": "a.csv"}, content=b"x")
    assert found.status_code in ERRORS
    assert list(elsewhere.iterdir()) == []


def test_a_link_put_in_after_the_path_was_resolved(folder: Path, outside: Path) -> None:
    project = Project.of(folder)
    (folder / "d").mkdir()
    (folder / "d" / "canary.yaml").write_text("mine", "utf-8")
    file = project.inside("d/canary.yaml")
    assert opening.read_bytes(project, file, "d") == b"mine"
    (folder / "d" / "canary.yaml").unlink()
    (folder / "d").rmdir()
    (folder / "d").symlink_to(outside)
    with pytest.raises(OutputError):
        opening.read_bytes(project, file, "d")


@pytest.mark.parametrize("tag", [
    "!!python/object/apply:os.system ['touch {}']", "!!python/name:os.system",
    "!!python/object/new:subprocess.Popen [[touch, {}]]", "!!python/module:antigravity",
    "!include {}", "!!binary aGVsbG8=",
    "!<tag:yaml.org,2002:python/object/apply:os.system> ['touch {}']",
])  # fmt: skip
def test_no_tag_runs_code(client: TestClient, folder: Path, tag: str) -> None:
    made = folder.parent / "made"
    text = f"format: arcless-line/1\nname: {tag.format(made)}\n"
    saved = sent(client, "put", "/api/file", {"path": "t.yaml", "text": text, "version": None})
    assert saved.status_code == 200
    asked = {"path": "t.yaml", "text": text}
    assert sent(client, "post", "/api/check", asked).json()["errors"]
    sent(client, "post", "/api/form", asked)
    sent(client, "post", "/api/patch", {**asked, "changes": {"name": "!!python/name:os.system"}})
    sent(client, "post", "/api/statics", {**asked, "changes": {}, "want": ["line"]})
    client.get("/api/project")
    assert not made.exists()


def test_an_expression_is_a_text(client: TestClient, folder: Path) -> None:
    made = folder.parent / "made"
    for value in (
        f"__import__('os').system('touch {made}')",
        f"$(touch {made})",
        "{{7*7}}",
        "=1+1",
    ):
        text = f'format: arcless-line/1\nname: x\ncontact_wire: {{tension: "{value}"}}\n'
        assert sent(client, "post", "/api/check", {"path": "t.yaml", "text": text}).json()["errors"]
        asked = {"scenario": "shipped:scenario/en50318-ac-simple-320-planar", "name": "v",
                 "changes": {"line.contact_wire.tension": value}}  # fmt: skip
        assert sent(client, "post", "/api/variant", asked).status_code in ERRORS
    assert not made.exists()
    assert list(folder.iterdir()) == []


def test_a_controller_in_python_runs_with_a_run_alone(client: TestClient, folder: Path) -> None:
    made = folder.parent / "made"
    (folder / "own.py").write_text(f"open({str(made)!r}, 'w')\ndef control(_): return 0.0\n")
    shipped = Path(arcless.__file__).parent / "models" / "scenarios"
    text = (shipped / "en50318-ac-simple-320-planar.yaml").read_text("utf-8")
    (folder / "s.yaml").write_text(text, "utf-8")
    changes = {"pantographs.0.controller": {"sample_time": "10 ms", "function": "own.py:control"}}
    asked = {"path": "s.yaml", "text": text, "changes": changes, "question": 1, "want": ["line"]}
    found = sent(client, "post", "/api/patch", asked)
    changed = found.json()["text"]
    assert sent(client, "post", "/api/check", {**asked, "text": changed}).json()["errors"] == []
    assert sent(client, "post", "/api/statics", asked).json()["errors"] == []
    client.get("/api/project")
    assert not made.exists()
