"""FMUs on Windows: those of Arcless driven by FMPy, and those of others in a process of their own.

`make windows` compiles the pantograph of tests/support/fmu for Windows, and says where it lies.
"""

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import arcless
from arcless.errors import FmuError
from arcless.fmi import export_fmu
from tests.support import fmus
from tests.unit.simulate.fmu.test_coupled import HOLDS, begun, exact, mapped, push

LIBRARIES = os.environ.get("ARCLESS_PANTOGRAPHS")
pytestmark = pytest.mark.skipif(sys.platform != "win32", reason="this is not Windows")
SCENARIO = "en50318-ac-simple-320-planar"
GIVEN = {"pantographs.0.mean_force": None, "pantographs.0.static_force": 120.0}
PATIENCE_S = 120
Fmu = Callable[[str], Path]


@pytest.fixture
def fmu(tmp_path: Path) -> Fmu:
    """Return what packs the pantograph with a fault, which `plain` has not."""
    if LIBRARIES is None:
        pytest.skip("no libraries of a pantograph: `make windows` compiles them")
    folder = Path(LIBRARIES)
    return lambda fault: fmus.pack(
        tmp_path / f"{fault}.fmu", fmus.description(), {"win64": folder / f"{fault}.dll"}
    )


@pytest.fixture
def left(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], list[Path]]:
    """Return what lists the folders of FMUs that are there."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return lambda: list(folder.glob("arcless-fmu-*"))


@pytest.mark.parametrize("version", [2, 3])
def test_an_fmu_of_arcless_takes_the_steps_of_the_loop(tmp_path: Path, version: int) -> None:
    from tests.support.exported import driven

    scenario = arcless.load(SCENARIO).with_(**GIVEN)
    export_fmu(scenario, tmp_path / "line.fmu", version=version, given="control-force")
    loop = arcless.realtime(scenario, simulated=True)
    with driven(tmp_path / "line.fmu") as run:
        for number in range(200):
            force = 40.0 * float(np.sin(0.02 * number))
            expected = loop.step(force)
            run.put({"P1.control_force": force})
            run.step()
            found = run.get("P1.contact_force", "P1.wire_height", "position")
            assert found == [expected[0], loop.height_m[0], loop.position_m]


@pytest.mark.parametrize("how", ["plain", "speaks"])
def test_a_pantograph_moves_as_its_equations_say(
    fmu: Fmu, left: Callable[[], list[Path]], how: str
) -> None:
    """Text that the library prints does not get between the numbers."""
    coupled = begun(mapped(fmu(how)))
    try:
        rows = np.array([push(coupled, step) for step in range(300)])
    finally:
        coupled.close()
    # As in tests/unit/simulate/fmu: (50/s · 125 µs)⁵/120 of a motion of 20 mm, 2400 times.
    np.testing.assert_allclose(rows[:, 1, 0], exact(300), rtol=0, atol=1e-12)
    assert not left()


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("crashes", "access violation"),
        ("exits", "the FMU is gone: got it ended with code 7; hint: its last words: licence not"),
        ("hangs", "the FMU hangs: got no answer within 3 s"),
    ],
)
def test_a_failure_says_when_and_where(
    fmu: Fmu, left: Callable[[], list[Path]], fault: str, words: str
) -> None:
    coupled = begun(mapped(fmu(fault), time_limit=3))
    try:
        with pytest.raises(FmuError) as caught:
            for step in range(100):
                push(coupled, step)
    finally:
        coupled.close()
    assert str(caught.value).startswith("pantograph P1, t = 0.01")
    assert words in str(caught.value)
    assert not left()


def test_a_hanging_fmu_ends_when_arcless_is_killed(fmu: Fmu) -> None:
    assert sys.platform == "win32"
    import ctypes

    kernel = ctypes.WinDLL("kernel32")
    kernel.OpenProcess.restype = ctypes.c_void_p
    synchronize, is_ended = 0x0010_0000, 0
    with subprocess.Popen(
        [sys.executable, "-c", HOLDS, str(fmu("hangs"))], stdout=subprocess.PIPE
    ) as parent:
        assert parent.stdout is not None
        child = ctypes.c_void_p(
            kernel.OpenProcess(synchronize, False, int(parent.stdout.readline()))
        )
        assert child.value
        parent.kill()
    assert kernel.WaitForSingleObject(child, 1000 * PATIENCE_S) == is_ended
