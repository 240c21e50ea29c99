"""Inputs that fuzzing starts from: `crates/core/fuzz/corpus`, a line of hexadecimal digits each.

`python -m tests.hostile.corpus unpack FOLDER` writes each to a file in FOLDER/TARGET, as libFuzzer
reads them; `python -m tests.hostile.corpus pack TARGET FOLDER` replaces the inputs of a target by
the files of a folder.
"""

import argparse
import shutil
from pathlib import Path

CORPUS = Path(__file__).parents[2] / "crates" / "core" / "fuzz" / "corpus"


def unpack(folder: Path, corpus: Path = CORPUS) -> None:
    """Write the inputs of all targets to files; what the folder had is gone."""
    shutil.rmtree(folder, ignore_errors=True)
    for packed in corpus.glob("*.txt"):
        (folder / packed.stem).mkdir(parents=True)
        for number, line in enumerate(packed.read_text(encoding="ascii").splitlines()):
            (folder / packed.stem / f"{number:04}").write_bytes(bytes.fromhex(line))


def pack(target: str, folder: Path, corpus: Path = CORPUS) -> None:
    """Replace the inputs of a target by the files of a folder, each once and sorted."""
    lines = sorted({path.read_bytes().hex() for path in folder.iterdir()})
    (corpus / f"{target}.txt").write_text("".join(f"{line}\n" for line in lines), encoding="ascii")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("unpack").add_argument("folder", type=Path)
    packing = commands.add_parser("pack")
    packing.add_argument("target")
    packing.add_argument("folder", type=Path)
    given = parser.parse_args()
    if given.command == "unpack":
        unpack(given.folder)
    else:
        pack(given.target, given.folder)


if __name__ == "__main__":
    main()
