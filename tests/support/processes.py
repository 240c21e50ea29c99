"""Processes that another one has started, on Linux."""

from pathlib import Path


def below(process: int) -> list[int]:
    """Return the numbers of all processes below one that are there."""
    found = []
    for task in _tasks(process):
        try:
            children = (task / "children").read_text().split()
        except OSError:
            continue
        for child in map(int, children):
            found += [child, *below(child)]
    return found


def is_there(process: int) -> bool:
    """Return whether a process is there, and not only waited for."""
    try:
        return "Z" not in Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except FileNotFoundError:
        return False


def _tasks(process: int) -> list[Path]:
    """Return the threads of a process: each may start others."""
    try:
        return list(Path(f"/proc/{process}/task").iterdir())
    except OSError:
        return []
