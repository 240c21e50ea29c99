"""A project with a scenario and its line, and a file outside that nobody may see."""

from pathlib import Path

import pytest

from arcless.model.own_copy import copies, write_copies
from arcless.studio.project.project import Project

CANARY = "canary-3f9a"


@pytest.fixture
def project(tmp_path: Path) -> Project:
    """Return a project next to files that are none of its own."""
    folder = tmp_path / "project"
    folder.mkdir()
    write_copies(folder, copies("my", "en50318-ac-simple-320"), "{}\n")
    outside = tmp_path / "outside"
    outside.mkdir()
    for name in ("secret.yaml", "secret.csv", "secret.json"):
        (outside / name).write_text(f"{CANARY}: {CANARY}\n")
    return Project.of(folder)
