"""Behaviour that only a real process shows: signals, pipes, terminals, exit codes."""

import json
import os
import pty
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.support.signals import interruptible

Process = Callable[..., subprocess.CompletedProcess[str]]
# 675 000 steps, and statics of 10 km of line: no machine finishes these while a test waits.
LONG_STEPPING = ("--set", "solver.time_step=0.01 ms")
LONG_STATICS = ("--set", "line.spans=[{type: span, count: 200}]")
# The promise is one second; a loaded two-core machine gets a second more.
STOPS_WITHIN_S = 2.0


def test_module_and_script_are_the_same_command(process: Process) -> None:
    script = Path(sys.executable).with_name("arcless")
    by_script = subprocess.run([script, "--help"], capture_output=True, text=True, check=True)
    assert by_script.stdout == process("--help").stdout


def test_json_alone_on_standard_output(process: Process, short: Path) -> None:
    done = process("run", short, "--json", "--no-report")
    assert done.returncode in (0, 3), done.stderr
    assert json.loads(done.stdout)["scenario"] == "short"
    assert "\x1b" not in done.stdout + done.stderr


def test_errors_leave_standard_output_empty(process: Process) -> None:
    done = process("check", "none.yaml")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("error: none.yaml")
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("long", [LONG_STEPPING, LONG_STATICS], ids=["stepping", "statics"])
def test_interrupt_leaves_no_file(short: Path, tmp_path: Path, long: tuple[str, ...]) -> None:
    words = ["-m", "arcless", "run", str(short), "--out", "new/folder", *long]
    with interruptible():
        running = subprocess.Popen(
            [sys.executable, *words],
            cwd=tmp_path,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
    wait_for(lambda: any(tmp_path.rglob(".arcless-*")))
    time.sleep(2.0)  # past the imports, into native code
    assert running.poll() is None, running.communicate()
    started = time.monotonic()
    running.send_signal(signal.SIGINT)
    out, err = running.communicate(timeout=60)
    assert time.monotonic() - started < STOPS_WITHIN_S
    assert (running.returncode, out, err) == (1, "", "interrupted\n")
    assert list(tmp_path.iterdir()) == []


def test_interrupt_during_start(tmp_path: Path, short: Path) -> None:
    for delay in (0.05, 0.15, 0.4, 0.8):
        with interruptible():
            running = subprocess.Popen(
                [sys.executable, "-m", "arcless", "run", str(short), *LONG_STEPPING],
                cwd=tmp_path,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                text=True,
            )
        time.sleep(delay)
        running.send_signal(signal.SIGINT)
        running.communicate(timeout=60)
        assert running.returncode != 0
        assert list(tmp_path.iterdir()) == []


def test_reader_that_goes_away_is_no_error(short: Path) -> None:
    running = subprocess.Popen(
        [sys.executable, "-m", "arcless", "schema"], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert running.stdout is not None
    assert running.stderr is not None
    running.stdout.close()
    assert running.stderr.read() == b""
    assert running.wait(timeout=60) == 0


def test_progress_on_a_terminal_only(short: Path, tmp_path: Path, process: Process) -> None:
    words = ["-m", "arcless", "run", str(short), "--no-report", "--out", "out"]
    screen, terminal = pty.openpty()
    environment = {**os.environ, "TERM": "xterm", "COLUMNS": "100"}
    running = subprocess.Popen(
        [sys.executable, *words],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=terminal,
        env=environment,
    )
    os.close(terminal)
    shown = b""
    try:
        while part := os.read(screen, 4096):
            shown += part
    except OSError:  # the terminal closes with the process
        pass
    assert running.wait(timeout=60) in (0, 3)
    assert b"%" in shown
    assert "%" not in process("run", short, "--no-report", "--out", "piped").stderr


def wait_for(happened: Callable[[], bool], limit_s: float = 30.0) -> None:
    """Wait until something happened."""
    until = time.monotonic() + limit_s
    while not happened():
        assert time.monotonic() < until, "waited in vain"
        time.sleep(0.05)
