"""The studio's application in this process, and a client that is its page."""

import warnings
from collections.abc import Callable
from pathlib import Path

import pytest

from arcless.studio.project.project import Project
from arcless.studio.server import page
from arcless.studio.server.app import application
from arcless.studio.server.crowd import Crowd
from arcless.studio.server.keys import Keys

with warnings.catch_warnings():
    # Starlette names another package for its client than the one that is there.
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient

PORT = 8123
OWN = f"http://127.0.0.1:{PORT}"
Ask = Callable[..., TestClient]


@pytest.fixture
def keys() -> Keys:
    return Keys(PORT)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return the folder of a project; next to it there is room for what must not be read."""
    found = tmp_path / "project"
    found.mkdir()
    return found


@pytest.fixture
def stranger(folder: Path, tmp_path: Path, keys: Keys, monkeypatch: pytest.MonkeyPatch) -> Ask:
    """Return a function that makes a client without the cookie, with headers of its own."""
    built = tmp_path / "page"
    built.mkdir()
    (built / "index.html").write_text("<!doctype html><title>the page</title>", "utf-8")
    monkeypatch.setattr(page, "FOLDER", built)

    def client(**headers: str) -> TestClient:
        app = application(Project.of(folder), keys, Crowd())
        return TestClient(app, OWN, headers=headers, follow_redirects=False)

    return client


@pytest.fixture
def client(stranger: Ask, keys: Keys) -> TestClient:
    """Return a client that is the page: it has the cookie and says where it is from."""
    found = stranger(origin=OWN)
    session = keys.session_for(keys.token)
    assert session is not None
    found.cookies.set(keys.cookie, session)
    return found
