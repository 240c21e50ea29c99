"""Build the site of the documentation: `python docs/website/build.py [FOLDER]`.

Pages are copied into FOLDER/source with those that the program makes, and Sphinx builds
FOLDER/html. A warning, a notebook that fails, a link that leads nowhere and anything that a page
would load from elsewhere end it with 1.
"""

import json
import os
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))

from sphinx.cmd.build import build_main
from website import checks, commands, pages, python, schemas

HERE = Path(__file__).parent
# Kernels say in a warning that they talk by TCP, which on one machine is no news.
ONLY_ERRORS = "--log-level=40"


def kernel(folder: Path) -> None:
    """Have notebooks run by this Python, whatever kernel a user has installed as `python3`."""
    command = [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}", ONLY_ERRORS]
    specification = {"argv": command, "display_name": "Python 3", "language": "python"}
    path = folder / "jupyter" / "kernels" / "python3" / "kernel.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(specification), "utf-8")
    os.environ["JUPYTER_PATH"] = str(folder / "jupyter")


def main(folder: Path) -> int:
    """Build and check the site; return the exit code."""
    source, html = folder / "source", folder / "html"
    made = commands.pages() | schemas.pages() | python.pages()
    staging = pages.Staging(source)
    pages.stage(staging, made)
    kernel(folder)
    every = ["--write-all"] if staging.index_changed else []
    options = [*every, "--fail-on-warning", "--keep-going", "--nitpicky", "--quiet", "-b", "html"]
    notebooks = f"nb_execution_cache_path={folder / 'notebooks'}"
    state = ["-d", str(folder / "doctrees"), "-D", notebooks]
    code = build_main([*options, *state, "-c", str(HERE), str(source), str(html)])
    if code:
        return code
    complaints = checks.complaints(html)
    for text in complaints:
        print(f"make docs: {text}", file=sys.stderr)
    return int(bool(complaints))


if __name__ == "__main__":
    sys.exit(main(Path(*sys.argv[1:]) if sys.argv[1:] else pages.ROOT / "target" / "docs"))
