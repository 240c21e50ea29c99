"""The numerical core with one line spoiled, built beside the real one."""

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]

# Built often, run shortly: parts of the core that did not change are not compiled again.
FAST_TO_BUILD = {
    "CARGO_INCREMENTAL": "1",
    "CARGO_PROFILE_RELEASE_LTO": "off",
    "CARGO_PROFILE_RELEASE_CODEGEN_UNITS": "64",
    "CARGO_PROFILE_RELEASE_DEBUG": "0",
    "CARGO_PROFILE_RELEASE_OPT_LEVEL": "1",
}


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
        assert text.count(self.old) == 1, (
            f"{self.file} has `{self.old}` {text.count(self.old)} times"
        )
        return text.replace(self.old, self.new)

    def nodes(self) -> list[str]:
        return [f"tests/verification/{check}" for check in self.checks]


class Workshop:
    """A copy of the sources where cores are built; a build takes seconds, but for the first."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        ignored = shutil.ignore_patterns("target", "__pycache__", "_core*", "corpus", "artifacts")
        shutil.copytree(ROOT / "crates", folder / "crates", ignore=ignored)
        shutil.copytree(ROOT / "python", folder / "python", ignore=ignored)
        for name in ("Cargo.toml", "Cargo.lock"):
            if (ROOT / name).exists():
                shutil.copy2(ROOT / name, folder / name)

    def build(self) -> None:
        """Compile the core as it stands in the copy and put it into the copy of the package."""
        target = self.folder / "target"
        environment = os.environ | FAST_TO_BUILD | {
            "CARGO_TARGET_DIR": str(target),
            "PYO3_PYTHON": sys.executable,
        }  # fmt: skip
        command = ["cargo", "build", "--release", "--quiet", "-p", "arcless-py"]
        subprocess.run(command, cwd=self.folder, env=environment, check=True)
        built = target / "release" / "lib_core.so"
        shutil.copy2(built, self.folder / "python" / "arcless" / "_core.abi3.so")

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
        """Run checks with the core that was built last."""
        command = [
            sys.executable,
            "-m",
            "pytest",
            "--tb=no",
            "-q",
            "-rfE",
            "-p",
            "no:cacheprovider",
        ]
        environment = os.environ | {"PYTHONPATH": str(self.folder / "python")}
        done = subprocess.run(
            [*command, *checks],
            cwd=ROOT,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode in (0, 1), done.stdout + done.stderr
        lines = done.stdout.splitlines()
        assert not [line for line in lines if line.startswith("ERROR")], done.stdout
        failed = [line.split()[1] for line in lines if line.startswith("FAILED")]
        of = lambda check: any(f == check or f.startswith(f"{check}[") for f in failed)  # noqa: E731
        return {check: of(check) for check in checks}
