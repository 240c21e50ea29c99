"""Try an installed wheel: `check_wheel.py REPOSITORY`, run outside of the repository."""

import sys
from importlib.metadata import files
from pathlib import Path

import arcless


def main(repository: Path) -> None:
    installed = Path(arcless.__file__).parent
    assert repository not in installed.parents, f"{installed} is not the wheel"
    listed = {str(path) for path in files("arcless") or []}
    source = repository / "python"
    wanted = [
        path
        for path in (source / "arcless").rglob("*")
        if path.is_file() and path.suffix not in (".pyc", ".so")
    ]
    missing = [path for path in wanted if str(path.relative_to(source)) not in listed]
    assert not missing, f"not in the wheel: {missing}"
    assert "arcless/studio/page/index.html" in listed, "the page of the studio is not in the wheel"
    library = any(name.startswith("arcless/fmi/libraries/") for name in listed)
    assert library, "the library of FMUs is not in the wheel"
    assert any("LICENSE" in name for name in listed), "no licence in the wheel"
    for entry in arcless.library():
        if entry.kind == "scenario":
            arcless.load(entry.name)
    lengths = arcless.statics(arcless.load("en50318-ac-simple-320-planar")).to_dict()["droppers"]
    sys.stdout.write(
        f"wheel works: version {arcless.__version__}, {len(lengths)} droppers computed\n"
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]))
