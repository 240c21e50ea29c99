"""Try an installed wheel: `check_wheel.py REPOSITORY [FORCES]`, run outside of the repository.

FORCES is a file of NumPy with the contact force of a run on another system, to compare with.
"""

import platform
import sys
from importlib.metadata import files
from pathlib import Path

import arcless

SCENARIO = "en50318-ac-simple-320-planar"
# Libraries of the systems differ in the last bit of exp, pow and hypot: 1.4e-10 N were seen, N.
CLOSE_N = 1e-6


def main(repository: Path, forces: Path | None = None) -> None:
    installed = Path(arcless.__file__).parent
    assert repository / "python" not in installed.parents, f"{installed} is not the wheel"
    listed = {str(path) for path in files("arcless") or []}
    source = repository / "python"
    wanted = [
        path
        for path in (source / "arcless").rglob("*")
        if path.is_file() and path.suffix not in (".pyc", ".so", ".dll")
    ]
    missing = [path for path in wanted if str(path.relative_to(source)) not in listed]
    assert not missing, f"not in the wheel: {missing}"
    assert "arcless/studio/page/index.html" in listed, "the page of the studio is not in the wheel"
    library = f"arcless/fmi/libraries/{platform.machine()}-linux/arcless_loop.so"
    assert library in listed, f"{library} is not in the wheel"
    assert any("LICENSE" in name for name in listed), "no licence in the wheel"
    for entry in arcless.library():
        if entry.kind == "scenario":
            arcless.load(entry.name)
    lengths = arcless.statics(arcless.load(SCENARIO)).to_dict()["droppers"]
    sys.stdout.write(
        f"wheel works: version {arcless.__version__}, {len(lengths)} droppers computed\n"
    )
    if forces is not None:
        compare(forces)


def compare(file: Path) -> None:
    import numpy as np

    expected = np.load(file)
    found = arcless.run(arcless.load(SCENARIO)).dataset["contact_force"].values
    off = float(np.abs(found - expected).max())
    assert off <= CLOSE_N, f"contact forces are {off:.3g} N off"
    same = 100.0 * float((found == expected).mean())
    sys.stdout.write(f"contact forces: {off:.2g} N off at most, {same:.1f} % to the last bit\n")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
