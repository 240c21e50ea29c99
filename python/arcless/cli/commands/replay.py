"""`arcless replay`: the complementarity problem of a failed time step, solved again."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from arcless.cli.terminal import console
from arcless.errors import ModelError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

PATTERN = "arcless-lcp-*.json"  # as failed runs name them
MAX_BYTES = 256 * 1024 * 1024  # far above any step's problem; a larger file is another file


@dataclass(frozen=True)
class SavedProblem:
    """A complementarity problem y = Hx + w as a failed run saved it."""

    H: "NDArray[np.float64]"
    w: "NDArray[np.float64]"
    links: list[str]
    step: int | None
    time_s: float | None


def replay(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="FILE",
            help="The JSON file that a failed run left, or a folder with one of them.",
            show_default=False,
        ),
    ],
) -> None:
    """Solve the problem of a failed time step again, from the file that the run named.

    The problem is the complementarity problem of contacts and droppers, y = Hx + w.

    Exit code 1 means that it still has no solution.
    """
    from arcless import lcp

    file = _file_in(file) if file.is_dir() else file
    problem = read_problem(file)
    try:
        x, y, info = lcp.solve(problem.H, problem.w, symmetric=False)
    except lcp.LcpInputError as error:
        error.where = str(file)
        raise
    except lcp.LcpUnsolvedError as error:
        console.data(_heading(problem))
        console.data(f"status: not solved, pivots: {error.pivots}, residual: {error.residual:.1e}")
        raise
    console.data(_heading(problem))
    console.data(f"status: {info.status}, pivots: {info.pivots}, residual: {info.residual:.1e}")
    for name, force, gap in zip(problem.links, x, y, strict=True):
        console.data(f"{name}: x = {force:.9g}, y = {gap:.9g}")


def _file_in(folder: Path) -> Path:
    """Return the one saved problem in a folder."""
    found = sorted(folder.glob(PATTERN))
    if len(found) == 1:
        return found[0]
    got = f"{len(found)} of them, such as {found[-1].name}" if found else "none"
    raise ModelError(
        "no single problem to replay in this folder",
        where=str(folder),
        got=got,
        expected=f"one file {PATTERN}, or its name",
        hint="a failed run names the file that it left; `arcless report` and `assess` take runs",
    )


def _heading(problem: SavedProblem) -> str:
    step = "unknown" if problem.step is None else problem.step
    time = "unknown" if problem.time_s is None else f"{problem.time_s} s"
    return f"step: {step}, time: {time}, links: {len(problem.links)}"


def read_problem(file: Path) -> SavedProblem:
    """Read a saved problem.

    Raises
    ------
    ModelError
        The file is no saved problem, or its numbers do not belong together.
    """
    import numpy as np

    saved = _read(file)
    try:
        w = np.asarray(saved["w"], dtype=float)
        matrix = np.asarray(saved["H"], dtype=float).reshape(w.size, w.size)
    except KeyError as error:
        raise _refused(file, f"no field {error}") from error
    except (ValueError, TypeError) as error:
        raise _refused(file, f"H and w that do not fit: {error}") from error
    links = [str(link) for link in saved.get("links") or range(w.size)]
    if len(links) != w.size:
        raise _refused(file, f"{len(links)} links for {w.size} unknowns")
    return SavedProblem(matrix, w, links, saved.get("step"), saved.get("time_s"))


def _read(file: Path) -> dict[str, Any]:
    try:
        if file.stat().st_size > MAX_BYTES:
            raise _refused(file, f"more than {MAX_BYTES // 2**20} MiB")
        saved = json.loads(file.read_text("utf-8"))
    except OSError as error:
        raise _refused(file, error.strerror or str(error)) from error
    except (ValueError, RecursionError) as error:
        raise _refused(file, "no JSON") from error
    if not isinstance(saved, dict) or saved.get("kind") != "lcp":
        raise _refused(file, 'JSON without `"kind": "lcp"`')
    return saved


def _refused(file: Path, got: str) -> ModelError:
    return ModelError(
        "cannot replay this file",
        where=str(file),
        got=got,
        expected="the JSON file that a failed run left, with H, w and links",
    )
