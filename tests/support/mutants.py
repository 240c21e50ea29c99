"""The numerical core with one line spoiled, built beside the real one."""

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]

# Built often, run shortly: parts of the core that did not change are not compiled again, and
# optimised little. Bits may differ from those of the real build, tolerances do not care.
FAST_TO_BUILD = {
    "CARGO_INCREMENTAL": "1",
    "CARGO_PROFILE_RELEASE_LTO": "off",
    "CARGO_PROFILE_RELEASE_CODEGEN_UNITS": "64",
    "CARGO_PROFILE_RELEASE_DEBUG": "0",
    "CARGO_PROFILE_RELEASE_OPT_LEVEL": "1",
    "CARGO_TARGET_DIR": str(ROOT / "target" / "mutants"),
    "PYO3_PYTHON": sys.executable,
}
LIBRARY = ROOT / "target" / "mutants" / "release" / "lib_core.so"


@dataclass(frozen=True)
class Mutation:
    """One wrong place in the source of the core, and the checks that must notice it."""

    name: str
    file: str  # below crates/core/src
    old: str  # occurs there once
    new: str
    checks: tuple[str, ...]  # below tests/verification: file::function

    def source(self, root: Path = ROOT) -> Path:
        return root / "crates" / "core" / "src" / self.file

    def spoil(self, text: str) -> str:
        times = text.count(self.old)
        assert times == 1, f"{self.file}: `{self.old}` stands there {times} times"
        return text.replace(self.old, self.new)

    def nodes(self) -> list[str]:
        return [f"tests/verification/{check}" for check in self.checks]


class Workshop:
    """A copy of the sources where cores are built; a build takes seconds, but for the first."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        ignored = shutil.ignore_patterns("target", "fuzz", "__pycache__", "_core*")
        for name in ("crates", "python"):
            # With the time of the copy: cargo takes an older file for one that it has compiled, and
            # what it compiled last had a fault.
            shutil.copytree(ROOT / name, folder / name, ignore=ignored, copy_function=shutil.copy)
        for name in ("Cargo.toml", "Cargo.lock"):
            if (ROOT / name).exists():
                shutil.copy2(ROOT / name, folder / name)

    def build(self) -> None:
        """Compile the core as it stands in the copy and put it into the copy of the package."""
        command = ["cargo", "build", "--release", "--quiet", "-p", "arcless-py"]
        environment = os.environ | FAST_TO_BUILD
        subprocess.run(command, cwd=self.folder, env=environment, check=True)
        place = self.folder / "python" / "arcless" / "_core.abi3.so"
        place.unlink(missing_ok=True)  # never write into a file that a process has loaded
        shutil.copy2(LIBRARY, place)

    def with_fault(self, mutation: Mutation, checks: Sequence[str]) -> dict[str, bool]:
        """Tell of each check (a pytest address) whether it fails with this fault in the core."""
        source = mutation.source(self.folder)
        sound = source.read_text(encoding="utf-8")
        source.write_text(mutation.spoil(sound), encoding="utf-8")
        try:
            self.build()
            return self.fails(checks)
        finally:
            source.write_text(sound, encoding="utf-8")

    def fails(self, checks: Sequence[str]) -> dict[str, bool]:
        """Run checks with the core that was built last.

        A check fails when it raises. What differs from its record but is inside of its tolerance
        is an error of the comparison that follows, and no notice.
        """
        words = ["--tb=no", "-q", "-rf", "-p", "no:cacheprovider"]
        done = subprocess.run(
            [sys.executable, "-m", "pytest", *words, *checks],
            cwd=ROOT,
            env=os.environ | {"PYTHONPATH": str(self.folder / "python")},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode in (0, 1), done.stdout + done.stderr
        lines = [line.split(" - ")[0] for line in done.stdout.splitlines()]
        failed = [line.removeprefix("FAILED ") for line in lines if line.startswith("FAILED ")]
        return {
            check: any(name == check or name.startswith(f"{check}[") for name in failed)
            for check in checks
        }
