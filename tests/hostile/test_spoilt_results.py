"""Spoilt result files give an error of ours with one sentence, or a result; never anything else.

A checksum at the end of a file finds damage before the HDF5 library does, which a stretch of zeros
can send round in circles. What is cut short has no checksum; HDF5 sees that. That library is not
ours and could take the process down, so files are read in a process of their own.
"""

import subprocess
import sys
from collections import Counter
from pathlib import Path
from random import Random

import pytest

import arcless
from tests.support.hostile import FACTOR

SHORT = Path(__file__).parents[1] / "interface" / "data" / "short.yaml"
MANY = 40 * FACTOR
LONGEST = 300.0 * FACTOR  # s: far more than reading takes, for what never ends
# Reads every file named on its standard input as whoever assesses or goes on with a run would.
READER = """
import sys
import arcless
from arcless.errors import ArclessError
for path in sys.stdin.read().split():
    print("reading", flush=True)
    try:
        result = arcless.open(path)
        result.scenario
        (result if result.is_complete else arcless.resume(result)).assessment.to_json()
        print("result", flush=True)
    except ArclessError as error:
        assert error.what and "Traceback" not in str(error)
        print("error", flush=True)
"""


def spoilt(data: bytes, random: Random) -> bytes:
    """Cut a file short, or change some bits or stretches of it, half of them near its beginning."""
    changed = bytearray(data)
    reach = len(data) if random.random() < 0.5 else 4096
    for _ in range(random.choice([1, 3, 30])):
        at = random.randrange(reach)
        changed[at] ^= 1 << random.randrange(8)
    if random.random() < 0.3:
        at, size = random.randrange(reach), random.choice([8, 100, 4000])
        changed[at : at + size] = random.choice([bytes(size), random.randbytes(size)])
    if random.random() < 0.2:
        del changed[random.randrange(len(data)) :]
    return bytes(changed)


@pytest.fixture(scope="module")
def results() -> dict[str, "arcless.results.Result"]:
    scenario = arcless.load(SHORT)
    return {"whole": arcless.run(scenario), "part": arcless.run(scenario, until="0.05 s")}


@pytest.mark.parametrize("kind", ["whole", "part"])
def test_spoilt_results(
    kind: str, results: dict[str, "arcless.results.Result"], tmp_path: Path
) -> None:
    results[kind].save(tmp_path / "sound.nc")
    data, random = (tmp_path / "sound.nc").read_bytes(), Random(kind)
    paths = [tmp_path / f"{number}.nc" for number in range(MANY)]
    for path in paths:
        path.write_bytes(spoilt(data, random))
    # A warning of a library about what it found is none of its failures.
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", READER],
        input="\n".join(map(str, [tmp_path / "sound.nc", *paths])),
        capture_output=True,
        text=True,
        timeout=LONGEST,
        check=False,
    )
    said = done.stdout.split()
    assert done.returncode == 0, f"{paths[said.count('reading') - 2]}: {done.stderr[-2000:]}"
    counts = Counter(said)
    assert counts == {"reading": MANY + 1, "result": 1, "error": MANY}, "all but the sound one"
