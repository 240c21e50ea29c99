"""Files of the shipped models; nothing is imported that a prompt would have to wait for."""

from functools import cache
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "models"
# Kind of model → folder of its files.
FOLDERS = {"line": "lines", "pantograph": "pantographs", "scenario": "scenarios",
           "study": "studies"}  # fmt: skip


@cache
def shipped(kind: str) -> dict[str, Path]:
    """Return the files of the shipped models of a kind, by name."""
    return {path.stem: path for path in sorted((FOLDER / FOLDERS[kind]).glob("*.yaml"))}
