"""A short run that drills stop, and what a folder must look like afterwards."""

import json
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import asdict
from functools import cache
from pathlib import Path
from tempfile import NamedTemporaryFile

import pytest

import arcless
from tests.support.stopped import End, Job

ROOT = Path(__file__).parents[2]
SHORT = ROOT / "tests" / "interface" / "data" / "short.yaml"
# Six spans in 4 ms steps: a run that takes a fraction of a second, so that drills can be many.
QUICK = {
    "line.spans": "[{type: span, count: 6}]",
    "travel": "{start: 50 m, end: 200 m}",
    "analysis": "{from: 60 m, to: 190 m}",
    "solver.time_step": "4 ms",
}
# Where the folder holds an older run, it was slower: files of two runs cannot be mistaken.
OLD, NEW = "140 km/h", "160 km/h"
RUN = ["run", str(SHORT), "--out", "out", "--overwrite", "--quiet", "--speed", NEW]
RUN += [word for field, value in QUICK.items() for word in ("--set", f"{field}={value}")]

Stop = Callable[[Job], End]


@pytest.fixture(scope="session")
def stop() -> Iterator[Stop]:
    """Carry out jobs, one after the other, in forks of one process."""
    with subprocess.Popen(
        [sys.executable, "-m", "tests.support.stopped", *RUN],
        cwd=ROOT,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as server:
        assert server.stdin is not None
        assert server.stdout is not None

        def carry_out(job: Job) -> End:
            assert server.stdin is not None
            assert server.stdout is not None
            print(json.dumps(asdict(job)), file=server.stdin, flush=True)
            return End(**json.loads(server.stdout.readline()))

        yield carry_out
        server.stdin.close()


@pytest.fixture(scope="session")
def older(stop: Stop, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder that holds the files of a finished, older run in `out`."""
    folder = tmp_path_factory.mktemp("older")
    end = stop(Job([*RUN, "--speed", OLD], str(folder), "never"))
    assert end.code in (0, 3), end
    assert names(folder / "out") == ["assessment.json", "report.html", "result.nc"]
    return folder


@pytest.fixture
def place(older: Path, tmp_path: Path) -> Callable[[str], Path]:
    """Make a folder for one drill: `fresh`, or `older` with the files of an older run."""
    made = 0

    def make(kind: str) -> Path:
        nonlocal made
        made += 1
        folder = tmp_path / f"{kind}-{made}"
        if kind == "older":
            shutil.copytree(older, folder)
        else:
            folder.mkdir()
        return folder

    return make


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Callable[[int], Path]]:
    """Return a maker of disks of some KiB; only who may mount can have one."""
    mounted: list[Path] = []

    def make(kibibytes: int) -> Path:
        place = tmp_path / f"disk-{kibibytes}"
        place.mkdir()
        command = ["mount", "-t", "tmpfs", "-o", f"size={kibibytes}k", "tmpfs", str(place)]
        try:
            done = subprocess.run(command, capture_output=True, check=False)
        except FileNotFoundError:
            pytest.skip("there is no command `mount` here")
        if done.returncode:
            pytest.skip("this user may not mount a small disk; the other drills stand for it")
        mounted.append(place)
        return place

    yield make
    for place in mounted:
        unmount(place)


# Of 0.1 s each. The process that cleans up after the workers of a study ends a moment after them.
TRIES = 100


def unmount(place: Path) -> None:
    """Remove a small disk; what holds it longer than some seconds is an error."""
    for _ in range(TRIES):
        done = subprocess.run(["umount", str(place)], capture_output=True, text=True, check=False)
        if done.returncode == 0:
            return
        time.sleep(0.1)
    raise AssertionError(f"{done.stderr.strip()}; held by {holders(place)}")


def holders(place: Path) -> list[str]:
    """Return the commands of the processes that work in a folder or hold a file of it."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            held = [process / "cwd", *(process / "fd").iterdir()]
            mapped = str(place) in (process / "maps").read_text("utf-8")
            if mapped or any(link.resolve().is_relative_to(place) for link in held):
                found.append((process / "cmdline").read_bytes().replace(b"\0", b" ").decode())
    return found


def names(folder: Path) -> list[str]:
    """Return the names of the visible files of a folder."""
    return sorted(p.name for p in folder.glob("*") if not p.name.startswith("."))


def leftovers(folder: Path) -> list[str]:
    """Return everything below a folder that is hidden, by its path."""
    return sorted(str(p.relative_to(folder)) for p in folder.rglob(".*"))


def check_whole(folder: Path) -> str | None:
    """Read all that has its final name; return the one speed of which it tells, if any."""
    speeds = {told_by(name, (folder / name).read_bytes()) for name in names(folder)}
    assert len(speeds) <= 1, f"files of two runs in one folder: {speeds}"
    return speeds.pop() if speeds else None


@cache  # most drills leave the files of the older run, which need reading only once
def told_by(name: str, content: bytes) -> str:
    """Read a whole file; return the speed of which it tells."""
    if name == "result.nc":
        with NamedTemporaryFile(suffix=".nc") as file:
            file.write(content)
            file.flush()
            result = arcless.open(file.name)
        assert result.dataset.contact_force.size > 0
        return f"{result.scenario.speed * 3.6:.0f} km/h"
    if name == "assessment.json":
        return f"{json.loads(content)['speed_m_s'] * 3.6:.0f} km/h"
    assert name == "report.html", name
    text = content.decode()
    assert text.rstrip().endswith("</html>")
    return next(speed for speed in (OLD, NEW) if speed in text)
