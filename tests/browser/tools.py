"""The tools that drive pages in a browser: Chromium, and Node with packages of the studio's page.

`make page` installs those packages. Where something is missing, the tests that need it are skipped
with one sentence.
"""

import shutil
from pathlib import Path

from page import build
from page.build import node

FOLDER = build.HERE
NAMES = ("chromium", "chromium-browser", "google-chrome")

__all__ = ["FOLDER", "chromium", "missing", "node"]


def chromium() -> str | None:
    """Return the program, or None where there is none."""
    return next((found for name in NAMES if (found := shutil.which(name))), None)


def missing(folder: Path = FOLDER) -> str:
    """Return a sentence about what is missing for these tests; empty if nothing is."""
    reason = build.missing(folder) if chromium() else "there is no Chromium here"
    return reason and f"pages are not tried in a browser: {reason}"
