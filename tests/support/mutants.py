"""The numerical core with one line spoiled, built next to the real one."""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
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


SOURCE = Path("crates", "core", "src")
FUNCTION = re.compile(
    r"^(?P<indent> *)(?:pub(?:\([^)]*\))? )?(?:const )?fn (?P<name>\w+)", re.MULTILINE
)
BLOCK = re.compile(r"^impl(?:<.*?>)? (?:.* for )?(?:\w+::)*(?P<type>\w+)", re.MULTILINE)
LETTER = re.compile(r"\b[A-Z]\b")
# A name, what is read of it, and what calls give.
OPERAND = r"[A-Za-z_]\w*(?:::\w+)*(?:\.\w+|\[[^\[\]]*\]|\((?:[^()]|\([^()]*\))*\))*"


@dataclass(frozen=True)
class Mutation:
    """One wrong place in the source of the core, and the checks that must notice it.

    Single capital letters in `old` and `new` are operands: names of variables are free to change.
    """

    name: str
    function: str  # that it stands in: `name`, or `Type::name` where several are called so
    old: str  # an expression or a statement that occurs there once
    new: str
    checks: tuple[str, ...]  # below tests/verification: file::function

    @property
    def file(self) -> str:
        """Path of the source file below `crates/core/src`."""
        path, _ = self.spoil(ROOT)
        return path.relative_to(ROOT / SOURCE).as_posix()

    def spoil(self, root: Path) -> tuple[Path, str]:
        """Return the path of the source file and its text with the fault."""
        pattern = re.compile(self._pattern())
        bodies = [body for body in functions(root / SOURCE) if body.is_called(self.function)]
        found = [(b, match) for b in bodies for match in pattern.finditer(b.text, b.start, b.end)]
        assert len(found) == 1, f"`{self.old}` stands {len(found)} times in {self.function}"
        (body, match) = found[0]
        new = LETTER.sub(lambda letter: match[letter[0]], self.new)
        return body.path, body.text[: match.start()] + new + body.text[match.end() :]

    def _pattern(self) -> str:
        parts, seen, last = [], set[str](), 0
        for letter in LETTER.finditer(self.old):
            name = letter[0]
            operand = f"(?P={name})" if name in seen else f"(?P<{name}>{OPERAND})"
            parts += [_literal(self.old[last : letter.start()]), rf"(?<![\w.]){operand}(?!\w)"]
            seen.add(name)
            last = letter.end()
        return "".join(parts) + _literal(self.old[last:])

    def nodes(self) -> list[str]:
        return [f"tests/verification/{check}" for check in self.checks]


def _literal(text: str) -> str:
    """Return a pattern for a text, however its lines are broken."""
    return re.sub(r"(?:\\\s)+", r"\\s*", re.escape(text))


@dataclass(frozen=True)
class Body:
    """A function in a text: what it is called, of which type, and where it stands."""

    name: str
    of: str
    path: Path
    text: str
    start: int
    end: int

    def is_called(self, name: str) -> bool:
        return name in (self.name, f"{self.of}::{self.name}")


@cache
def functions(source: Path) -> list[Body]:
    """Return the functions of all source files. What rustfmt wrote ends where its indent closes."""
    found = []
    for path in sorted(source.rglob("*.rs")):
        text = path.read_text(encoding="utf-8")
        blocks = [(block.start(), block["type"]) for block in BLOCK.finditer(text)]
        for start in FUNCTION.finditer(text):
            end = re.compile(rf"^{start['indent']}\}}", re.MULTILINE).search(text, start.end())
            of = [name for place, name in blocks if place < start.start() and start["indent"]]
            if end is not None:
                body = Body(start["name"], (of or [""])[-1], path, text, start.end(), end.start())
                found.append(body)
    return found


class Workshop:
    """A copy of the sources where cores are built; a build takes seconds, except the first."""

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
        source, spoilt = mutation.spoil(self.folder)
        sound = source.read_text(encoding="utf-8")
        source.write_text(spoilt, encoding="utf-8")
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
