"""An FMU in its process: its motion, its failures, and that nothing of it stays behind."""

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless.errors import ArclessError, FmuError, ModelError
from arcless.model.fmu.mapping import PantographFmu
from arcless.simulate.fmu import process
from arcless.simulate.fmu.admission import FmuPlace
from arcless.simulate.fmu.coupled import CoupledFmu
from tests.support import fmus

Floats = NDArray[np.float64]
pytestmark = fmus.can_run
FORCE, STEP = 120.0, 1e-3
PLACE = FmuPlace(name="P1", field="pantographs.0.model.fmu", step_s=STEP, balance=0.5)
STILL = dict.fromkeys(
    ("base_height", "base_velocity", "speed", "track_position", "control_force"), 0.0
)
LEVEL = 5.3  # m


def mapped(file: Path, **more: Any) -> PantographFmu:
    return PantographFmu.model_validate({"file": str(file), "static_force": "static_force", **more})


def begun(fmu: PantographFmu) -> CoupledFmu:
    """Return an FMU that stands at its start; where that fails nothing of it is left."""
    coupled = CoupledFmu(fmu, PLACE, FORCE)
    try:
        strips = fmu.strips
        coupled.begin(np.full(strips, LEVEL), np.full(strips, FORCE / strips), STILL)
    except BaseException:
        coupled.close()
        raise
    return coupled


def push(fmu: CoupledFmu, step: int) -> tuple[Floats, Floats]:
    """Take a step; return what was expected of it and what was reached, m."""
    free, compliance = fmu.predict(step, 50.0 * STEP * step, STILL)
    forces = np.full(len(free), FORCE / len(free)) + 40.0 * np.sin(
        0.05 * step + np.arange(len(free))
    )
    expected = free - compliance @ forces
    return expected - LEVEL, fmu.advance(forces) - LEVEL


def exact(steps: int, control: float | None = None) -> Floats:
    """Return the rise of the strip of the C pantograph after each step, by its exponential, m.

    Under the forces of `push`; with a control force in N under the static force.
    """
    from scipy.linalg import expm

    mass, spring, damper = np.diag([6.0, 9.0, 7.5]), [160.0, 15500.0, 7000.0], [100.0, 0.1, 45.0]
    k, c = np.zeros((3, 3)), np.zeros((3, 3))
    for i in range(3):
        e = np.eye(3)[i] - (np.eye(3)[i - 1] if i else 0.0)
        k += spring[i] * np.outer(e, e)
        c += damper[i] * np.outer(e, e)
    whole = np.zeros((8, 8))
    whole[:3, 3:6] = np.eye(3)
    whole[3:6, :3], whole[3:6, 3:6] = -np.linalg.solve(mass, k), -np.linalg.solve(mass, c)
    whole[5, 6], whole[3, 7] = -1.0 / 7.5, 1.0 / 6.0
    held, state, heights = expm(STEP * whole), np.zeros(8), []
    for step in range(steps):
        state[6] = 40.0 * np.sin(0.05 * step) if control is None else 0.0
        state[7] = control or 0.0
        state = held @ state
        heights.append(state[2])
    return np.array(heights)


@pytest.mark.parametrize("fmi", [2, 3])
def test_it_moves_as_its_equations_say(tmp_path: Path, fmi: int) -> None:
    fmu = begun(mapped(fmus.fmu(tmp_path, fmi)))
    try:
        rows = np.array([np.concatenate(push(fmu, step)) for step in range(300)])
        facts = fmu.facts()
    finally:
        fmu.close()
    # Runge-Kutta of order 4 with 125 µs: (50/s · 125 µs)⁵/120 of a motion of 20 mm, 2400 times.
    np.testing.assert_allclose(rows[:, 1], exact(300), rtol=0, atol=1e-12)
    # The FMU is linear: what a step takes for its heights is what it does, up to rounding of 5 m.
    np.testing.assert_allclose(rows[:, 0], rows[:, 1], rtol=0, atol=4e-15)
    assert (facts["steps"], facts["compliance_measured"]) == (300, 1)
    assert facts["largest_height_difference_m"] < 4e-15
    assert abs(facts["start_imbalance_N"]) < 1e-6  # 1e-15 m over a compliance of 6.7e-8 m/N
    assert facts["fmi_version"] == fmi


def test_two_strips(tmp_path: Path) -> None:
    names = {
        "contact_force": ("contact_force_1", "contact_force_2"),
        "strip_height": ("strip_height_1", "strip_height_2"),
        "strip_offset": (-0.2, 0.2),
    }
    fmu = begun(mapped(fmus.fmu(tmp_path, strips=2), **names))
    try:
        _, compliance = fmu.predict(0, 0.0, STILL)
        rows = np.array([push(fmu, step) for step in range(100)])
    finally:
        fmu.close()
    # Each strip has 3.75 kg, and within a step next to nothing of the other one.
    np.testing.assert_allclose(np.diag(compliance), STEP**2 / (2.0 * 3.75), rtol=5e-3)
    assert abs(compliance[0, 1]) < 1e-3 * compliance[0, 0]
    np.testing.assert_allclose(rows[:, 0], rows[:, 1], rtol=0, atol=4e-15)  # rounding of 5 m


def test_units_of_the_fmu_are_converted(tmp_path: Path) -> None:
    # The same library, described in kN and mm: it takes 0.12 for 120 N, and moves by so little.
    units = {"contact_force": "kN", "static_force": "kN", "strip_height": "mm"}
    plain = begun(mapped(fmus.fmu(tmp_path)))
    try:
        reached = np.array([push(plain, step)[1] for step in range(50)])
    finally:
        plain.close()
    other = begun(mapped(fmus.fmu(tmp_path, units=units)))
    try:
        converted = np.array([push(other, step)[1] for step in range(50)])
    finally:
        other.close()
    np.testing.assert_allclose(converted, 1e-6 * reached, rtol=0, atol=4e-15)  # rounding of 5 m


def test_an_fmu_without_saved_states(tmp_path: Path) -> None:
    file = fmus.fmu(tmp_path, faults=("NOSTATE",), keeps_state=False)
    fmu = begun(mapped(file, strip_mass=7.5))
    try:
        rows = np.array([np.concatenate(push(fmu, step)) for step in range(300)])
    finally:
        fmu.close()
    np.testing.assert_allclose(rows[:, 1], exact(300), rtol=0, atol=1e-12)
    # All other forces on the strip are taken to be those of the step before. Spring and damper
    # below it change them by 7 kN/m Δz and 45 N s/m Δv at most, if what is below stands still.
    moved = np.max(np.abs(np.diff(rows[:, 1])))
    faster = np.max(np.abs(np.diff(rows[:, 1], 2))) / STEP
    bound = STEP**2 / 7.5 * (7000.0 * moved + 45.0 * faster)
    missed = np.max(np.abs(rows[:, 0] - rows[:, 1]))
    assert 0.1 * bound < missed < 1.5 * bound
    assert fmu.facts()["compliance_measured"] == 0


def risen(file: Path, **parameters: float) -> Floats:
    """Return the rise of the strip with 60 N more on the first mass, after each step, m."""
    more = {"start_height": "start_height", "control_force": "control_force"}
    fmu = begun(mapped(file, **more, parameters=parameters))
    try:
        assert not fmu._level.any()  # it starts at the height that it was given
        rows = []
        for step in range(50):
            fmu.predict(step, 0.0, {**STILL, "control_force": 60.0})
            rows.append(fmu.advance(np.array([FORCE]))[0] - LEVEL)
    finally:
        fmu.close()
    return np.array(rows)


def test_parameters_start_height_and_inputs_reach_it(tmp_path: Path) -> None:
    file = fmus.fmu(tmp_path)
    exactly, by_the_rule = risen(file), risen(file, scheme=1.0)
    rise = exact(50, control=60.0)
    np.testing.assert_allclose(exactly, rise, rtol=0, atol=1e-12)
    # The trapezoidal rule is off by about (ω h)²/12 of what moves with ω, at most 57/s here.
    off = np.abs(by_the_rule - rise)
    assert 1e-10 < np.max(off) < (57.0 * STEP) ** 2 * np.max(rise)


FAILURES = {
    "CRASH=0.0105": "the FMU is gone: got it crashed (segmentation fault)",
    "EXIT=0.0105": "the FMU is gone: got it ended with code 7; hint: its last words: licence not",
    "HANG=0.0105": "the FMU hangs: got no answer within 3 s; hint: give a longer time_limit if it"
    " only is slow",
    "NOTANUMBER=0.0105": "the FMU gave no number: got strip_height = nan, expected a finite height",
    "LIFTS": "a contact force raises a strip of the FMU",
}


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("fault", FAILURES)
def test_a_failure_says_when_and_where(tmp_path: Path, fault: str, fmi: int) -> None:
    fmu = begun(mapped(fmus.fmu(tmp_path, fmi, faults=(fault,)), time_limit=3))
    try:
        with pytest.raises(FmuError) as caught:
            for step in range(100):
                push(fmu, step)
    finally:
        fmu.close()
    at = "t = 0 s, 0.00 m" if fault == "LIFTS" else "t = 0.01"
    assert str(caught.value).startswith(f"pantograph P1, {at}")
    assert FAILURES[fault] in str(caught.value)


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_status_of_the_fmu_is_told(tmp_path: Path, fmi: int) -> None:
    fmu = begun(mapped(fmus.fmu(tmp_path, fmi, faults=("FAIL=0.0105",))))
    words = rf"the FMU failed: got fmi{fmi}DoStep failed with status 3 \(error\)"
    try:
        with pytest.raises(FmuError, match=words):
            for step in range(100):
                push(fmu, step)
    finally:
        fmu.close()


def test_what_an_fmu_prints_disturbs_nothing(tmp_path: Path) -> None:
    fmu = begun(mapped(fmus.fmu(tmp_path, faults=("SPEAK",))))
    try:
        rows = np.array([push(fmu, step)[1] for step in range(300)])
    finally:
        fmu.close()
    np.testing.assert_allclose(rows[:, 0], exact(300), rtol=0, atol=1e-12)


@pytest.fixture
def left(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], list[Path]]:
    """Return what lists the folders of FMUs that are there."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return lambda: list(folder.glob("arcless-fmu-*"))


def test_nothing_stays_behind(tmp_path: Path, left: Callable[[], list[Path]]) -> None:
    fmu = begun(mapped(fmus.fmu(tmp_path)))
    child = fmu._process._process
    assert len(left()) == 1
    assert child.poll() is None
    fmu.close()
    fmu.close()
    assert child.poll() is not None
    assert not left()


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"model": "other"}, "other.so"),
        ({"token": "another"}, "Failed to instantiate"),
    ],
)
def test_a_library_that_does_not_load(
    tmp_path: Path, left: Callable[[], list[Path]], changed: dict[str, str], words: str
) -> None:
    text = fmus.description()
    text = text.replace(fmus.TOKEN, changed.get("token", fmus.TOKEN))
    if "model" in changed:
        file = fmus.undescribed(tmp_path, text)
        words = "pantograph.so"
    else:
        built = fmus.library()
        file = fmus.pack(tmp_path / "p.fmu", text, {fmus.own_platform(2): built})
    with pytest.raises(FmuError, match=words) as caught:
        begun(mapped(file))
    assert str(caught.value).startswith("pantograph P1, t = 0 s: the FMU failed: got ")
    assert not left()


def test_a_file_that_was_changed_is_refused(tmp_path: Path) -> None:
    fmu = mapped(fmus.fmu(tmp_path), sha256=64 * "a")
    with pytest.raises(ModelError, match="another FMU than the model was made with") as caught:
        begun(fmu)
    assert caught.value.where == "pantographs.0.model.fmu.sha256"


def test_steps_must_be_multiples_of_the_internal_one(tmp_path: Path) -> None:
    file = fmus.fmu(tmp_path, 3, attributes='fixedInternalStepSize="0.0003"')
    with pytest.raises(
        ModelError, match="a time step that the FMU cannot take: got 1 ms, expected a"
    ):
        begun(mapped(file))


def test_without_fmpy_it_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = fmus.fmu(tmp_path)
    monkeypatch.setattr(process, "find_spec", lambda _name: None)
    with pytest.raises(ArclessError, match=r"pip install 'arcless\[fmi\]'"):
        begun(mapped(file))


HOLDS = """
import sys, time
from pathlib import Path
from tests.unit.simulate.fmu.test_coupled import begun, mapped, push
fmu = begun(mapped(Path(sys.argv[1]), time_limit=600))
print(fmu._process._process.pid, flush=True)
for step in range(100):
    push(fmu, step)
"""


def test_a_hanging_fmu_ends_when_arcless_is_killed(
    tmp_path: Path, left: Callable[[], list[Path]]
) -> None:
    file = fmus.fmu(tmp_path, faults=("HANG=0.0105",))
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(filter(None, sys.path)),
        "TMPDIR": tempfile.gettempdir(),
    }
    parent = subprocess.Popen(
        [sys.executable, "-c", HOLDS, str(file)],
        stdout=subprocess.PIPE, env=environment, cwd=Path(__file__).parents[4],
    )  # fmt: skip
    assert parent.stdout is not None
    child = int(parent.stdout.readline())
    parent.send_signal(signal.SIGKILL)
    parent.wait()
    deadline = time.monotonic() + 30.0
    while _runs(child) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert not _runs(child)
    assert not left()


def _runs(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    state = Path(f"/proc/{pid}/stat")
    return not state.exists() or state.read_text().rpartition(")")[2].split()[0] != "Z"
