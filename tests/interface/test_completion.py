"""Completion at the prompt, asked as the shells ask; in bash the whole way."""

import os
import pty
import select
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from arcless.cli.completion import names
from arcless.cli.completion.scripts import VARIABLE
from arcless.storage.shipped_files import FOLDERS, shipped
from tests.interface.test_start import SLOW, modules_of

SHELLS = ("bash", "zsh", "fish")
Complete = Callable[..., list[str]]


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the current folder: a run, what is none, a study, model files, a measurement."""
    for file in ("runs/a/result.nc", "runs/b/notes.txt", "runs/studies/grid/study.json"):
        (tmp_path / file).parent.mkdir(parents=True)
        (tmp_path / file).touch()
    for file in ("mine.yaml", "table.csv", "other.nc", "notes.txt"):
        (tmp_path / file).touch()
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a program `arcless`."""
    folder = tmp_path_factory.mktemp("bin")
    file = folder / "arcless"
    file.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m arcless "$@"\n')
    file.chmod(0o755)
    return folder


@pytest.fixture
def complete(place: Path, program: Path) -> Complete:
    """Complete the last of some words as bash does when the tab key is pressed."""
    bash = shutil.which("bash")
    if bash is None:
        pytest.skip("there is no bash here")
    # What readline hands to the function, and what it is given back.
    script = (
        'eval "$(arcless completion bash)"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1));'
        ' _arcless_completion arcless; printf "%s\\n" "${COMPREPLY[@]}"'
    )

    def ask(*words: str) -> list[str]:
        done = subprocess.run(
            [bash, "--norc", "-c", script, "bash", "arcless", *words],
            cwd=place, env={**os.environ, "PATH": f"{program}:{os.environ['PATH']}"},
            capture_output=True, text=True, timeout=60, check=True,
        )  # fmt: skip
        assert done.stderr == ""
        return done.stdout.split()

    return ask


@pytest.mark.parametrize(
    ("words", "found"),
    [
        (["sta"], ["statics"]),
        (["study", "re"], ["resume", "report"]),
        (["run", "--sp"], ["--speed"]),
        (["run", "norway-s25-"], ["norway-s25-250"]),
        (["run", "mi"], ["mine.yaml"]),
        (["statics", "en50318-2002-3"], ["en50318-2002-300"]),
        (["statics", "line/norway-s25"], ["line/norway-s25"]),
        (["table", "norway-s25"], ["norway-s25", "norway-s25-250"]),
        (["show", "line/norway-s25"], ["line/norway-s25"]),
        (["new", "x", "--from", "dsa"], ["dsa-250", "dsa-380"]),
        (["assess", "runs/"], ["runs/a"]),
        (["compare", "runs/a", "t"], ["table.csv"]),
        (["export", "o"], ["other.nc"]),
        (["study", "run", "speed"], ["speed-sweep"]),
        (["study", "status", "runs/"], ["runs/studies/grid"]),
        (["library", "lin"], ["line"]),
        (["completion", ""], ["bash", "zsh", "fish"]),
        # Nothing of ours: the shell completes names of files.
        (["replay", "notes"], []),
        (["run", "no-such-model"], []),
        (["no-such-command", "--x"], []),
    ],
)
def test_in_bash(complete: Complete, words: list[str], found: list[str]) -> None:
    told = complete(*words)
    assert set(told) >= set(found)
    assert bool(told) == bool(found)
    assert all(one.startswith(words[-1]) for one in told)


def test_the_tab_key_in_a_terminal(program: Path, place: Path) -> None:
    bash = shutil.which("bash")
    if bash is None:
        pytest.skip("there is no bash here")
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(place)
        os.environ |= {"PATH": f"{program}:{os.environ['PATH']}", "TERM": "dumb", "PS1": "$ "}
        os.execv(bash, [bash, "--norc", "--noprofile", "-i"])
    told = b""
    try:
        os.write(terminal, b'eval "$(arcless completion bash)"\narcless stat\t')
        ends = time.monotonic() + 30.0
        while b"arcless statics " not in told and time.monotonic() < ends:
            if select.select([terminal], [], [], 1.0)[0]:
                told += os.read(terminal, 4096)
    finally:
        os.write(terminal, b"\x03exit\n")
        os.close(terminal)
        os.waitpid(child, 0)
    assert b"arcless statics " in told, told


@pytest.mark.parametrize(
    ("shell", "asks", "told"),
    [
        ("zsh", {"_TYPER_COMPLETE_ARGS": "arcless run norway-s25-"}, "norway-s25-250"),
        ("zsh", {"_TYPER_COMPLETE_ARGS": "arcless replay x"}, "_files"),
        (
            "fish",
            {"_TYPER_COMPLETE_ARGS": "arcless sta", "_TYPER_COMPLETE_FISH_ACTION": "get-args"},
            "statics\tFind the line at rest, without a run.",
        ),
    ],
)
def test_as_other_shells_ask(
    process: Callable[..., subprocess.CompletedProcess[str]],
    shell: str, asks: dict[str, str], told: str,
) -> None:  # fmt: skip
    done = process(env={**os.environ, **asks, VARIABLE: f"complete_{shell}"})
    assert told in done.stdout
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(shutil.which("fish") is None, reason="there is no fish here")
def test_in_fish(program: Path, place: Path) -> None:
    script = "arcless completion fish | source; complete -C 'arcless run norway-s25-'"
    done = subprocess.run(
        ["fish", "--no-config", "-c", script], cwd=place,
        env={**os.environ, "PATH": f"{program}:{os.environ['PATH']}"},
        capture_output=True, text=True, timeout=60, check=True,
    )  # fmt: skip
    assert (done.stdout.split(), done.stderr) == (["norway-s25-250"], "")


@pytest.mark.parametrize("shell", SHELLS)
def test_a_script_is_one_that_its_shell_reads(arcless: Callable[..., object], shell: str) -> None:
    done = arcless("completion", shell)
    assert (done.exit_code, done.stderr) == (0, "")  # type: ignore[attr-defined]
    program = shutil.which(shell)
    if program is None:
        pytest.skip(f"there is no {shell} here")
    subprocess.run([program, "-n"], input=done.stdout, text=True, check=True, timeout=30)  # type: ignore[attr-defined]


def test_the_tab_key_waits_for_nothing_slow(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "complete_bash")
    monkeypatch.setenv("COMP_WORDS", "arcless\nrun\nen")
    monkeypatch.setenv("COMP_CWORD", "2")
    modules = modules_of()
    loaded = {name.partition(".")[0] for name in modules}
    assert not loaded & (SLOW | {"numpy", "yaml", "rich"})  # Typer itself may need pydantic
    assert not {name for name in modules if name.startswith("arcless.model")}


def test_names_are_those_of_files_and_no_file_is_read(place: Path) -> None:
    assert names.shipped_models("") == list(
        dict.fromkeys(name for kind in FOLDERS for name in shipped(kind))
    )
    assert names.runs("") == ["runs/a", "other.nc"]
    assert names.runs_and_measurements("") == ["runs/a", "other.nc", "table.csv"]
    assert names.begun_studies("runs") == ["runs/studies/grid"]
    (place / "runs").rename(place / "elsewhere")
    assert names.runs("runs") == []
