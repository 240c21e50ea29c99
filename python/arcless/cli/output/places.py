"""Places of files that are named on the command line."""

from pathlib import Path

from arcless.errors import OutputError
from arcless.units import show


def check_place(file: Path, suffix: str, option: str) -> None:
    """Refuse a file that could not be written after the computing, before it."""
    from arcless.storage.whole_files import check_writable

    if file.suffix.lower() != suffix:
        raise OutputError(
            f"not a {suffix} file",
            where=str(file),
            got=show(file.suffix) if file.suffix else "a name without an ending",
            expected=f"a name that ends in {suffix}",
            hint=f"this is the only form that `{option}` writes; a browser can print it",
        )
    check_writable(file)
