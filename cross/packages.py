"""Packages that Arcless needs on another system, unpacked into a folder to try a wheel there."""

import shutil
import sys
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path

from cross.toolchain import ROOT, MissingError, run


def wheel_of(pattern: str) -> Path:
    """Return the wheel in dist/ that has a name like this.

    Raises
    ------
    MissingError
        There is none, or several.
    """
    found = sorted((ROOT / "dist").glob(pattern))
    if len(found) != 1:
        raise MissingError(f"dist/ has {len(found)} wheels {pattern}: make one by `PARTS=wheel`")
    return found[0]


def put_packages(
    site: Path,
    platforms: Sequence[str],
    python: str,
    *,
    extras: Sequence[str] = (),
    more: Sequence[str] = (),
    then: Callable[[], None] | None = None,
) -> None:
    """Put packages that Arcless needs into a folder, unless those lie there already.

    Parameters
    ----------
    site
        The folder.
    platforms, python
        Tags of wheels, and the version of Python, for which they are.
    extras, more
        Extras of Arcless whose packages are put there too, and other packages.
    then
        Called when they are there, before they count as put there.
    """
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    optional = project["optional-dependencies"]
    asked = [*project["dependencies"], *(one for name in extras for one in optional[name]), *more]
    listed = site.with_name("packages.txt")
    if listed.exists() and listed.read_text("utf-8") == "\n".join(asked):
        return
    listed.unlink(missing_ok=True)
    wheels = site.with_name("wheels")
    for folder in (site, wheels):
        shutil.rmtree(folder, ignore_errors=True)
    tags = [word for platform in platforms for word in ("--platform", platform)]
    run(
        sys.executable, "-m", "pip", "download", "-q", "--only-binary", ":all:", *tags,
        "--python-version", python, "-d", str(wheels), *asked,
    )  # fmt: skip
    for one in sorted(wheels.glob("*.whl")):
        run("unzip", "-qo", str(one), "-d", str(site))
    if then is not None:
        then()
    listed.write_text("\n".join(asked), "utf-8")


def put_wheel(wheel: Path, site: Path) -> None:
    """Put the wheel of Arcless into a folder, in place of an earlier one."""
    for old in site.glob("arcless*"):
        shutil.rmtree(old)
    run("unzip", "-qo", str(wheel), "-d", str(site))


def put_down_forces(file: Path) -> None:
    """Put down the contact force of a run on this system, to compare with."""
    code = (
        "import sys, numpy, arcless\n"
        "run = arcless.run(arcless.load('en50318-ac-simple-320-planar'))\n"
        "numpy.save(sys.argv[1], run.dataset['contact_force'].values)\n"
    )
    file.parent.mkdir(parents=True, exist_ok=True)
    run(sys.executable, "-c", code, str(file))
