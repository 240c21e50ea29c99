"""The crate fmi-rs drives an FMU through the same steps as the loop inside, bit for bit."""

import math
import shutil
import struct
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

import arcless
from arcless.model import Scenario

ROOT = Path(__file__).parents[4]
PROGRAM = ROOT / "tests" / "importer"
STEPS = 500


@pytest.fixture(scope="module")
def importer() -> Path:
    """Return the program, compiled; its packages come from where cargo finds them."""
    cargo = shutil.which("cargo")
    if cargo is None:
        pytest.skip("no cargo here")
    target = ROOT / "target" / "importer"
    words = ("build", "--quiet", "--manifest-path", "Cargo.toml", "--target-dir", str(target))
    subprocess.run([cargo, *words], cwd=PROGRAM, check=True)
    return target / "debug" / "arcless-importer"


@pytest.mark.evidence  # it compiles a program with fifty packages
@pytest.mark.parametrize("version", [2, 3])
def test_fmi_rs_takes_the_steps_of_the_loop(
    scenario: Scenario, fmu: Callable[..., Path], importer: Path, version: int
) -> None:
    words = (str(fmu(version)), str(version), str(STEPS), "P1.contact_force", "P1.wire_height")
    done = subprocess.run([importer, *words], check=True, capture_output=True, text=True)
    found = [struct.unpack(">d", bytes.fromhex(line))[0] for line in done.stdout.split()]
    loop = arcless.realtime(scenario)
    expected = []
    for step in range(STEPS):
        loop.step(120.0 + 40.0 * math.sin(0.02 * step))
        expected.append(float(loop.height_m[0]))
    # Both sines are those of the C library, as a rule the same; else they differ in the last bit.
    assert found == pytest.approx(expected, abs=1e-12)
    assert len(found) == STEPS
